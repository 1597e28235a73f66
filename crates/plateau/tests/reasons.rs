//! What a least area says of why it ended is true: held against what its own polish by other tolerances finds, and against finer rules.

#[allow(dead_code)] // other laws use the rest of it
mod frames;

use energy::area;
use frames::{frame, sheet};
use plateau::{AreaEnd, AreaExtremal, ValleyEnd, least_area, least_area_complex_near};
use surfaces::{Complex, Net, Patch, Point, TensorPatch, discrete_coons};

/// A tolerance at which the area counts for more than the parametrisation.
const BETTER: f64 = 1e-12;

/// The border of a net that is flat and straight but for a corner, which turns in.
fn re_entrant() -> Net {
    let line = |a: Point, b: Point| (0..=3).map(|k| a + (b - a) * (f64::from(k) / 3.0)).collect::<Vec<_>>();
    let corners =
        [(0.0, 0.0), (0.0, 3.0), (3.0, 0.0), (1.0, 1.2)].map(|(x, y)| Point::new(x, y, 0.1 * x * y));
    let [a, b, c, d] = corners;
    Net::from_boundary(&line(a, b), &line(c, d), &line(a, c), &line(b, d)).unwrap()
}

/// The border of a flat sheet.
fn flat(seed: u64) -> Net {
    let level = |side: Vec<Point>| side.into_iter().map(|p| Point::new(p.x, p.y, 0.0)).collect::<Vec<_>>();
    let [u0, u1, v0, v1] = sheet(seed).boundary().map(level);
    Net::from_boundary(&u0, &u1, &v0, &v1).unwrap()
}

/// A border one side of which is a point.
fn collapsed() -> Net {
    let apex = Point::new(0.0, 0.0, 1.0);
    let side = |x: f64, y: f64| vec![apex, Point::new(0.6 * x, 0.6 * y, 0.9), Point::new(x, y, 0.0)];
    let arc = vec![Point::new(1.0, 0.0, 0.0), Point::new(1.0, 1.0, 0.3), Point::new(0.0, 1.0, 0.0)];
    Net::from_boundary(&[apex; 3], &arc, &side(1.0, 0.0), &side(0.0, 1.0)).unwrap()
}

/// Enneper's surface over [−a, a]²: beyond a = 1 it is unstable.
fn enneper(a: f64) -> Net {
    // The blossoms of 1, u, u², u³ at 3 − k times −a and k times a.
    let blossoms = |k: usize| {
        let [x, y, z] = [0, 1, 2].map(|i| if i < k { a } else { -a });
        [1.0, (x + y + z) / 3.0, (x * y + y * z + z * x) / 3.0, x * y * z]
    };
    let points = (0..16).map(|index| {
        let (u, v) = (blossoms(index / 4), blossoms(index % 4));
        let p = |i: usize, j: usize| u[i] * v[j];
        Point::new(p(1, 0) - p(3, 0) / 3.0 + p(1, 2), p(0, 3) / 3.0 - p(0, 1) - p(2, 1), p(2, 0) - p(0, 2))
    });
    Net::new(4, 4, points.collect()).unwrap()
}

/// The least over the mean area density on a grid, which holds the border.
fn evenness(patch: &TensorPatch) -> f64 {
    let grid = || (0..=60).map(|k| f64::from(k) / 60.0);
    let density = |u, v| patch.jet(u, v).area_density();
    let densities: Vec<f64> = grid().flat_map(|u| grid().map(move |v| density(u, v))).collect();
    densities.iter().copied().fold(f64::INFINITY, f64::min) * densities.len() as f64
        / densities.iter().sum::<f64>()
}

/// How far the furthest control point lies from a control point of the border, over the largest distance of two of these.
fn far(net: &Net) -> f64 {
    let border = net.boundary().concat();
    let size = border.iter().flat_map(|a| border.iter().map(|b| a.distance(*b))).fold(0.0, f64::max);
    let from_border = |p: &Point| border.iter().map(|b| b.distance(*p)).fold(f64::INFINITY, f64::min);
    net.points().iter().map(from_border).fold(0.0, f64::max) / size
}

struct Case {
    patch: TensorPatch,
    found: AreaExtremal,
    coons: TensorPatch,
    tolerance: f64,
}

impl Case {
    fn new(net: &Net, tolerance: f64) -> Self {
        // Of one degree both ways, as the faces of complexes are: what is gained from where it ended is then gained among its own.
        let net = &Complex::of_net(net).unwrap().net(0).unwrap();
        let [u0, u1, v0, v1] = net.boundary();
        let coons = TensorPatch::bernstein(discrete_coons(&u0, &u1, &v0, &v1).unwrap()).unwrap();
        let (patch, found) =
            least_area(&TensorPatch::bernstein(net.clone()).unwrap(), tolerance, &()).unwrap();
        Self { patch, found, coons, tolerance }
    }

