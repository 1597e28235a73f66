//! What sides have in common: checks of their points, and corners made one.

use surfaces::{Point, extent};

use super::{BoundaryError, Corner, Gap, MAX_COORDINATE, MAX_DEGREE, MIN_SIZE};
use crate::Loop;

/// Checks the numbers of points and the coordinates of sides.
pub(super) fn check(names: &[&'static str], sides: &[Vec<Point>]) -> Result<(), BoundaryError> {
    for (&side, points) in names.iter().zip(sides) {
        if !(2..=MAX_DEGREE + 1).contains(&points.len()) {
            return Err(BoundaryError::Count { side, found: points.len() });
        }
        let is_admissible = |p: &Point| p.is_finite() && size(p) <= MAX_COORDINATE;
        if let Some(index) = points.iter().position(|p| !is_admissible(p)) {
            return Err(BoundaryError::Coordinate { side, index });
        }
    }
    let size = sides.iter().flatten().map(size).fold(0.0, f64::max);
    if size > 0.0 && size < MIN_SIZE {
        return Err(BoundaryError::TooSmall { size });
    }
    Ok(())
}

/// The largest |coordinate|.
fn size(p: &Point) -> f64 {
    p.x.abs().max(p.y.abs()).max(p.z.abs())
}

/// Whether two sides have as many points.
pub(super) fn as_many(names: [&'static str; 2], sides: [&[Point]; 2]) -> Result<(), BoundaryError> {
    let counts = sides.map(<[Point]>::len);
    if counts[0] == counts[1] { Ok(()) } else { Err(BoundaryError::Lengths { sides: names, counts }) }
}

/// Makes the ends of sides that lie within [`Loop::WELD`] of the size one point, halfway between them; returns their largest
/// distance before.
pub(super) fn weld(sides: &mut [Vec<Point>], corners: &[Corner]) -> Result<f64, BoundaryError> {
    let all: Vec<Point> = sides.iter().flatten().copied().collect();
    let weld = Loop::WELD * extent(&all);
    let gap = |&(corner, ends): &Corner| Gap { corner, ends, points: ends.map(|end| *end_of(sides, end)) };
    let gaps: Vec<Gap> = corners.iter().map(gap).collect();
    let apart: Vec<Gap> = gaps.iter().filter(|gap| gap.distance() > weld).copied().collect();
    if !apart.is_empty() {
        return Err(BoundaryError::Apart { gaps: apart, weld });
    }
    for gap in gaps.iter().filter(|gap| gap.points[0] != gap.points[1]) {
        let middle = (gap.points[0] + gap.points[1]) * 0.5;
        for (side, at_end) in gap.ends {
            let points = &mut sides[side];
            let k = if at_end { points.len() - 1 } else { 0 };
            points[k] = middle;
        }
    }
    Ok(gaps.iter().map(Gap::distance).fold(0.0, f64::max))
}

/// The point in which a side begins or ends.
pub(crate) fn end_of(sides: &[Vec<Point>], (side, at_end): (usize, bool)) -> &Point {
    let points = &sides[side];
    &points[if at_end { points.len() - 1 } else { 0 }]
}
