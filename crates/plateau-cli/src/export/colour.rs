//! Mean curvature as colour.

use surfaces::Mesh;

use crate::colour;

/// |H| times the size of the mesh below which mean curvature is rounding: a minimal surface has no colours.
const FLAT: f64 = 1e-9;

/// Blue for negative, white for zero, red for positive mean curvature, grey where there is none; with the |H| at which the
/// colours are full. None for minimal surfaces.
pub(crate) fn by_mean_curvature(mesh: &Mesh) -> Option<(Vec<[u8; 3]>, f64)> {
    let rounding = FLAT / super::diagonal(mesh.points.iter().map(|p| [p.x, p.y, p.z]));
    let full = colour::full_scale(mesh.mean_curvature.iter().flatten().copied(), rounding)?;
    Some((mesh.mean_curvature.iter().map(|h| shade(h.map(|h| h / full))).collect(), full))
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
