//! Fits by twice continuously differentiable quintics.
//!
//! GT, TB–Coons, AHT and AT patches are no B-splines: they are interpolated by biquintic splines with triple knots that share
//! position and the first two derivatives with the patch at every knot, so that the spline is twice continuously
//! differentiable. Its control points are blossoms: with l, t, r three knots in a row and a quintic f,
//!
//! ```text
//! f[t, t, t, x, y] = f(t) + ((x − t) + (y − t)) f'(t)/5 + (x − t)(y − t) f''(t)/20,   (x, y) = (l, l), (l, r), (r, r).
//! ```

use bases::{Basis, Matrix};
use thiserror::Error;

use super::surface::sum;
use super::{Knots, SplineSurface};
use crate::{Patch, Pieces, Point, TensorPatch, extent};

/// Most control points of a fit.
const LARGEST_NET: usize = 300_000;

/// What the largest distance on the grid of a measurement is multiplied by, for what may lie between its points.
const MARGIN: f64 = 1.25;

/// Steps between two knots of the grid a fit is measured on.
const STEPS: usize = 8;

/// Segments of a piece in one direction that are tried.
const SEGMENTS: [usize; 15] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192];

/// Why a surface has no fit.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SplineFitError {
    /// The tolerance is below what fits reach.
    #[error(
        "no B-spline of up to {max} control points was found within {asked:.1e} of the patch, the best within \
         {reached:.1e}: allow a larger tolerance (a share of the size, which is {size:.3e}); below about 1e-13 rounding \
         ends all fits",
        max = LARGEST_NET
    )]
    Tolerance {
        /// The distance asked for.
        asked: f64,
        /// The distance reached.
        reached: f64,
        /// Diagonal of the box around points of the surface.
        size: f64,
    },
    /// One segment a piece is too many.
    #[error(
        "the surface has too many pieces for one B-spline of up to {max} control points: shorten its spans",
        max = LARGEST_NET
    )]
    TooManyPieces,
    /// The surface overflows.
    #[error("the patch has points or derivatives beyond double precision: scale its boundary")]
    NotFinite,
}

/// A B-spline surface near another surface.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineFit {
    /// The spline.
    pub surface: SplineSurface,
    /// Points of the two at equal parameters are no farther apart: 1.25 times the largest distance on a grid of eight steps
    /// between two knots, in each direction.
    pub deviation: f64,
    /// What the tolerance is a share of: the diagonal of the box around points of the surface.
    pub size: f64,
}

impl SplineFit {
    /// The biquintic, twice continuously differentiable spline within `tolerance` times the size of a patch of any functions.
    ///
    /// # Errors
    /// [`SplineFitError`].
    pub fn of_patch(patch: &TensorPatch, tolerance: f64) -> Result<Self, SplineFitError> {
        let cuts = patch.rectangle().map(|(start, end)| vec![start, end]);
        Grid { cuts, patches: std::slice::from_ref(patch), whole: patch }.fit(tolerance)
    }

    /// The same of a surface in pieces, whose cuts are knots.
    ///
    /// # Errors
    /// [`SplineFitError`].
    pub fn of_pieces(pieces: &Pieces, tolerance: f64) -> Result<Self, SplineFitError> {
        let cuts = pieces.cuts().map(<[f64]>::to_vec);
        Grid { cuts, patches: pieces.patches(), whole: pieces }.fit(tolerance)
    }
}

/// A surface of patches with separated variables that meet along parameter lines.
struct Grid<'a> {
    cuts: [Vec<f64>; 2],
    /// Row by row, with u.
    patches: &'a [TensorPatch],
    whole: &'a dyn Patch,
}

