//! A loop as a ring of Bézier pieces, with its corners.

use std::f64::consts::PI;
use std::ops::Range;

use surfaces::{Bezier, BoundaryCurve, Deviation, Point, Samples};

use super::{Cutting, CuttingError, Loop};
use crate::crossing::{crossing, meet};

/// A closed ring of pieces; piece k runs from vertex k to vertex k + 1.
#[derive(Debug, Clone)]
pub(super) struct Rim {
    pub(super) pieces: Vec<Bezier>,
    /// For every vertex, the angle inside the loop if it is a corner.
    pub(super) corners: Vec<Option<f64>>,
    pub(super) deviation: Deviation,
}

impl Rim {
    /// As [`Self::new`]; a loop in a plane that crosses itself is refused.
    pub(super) fn uncrossed(around: &Loop, cutting: &Cutting) -> Result<Self, CuttingError> {
        let rim = Self::new(around, cutting)?;
        match rim.crossing() {
            Some(at) => Err(CuttingError::Crosses { at: at.into() }),
            None => Ok(rim),
        }
    }

    /// The pieces of a loop, its curves fitted, welded, and cut at corners of samples.
    fn new(around: &Loop, cutting: &Cutting) -> Result<Self, CuttingError> {
        let (mut pieces, mut deviation): (Vec<Bezier>, _) = (Vec::new(), Deviation::default());
        for (curve, given) in around.curves().iter().enumerate() {
            let mut begins = true;
            for part in parts(given, around.curves().len() == 1) {
                let fit = part
                    .fit(cutting.degree, cutting.tolerance)
                    .map_err(|error| CuttingError::Curve { curve, error })?;
                deviation = deviation.and(fit.deviation());
                for piece in fit.pieces() {
                    let end = pieces.last().filter(|_| std::mem::take(&mut begins)).map(Bezier::end);
                    pieces.push(end.map_or_else(|| piece.clone(), |end| piece.with_ends(end, piece.end())));
                }
            }
        }
        check_count(pieces.len())?;
        let start = pieces[0].start();
        if let Some(last) = pieces.last_mut() {
            *last = last.with_ends(last.start(), start);
        }
        // What is moved to a point at distance d moves the curve by at most d, over the length of a piece.
        let welded = around.welded();
        let longest = pieces.iter().map(length).fold(0.0, f64::max);
        deviation = deviation.and(Deviation { largest: welded, area: 0.5 * welded * longest });
        Ok(Self::of_pieces(pieces, deviation, cutting.corner_angle))
    }

    /// The ring of given pieces, with the corners where its direction turns by more than `corner_angle`.
    pub(super) fn of_pieces(pieces: Vec<Bezier>, deviation: Deviation, corner_angle: f64) -> Self {
        let corners = vec![None; pieces.len()];
        let mut rim = Self { pieces, corners, deviation };
        rim.find_corners(corner_angle);
        rim
    }

    /// Number of pieces, and of vertices.
    pub(super) fn len(&self) -> usize {
        self.pieces.len()
    }

    /// The vertices that are corners.
    pub(super) fn corner_vertices(&self) -> Vec<usize> {
        (0..self.len()).filter(|&k| self.corners[k].is_some()).collect()
    }

    /// Whether all corners are between 30° and 150°.
    pub(super) fn is_tame(&self) -> bool {
        self.corners.iter().flatten().all(|&angle| is_tame(angle))
    }

    /// Halves the longest pieces until there are at least `count`.
    pub(super) fn with_at_least(mut self, count: usize) -> Self {
        while self.len() < count {
            self.halve_longest(0..self.len());
        }
        self
    }

    /// Cuts the longest piece of a range at its middle.
    pub(super) fn halve_longest(&mut self, range: Range<usize>) {
        self.halve(range.start + longest(&self.pieces[range]));
    }

    /// Cuts a piece at its middle.
    pub(super) fn halve(&mut self, piece: usize) {
        let halves = self.pieces[piece].split(0.5);
        self.pieces.splice(piece..=piece, halves);
        self.corners.insert(piece + 1, None);
    }

    /// The same ring from another vertex on.
    pub(super) fn begun_at(mut self, vertex: usize) -> Self {
        self.pieces.rotate_left(vertex);
        self.corners.rotate_left(vertex);
        self
    }

    /// The same ring run the other way, from the same vertex.
    pub(super) fn reversed(mut self) -> Self {
        self.pieces = self.pieces.into_iter().rev().map(Bezier::reversed).collect();
        self.corners[1..].reverse();
        self
    }

    /// Vertices where the direction turns by more than `least`, with the angles inside.
    fn find_corners(&mut self, least: f64) {
        let normal = self.normal();
        let count = self.len();
        for k in 0..count {
            // Bézier curves begin along the first control point that differs from the start.
            let after = self.pieces[k].direction();
            let before = -self.pieces[(k + count - 1) % count].clone().reversed().direction();
            if angle(before, after) > least {
                self.corners[k] = Some(inside(before, after, normal));
            }
        }
    }

    /// Where a loop in a plane crosses itself; none of a loop in space is looked for.
    fn crossing(&self) -> Option<Point> {
        let along = |piece: &Bezier, [from, to]: [f64; 2], count: usize| {
            (0..=count).map(|k| piece.point(from + (to - from) * uneven(k, count))).collect::<Vec<_>>()
        };
        let chords: Vec<Point> =
            self.pieces.iter().flat_map(|piece| along(piece, [0.0, 1.0], CHORDS).split_off(1)).collect();
        let found = crossing(&chords)?;
        // Chords of curves side by side may cross where the curves do not: shorter ones tell. Chord k ends with point k + 1.
        let [first, second] = found.segments.map(|k| {
            let k = (k + 1) % chords.len();
            let ends = [k % CHORDS, k % CHORDS + 1].map(|k| uneven(k, CHORDS));
            along(&self.pieces[k / CHORDS], ends, FINER)
        });
        meet(&chords, &first, &second)
    }

