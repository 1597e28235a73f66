//! What is degenerate about a boundary: the cause of singular, folded or vanishing patches, said before their figures.

use surfaces::Point;

use crate::Degeneracy;
use crate::boundary::{Boundary, Corner, TensorBoundary, TriangleBoundary};
use crate::crossing::crossing;

/// Differences below this share of the extent are rounding.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Likewise of the distance from the origin: a few units in the last place of the coordinates.
const ROUNDING_FAR: f64 = 4.0 * f64::EPSILON;

/// Sine of an angle that counts as 0 or 180°.
const PARALLEL: f64 = 1e-9;

/// Extent of a boundary, as a share of its distance from the origin, below which coordinates have lost half their digits.
const FAR: f64 = 1e-8;

/// Straight pieces into which a side is cut where crossings are looked for: an odd number, so that the middle of a side,
/// where symmetric boundaries cross, is the middle of a piece.
const PIECES: usize = 47;

/// A side of the boundary under its name in the experiment file.
struct Side {
    name: &'static str,
    points: Vec<Point>,
}

impl Side {
    fn new(name: &'static str, points: &[Point]) -> Self {
        Self { name, points: points.to_vec() }
    }

    fn reversed(&self) -> Vec<Point> {
        self.points.iter().rev().copied().collect()
    }

    fn is_point(&self, tiny: f64) -> bool {
        self.points.iter().all(|p| p.distance(self.points[0]) <= tiny)
    }

    /// The points of the Bernstein curve of the side at equal steps.
    fn sampled(&self) -> Vec<Point> {
        (0..=PIECES).map(|k| at(&self.points, k as f64 / PIECES as f64)).collect()
    }
}

/// That a boundary so large lies too far from the origin for its coordinates to tell much.
pub(crate) fn far(extent: f64, distance: f64) -> Option<Degeneracy> {
    (extent < FAR * distance).then_some(Degeneracy::Far { extent, distance })
}

/// De Casteljau.
fn at(points: &[Point], t: f64) -> Point {
    let mut row = points.to_vec();
    while row.len() > 1 {
        row = row.windows(2).map(|pair| pair[0] * (1.0 - t) + pair[1] * t).collect();
    }
    row[0]
}

/// The degeneracies of a boundary, the gravest first; none of an ordinary one.
pub fn degeneracies(boundary: &Boundary) -> Vec<Degeneracy> {
    let (near, origin) = boundary.anchored();
    found(&near, origin).into_iter().map(|degeneracy| degeneracy.moved(origin)).collect()
}

