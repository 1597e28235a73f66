//! For which shapes the GT functions are nonnegative.

use std::f64::consts::PI;

use crate::{Basis, BasisError, GtParts};

/// Places at which the functions are looked at, crowded towards both ends, where the region is decided.
const PLACES: usize = 2000;
/// Half the side of a square that holds the regions of the degrees offered.
const REACH: f64 = 8.0;
/// Largest degree offered.
const MAX_DEGREE: usize = 20;

/// The shapes (θ1, θ2) for which all GT functions of a degree are nonnegative on [0, 1]: a convex region, as the corners of a polygon around it, in order.
///
/// The functions are affine in the shape, so each is nonnegative at a place t on one side of a line; the polygon is what 2000 places leave of a square. It holds the
/// region, and lies within 1e-5 of it. For degree 2 it is the square [0, 4]²; each further degree adds shapes below 0, none above 4.
///
/// ```
/// let square = bases::nonnegative_shapes(2)?;
/// assert!(square.iter().flatten().all(|x| x.abs() < 1e-5 || (x - 4.0).abs() < 1e-5));
/// // At degree 3 curves may leave with a shape below 0, as long as they do not turn back: n − 2 + θ1 π/4 ≥ 0.
/// let least = bases::nonnegative_shapes(3)?.iter().map(|shape| shape[0]).fold(0.0, f64::min);
/// assert!((least + 4.0 / std::f64::consts::PI).abs() < 1e-5);
/// # Ok::<(), bases::BasisError>(())
/// ```
///
/// # Errors
/// [`BasisError::Degree`] below 2 or above 20.
pub fn nonnegative_shapes(degree: usize) -> Result<Vec<[f64; 2]>, BasisError> {
    if degree > MAX_DEGREE {
        return Err(BasisError::Degree { family: "GT", degree, min: 2, max: MAX_DEGREE });
    }
    let parts = GtParts::new(degree)?;
    let count = degree + 1;
    let mut region = vec![[-REACH, -REACH], [REACH, -REACH], [REACH, REACH], [-REACH, REACH]];
    for place in 1..PLACES {
        let t = 0.5 - 0.5 * libm::cos(PI * place as f64 / PLACES as f64);
        let values = parts.evaluate(t, 0);
        let values = values.row(0);
        for k in 0..count {
            region = cut(&region, [values[k], values[count + k], values[2 * count + k]]);
        }
    }
    Ok(region)
}

/// What lies of a convex polygon where a + b θ1 + c θ2 ≥ 0.
fn cut(polygon: &[[f64; 2]], [a, b, c]: [f64; 3]) -> Vec<[f64; 2]> {
    let height = |p: [f64; 2]| a + b * p[0] + c * p[1];
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (k, &from) in polygon.iter().enumerate() {
        let to = polygon[(k + 1) % polygon.len()];
        let (f, g) = (height(from), height(to));
        if f >= 0.0 {
            left.push(from);
        }
        if (f < 0.0) != (g < 0.0) {
            let s = f / (f - g);
            left.push([from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]);
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least value of all functions of a degree at a shape.
    fn least(degree: usize, [t1, t2]: [f64; 2]) -> f64 {
        let (parts, n) = (GtParts::new(degree).unwrap(), degree + 1);
        let at = |place: usize| {
            let values = parts.evaluate(place as f64 / 1000.0, 0);
            let values = values.row(0);
            (0..n)
                .map(|k| values[k] + t1 * values[n + k] + t2 * values[2 * n + k])
                .fold(f64::INFINITY, f64::min)
        };
        (0..=1000).map(at).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn functions_are_nonnegative_within_and_negative_without() {
        for degree in 2..=8 {
            let region = nonnegative_shapes(degree).unwrap();
            assert!(region.iter().flatten().all(|x| *x < 4.0 + 1e-5));
            let middle = [0, 1].map(|k| region.iter().map(|p| p[k]).sum::<f64>() / region.len() as f64);
            for &corner in &region {
                let at = |s: f64| [0, 1].map(|k| middle[k] + s * (corner[k] - middle[k]));
                assert!(least(degree, at(0.999)) >= -1e-15, "{degree} {corner:?}");
                assert!(least(degree, at(1.02)) < 0.0, "{degree} {corner:?}");
            }
        }
    }

    #[test]
    fn every_degree_admits_what_the_one_before_does() {
        let mut before: Vec<[f64; 2]> = Vec::new();
        for degree in 2..=MAX_DEGREE {
            assert!(before.iter().all(|&[x, y]| least(degree, [0.999 * x, 0.999 * y]) >= -1e-6), "{degree}");
            before = nonnegative_shapes(degree).unwrap();
        }
        assert!(nonnegative_shapes(1).is_err() && nonnegative_shapes(MAX_DEGREE + 1).is_err());
    }
}