impl Grid<'_> {
    fn fit(&self, tolerance: f64) -> Result<SplineFit, SplineFitError> {
        let size = self.size();
        if !size.is_finite() {
            return Err(SplineFitError::NotFinite);
        }
        let asked = tolerance * size;
        // Each direction alone first, to half the tolerance; then both, finer until the whole is within it.
        let mut places = [self.segments(0, 0.5 * asked)?, self.segments(1, 0.5 * asked)?];
        // The finer direction gives way first.
        while self.control_points(places) > LARGEST_NET {
            let finer = usize::from(places[1] > places[0]);
            places[finer] = places[finer].checked_sub(1).ok_or(SplineFitError::TooManyPieces)?;
        }
        let mut reached = f64::INFINITY;
        loop {
            let segments = places.map(|place| SEGMENTS[place]);
            let knots = [0, 1].map(|d| refined(&self.cuts[d], segments[d]));
            let spline = self.spline(knots, segments);
            let deviation = MARGIN * self.distance(&spline);
            if !deviation.is_finite() {
                return Err(SplineFitError::NotFinite);
            }
            if deviation <= asked {
                return Ok(SplineFit { surface: spline, deviation, size });
            }
            reached = reached.min(deviation);
            places = places.map(|place| place + 1);
            if places.iter().any(|&place| place == SEGMENTS.len())
                || self.control_points(places) > LARGEST_NET
            {
                return Err(SplineFitError::Tolerance { asked, reached, size });
            }
        }
    }

    /// Control points of the fit with that many segments a piece.
    fn control_points(&self, places: [usize; 2]) -> usize {
        let [u, v] = [0, 1].map(|d| 3 * ((self.cuts[d].len() - 1) * SEGMENTS[places[d]] + 1));
        u.saturating_mul(v)
    }

    /// The diagonal of the box around points of the surface: control points of AHT and AT lie far off it.
    fn size(&self) -> f64 {
        let [us, vs] = [0, 1].map(|d| refined(&self.cuts[d], STEPS));
        let along = |us: &[f64], vs: &[f64]| self.whole.jets(us, vs).into_iter().map(|jet| jet.point);
        let [middle_u, middle_v] = [us[us.len() / 2], vs[vs.len() / 2]];
        let border = along(&us, &[vs[0], middle_v, vs[vs.len() - 1]]);
        let points: Vec<Point> = border.chain(along(&[us[0], middle_u, us[us.len() - 1]], &vs)).collect();
        extent(&points)
    }

    /// The place in [`SEGMENTS`] of the least number of segments a piece with which Hermite interpolation in one direction
    /// is within `asked` of the surface, or of the largest that the net may have.
    fn segments(&self, direction: usize, asked: f64) -> Result<usize, SplineFitError> {
        let (cuts, other) = (&self.cuts[direction], 1 - direction);
        let degrees = self.patches[0].net().degrees();
        let across = refined(&self.cuts[other], 2 * [degrees.0, degrees.1][other] + 4);
        let pieces = cuts.len() - 1;
        for (place, &count) in SEGMENTS.iter().enumerate() {
            let mut worst: f64 = 0.0;
            for ends in refined(cuts, count).windows(2) {
                let (start, end) = (ends[0], ends[1]);
                // Both ends first, then three points inside.
                let shares = [0.0, 1.0, 0.3, 0.5, 0.7];
                let along = shares.map(|x| if x == 1.0 { end } else { start + x * (end - start) });
                let jets = if direction == 0 {
                    self.whole.jets(&along, &across)
                } else {
                    self.whole.jets(&across, &along)
                };
                let jet = |a: usize, b: usize| {
                    let jet =
                        // Jets come row by row with u, whichever direction is looked at.
                        if direction == 0 { jets[a * across.len() + b] } else { jets[b * along.len() + a] };
                    (jet.point, if direction == 0 { [jet.u, jet.uu] } else { [jet.v, jet.vv] })
                };
                for b in 0..across.len() {
                    for a in 2..shares.len() {
                        let fit = hermite(jet(0, b), jet(1, b), shares[a], end - start);
                        worst = worst.max(fit.distance(jet(a, b).0));
                        if !fit.is_finite() {
                            return Err(SplineFitError::NotFinite);
                        }
                    }
                }
                if worst > asked {
                    break;
                }
            }
            // The other direction has at least two knots, hence six control points: 3 (pieces · count + 1) · 6.
            if worst <= asked || 18 * (pieces * count + 1) > LARGEST_NET {
                return Ok(place);
            }
        }
        Ok(SEGMENTS.len() - 1)
    }

    /// The interpolating spline with `segments` in each piece.
    fn spline(&self, knots: [Vec<f64>; 2], segments: [usize; 2]) -> SplineSurface {
        let [rows, cols] = [3 * knots[0].len(), 3 * knots[1].len()];
        let mut points = vec![Point::ZERO; rows * cols];
        let pieces_v = self.cuts[1].len() - 1;
        for (k, patch) in self.patches.iter().enumerate() {
            let at = [k / pieces_v, k % pieces_v];
            let net = patch.net();
            let starts = patch.rectangle().map(|(start, _)| start);
            // A knot on a cut belongs to the piece after it.
            let own = [0, 1].map(|d| {
                let last = at[d] + 2 == self.cuts[d].len();
                at[d] * segments[d]..(at[d] + 1) * segments[d] + usize::from(last)
            });
            for product in patch.products() {
                // A patch keeps its own rectangle, which need not begin where its cut does.
                let shift = [0, 1].map(|d| starts[d] - self.cuts[d][at[d]]);
                let f = coefficients(product.u.as_ref(), &knots[0], own[0].clone(), shift[0]);
                let g = coefficients(product.v.as_ref(), &knots[1], own[1].clone(), shift[1]);
                // Sums over u first: a row of the net once for all control values along v.
                for a in 0..f.rows() {
                    let curve: Vec<Point> = (0..net.cols())
                        .map(|j| sum((0..net.rows()).map(|i| net.point(i, j) * f[(a, i)])))
                        .collect();
                    for b in 0..g.rows() {
                        points[(3 * own[0].start + a) * cols + 3 * own[1].start + b] +=
                            sum(curve.iter().zip(g.row(b)).map(|(p, g)| *p * *g));
                    }
                }
            }
        }
        SplineSurface { knots: knots.map(Knots::quintic), points }
    }

    /// The largest distance between the surface and a spline at equal parameters of a grid.
    fn distance(&self, spline: &SplineSurface) -> f64 {
        let steps = |knots: &[f64]| refined(knots, STEPS);
        let vs = steps(&spline.knots[1].values);
        let mut worst: f64 = 0.0;
        // Segment by segment in u: a fine grid of a long surface is large.
        for ends in spline.knots[0].values.windows(2) {
            let us = steps(ends);
            let jets = self.whole.jets(&us, &vs);
            for (jet, point) in jets.iter().zip(spline.points_at(&us, &vs)) {
                let distance = jet.point.distance(point);
                if distance.is_nan() {
                    return f64::INFINITY;
                }
                worst = worst.max(distance);
            }
        }
        worst
    }
}