/// The degeneracies of a boundary that was given `origin` away from where it lies.
fn found(boundary: &Boundary, origin: Point) -> Vec<Degeneracy> {
    let (names, points, corners): (&[&'static str], &[Vec<Point>], &[Corner]) = match boundary {
        Boundary::Tensor(sides) => (&TensorBoundary::NAMES, sides.sides(), &TensorBoundary::CORNERS),
        Boundary::Opposite(sides) => (&sides.direction().names(), sides.sides(), &[]),
        Boundary::Triangle(sides) => (&TriangleBoundary::NAMES, sides.sides(), &TriangleBoundary::CORNERS),
    };
    let sides: Vec<Side> = names.iter().zip(points).map(|(name, points)| Side::new(name, points)).collect();
    let all: Vec<Point> = sides.iter().flat_map(|side| side.points.iter().copied()).collect();
    let first = all[0];
    // The extent from a first point is at least half of the largest distance, and at most that.
    let farthest =
        all.iter().copied().fold(first, |q, p| if p.distance(first) > q.distance(first) { p } else { q });
    let (extent, distance) =
        (farthest.distance(first), all.iter().map(|&p| (p + origin).norm()).fold(0.0, f64::max));
    let tiny = (ROUNDING * extent).max(ROUNDING_FAR * distance);
    if extent <= tiny {
        return vec![Degeneracy::OnePoint { at: first }];
    }
    // The gravest first: what comes later is looked for only where nothing before explains it.
    let mut found = Vec::new();
    // First, for what follows is then no more than its coordinates can tell.
    found.extend(far(extent, distance));
    let along = (farthest - first) * (1.0 / extent);
    if all.iter().all(|&p| (p - first).cross(along).norm() <= tiny) {
        found.push(Degeneracy::Straight);
        return found;
    }
    let mut grave = false;
    for side in sides.iter().filter(|side| side.is_point(tiny)) {
        grave = true;
        found.push(Degeneracy::PointSide { side: side.name, at: side.points[0] });
    }
    grave |= coincident_sides(&sides, tiny, &mut found);
    for (k, (name, ends)) in corners.iter().enumerate() {
        let here = corner_point(&sides, ends[0]);
        for (other, other_ends) in &corners[..k] {
            // Corners joined by a side that is a point are one by intention, and were told above.
            let joined =
                sides.iter().any(|side| side.is_point(tiny) && side.points[0].distance(here) <= tiny);
            if corner_point(&sides, other_ends[0]).distance(here) <= tiny && !joined {
                grave = true;
                found.push(Degeneracy::Pinched { first: other, second: name, at: here });
            }
        }
        // Parallel tangents are a consequence where sides are points or coincide.
        if !grave {
            found.extend(singular_corner(&sides, name, *ends, tiny));
        }
    }
    if !grave && !corners.is_empty() {
        found.extend(folds(&sides, corners.len(), tiny));
    }
    found
}

fn corner_point(sides: &[Side], (side, at_end): (usize, bool)) -> Point {
    let points = &sides[side].points;
    if at_end { points[points.len() - 1] } else { points[0] }
}

/// Pairs of sides through the same points.
fn coincident_sides(sides: &[Side], tiny: f64, found: &mut Vec<Degeneracy>) -> bool {
    let same =
        |a: &[Point], b: &[Point]| a.len() == b.len() && a.iter().zip(b).all(|(p, q)| p.distance(*q) <= tiny);
    let before = found.len();
    for (k, side) in sides.iter().enumerate() {
        for other in &sides[..k] {
            if !side.is_point(tiny)
                && (same(&side.points, &other.points) || same(&side.reversed(), &other.points))
            {
                found.push(Degeneracy::SameSides { first: other.name, second: side.name });
            }
        }
    }
    found.len() > before
}

/// Why both tangents at a corner are parallel, if they are.
fn singular_corner(
    sides: &[Side],
    corner: &'static str,
    ends: [(usize, bool); 2],
    tiny: f64,
) -> Option<Degeneracy> {
    // The first step of each side away from the corner: the tangents of the patch there.
    let leave = ends.map(|(k, at_end)| {
        let points = &sides[k].points;
        let n = points.len();
        if at_end { points[n - 2] - points[n - 1] } else { points[1] - points[0] }
    });
    if let Some(k) = leave.iter().position(|d| d.norm() <= tiny) {
        let (side, at_end) = ends[k];
        let n = sides[side].points.len();
        let points = if at_end { [n - 2, n - 1] } else { [0, 1] };
        return Some(Degeneracy::NoTangent { points, side: sides[side].name, corner });
    }
    let [a, b] = leave;
    (a.cross(b).norm() <= PARALLEL * a.norm() * b.norm()).then(|| {
        let angle = if a.dot(b) > 0.0 { 0 } else { 180 };
        Degeneracy::NoAngle { sides: ends.map(|(k, _)| sides[k].name), corner, angle }
    })
}

/// Where sides, read as Bernstein curves, turn back, and where a planar boundary crosses itself.
fn folds(sides: &[Side], corners: usize, tiny: f64) -> Vec<Degeneracy> {
    let curves: Vec<Vec<Point>> = sides.iter().map(Side::sampled).collect();
    let mut found = Vec::new();
    for (side, curve) in sides.iter().zip(&curves) {
        let back = curve.windows(3).find(|p| {
            // A turn of more than about 154° between two of 47 pieces is no bend of a smooth curve.
            let (a, b) = (p[1] - p[0], p[2] - p[1]);
            a.dot(b) < -0.9 * a.norm() * b.norm() && a.norm().min(b.norm()) > tiny
        });
        if let Some(p) = back {
            found.push(Degeneracy::TurnsBack { side: side.name, at: p[1] });
        }
    }
    if found.is_empty() {
        // Around the boundary: ab, bc, ca, or u0, v1, u1 backwards, v0 backwards.
        let around: Vec<Point> = match corners {
            3 => curves.concat(),
            _ => {
                let backwards = |k: usize| curves[k].iter().rev();
                curves[0].iter().chain(&curves[3]).chain(backwards(1)).chain(backwards(2)).copied().collect()
            }
        };
        found.extend(crossing(&around).map(|crossing| Degeneracy::Crossed { at: crossing.at }));
    }
    found
}
