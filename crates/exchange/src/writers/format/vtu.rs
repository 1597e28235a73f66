//! VTK unstructured grid (XML), for ParaView: triangles with curvatures, normals and parameters at the vertices.
//!
//! Arrays are inline base64 of little-endian numbers. Where a patch is singular it has no curvature: 0 is written, and the
//! array `singular`, which regular patches lack, is 1.

use std::io::{self, Write};

use base64::prelude::BASE64_STANDARD;
use base64::write::EncoderWriter;
use surfaces::Mesh;

use crate::writers::subject::{Export, Subject};

/// The cell type of a triangle in VTK.
const TRIANGLE: u8 = 5;

pub(crate) struct Vtu;

impl Export for Vtu {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        let mesh = subject.mesh;
        let (points, cells) = (mesh.points.len(), mesh.triangles.len());
        out.write_all(
            b"<?xml version=\"1.0\"?>\n\
              <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
              <UnstructuredGrid>\n",
        )?;
        writeln!(out, "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">")?;
        point_data(mesh, out)?;
        writeln!(out, "<Points>")?;
        doubles("points", [points, 3], mesh.points.iter().flat_map(|p| [p.x, p.y, p.z]), out)?;
        writeln!(out, "</Points>\n<Cells>")?;
        let corners = mesh.triangles.iter().flatten().map(|&k| i64::from(k).to_le_bytes());
        array("Int64", "connectivity", [3 * cells, 1], corners, out)?;
        array("Int64", "offsets", [cells, 1], (1..=cells as i64).map(|k| (3 * k).to_le_bytes()), out)?;
        array("UInt8", "types", [cells, 1], mesh.triangles.iter().map(|_| [TRIANGLE]), out)?;
        out.write_all(b"</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
    }
}

fn point_data(mesh: &Mesh, out: &mut dyn Write) -> io::Result<()> {
    let points = mesh.points.len();
    writeln!(out, "<PointData Scalars=\"mean_curvature\" Normals=\"normals\" TCoords=\"parameters\">")?;
    for (name, values) in
        [("mean_curvature", &mesh.mean_curvature), ("gauss_curvature", &mesh.gauss_curvature)]
    {
        doubles(name, [points, 1], values.iter().map(|value| value.unwrap_or(0.0)), out)?;
    }
    if mesh.mean_curvature.contains(&None) {
        let singular = mesh.mean_curvature.iter().map(|h| [u8::from(h.is_none())]);
        array("UInt8", "singular", [points, 1], singular, out)?;
    }
    doubles("normals", [points, 3], mesh.normals.iter().flat_map(|n| [n.x, n.y, n.z]), out)?;
    doubles("parameters", [points, 2], mesh.parameters.iter().copied().flatten(), out)?;
    writeln!(out, "</PointData>")
}

fn doubles(
    name: &str,
    size: [usize; 2],
    values: impl Iterator<Item = f64>,
    out: &mut dyn Write,
) -> io::Result<()> {
    array("Float64", name, size, values.map(f64::to_le_bytes), out)
}

/// One array of so many tuples of so many numbers: the number of its bytes, then the bytes, in base64, as they come.
fn array<const N: usize>(
    kind: &str,
    name: &str,
    [tuples, components]: [usize; 2],
    numbers: impl Iterator<Item = [u8; N]>,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">"
    )?;
    let mut coded = EncoderWriter::new(&mut *out, &BASE64_STANDARD);
    coded.write_all(&((N * tuples * components) as u64).to_le_bytes())?;
    for bytes in numbers {
        coded.write_all(&bytes)?;
    }
    coded.finish()?;
    drop(coded);
    writeln!(out, "\n</DataArray>")
}
