//! Mean curvature as colour.

use surfaces::Mesh;

/// |H| times the size of the mesh below which mean curvature is rounding: a minimal surface has no colours.
const FLAT: f64 = 1e-9;

/// Share of the vertices whose |H| the scale covers; a few near singular points would wash out all the others.
const COVERED: f64 = 0.98;

/// Blue for negative, white for zero, red for positive mean curvature, grey where there is none; with the |H| at which the
/// colours are full. None for minimal surfaces.
pub(crate) fn by_mean_curvature(mesh: &Mesh) -> Option<(Vec<[u8; 3]>, f64)> {
    let mut sizes: Vec<f64> =
        mesh.mean_curvature.iter().flatten().map(|h| h.abs()).filter(|h| h.is_finite()).collect();
    let place = ((sizes.len() as f64 * COVERED) as usize).min(sizes.len().checked_sub(1)?);
    let (_, full, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
    let full = *full;
    if full * super::diagonal(mesh.points.iter().map(|p| [p.x, p.y, p.z])) <= FLAT {
        return None;
    }
    Some((mesh.mean_curvature.iter().map(|h| shade(h.map(|h| h / full))).collect(), full))
}

/// The colour of a curvature in units of the full one, sRGB.
fn shade(h: Option<f64>) -> [u8; 3] {
    const BLUE: [f64; 3] = [33.0, 102.0, 172.0];
    const WHITE: [f64; 3] = [247.0, 247.0, 247.0];
    const RED: [f64; 3] = [178.0, 24.0, 43.0];
    let Some(h) = h.filter(|h| h.is_finite()) else { return [128; 3] };
    let (end, share) = if h < 0.0 { (BLUE, (-h).min(1.0)) } else { (RED, h.min(1.0)) };
    std::array::from_fn(|k| (WHITE[k] + share * (end[k] - WHITE[k])).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_have_colours_and_zero_has_none() {
        assert_eq!(shade(Some(0.0)), [247; 3]);
        assert_eq!(shade(Some(-7.0)), [33, 102, 172]);
        assert_eq!(shade(Some(1.0)), [178, 24, 43]);
        assert_eq!(shade(None), [128; 3]);
        let halfway = shade(Some(0.5));
        assert!(halfway[0] > 178 && halfway[2] > 43 && halfway[2] < 247, "{halfway:?}");
    }

    #[test]
    fn minimal_surfaces_are_left_plain() {
        let helicoid = surfaces::Helicoid::new(1.0, 2.0, 1.5, 6.0).unwrap();
        assert_eq!(by_mean_curvature(&Mesh::of(&helicoid.pieces().unwrap(), 16)), None);
    }
}
