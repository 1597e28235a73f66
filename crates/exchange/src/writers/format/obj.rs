//! Wavefront OBJ: vertices, parameters as texture coordinates, normals, triangles.

use std::io::{self, Write};

use crate::writers::name::one_line;
use crate::writers::subject::{Export, Subject};

pub(crate) struct Obj;

impl Export for Obj {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        let mesh = subject.mesh;
        // A backslash at the end of a line continues it.
        let name = one_line(subject.name).replace('\\', "/");
        writeln!(out, "# {name}")?;
        writeln!(out, "o {}", name.replace(' ', "_"))?;
        for p in &mesh.points {
            writeln!(out, "v {} {} {}", p.x, p.y, p.z)?;
        }
        for [u, v] in &mesh.parameters {
            writeln!(out, "vt {u} {v}")?;
        }
        for n in &mesh.normals {
            writeln!(out, "vn {} {} {}", n.x, n.y, n.z)?;
        }
        for [a, b, c] in mesh.triangles.iter().map(|t| t.map(|k| k + 1)) {
            writeln!(out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
        }
        Ok(())
    }
}
