//! Stanford PLY, binary little endian: everything the mesh knows, in double precision.
//!
//! PLY has no missing values. Where the patch is singular and has no curvature, 0 is written and the property `singular` is
//! 1; a comment of the header counts those vertices. Regular patches have neither.

use std::io::{self, Write};

use crate::writers::name::ascii;
use crate::writers::subject::{Colours, Export, Subject};

const HEADER: &str = "\
property double x
property double y
property double z
property double nx
property double ny
property double nz
property double u
property double v
property double mean_curvature
property double gauss_curvature
";

const COLOURS: &str = "\
property uchar red
property uchar green
property uchar blue
";

pub(crate) struct Ply;

impl Export for Ply {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        let mesh = subject.mesh;
        let colours = subject.colours;
        // Some readers look for the end of the header anywhere in it.
        let name = ascii(subject.name).replace("end_header", "end header");
        writeln!(out, "ply\nformat binary_little_endian 1.0\ncomment {name}")?;
        match &colours {
            Some(Colours { full, .. }) => writeln!(
                out,
                "comment colours: blue negative, white zero, red positive mean curvature; full colour at {full}"
            )?,
            None => writeln!(out, "comment no colours: the mean curvature is zero to within rounding")?,
        }
        let singular = mesh.mean_curvature.iter().filter(|h| h.is_none()).count();
        if singular > 0 {
            writeln!(
                out,
                "comment the patch is singular at {singular} vertices, marked 1: they have no curvature, written 0"
            )?;
        }
        write!(out, "element vertex {}\n{HEADER}", mesh.points.len())?;
        if singular > 0 {
            writeln!(out, "property uchar singular")?;
        }
        if colours.is_some() {
            out.write_all(COLOURS.as_bytes())?;
        }
        writeln!(
            out,
            "element face {}\nproperty list uchar uint vertex_indices\nend_header",
            mesh.triangles.len()
        )?;
        for k in 0..mesh.points.len() {
            let (p, n, [u, v]) = (mesh.points[k], mesh.normals[k], mesh.parameters[k]);
            let curvature = |values: &[Option<f64>]| values[k].unwrap_or(0.0);
            let (mean, gauss) = (curvature(&mesh.mean_curvature), curvature(&mesh.gauss_curvature));
            for x in [p.x, p.y, p.z, n.x, n.y, n.z, u, v, mean, gauss] {
                out.write_all(&x.to_le_bytes())?;
            }
            if singular > 0 {
                out.write_all(&[u8::from(mesh.mean_curvature[k].is_none())])?;
            }
            if let Some(Colours { of_vertices, .. }) = &colours {
                out.write_all(&of_vertices[k])?;
            }
        }
        for triangle in &mesh.triangles {
            out.write_all(&[3])?;
            for k in triangle {
                out.write_all(&k.to_le_bytes())?;
            }
        }
        Ok(())
    }
}
