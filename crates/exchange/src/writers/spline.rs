//! B-spline surfaces, the form in which CAD programs hold a patch.
//!
//! Bernstein patches are B-splines. GT, TB–Coons, AHT and AT patches are not: they are interpolated by biquintic splines with
//! triple knots that share position and the first two derivatives with the patch at every knot, so that the spline is twice
//! continuously differentiable. Its control points are blossoms: with l, t, r three knots in a row and a quintic f,
//!
//! ```text
//! f[t, t, t, x, y] = f(t) + ((x − t) + (y − t)) f'(t)/5 + (x − t)(y − t) f''(t)/20,   (x, y) = (l, l), (l, r), (r, r).
//! ```

use bases::{Basis, Matrix};
use surfaces::{Domain, Patch, Point, TensorPatch, TrianglePatch};
use thiserror::Error;

use plateau::{Family, Surface};

/// Largest degree OpenCASCADE, and with it FreeCAD, takes.
pub(super) const LARGEST_DEGREE: usize = 25;

/// Most control points of a fit.
const LARGEST_NET: usize = 300_000;

/// What the largest distance on the grid of a measurement is multiplied by, for what may lie between its points.
const MARGIN: f64 = 1.25;

/// Steps between two knots of the grid a fit is measured on.
const STEPS: usize = 8;

/// Segments of a piece in one direction that are tried.
const SEGMENTS: [usize; 15] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192];

/// Why a surface has no spline.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SplineError {
    /// Polynomials of high degree are refused by the programs that read the file.
    #[error(
        "the triangular patch has degree {degree}, and OpenCASCADE reads degrees up to {max}: run the method on a boundary \
         of lower degree, or export a mesh (glb, ply)",
        max = LARGEST_DEGREE
    )]
    Degree {
        /// Degree of the patch.
        degree: usize,
    },
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
    /// A surface of several faces is no single spline.
    #[error("the surface has several faces that share edges: no single B-spline holds it")]
    Faces,
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

/// A tensor product B-spline surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    pub(crate) knots: [Knots; 2],
    pub(crate) points: Vec<Point>,
}

/// The knots of one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Knots {
    pub(crate) degree: usize,
    /// Ascending.
    pub(crate) values: Vec<f64>,
    /// How often each is repeated; degree + 1 at the ends.
    pub(crate) multiplicities: Vec<usize>,
}

/// How a [`Spline`] came about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// It is the patch, up to the rounding of its control points.
    Exact,
    /// It is a fit.
    Fitted {
        /// Points at equal parameters are no farther apart: the largest distance measured, times a margin.
        deviation: f64,
        /// What the tolerance is a share of: the diagonal of the box around points of the surface.
        size: f64,
    },
}

impl Spline {
    /// The spline of a surface, exact if it can be, otherwise within `tolerance` times its size.
    ///
    /// # Errors
    /// [`SplineError`].
    pub fn of(surface: &Surface, family: Family, tolerance: f64) -> Result<(Self, Accuracy), SplineError> {
        match surface {
            Surface::Tensor(patch) if family == Family::Bernstein && exact_degrees(patch) => {
                Ok((Self::bernstein(patch), Accuracy::Exact))
            }
            Surface::Tensor(patch) => {
                let [u, v] = patch.rectangle();
                Grid {
                    cuts: [vec![u.0, u.1], vec![v.0, v.1]],
                    patches: std::slice::from_ref(patch),
                    whole: patch,
                }
                .fit(tolerance)
            }
            Surface::Pieces(pieces) => {
                let cuts = pieces.cuts().map(<[f64]>::to_vec);
                Grid { cuts, patches: pieces.patches(), whole: pieces }.fit(tolerance)
            }
            Surface::Triangle(patch) => Ok((Self::triangle(patch)?, Accuracy::Exact)),
            Surface::Complex(_) => Err(SplineError::Faces),
        }
    }

    /// The knots of u and of v.
    pub fn knots(&self) -> [&Knots; 2] {
        [&self.knots[0], &self.knots[1]]
    }

