//! What the faces of a surface hide.

use super::camera::Camera;
use crate::scene::{Sample, Scene};

/// How far before a point, in units of the radius of the scene, a face lies that hides it: points of borders lie on faces.
const BEFORE: f64 = 0.02;

/// Cells of each direction in which triangles are looked up.
const CELLS: usize = 40;

/// The triangles of a surface as a camera sees them.
pub(super) struct Cover<'c> {
    camera: &'c Camera,
    triangles: Vec<[[f64; 3]; 3]>,
    /// The triangles that touch each cell of a square around the scene.
    cells: Vec<Vec<usize>>,
}

impl<'c> Cover<'c> {
    /// The faces of `stride` cells a side of a sample, cut into triangles.
    pub(super) fn new(scene: &Scene<'_>, sample: &Sample, camera: &'c Camera, stride: usize) -> Self {
        let mut triangles = Vec::new();
        for face in sample.faces(stride) {
            let corners: Vec<[f64; 3]> =
                face.iter().map(|&k| camera.seen(scene.local(sample.points[k]))).collect();
            triangles.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
        }
        let mut cells = vec![Vec::new(); CELLS * CELLS];
        for (number, triangle) in triangles.iter().enumerate() {
            let range = |k: usize| {
                let low = triangle.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
                let high = triangle.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
                cell(low)..=cell(high)
            };
            for column in range(0) {
                range(1).for_each(|row| cells[CELLS * column + row].push(number));
            }
        }
        Self { camera, triangles, cells }
    }

    /// Whether a face lies before a point of the scene's frame.
    pub(super) fn hides(&self, point: surfaces::Point) -> bool {
        let seen = self.camera.seen(point);
        let near = &self.cells[CELLS * cell(seen[0]) + cell(seen[1])];
        near.iter().any(|&k| depth(&self.triangles[k], seen).is_some_and(|depth| depth > seen[2] + BEFORE))
    }
}

/// The cell of a coordinate; surfaces lie within the unit ball.
fn cell(x: f64) -> usize {
    ((0.5 * (x + 1.0) * CELLS as f64).max(0.0) as usize).min(CELLS - 1)
}

/// How near a triangle is at a place that it covers.
fn depth([a, b, c]: &[[f64; 3]; 3], at: [f64; 3]) -> Option<f64> {
    let cross =
        |p: &[f64; 3], q: &[f64; 3]| (p[0] - at[0]) * (q[1] - at[1]) - (p[1] - at[1]) * (q[0] - at[0]);
    let shares = [cross(b, c), cross(c, a), cross(a, b)];
    let whole: f64 = shares.iter().sum();
    let covers = whole != 0.0 && shares.iter().all(|share| share / whole >= 0.0);
    covers.then(|| (shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2]) / whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_covers_its_inside_at_its_own_depth() {
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 2.0]];
        for turned in [triangle, [triangle[2], triangle[1], triangle[0]]] {
            let found = depth(&turned, [0.25, 0.5, 0.0]).unwrap();
            assert!((found - 1.25).abs() < 1e-15, "{found}");
            assert_eq!(depth(&turned, [0.75, 0.5, 0.0]), None);
        }
    }
}
