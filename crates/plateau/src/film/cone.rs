//! Two loops so far apart that nothing spans both.
//!
//! All catenoids r = c cosh(z/c) about an axis touch one cone, r = sinh(τ) |z| with τ tanh τ = 1, from outside. A connected surface of least area whose rim lies in
//! both halves of that cone would cross the plane z = 0, lie within the catenoid of a large c, and touch from within that of the largest c it does not lie within; by the
//! maximum principle it would be that catenoid, whose rim does not lie in the cone. So there is none, be it an annulus or anything else.

use surfaces::Point;

use crate::Loop;

/// The slope of the cone: sinh τ.
const SLOPE: f64 = 1.508_879_561_538_32;
/// By how much more than its argument moves the height over the cone may change: √(1 + slope²).
const LIPSCHITZ: f64 = 1.810_2;
/// Samples of a loop by which a cone is looked for, and by which one is confirmed.
const SAMPLES: [usize; 2] = [48, 1024];
/// Halvings of the steps in which a cone is looked for, and steps of each length at most.
const HALVINGS: usize = 24;
const STEPS: usize = 12;
/// The first step, as a share of the distance of the loops, and an angle.
const FIRST: f64 = 0.1;

/// A cone with one loop in each of its halves.
#[derive(Clone, Copy)]
pub(super) struct Cone {
    pub(super) apex: Point,
    /// A unit vector towards the second loop.
    pub(super) axis: Point,
}

/// Samples of a loop and how far it may pass from the chords between them.
struct Samples {
    points: Vec<Point>,
    sag: f64,
}

impl Samples {
    fn of(around: &Loop, wanted: usize) -> Self {
        let curves = around.curves();
        let each = wanted.div_ceil(curves.len().max(1)).max(4);
        let (mut points, mut sag) = (Vec::new(), 0.0_f64);
        for curve in curves {
            let of_curve: Vec<Point> = (0..=each).map(|k| curve.point(k as f64 / each as f64)).collect();
            let second = |w: &[Point]| (w[0] + w[2] - w[1] * 2.0).norm();
            // Twice what a parabola through three samples has.
            sag = of_curve.windows(3).map(second).fold(sag, |sag, second| sag.max(0.25 * second));
            points.extend(of_curve);
        }
        Self { points, sag }
    }

    /// The centroid of the loop; none of a loop in one point.
    fn middle(&self) -> Option<Point> {
        let (mut sum, mut length) = (Point::ZERO, 0.0);
        for ends in self.points.windows(2) {
            let chord = ends[0].distance(ends[1]);
            sum += (ends[0] + ends[1]) * (0.5 * chord);
            length += chord;
        }
        (length > 0.0).then(|| sum * (1.0 / length))
    }
}

impl Cone {
    /// The largest height of points of either loop over its half of the cone: not positive where they lie in it.
    fn height(&self, first: &[Point], second: &[Point]) -> f64 {
        let of = |points: &[Point], axis: Point| {
            let height = |p: &Point| {
                let away = *p - self.apex;
                let along = away.dot(axis);
                (away - axis * along).norm() - SLOPE * along
            };
            points.iter().map(height).fold(f64::NEG_INFINITY, f64::max)
        };
        of(first, self.axis * -1.0).max(of(second, self.axis))
    }

    /// The same without coordinates that are no more than rounding.
    fn rounded(self, size: f64) -> Self {
        let round = |p: Point, of: f64| {
            Point::from([p.x, p.y, p.z].map(|x| if x.abs() <= 1e-12 * of { 0.0 } else { x }))
        };
        Self { apex: round(self.apex, size), axis: round(self.axis, 1.0) }
    }

    /// The cones a step away: the apex moved, or the axis turned about it.
    fn neighbours(&self, step: f64, size: f64) -> impl Iterator<Item = Self> + use<'_> {
        let unit = |k: usize| Point::from(std::array::from_fn(|axis| f64::from(u8::from(axis == k))));
        (0..12).filter_map(move |k| {
            let by = unit(k % 3) * if k % 2 == 0 { step } else { -step };
            match k < 6 {
                true => Some(Self { apex: self.apex + by * size, ..*self }),
                false => Some(Self { axis: (self.axis + by).unit()?, ..*self }),
            }
        })
    }
}

/// A cone that shows that nothing connected of least area spans two loops, if one was found.
pub(super) fn between(first: &Loop, second: &Loop) -> Option<Cone> {
    let [coarse, fine] = SAMPLES.map(|count| [first, second].map(|around| Samples::of(around, count)));
    let (from, to) = (coarse[0].middle()?, coarse[1].middle()?);
    let (size, axis) = (from.distance(to), (to - from).unit()?);
    let wide = |around: &Samples, middle: Point| {
        around.points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max)
    };
    let (near, far) = (wide(&coarse[0], from), wide(&coarse[1], to));
    let mut best = Cone { apex: from + (to - from) * (near / (near + far)), axis };
    let height = |cone: &Cone, samples: &[Samples; 2]| cone.height(&samples[0].points, &samples[1].points);
    let is_proof =
        |cone: &Cone| height(cone, &fine) < -LIPSCHITZ * fine[0].sag.max(fine[1].sag) - 1e-9 * size;
    let (mut lowest, mut step) = (height(&best, &coarse), FIRST);
    for _ in 0..HALVINGS {
        if lowest < 0.0 && is_proof(&best) {
            return Some(best.rounded(size));
        }
        for _ in 0..STEPS {
            let next = best.neighbours(step, size).map(|cone| (height(&cone, &coarse), cone));
            let Some((height, cone)) = next.min_by(|a, b| a.0.total_cmp(&b.0)) else { break };
            if height >= lowest {
                break;
            }
            (lowest, best) = (height, cone);
        }
        step *= 0.5;
    }
    (lowest < 0.0 && is_proof(&best)).then(|| best.rounded(size))
}
