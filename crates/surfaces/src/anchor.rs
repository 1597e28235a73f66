//! The point that computations are relative to.

use crate::{Point, extent};

/// A point near all of `points`, or 0 if they lie around the origin: differences to it are exact, so that what is computed of
/// them neither loses digits to the distance from the origin nor depends on it.
///
/// Each coordinate is that of the first point, cut to a multiple of the least power of two that is at least twice the size of the
/// points. So a coordinate of any point less that of the anchor, and the sum of the two again, has no rounding; coordinates relative to
/// the anchor are at most six times the size; and points that lie within twice their size of the origin keep theirs.
/// Points that are all the same are their own anchor; 0 for none, and for points that are not finite.
///
/// ```
/// use surfaces::{Point, anchor};
/// let frame = [[0.1, 0.2, 0.0], [3.0, 0.1, 1.0]].map(Point::from);
/// assert_eq!(anchor(&frame), Point::ZERO);
/// let far = frame.map(|p| p + Point::new(1e6, 0.0, 0.0));
/// let origin = anchor(&far);
/// assert!(far.iter().all(|&p| (p - origin) + origin == p && (p - origin).norm() < 20.0));
/// ```
pub fn anchor(points: &[Point]) -> Point {
    let (Some(&first), size) = (points.first(), extent(points)) else { return Point::ZERO };
    if points.iter().all(|&p| p == first) {
        return first;
    }
    // A size whose square leaves the range of doubles.
    if size == 0.0 || !size.is_finite() {
        return Point::ZERO;
    }
    // The least power of two that is not below: that of the exponent, and twice it for every other mantissa.
    let exponent = libm::ilogb(2.0 * size);
    let step = libm::ldexp(1.0, exponent + i32::from(libm::ldexp(1.0, exponent) < 2.0 * size));
    let cut = |x: f64| {
        // Beyond 2^53 steps every double is a multiple of the step.
        let steps = x / step;
        if steps.is_finite() { libm::trunc(steps) * step } else { x }
    };
    Point::new(cut(first.x), cut(first.y), cut(first.z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn differences_to_the_anchor_are_exact(
            place in prop::array::uniform3(-1e3..1e3f64),
            shape in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 1..8),
            (far, size) in (-40..80i32, -40..40i32),
        ) {
            let (far, size) = (libm::ldexp(1.0, far), libm::ldexp(1.0, size));
            let at = |k: usize, d: usize| far * place[d] + size * shape[k][d];
            let points: Vec<Point> = (0..shape.len()).map(|k| Point::new(at(k, 0), at(k, 1), at(k, 2))).collect();
            let (origin, extent) = (anchor(&points), extent(&points));
            for &p in &points {
                let near = p - origin;
                prop_assert_eq!(near + origin, p);
                prop_assert!([near.x, near.y, near.z].iter().all(|c| c.abs() <= 6.0 * extent));
                // Exact: the difference has no rounding (two-sum).
                for (x, o, d) in [(p.x, origin.x, near.x), (p.y, origin.y, near.y), (p.z, origin.z, near.z)] {
                    let back = d - x;
                    prop_assert_eq!((x - (d - back)) + (-o - back), 0.0);
                }
            }
        }
    }

    #[test]
    fn what_lies_at_the_origin_stays() {
        let frame = [[-1.0, 0.0, 0.5], [1.0, 1.0, 0.0]].map(Point::from);
        assert_eq!(anchor(&frame), Point::ZERO);
        assert_eq!(anchor(&frame.map(|p| p * 1e-300)), Point::ZERO);
        assert_eq!(anchor(&[]), Point::ZERO);
        let one = Point::new(1.0, 2.0, 3.0);
        assert_eq!(anchor(&[one, one]), one);
        assert_eq!(anchor(&[one, Point::new(f64::INFINITY, 0.0, 0.0)]), Point::ZERO);
    }
}
