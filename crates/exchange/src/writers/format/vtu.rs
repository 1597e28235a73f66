//! VTK unstructured grid, for ParaView: triangles with curvatures, normals and parameters at the vertices.
//!
//! Where a patch is singular it has no curvature: 0 is written, and the array `singular`, which regular patches lack, is 1.

use std::io::{self, Write};

use surfaces::Mesh;

use crate::writers::subject::{Export, Subject};
use crate::writers::vtk::{Cell, array, doubles, grid};

/// The cell type of a triangle in VTK.
const TRIANGLE: u8 = 5;

pub(crate) struct Vtu;

impl Export for Vtu {
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        let mesh = subject.mesh;
        let cells = mesh.triangles.iter().map(|nodes| Cell { kind: TRIANGLE, nodes });
        grid(&mesh.points, cells, |out| point_data(mesh, out), out)
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
