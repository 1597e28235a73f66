//! Areas known in closed form: the error that is reported is never less than the true one, and seldom far more.
//!
//! The table: `cargo test --release -p plateau-energy --test area_bounds -- --nocapture`.
#![allow(clippy::print_stdout, reason = "the table is the point")]

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use energy::{area, integrate};
use surfaces::{Domain, Helicoid, Jet, Net, Patch, Point, TensorPatch, TrapeziumHelicoid};

/// A surface in closed form: domain and tangents.
struct Closed<F>(Domain, F);

impl<F: Fn(f64, f64) -> [Point; 2] + Send + Sync> Patch for Closed<F> {
    fn domain(&self) -> Domain {
        self.0
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        let [u, v] = (self.1)(u, v);
        Jet { u, v, ..Jet::default() }
    }
}

fn closed<F: Fn(f64, f64) -> [Point; 2] + Send + Sync>(
    u: (f64, f64),
    v: (f64, f64),
    tangents: F,
) -> Closed<F> {
    Closed(Domain::Rectangle { u, v }, tangents)
}

/// A sequence that fills [from, to) evenly.
fn fill(k: usize, from: f64, to: f64) -> f64 {
    from + (to - from) * (0.5 + k as f64 * 0.618_033_988_749_894_8).fract()
}

/// Enneper's surface over [0, a] × [0, b]: a bicubic patch, the monomials written in blossoms.
fn enneper(a: f64, b: f64) -> TensorPatch {
    let power = [[1., 1., 1., 1.], [0., 1. / 3., 2. / 3., 1.], [0., 0., 1. / 3., 1.], [0., 0., 0., 1.]];
    let points = (0..16).map(|k| {
        let u = |e: usize| power[e][k / 4] * a.powi(e as i32);
        let v = |e: usize| power[e][k % 4] * b.powi(e as i32);
        Point::new(u(1) - u(3) / 3. + u(1) * v(2), v(1) - v(3) / 3. + v(1) * u(2), u(2) - v(2))
    });
    TensorPatch::bernstein(Net::new(4, 4, points.collect()).unwrap()).unwrap()
}

/// A bicubic chart of the unit square that moves its interior, so that its density is no constant.
fn square(bend: f64) -> TensorPatch {
    let points = (0..16).map(|k| {
        let (i, j) = (k / 4, k % 4);
        let inner = i % 3 != 0 && j % 3 != 0;
        let shift = if inner { bend } else { 0.0 };
        Point::new(i as f64 / 3.0 + shift, j as f64 / 3.0 - 0.5 * shift, 0.0)
    });
    TensorPatch::bernstein(Net::new(4, 4, points.collect()).unwrap()).unwrap()
}

struct Table {
    cases: usize,
    tight: usize,
}

impl Table {
    fn check(&mut self, name: &str, parameter: f64, patch: &dyn Patch, exact: f64) {
        let found = area(patch).unwrap();
        let true_error = (found.value - exact).abs();
        // Below this a true error is rounding: of the sums, and of the closed form here.
        let floor = 64.0 * f64::EPSILON * exact;
        let ratio = found.error / true_error.max(floor);
        self.cases += 1;
        self.tight += usize::from(ratio <= 100.0);
        println!(
            "{name:<28}{parameter:>8.4}{exact:>20.15}{:>6}{true_error:>10.1e}{:>10.1e}{ratio:>10.1}",
            found.points, found.error
        );
        assert!(true_error <= found.error, "{name}, {parameter}: {found:?} for {exact}");
    }
}