    /// The control points, row by row, with u; as many in a row as `v` has functions.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    fn bernstein(patch: &TensorPatch) -> Self {
        let (m, n) = patch.net().degrees();
        Self { knots: [Knots::bernstein(m), Knots::bernstein(n)], points: patch.net().points().to_vec() }
    }

    /// The triangular patch as a rectangular one whose side u = 0 is the corner A: with barycentric coordinates
    /// `1 − s`, `s (1 − t)`, `s t` the functions are `B^n_ijk = B^n_{j+k}(s) B^{j+k}_k(t)`, so row a is a curve of degree a
    /// in t, raised to degree n.
    fn triangle(patch: &TrianglePatch) -> Result<Self, SplineError> {
        let net = patch.net();
        let n = net.degree();
        if n > LARGEST_DEGREE {
            return Err(SplineError::Degree { degree: n });
        }
        let rows = (0..=n).flat_map(|a| {
            let mut row: Vec<Point> = (0..=a).map(|k| net.point(n - a, a - k)).collect();
            while row.len() <= n {
                row = raised(&row);
            }
            row
        });
        Ok(Self { knots: [Knots::bernstein(n), Knots::bernstein(n)], points: rows.collect() })
    }

    /// Columns of the net.
    pub(crate) fn cols(&self) -> usize {
        self.knots[1].count()
    }

    /// The points at `us × vs`, all v of the first u first.
    pub(crate) fn points_at(&self, us: &[f64], vs: &[f64]) -> Vec<Point> {
        let cols = self.cols();
        let in_v: Vec<(usize, Vec<f64>)> = vs.iter().map(|&v| self.knots[1].functions(v)).collect();
        let mut points = Vec::with_capacity(us.len() * vs.len());
        for &u in us {
            let (first, f) = self.knots[0].functions(u);
            let curve: Vec<Point> = (0..cols)
                .map(|j| sum(f.iter().enumerate().map(|(i, f)| self.points[(first + i) * cols + j] * *f)))
                .collect();
            points.extend(
                in_v.iter().map(|(first, g)| sum(g.iter().enumerate().map(|(j, g)| curve[first + j] * *g))),
            );
        }
        points
    }
}

impl Knots {
    /// The Bernstein polynomials on [0, 1].
    pub(super) fn bernstein(degree: usize) -> Self {
        Self { degree, values: vec![0.0, 1.0], multiplicities: vec![degree + 1; 2] }
    }

    /// Twice continuously differentiable quintics.
    fn quintic(values: Vec<f64>) -> Self {
        let last = values.len() - 1;
        let multiplicities = (0..=last).map(|k| if k == 0 || k == last { 6 } else { 3 }).collect();
        Self { degree: 5, values, multiplicities }
    }

    /// The degree of the functions.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All knots, each as often as it is repeated.
    pub fn repeated(&self) -> Vec<f64> {
        let knots = self.values.iter().zip(&self.multiplicities);
        knots.flat_map(|(&value, &times)| std::iter::repeat_n(value, times)).collect()
    }

    /// Number of functions.
    pub fn count(&self) -> usize {
        self.multiplicities.iter().sum::<usize>() - self.degree - 1
    }