    /// What the same steps gain from where they ended, as a share of the area, with how even that is in shares of the Coons patch's.
    fn gained(&self, tolerance: f64) -> (f64, f64) {
        let complex = Complex::of_net(self.patch.net()).unwrap();
        let (better, found) = least_area_complex_near(&complex, tolerance, &()).unwrap();
        let patch = better.patch(0).unwrap();
        (1.0 - found.area.value / self.found.area.value, evenness(&patch) / evenness(&self.coons))
    }

    /// What is said and is not so.
    fn false_sentences(&self) -> Vec<String> {
        let (found, mut wrong) = (&self.found, Vec::new());
        let mut demand = |holds: bool, what: String| {
            if !holds {
                wrong.push(format!("{what}: {} {found:?}", found.reason()));
            }
        };
        // Of twice as many points and more: the rule of the figures settles by itself.
        let finer = area(&self.patch).unwrap();
        let apart = (finer.value - found.area.value).abs();
        if found.area.settled && finer.settled {
            let allowed = (1e-9 * finer.value).max(found.area.error + finer.error);
            demand(apart <= allowed, format!("settled, but a finer rule is {apart:.1e} away"));
        }
        match found.end {
            AreaEnd::Stationary => demand(found.gradient <= 1e-7, "the gradient is no rounding".into()),
            AreaEnd::Rough => demand(found.gradient > 1e-12, "the gradient is rounding".into()),
            AreaEnd::Budget => demand(found.normal_steps.steps <= 20, "not all steps were made".into()),
            _ => demand(false, "an end that no law is known for".into()),
        }
        let valley = found.valley;
        match valley {
            ValleyEnd::Tolerance => {
                let (gain, _) = self.gained(self.tolerance);
                demand(gain <= 10.0 * self.tolerance, format!("the same steps gain {gain:.1e}"));
            }
            ValleyEnd::Rounding => {
                let (gain, _) = self.gained(BETTER);
                demand(gain <= 1e-10, format!("further steps gain {gain:.1e}"));
            }
            ValleyEnd::Ratio | ValleyEnd::Reach => {
                let (gain, ratio) = self.gained(BETTER);
                let nearly_folds = ratio < 0.15 || gain <= 10.0 * self.tolerance;
                demand(
                    valley == ValleyEnd::Reach || nearly_folds,
                    format!("{gain:.1e} less at ratio {ratio}"),
                );
            }
            ValleyEnd::Singular => demand(found.jacobian_ratio <= 1e-6, "the surface is regular".into()),
            ValleyEnd::Budget => demand(found.steps.steps >= 24, "not all steps were made".into()),
            ValleyEnd::Far => {
                let ratio = evenness(&self.patch) / evenness(&self.coons);
                let far = far(self.patch.net());
                demand(ratio < 0.12 || far > 0.5, format!("even to {ratio:.2}, near to {far:.2}"));
            }
            _ => demand(false, "an end that no law is known for".into()),
        }
        wrong
    }
}

#[test]
fn reasons_for_stopping_are_true() {
    let mut wrong = Vec::new();
    let seeds = std::env::var("LAWS").ok().and_then(|text| text.parse().ok()).unwrap_or(10);
    let random = (0..seeds).map(|seed| (format!("{seed} {:?}", frame(seed).0), frame(seed).1));
    let sheets = (0..seeds / 5).map(|seed| (format!("sheet {seed}"), sheet(seed)));
    let others = [("re-entrant", re_entrant()), ("flat", flat(1)), ("collapsed", collapsed())];
    let others = others.into_iter().map(|(name, net)| (name.to_owned(), net.raised(1)));
    for (name, net) in random.chain(sheets).chain(others) {
        for tolerance in [1e-6, 1e-9] {
            let case = Case::new(&net, tolerance);
            wrong.extend(
                case.false_sentences().into_iter().map(|what| format!("{name} at {tolerance:e}: {what}")),
            );
        }
    }
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_saddle_that_is_left_is_one() {
    let net = enneper(1.3);
    let saddle = area(&TensorPatch::bernstein(net.clone()).unwrap()).unwrap().value;
    let (_, found) = least_area(&TensorPatch::bernstein(net.raised(2)).unwrap(), 1e-9, &()).unwrap();
    // Enneper's surface has the symmetry of its border, the surfaces of less area have not: a descent that keeps it ends there.
    assert!(found.left_saddle, "{found:?}");
    assert!(found.area.value < saddle * (1.0 - 1e-4), "{saddle} {found:?}");
    assert!(found.second_variation.is_some_and(|sigma| sigma > 0.0), "{found:?}");
    let (_, stable) = least_area(&TensorPatch::bernstein(enneper(0.8)).unwrap(), 1e-9, &()).unwrap();
    assert!(!stable.left_saddle && stable.second_variation.is_some_and(|sigma| sigma > 0.0), "{stable:?}");
}
