//! Watertight triangle meshes.

use super::{Complex, ComplexError, Side};
use crate::{Mesh, Patch, Point};

/// A triangle mesh of a complex whose vertices on edges are shared by all faces there.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexMesh {
    /// The triangles. At a vertex of several faces the parameters are those of the first, the normal is the mean of theirs,
    /// and the curvatures are those farthest from 0.
    pub mesh: Mesh,
    /// The face of every triangle.
    pub faces: Vec<usize>,
    /// For every face of the complex its (`subdivisions` + 1)² vertices, those of one u after those of another.
    pub grids: Vec<Vec<u32>>,
    /// For every edge of the complex its `subdivisions` + 1 vertices, from its first end to its second.
    pub edges: Vec<Vec<u32>>,
}

impl Complex {
    /// The mesh with N = `subdivisions` equal steps of each parameter of every face, N at least 1: 2N² triangles a face, no
    /// vertex twice. All triangles of a part that has two sides lie on the same; where that is impossible
    /// ([`Orientation`](super::Orientation)), each face keeps the side the first face of its part gave it.
    ///
    /// # Errors
    /// [`ComplexError::TooLarge`] for more than [`Complex::MAX_POINTS`] vertices, [`ComplexError::Degree`] for more than 100
    /// steps.
    pub fn mesh(&self, subdivisions: usize) -> Result<ComplexMesh, ComplexError> {
        let n = subdivisions.max(1);
        // Vertices of the mesh are numbered like the control points of a complex of degree N.
        let layout = self.layout.with_degree(n)?;
        let count = layout.count();
        let mut mesh = Mesh {
            points: vec![Point::ZERO; count],
            normals: vec![Point::ZERO; count],
            parameters: vec![[0.0; 2]; count],
            mean_curvature: vec![None; count],
            gauss_curvature: vec![None; count],
            triangles: Vec::with_capacity(2 * n * n * self.faces().len()),
        };
        let steps: Vec<f64> = (0..=n).map(|k| k as f64 / n as f64).collect();
        let orientation = self.orientation();
        let mut faces = Vec::with_capacity(mesh.triangles.capacity());
        let mut met = vec![false; count];
        let mut flat = vec![Point::ZERO; count];
        for (face, nodes) in layout.faces.iter().map(super::Face::nodes).enumerate() {
            let flipped = orientation.flipped()[face];
            let sign = if flipped { -1.0 } else { 1.0 };
            let patch =
                self.patch(face).map_err(|_| ComplexError::Degree { degree: self.degree(), max: 100 })?;
            for (k, jet) in patch.jets(&steps, &steps).into_iter().enumerate() {
                let node = nodes[k];
                mesh.normals[node] += jet.normal().unwrap_or_default() * sign;
                if !std::mem::replace(&mut met[node], true) {
                    mesh.points[node] = jet.point;
                    mesh.parameters[node] = [steps[k / (n + 1)], steps[k % (n + 1)]];
                }
                farther(&mut mesh.mean_curvature[node], jet.mean_curvature().map(|h| h * sign));
                farther(&mut mesh.gauss_curvature[node], jet.gauss_curvature());
            }
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let at = |i: usize, j: usize| nodes[(n + 1) * i + j] as u32;
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let triangles = if flipped { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
                for triangle in triangles {
                    let [p, q, r] = triangle.map(|k| mesh.points[k as usize]);
                    let normal = (q - p).cross(r - p);
                    triangle.into_iter().for_each(|k| flat[k as usize] += normal);
                    mesh.triangles.push(triangle);
                    faces.push(face);
                }
            }
        }
        // Where the patches have no normal, that of the triangles around.
        for (normal, flat) in mesh.normals.iter_mut().zip(&flat) {
            let up = Point::new(0.0, 0.0, 1.0);
            *normal = normal.unit().or(flat.unit()).unwrap_or(up);
        }
        let run =
            |edge: usize| layout.run(edge, layout.edges[edge].ends()).into_iter().map(|k| k as u32).collect();
        let grids =
            layout.faces.iter().map(|face| face.nodes().iter().map(|&k| k as u32).collect()).collect();
        Ok(ComplexMesh { mesh, faces, grids, edges: (0..layout.edges.len()).map(run).collect() })
    }
}

/// Keeps the value farther from 0, if there is one.
fn farther(kept: &mut Option<f64>, found: Option<f64>) {
    if found.is_some_and(|found| kept.is_none_or(|kept| found.abs() > kept.abs())) {
        *kept = found;
    }
}

impl super::EdgeUse {
    /// Whether the border of the face, walked v00, v10, v11, v01, runs through the edge from its first end to its second.
    pub fn runs_with_edge(&self) -> bool {
        self.side.runs_round() != self.reversed
    }

    /// The parameters (u, v) in the face of the point at t ∈ [0, 1] of the edge.
    pub fn parameters(&self, t: f64) -> (f64, f64) {
        Side::parameters(self.side, if self.reversed { 1.0 - t } else { t })
    }
}
