//! Mean curvature as colour.

use surfaces::{Mesh, Point};

use crate::colour;

/// |H| times the size of the mesh below which mean curvature is rounding: a minimal surface has no colours.
const FLAT: f64 = 1e-9;

/// Blue for negative, white for zero, red for positive mean curvature, grey where there is none; with the |H| at which the
/// colours are full. None for minimal surfaces.
pub fn by_mean_curvature(mesh: &Mesh) -> Option<(Vec<[u8; 3]>, f64)> {
    let rounding = FLAT / diagonal(&mesh.points);
    let full = colour::full_scale(mesh.mean_curvature.iter().flatten().copied(), rounding)?;
    Some((mesh.mean_curvature.iter().map(|h| shade(h.map(|h| h / full))).collect(), full))
}

/// The diagonal of the least box around points.
fn diagonal(points: &[Point]) -> f64 {
    let coordinates = points.iter().map(|&p| <[f64; 3]>::from(p));
    let [low, high] = coordinates.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))]
    });
    (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt()
}

/// The colour of a curvature in units of the full one, sRGB.
fn shade(h: Option<f64>) -> [u8; 3] {
    h.filter(|h| h.is_finite()).map_or(colour::NONE, colour::diverging)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_have_colours_and_a_missing_curvature_is_grey() {
        assert_eq!([0.0, -7.0, 0.5].map(|h| shade(Some(h))), [0.0, -1.0, 0.5].map(colour::diverging));
        assert_eq!([None, Some(f64::NAN)].map(shade), [colour::NONE; 2]);
    }

    #[test]
    fn minimal_surfaces_are_left_plain() {
        let helicoid = surfaces::Helicoid::new(1.0, 2.0, 1.5, 6.0).unwrap();
        assert_eq!(by_mean_curvature(&Mesh::of(&helicoid.pieces().unwrap(), 16)), None);
    }
}
