//! How large curves are, and whether they are more than a point and a line.

use plateau::MIN_SIZE;
use surfaces::Point;

use super::AssemblyError;
use crate::CurveFile;

/// Coordinates that differ by this share of their size differ by rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Points no more than this many times their rounding apart say little about where they were meant to be.
const BLURRED: f64 = 100.0;

/// Share of the size by which points of a line may lie beside it.
const STRAIGHT: f64 = 1e-12;

/// How far rounding of its coordinates may have moved a point.
pub(super) fn rounding(p: Point) -> f64 {
    ROUNDING * p.norm()
}

/// The diagonal of the box around all curves.
pub(super) fn size(file: &CurveFile) -> Result<f64, AssemblyError> {
    let mut bounds: Option<[Point; 2]> = None;
    for p in points(file) {
        let [low, high] = bounds.unwrap_or([p, p]);
        let pick =
            |f: fn(f64, f64) -> f64, a: Point, b: Point| Point::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));
        bounds = Some([pick(f64::min, low, p), pick(f64::max, high, p)]);
    }
    let Some([low, high]) = bounds else { return Err(AssemblyError::NoSize) };
    let across = high - low;
    // Not the diagonal: squares of small numbers vanish.
    let extent = across.x.max(across.y).max(across.z);
    if extent == 0.0 {
        // Where numbers are whole at best it is hardly the points that are to blame.
        return Err(if step(low) > 1.0 { far(low) } else { AssemblyError::NoSize });
    }
    let size = across.norm();
    if size < MIN_SIZE {
        return Err(AssemblyError::TooNear { extent });
    }
    if size.is_finite() { Ok(size) } else { Err(AssemblyError::TooFarApart { extent }) }
}

/// Refuses curves that together are one straight line, to rounding.
pub(super) fn unless_line(file: &CurveFile, size: f64) -> Result<(), AssemblyError> {
    let Some(first) = points(file).next() else { return Ok(()) };
    let points: Vec<Point> = points(file).collect();
    if !are_beside(&points, size, farthest(&points, first)) {
        return Ok(());
    }
    Err(if size <= BLURRED * rounding(first) { far(first) } else { AssemblyError::Line })
}

/// Whether points lie beside the line from the first of them to another by no more than rounding. All is counted from the first: how far
/// the origin is, is nothing but a matter of digits.
fn are_beside(points: &[Point], size: f64, end: Point) -> bool {
    let first = points[0];
    let Some(direction) = (end - first).unit() else { return false };
    let width = (STRAIGHT * size).max(rounding(first));
    points.iter().all(|p| (*p - first).cross(direction).norm() <= width)
}

/// Whether points, one at least, run along the straight line from the first to the last, to rounding of curves of some size.
pub fn is_straight(points: &[Point], size: f64) -> bool {
    let (first, last) = (points[0], points[points.len() - 1]);
    are_beside(points, size, last)
        && points.windows(2).all(|pair| (pair[1] - pair[0]).dot(last - first) > 0.0)
}

fn farthest(points: &[Point], first: Point) -> Point {
    let farther = |a: Point, b: Point| if first.distance(b) > first.distance(a) { b } else { a };
    points.iter().copied().fold(first, farther)
}

fn points(file: &CurveFile) -> impl Iterator<Item = Point> {
    file.curves.iter().flat_map(|curve| curve.shape.sampled())
}

fn far(p: Point) -> AssemblyError {
    AssemblyError::Far { distance: p.norm(), step: step(p) }
}

/// How far apart neighbouring numbers are at the largest coordinate of a point.
fn step(p: Point) -> f64 {
    let largest = p.x.abs().max(p.y.abs()).max(p.z.abs());
    largest.next_up() - largest
}