    /// The first function that does not vanish at t, and the values of the degree + 1 from it on (Cox–de Boor).
    fn functions(&self, t: f64) -> (usize, Vec<f64>) {
        let last = self.values.len() - 2;
        let segment = self.values.partition_point(|knot| *knot <= t).saturating_sub(1).min(last);
        let before: usize = self.multiplicities[..=segment].iter().sum();
        // The knots around the segment: degree of them up to its start, degree from its end on.
        let repeated = |from: &mut dyn Iterator<Item = usize>| -> Vec<f64> {
            from.flat_map(|k| std::iter::repeat_n(self.values[k], self.multiplicities[k]))
                .take(self.degree)
                .collect()
        };
        let left = repeated(&mut (0..=segment).rev());
        let right = repeated(&mut (segment + 1..self.values.len()));
        let mut values = vec![1.0];
        for p in 1..=self.degree {
            let mut next = vec![0.0; p + 1];
            for k in 0..p {
                let (start, end) = (left[p - 1 - k], right[k]);
                let share = (t - start) / (end - start);
                next[k] += values[k] * (1.0 - share);
                next[k + 1] += values[k] * share;
            }
            values = next;
        }
        (before - self.degree - 1, values)
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
    fn fit(&self, tolerance: f64) -> Result<(Spline, Accuracy), SplineError> {
        let size = self.size();
        if !size.is_finite() {
            return Err(SplineError::NotFinite);
        }
        let asked = tolerance * size;
        // Each direction alone first, to half the tolerance; then both, finer until the whole is within it.
        let mut places = [self.segments(0, 0.5 * asked)?, self.segments(1, 0.5 * asked)?];
        while self.control_points(places) > LARGEST_NET {
            let finer = usize::from(places[1] > places[0]);
            places[finer] = places[finer].checked_sub(1).ok_or(SplineError::TooManyPieces)?;
        }
        let mut reached = f64::INFINITY;
        loop {
            let segments = places.map(|place| SEGMENTS[place]);
            let knots = [0, 1].map(|d| refined(&self.cuts[d], segments[d]));
            let spline = self.spline(knots, segments);
            let deviation = MARGIN * self.distance(&spline);
            if !deviation.is_finite() {
                return Err(SplineError::NotFinite);
            }
            if deviation <= asked {
                return Ok((spline, Accuracy::Fitted { deviation, size }));
            }
            reached = reached.min(deviation);
            places = places.map(|place| place + 1);
            if places.iter().any(|&place| place == SEGMENTS.len())
                || self.control_points(places) > LARGEST_NET
            {
                return Err(SplineError::Tolerance { asked, reached, size });
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
        let along = |us: &[f64], vs: &[f64]| self.whole.jets(us, vs).into_iter().map(|jet| jet.point.into());
        let [middle_u, middle_v] = [us[us.len() / 2], vs[vs.len() / 2]];
        let border = along(&us, &[vs[0], middle_v, vs[vs.len() - 1]]);
        super::extent::diagonal(border.chain(along(&[us[0], middle_u, us[us.len() - 1]], &vs)))
    }

    /// The place in [`SEGMENTS`] of the least number of segments a piece with which Hermite interpolation in one direction
    /// is within `asked` of the surface, or of the largest that the net may have.
    fn segments(&self, direction: usize, asked: f64) -> Result<usize, SplineError> {
        let (cuts, other) = (&self.cuts[direction], 1 - direction);
        let degrees = self.patches[0].net().degrees();
        let across = refined(&self.cuts[other], 2 * [degrees.0, degrees.1][other] + 4);
        let pieces = cuts.len() - 1;
        for (place, &count) in SEGMENTS.iter().enumerate() {
            let mut worst: f64 = 0.0;
            for ends in refined(cuts, count).windows(2) {
                let (start, end) = (ends[0], ends[1]);
                let shares = [0.0, 1.0, 0.3, 0.5, 0.7];
                let along = shares.map(|x| if x == 1.0 { end } else { start + x * (end - start) });
                let jets = if direction == 0 {
                    self.whole.jets(&along, &across)
                } else {
                    self.whole.jets(&across, &along)
                };
                let jet = |a: usize, b: usize| {
                    let jet =
                        if direction == 0 { jets[a * across.len() + b] } else { jets[b * along.len() + a] };
                    (jet.point, if direction == 0 { [jet.u, jet.uu] } else { [jet.v, jet.vv] })
                };
                for b in 0..across.len() {
                    for a in 2..shares.len() {
                        let fit = hermite(jet(0, b), jet(1, b), shares[a], end - start);
                        worst = worst.max(fit.distance(jet(a, b).0));
                        if !fit.is_finite() {
                            return Err(SplineError::NotFinite);
                        }
                    }
                }
                if worst > asked {
                    break;
                }
            }
            if worst <= asked || 18 * (pieces * count + 1) > LARGEST_NET {
                return Ok(place);
            }
        }
        Ok(SEGMENTS.len() - 1)
    }

    /// The interpolating spline with `segments` in each piece.
    fn spline(&self, knots: [Vec<f64>; 2], segments: [usize; 2]) -> Spline {
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
                let shift = [0, 1].map(|d| starts[d] - self.cuts[d][at[d]]);
                let f = coefficients(product.u.as_ref(), &knots[0], own[0].clone(), shift[0]);
                let g = coefficients(product.v.as_ref(), &knots[1], own[1].clone(), shift[1]);
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
        Spline { knots: knots.map(Knots::quintic), points }
    }

    /// The largest distance between the surface and a spline at equal parameters of a grid.
    fn distance(&self, spline: &Spline) -> f64 {
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
        let (l, r) = (knots[k.saturating_sub(1)] - t, knots[(k + 1).min(knots.len() - 1)] - t);
        let (start, end) = family.domain();
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

/// A Bézier curve with its degree raised by one; points that coincide stay where they are.
fn raised(polygon: &[Point]) -> Vec<Point> {
    let n = polygon.len();
    let mut points = vec![polygon[0]];
    points.extend((1..n).map(|i| polygon[i] + (polygon[i - 1] - polygon[i]) * (i as f64 / n as f64)));
    points.push(polygon[n - 1]);
    points
}

fn exact_degrees(patch: &TensorPatch) -> bool {
    let (m, n) = patch.net().degrees();
    m.max(n) <= LARGEST_DEGREE && matches!(patch.domain(), Domain::Rectangle { u: (0.0, 1.0), v: (0.0, 1.0) })
}

fn sum(points: impl Iterator<Item = Point>) -> Point {
    points.fold(Point::ZERO, |sum, p| sum + p)
}

#[cfg(test)]
mod tests {
    use surfaces::{Helicoid, Net, ShapedFamily, TriangleNet, tb_coons};

    use super::*;

    /// A net of degree (m, n) that is not symmetric in anything.
    fn net(m: usize, n: usize) -> Net {
        let points = (0..=m)
            .flat_map(|i| (0..=n).map(move |j| (i as f64, j as f64)))
            .map(|(i, j)| Point::new(i + 0.1 * j * j, j - 0.2 * i * j, libm::sin(2.0 * i + j) + 0.3 * i));
        Net::new(m + 1, n + 1, points.collect()).unwrap()
    }

    fn steps((start, end): (f64, f64), count: usize) -> Vec<f64> {
        refined(&[start, end], count)
    }

    fn distance(surface: &Surface, spline: &Spline, count: usize) -> f64 {
        let patch = surface.patch().expect("a single patch");
        let Domain::Rectangle { u, v } = patch.domain() else { panic!("a rectangle") };
        let (us, vs) = (steps(u, count), steps(v, count));
        let jets = patch.jets(&us, &vs);
        let pairs = jets.iter().zip(spline.points_at(&us, &vs));
        pairs.map(|(jet, p)| jet.point.distance(p)).fold(0.0, f64::max)
    }

    #[test]
    fn bernstein_patches_are_exact() {
        for (m, n) in [(1, 1), (3, 2), (5, 9), (25, 4)] {
            let surface = Surface::Tensor(TensorPatch::bernstein(net(m, n)).unwrap());
            let (spline, accuracy) = Spline::of(&surface, Family::Bernstein, 1e-6).unwrap();
            assert_eq!((accuracy, spline.knots[0].degree, spline.knots[1].degree), (Accuracy::Exact, m, n));
            assert!(distance(&surface, &spline, 17) < 1e-13 * net(m, n).size());
        }
    }

    #[test]
    fn fits_are_within_their_deviation_and_that_within_the_tolerance() {
        let gt = |m, n| Surface::Tensor(TensorPatch::gt(net(m, n), [0.3, 2.0, 4.0, 1.0]).unwrap());
        let coons = Surface::Tensor(tb_coons(net(4, 3), [1.0, 0.5, 2.0, 3.0]).unwrap());
        let helicoid = Surface::Pieces(Helicoid::new(1.0, 2.0, 1.5, 12.0).unwrap().pieces().unwrap());
        let cases = [
            (gt(2, 2), Family::Shaped(ShapedFamily::Gt)),
            (gt(3, 7), Family::Shaped(ShapedFamily::Gt)),
            (coons, Family::Shaped(ShapedFamily::TbCoons)),
            (helicoid, Family::Aht),
        ];
        for (surface, family) in &cases {
            for tolerance in [1e-3, 1e-6, 1e-10] {
                let (spline, accuracy) = Spline::of(surface, *family, tolerance).unwrap();
                let Accuracy::Fitted { deviation, size } = accuracy else { panic!("{family:?} is a fit") };
                let found = distance(surface, &spline, 101);
                assert!(found <= deviation, "{family:?}, {tolerance}: {found} > {deviation}");
                assert!(deviation <= tolerance * size, "{family:?}, {tolerance}: {deviation}");
                let [u, v] = [0, 1].map(|k| spline.knots[k].count());
                assert_eq!(spline.points.len(), u * v);
            }
        }
    }

    #[test]
    fn quintic_patches_are_fitted_without_error() {
        let surface = Surface::Tensor(TensorPatch::bernstein(net(5, 5)).unwrap());
        let (spline, accuracy) = Spline::of(&surface, Family::Shaped(ShapedFamily::Gt), 1e-13).unwrap();
        assert!(matches!(accuracy, Accuracy::Fitted { deviation, size } if deviation < 1e-13 * size));
        assert_eq!(spline.knots[0].values, [0.0, 1.0]);
    }

    #[test]
    fn what_no_fit_reaches_is_refused() {
        let surface = Surface::Tensor(TensorPatch::gt(net(3, 3), [1.0; 4]).unwrap());
        let error = Spline::of(&surface, Family::Shaped(ShapedFamily::Gt), 1e-18).unwrap_err();
        assert!(matches!(error, SplineError::Tolerance { reached, .. } if reached < 1e-12), "{error}");
    }

    #[test]
    fn triangles_fold_onto_the_square() {
        for n in 1..=6 {
            let count = (n + 1) * (n + 2) / 2;
            let point = |k: f64| Point::new(k, libm::sin(3.0 * k), libm::cos(k * k));
            let net = TriangleNet::new(n, (0..count).map(|k| point(k as f64)).collect()).unwrap();
            let patch = TrianglePatch::new(net).unwrap();
            let surface = Surface::Triangle(patch.clone());
            let (spline, accuracy) = Spline::of(&surface, Family::Triangle, 1e-6).unwrap();
            assert_eq!(accuracy, Accuracy::Exact);
            for s in steps((0.0, 1.0), 7) {
                for t in steps((0.0, 1.0), 7) {
                    let (here, there) =
                        (spline.points_at(&[s], &[t])[0], patch.point(1.0 - s, s * (1.0 - t)));
                    assert!(here.distance(there) < 1e-13 * patch.net().size(), "{n}: {s}, {t}");
                }
            }
            assert!(spline.points[..=n].iter().all(|p| *p == spline.points[0]));
        }
    }
}