/// Row 3k + c holds, for every function of a family, control value c at knot k of `own`.
fn coefficients(family: &dyn Basis, knots: &[f64], own: std::ops::Range<usize>, shift: f64) -> Matrix {
    let mut rows = Matrix::zeros(3 * own.len(), family.count());
    for (row, k) in own.enumerate() {
        let t = knots[k];
        // At an end the missing neighbour is the knot itself, which is there six times: the control value is the end point.
        let (l, r) = (knots[k.saturating_sub(1)] - t, knots[(k + 1).min(knots.len() - 1)] - t);
        let (start, end) = family.domain();
        // The shift rounds: an end of the domain must not fall outside it.
        let table = family.evaluate((t + shift).clamp(start, end), 2);
        for (c, (x, y)) in [(l, l), (l, r), (r, r)].into_iter().enumerate() {
            for i in 0..family.count() {
                rows[(3 * row + c, i)] =
                    table[(0, i)] + (x + y) / 5.0 * table[(1, i)] + x * y / 20.0 * table[(2, i)];
            }
        }
    }
    rows
}

/// The quintic with given point, first and second derivative at both ends of an interval of length h, at its share x.
fn hermite((p, [p1, p2]): (Point, [Point; 2]), (q, [q1, q2]): (Point, [Point; 2]), x: f64, h: f64) -> Point {
    // The Bézier points of the quintic: the same blossoms with the other end as neighbour.
    let start = [p, p + p1 * (h / 5.0), p + p1 * (0.4 * h) + p2 * (h * h / 20.0)];
    let end = [q + q1 * (-0.4 * h) + q2 * (h * h / 20.0), q + q1 * (-h / 5.0), q];
    let y = 1.0 - x;
    start[0] * (y * y * y * y * y)
        + start[1] * (5.0 * y * y * y * y * x)
        + start[2] * (10.0 * y * y * y * x * x)
        + end[0] * (10.0 * y * y * x * x * x)
        + end[1] * (5.0 * y * x * x * x * x)
        + end[2] * (x * x * x * x * x)
}

/// Every interval between two cuts in `count` equal parts, all ends included.
fn refined(cuts: &[f64], count: usize) -> Vec<f64> {
    let mut knots: Vec<f64> = cuts
        .windows(2)
        .flat_map(|ends| (0..count).map(|k| ends[0] + (ends[1] - ends[0]) * (k as f64 / count as f64)))
        .collect();
    knots.extend(cuts.last());
    knots
}