#[test]
fn reported_errors_hold() {
    println!(
        "{:<28}{:>8}{:>20}{:>6}{:>10}{:>10}{:>10}",
        "surface", "", "area", "rule", "error", "bound", "ratio"
    );
    let mut table = Table { cases: 0, tight: 0 };
    let cosh_square = |u: f64| 0.5 * u + 0.25 * (2.0 * u).sinh();
    for k in 0..12 {
        let (u, v) = (fill(k, 0.2, 3.0), fill(k + 7, 0.3, 7.0));
        let right = Helicoid::new(1.5, 0.0, u, v).unwrap();
        table.check("right helicoid, AHT net", u, &right.patch().unwrap(), 2.25 * v * cosh_square(u));
        let catenoid = Helicoid::new(0.0, 1.0, u, v).unwrap();
        table.check("catenoid, AHT net", u, &catenoid.patch().unwrap(), v * cosh_square(u));
        let between = Helicoid::over(0.6, 0.8, (-u, u), (0.0, 1.0)).unwrap();
        table.check("helicoid, closed form", u, &between, 2.0 * cosh_square(u));
    }
    for k in 0..8 {
        let (w, v) = (fill(k, 0.5, 4.0), fill(k + 3, 0.5, 5.5));
        let strip = TrapeziumHelicoid::new(v, [0.0, w], [0.0, 0.0]).unwrap().patch().unwrap();
        let exact = v * 0.5 * (w * (1.0 + w * w).sqrt() + w.asinh());
        table.check("helicoid, AT net", w, &strip, exact);
    }
    for k in 0..12 {
        let (a, b) = (fill(k, 0.1, 3.0), fill(k + 5, 0.1, 2.0));
        let m = |x: f64, e: i32| x.powi(e + 1) / f64::from(e + 1);
        let exact =
            a * b + 2.0 * (m(a, 2) * b + m(b, 2) * a) + m(a, 4) * b + m(b, 4) * a + 2.0 * m(a, 2) * m(b, 2);
        table.check("Enneper, bicubic", a, &enneper(a, b), exact);
    }
    for k in 0..8 {
        let bend = fill(k, -0.15, 0.15);
        table.check("plane, bent chart", bend, &square(bend), 1.0);
    }
    for k in 0..8 {
        let (south, north) = (fill(k, -1.5, -0.2), fill(k + 3, 0.0, FRAC_PI_2));
        let band = closed((0.0, 2.0), (south, north), |u, v| {
            let ((su, cu), (sv, cv)) = (u.sin_cos(), v.sin_cos());
            [Point::new(-su * cv, cu * cv, 0.0), Point::new(-cu * sv, -su * sv, cv)]
        });
        table.check("sphere, band", north, &band, 2.0 * (north.sin() - south.sin()));
    }
    let octant = Closed(Domain::Triangle, |u: f64, v: f64| {
        // p/|p| for p = (u, v, 1 − u − v).
        let p = Point::new(u, v, 1.0 - u - v);
        let (length, n) = (p.norm(), p * (1.0 / p.norm()));
        [Point::new(1.0, 0.0, -1.0), Point::new(0.0, 1.0, -1.0)].map(|d| (d - n * n.dot(d)) * (1.0 / length))
    });
    table.check("sphere, octant", 1.0, &octant, FRAC_PI_2);
    // z = ln(cos y / cos x) over [−c, c]²; areas by a product rule in 30 digits.
    for (c, exact) in SCHERK {
        let piece =
            closed((-c, c), (-c, c), |u, v| [Point::new(1.0, 0.0, u.tan()), Point::new(0.0, 1.0, -v.tan())]);
        table.check("Scherk", c, &piece, exact);
    }
    for k in 0..8 {
        let r = fill(k, 0.2, 5.0);
        let bowl = closed((0.0, r), (0.0, 1.5), |u, v| {
            let (s, c) = v.sin_cos();
            [Point::new(c, s, u), Point::new(-u * s, u * c, 0.0)]
        });
        table.check("paraboloid", r, &bowl, 0.5 * ((1.0 + r * r).powf(1.5) - 1.0));
        let torus = closed((0.0, 2.0), (-PI, PI), |u, v| {
            let ((su, cu), (sv, cv)) = (u.sin_cos(), v.sin_cos());
            let d = r + 1.0 + cv;
            [Point::new(-d * su, d * cu, 0.0), Point::new(-sv * cu, -sv * su, cv)]
        });
        table.check("torus", r, &torus, 2.0 * 2.0 * PI * (r + 1.0));
        let cone = closed((0.0, r), (0.0, 1.5), |u, v| {
            let (s, c) = v.sin_cos();
            [Point::new(c, s, 1.0), Point::new(-u * s, u * c, 0.0)]
        });
        table.check("cone to its apex", r, &cone, SQRT_2 * 0.75 * r * r);
    }
    for k in 0..24 {
        // (u² − 2cu, v): folded along u = c, where the density |2u − 2c| has a kink.
        let c = fill(k, 0.0, 1.0);
        let points = [0.0, -c, 1.0 - 2.0 * c]
            .into_iter()
            .flat_map(|x| [Point::new(x, 0.0, 0.0), Point::new(x, 1.0, 0.0)])
            .collect();
        let fold = TensorPatch::bernstein(Net::new(3, 2, points).unwrap()).unwrap();
        table.check("fold", c, &fold, c * c + (1.0 - c) * (1.0 - c));
    }
    let Table { cases, tight } = table;
    println!("{cases} areas: every bound holds, {tight} bounds within 100 times the error or its rounding");
    assert!(tight * 10 >= cases * 9, "{tight} of {cases}");
}

/// Half widths and areas of pieces of Scherk's surface.
const SCHERK: [(f64, f64); 4] = [
    (0.5, 1.087_245_963_837_638_8),
    (1.0, 5.697_512_211_587_057),
    (1.3, 13.357_200_286_880_184),
    (1.5, 29.231_986_771_644_754),
];

/// ∫‖Δx‖² of surfaces in conformal charts is 0 exactly; what is computed is rounding, and the error has to cover it.
#[test]
fn errors_of_vanishing_defects_hold() {
    for side in [0.5, 1.0, 2.0] {
        let patch = enneper(side, side);
        let dirichlet = |jet: &Jet| [jet.dirichlet_density()];
        let [scale] = integrate(&patch, 1e-12, [0.0], dirichlet).unwrap();
        let defect = |jet: &Jet| [jet.laplacian().dot(jet.laplacian())];
        let [defect] = integrate(&patch, 1e-12, [scale.value], defect).unwrap();
        assert!(defect.settled && defect.value <= defect.error, "{defect:?}");
        assert!(defect.error <= 1e-24 * scale.value, "{defect:?}");
    }
}