    /// The unit normal of the plane onto which the loop's projection has the largest area, if that is any to speak of.
    pub(super) fn normal(&self) -> Option<Point> {
        let points: Vec<Point> =
            self.pieces.iter().flat_map(|piece| (0..8).map(|k| piece.point(f64::from(k) / 8.0))).collect();
        let center = points.iter().fold(Point::ZERO, |sum, &p| sum + p) * (1.0 / points.len() as f64);
        let (mut area, mut length) = (Point::ZERO, 0.0);
        for k in 0..points.len() {
            let (a, b) = (points[k], points[(k + 1) % points.len()]);
            area += (a - center).cross(b - center) * 0.5;
            length += a.distance(b);
        }
        // A circle has 1/4π = 0.08.
        if area.norm() > 0.002 * length * length { area.unit() } else { None }
    }
}

/// Chords of a piece among which crossings are looked for, and parts of a chord to tell them from near misses.
const CHORDS: usize = 8;
const FINER: usize = 64;

/// Step k of `count` from 0 to 1, of uneven length: curves cross at thirds and middles of one another, and a crossing at the ends of chords
/// would be none.
fn uneven(k: usize, count: usize) -> f64 {
    let shift = if k == 0 || k == count { 0.0 } else { 0.381_966 };
    (k as f64 - shift) / count as f64
}

/// Most pieces of a loop, or of all curves of a graph: quads are a few times as many, and each has its own system.
const MOST_PIECES: usize = 1000;

/// That pieces are not too many.
pub(super) fn check_count(found: usize) -> Result<(), CuttingError> {
    if found > MOST_PIECES {
        return Err(CuttingError::TooManyPieces { found, max: MOST_PIECES });
    }
    Ok(())
}

/// Whether a quad may have a corner of this angle: 30° to 150°.
pub(super) fn is_tame(angle: f64) -> bool {
    (PI / 6.0..=PI * 5.0 / 6.0).contains(&angle)
}

/// The length of sixteen chords: within a few per cent of that of the curve.
pub(super) fn length(piece: &Bezier) -> f64 {
    (0..16).map(|k| piece.point(f64::from(k) / 16.0).distance(piece.point(f64::from(k + 1) / 16.0))).sum()
}

/// The longest of some pieces, the first of those as long but for rounding.
pub(super) fn longest(pieces: &[Bezier]) -> usize {
    let lengths: Vec<f64> = pieces.iter().map(length).collect();
    (1..lengths.len()).fold(0, |l, k| if lengths[k] > lengths[l] * (1.0 + 1e-9) { k } else { l })
}

/// The angle between two directions, 0 to π.
fn angle(a: Point, b: Point) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b))
}

/// The angle inside a loop, 0 to 2π, where the direction `before` turns into `after`: seen along the normal of the loop, in
/// space where one of them runs along that or there is none.
fn inside(before: Point, after: Point, normal: Option<Point>) -> f64 {
    let flat = normal.map(|normal| [before, after].map(|d| (d - normal * normal.dot(d), normal)));
    match flat {
        Some([(a, normal), (b, _)]) if a.norm() > 0.1 * before.norm() && b.norm() > 0.1 * after.norm() => {
            PI - libm::atan2(normal.dot(a.cross(b)), a.dot(b))
        }
        Some(_) | None => PI - angle(before, after),
    }
}

/// Samples between corners, any other curve as it is. A closed curve that is a loop of its own begins at a corner, if it
/// has one.
pub(super) fn parts(curve: &BoundaryCurve, is_alone: bool) -> Vec<BoundaryCurve> {
    let BoundaryCurve::Through(samples) = curve else { return vec![curve.clone()] };
    let mut points = samples.points().to_vec();
    let last = points.len() - 1;
    let is_ring = is_alone && points[0] == points[last];
    let mut cuts = corners_of(&points, samples, is_ring);
    if is_ring && let Some(&first) = cuts.first() {
        points.pop();
        points.rotate_left(first);
        points.push(points[0]);
        cuts = cuts.iter().map(|cut| cut - first).filter(|cut| *cut > 0).collect();
    }
    cuts.insert(0, 0);
    cuts.push(last);
    let part = |ends: &[usize]| {
        Samples::new(points[ends[0]..=ends[1]].to_vec(), samples.tolerance()).map(BoundaryCurve::Through)
    };
    // A part between two corners has two points that differ, so none is refused.
    cuts.windows(2).filter_map(|ends| part(ends).ok()).collect()
}

/// The samples where the chain turns by more than they admit, seen from the nearest ones that the tolerance can tell
/// from it; 0 among them only in a ring.
fn corners_of(points: &[Point], samples: &Samples, is_ring: bool) -> Vec<usize> {
    let last = points.len() - 1;
    let near = 10.0 * samples.tolerance();
    let turn = |k: usize| {
        let far = |j: &usize| points[*j].distance(points[k]) > near;
        let before =
            if is_ring { (1..last).map(|d| (k + last - d) % last).find(far) } else { (0..k).rev().find(far) };
        let after =
            if is_ring { (1..last).map(|d| (k + d) % last).find(far) } else { (k + 1..=last).find(far) };
        match (before, after) {
            (Some(a), Some(b)) => angle(points[k] - points[a], points[b] - points[k]),
            (None, _) | (_, None) => 0.0,
        }
    };
    let first = usize::from(!is_ring);
    // Regular polygons with exactly this turn are smooth whatever rounding does.
    let least = samples.corner_degrees().to_radians() * (1.0 + 1e-6);
    (first..last).filter(|&k| turn(k) > least).collect()
}
