//! What single precision leaves of a surface: some formats have no other.

use surfaces::Point;

use super::extent::{diagonal, extent};

/// Share of the size that single precision takes of any surface around the origin, and nobody needs to be told.
const USUAL: f64 = 1e-6;

/// What is lost of points when their coordinates are rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Loss {
    /// The largest change of a coordinate.
    pub(super) distance: f64,
    /// The same as a share of the size, the diagonal of the box around the points.
    pub(super) share: f64,
}

impl Loss {
    /// The loss of points far from the origin; none if it is the usual one.
    pub(super) fn of(points: &[Point]) -> Option<Self> {
        let changes = points.iter().flat_map(|p| [p.x, p.y, p.z]).map(|x| (x - f64::from(x as f32)).abs());
        let distance = changes.fold(0.0, f64::max);
        let size = size(points);
        (size > 0.0 && distance > USUAL * size).then(|| Self { distance, share: distance / size })
    }
}

/// Whether single precision holds points: none overflows, and the box around them keeps its size.
pub(super) fn fits(points: &[Point]) -> bool {
    const HALF_OF_THE_DIGITS: f64 = 4096.0;
    let size = size(points);
    let largest = points.iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0, |m: f64, x| m.max(x.abs()));
    largest <= f64::from(f32::MAX)
        && (size == 0.0 || size >= HALF_OF_THE_DIGITS * f64::from(f32::MIN_POSITIVE))
}

/// A place near points that are to be told from it, where they lose digits as they are: the middle of their box, in a format
/// that can move a mesh as a whole.
pub(super) fn origin(points: &[Point]) -> Option<Point> {
    Loss::of(points).map(|_| {
        let [low, high] = extent(points.iter().map(|&p| p.into()));
        let middle = |k: usize| low[k] + 0.5 * (high[k] - low[k]);
        Point::new(middle(0), middle(1), middle(2))
    })
}

fn size(points: &[Point]) -> f64 {
    diagonal(points.iter().map(|&p| p.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(offset: f64) -> [Point; 3] {
        [[0.0, 0.0], [1.0, 0.3], [0.1, 0.7]].map(|[x, y]| Point::new(x + offset, y, 0.0))
    }

    #[test]
    fn points_far_from_the_origin_lose_their_shape() {
        assert_eq!((Loss::of(&triangle(0.0)), origin(&triangle(0.0))), (None, None));
        let far = triangle(500_000.3);
        let loss = Loss::of(&far).unwrap();
        assert!(loss.distance > 1e-3 && loss.distance < 0.1 && loss.share <= loss.distance, "{loss:?}");
        let middle = origin(&far).unwrap();
        assert!(Loss::of(&far.map(|p| p - middle)).is_none());
    }
}
