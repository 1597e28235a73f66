//! The table of accuracy: errors of all families in u = 2⁻⁵³ against references of 31 digits.
//!
//! A small table is made by every run of the tests; the one with 10⁴ points a degree by
//! `cargo test --release -p plateau-bases --test accuracy -- --ignored --nocapture`.
#![allow(clippy::print_stdout, reason = "the table is the point")]

mod extended;

use bases::{Aht, At, Basis, Bernstein, GaussLegendre, Gt};
use extended::{Extended, HALF_PI, ONE, Table, ZERO};
use serde_json::Value;

const U: f64 = f64::EPSILON / 2.0;

/// Errors seen: absolute of the values, of derivatives relative to the largest function of their order, of the sum of the
/// values; all in u.
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    value: f64,
    first: f64,
    second: f64,
    sum: f64,
    points: usize,
}

impl Errors {
    /// `over`: where else than at t derivatives are looked at for the largest. All second derivatives of the GT functions of
    /// degree 2 vanish near t = ½ with the shape.
    fn add(&mut self, basis: &dyn Basis, t: f64, reference: &Table, over: &[f64]) {
        let table = basis.evaluate(t, 2);
        let elsewhere: Vec<_> = over.iter().map(|&t| basis.evaluate(t, 2)).collect();
        let mut worst = [0.0f64; 3];
        for r in 0..3 {
            let here = reference.iter().fold(0.0f64, |m, f| m.max(f[r].hi.abs()));
            let largest = elsewhere.iter().flat_map(|d| d.row(r)).fold(here, |m, d| m.max(d.abs()));
            let scale = if r == 0 { 1.0 } else { largest };
            for (ours, exact) in table.row(r).iter().zip(reference) {
                let error = exact[r].distance(*ours);
                assert!(error.is_finite(), "order {r} at {t}");
                worst[r] = worst[r].max(if error == 0.0 { 0.0 } else { error / scale / U });
            }
        }
        let sum = table.row(0).iter().fold(ZERO, |sum, &b| sum + Extended::of(b));
        self.value = self.value.max(worst[0]);
        self.first = self.first.max(worst[1]);
        self.second = self.second.max(worst[2]);
        self.sum = self.sum.max(sum.distance(1.0) / U);
        self.points += 1;
    }

    fn check(&self, family: &str, bound: f64, sum: f64) {
        let Self { value, first, second, points, .. } = *self;
        println!("{family:<34}{points:>8}{value:>9.2}{first:>9.2}{second:>9.2}{:>9.2}", self.sum);
        assert!(value <= bound, "{family}: values off by {value} u");
        assert!(first <= 10.0 * bound && second <= 10.0 * bound, "{family}: derivatives off by {self:?}");
        assert!(self.sum <= sum, "{family}: sums off by {} u", self.sum);
    }
}

fn heading() {
    println!(
        "{:<34}{:>8}{:>9}{:>9}{:>9}{:>9}",
        "errors in u = 2^-53", "points", "value", "d/dt", "d2/dt2", "sum - 1"
    );
}

/// A sequence that fills [0, 1) evenly: multiples of the golden ratio.
fn fill(k: usize, offset: f64) -> f64 {
    (offset + k as f64 * 0.618_033_988_749_894_8).fract()
}

/// Parameters: evenly, one in eight close to an end.
fn parameter(k: usize) -> f64 {
    let t = fill(k, 0.5);
    match k % 16 {
        0 => t * 1e-6,
        8 => 1.0 - t * 1e-6,
        _ => t,
    }
}

/// Shapes over [0, 4]², the corners and edges included.
fn shape(k: usize) -> [f64; 2] {
    match k % 10 {
        0 => [4.0, 4.0],
        1 => [4.0, 0.0],
        2 => [0.0, 4.0 * fill(k, 0.1) + 1e-3],
        _ => [4.0 * fill(k, 0.3), 4.0 * (0.7 + k as f64 * 0.754_877_666_246_692_7).fract()],
    }
}

fn polynomial_and_trigonometric(points: usize) {
    heading();
    let mut bernstein = [Errors::default(); 21];
    let mut gt = [Errors::default(); 21];
    let bases: Vec<Bernstein> = (0..=20).map(|n| Bernstein::new(n).unwrap()).collect();
    for k in 0..points {
        let (t, shape) = (parameter(k), shape(k));
        for (n, table) in extended::bernstein(20, t).iter().enumerate() {
            bernstein[n].add(&bases[n], t, table, &[]);
        }
        for (n, table) in extended::gt(20, shape, t).iter().enumerate() {
            gt[n + 2].add(&Gt::new(n + 2, shape).unwrap(), t, table, &[0.0, 0.5, 1.0]);
        }
    }
    for n in 1..=20 {
        bernstein[n].check(&format!("Bernstein, degree {n}"), 4.0, 8.0);
    }
    for n in 2..=20 {
        gt[n].check(&format!("GT, degree {n}"), 8.0, 8.0);
    }
}

/// AHT and AT by spans relative to their bound; promised are 256u/(1 − α/α*).
fn order_six(points: usize) {
    heading();
    for hyperbolic in [true, false] {
        let bound = if hyperbolic { Aht::SUPREMUM } else { At::SUPREMUM };
        let name = if hyperbolic { "AHT" } else { "AT" };
        for (from, to) in
            [(1e-8, 1e-4), (1e-4, 1e-2), (1e-2, 0.1), (0.1, 0.5), (0.5, 0.9), (0.9, 0.999), (0.999, 0.99999)]
        {
            let mut errors = Errors::default();
            for k in 0..points {
                let part: f64 = from * f64::powf(to / from, fill(k, 0.3));
                let span = part * bound;
                let basis: Box<dyn Basis> = if hyperbolic {
                    Box::new(Aht::new(span).unwrap())
                } else {
                    Box::new(At::new(span).unwrap())
                };
                // The reference divides by numbers that vanish at the bound: not too near, where it has digits to spare.
                let t = (parameter(k) * span).min(span);
                errors.add(basis.as_ref(), t, &extended::order_six(hyperbolic, span, t), &[]);
            }
            // Kept are 8u, far within the promise.
            errors.check(&format!("{name}, span {from} to {to} of bound"), 8.0, 8.0);
        }
    }
}

/// Nodes on [0, 1] to u absolutely and weights to an ulp: Newton's iteration on Legendre's recursion, in 31 digits.
fn gauss(sizes: impl Iterator<Item = usize>) {
    let (mut node, mut weight, mut count) = (0.0f64, 0.0f64, 0);
    for n in sizes {
        let rule = GaussLegendre::new(n).unwrap();
        for k in 0..n {
            let mut x = Extended::of(2.0) * Extended::of(rule.node(k)) - ONE;
            let mut slope = ONE;
            for _ in 0..3 {
                let (mut p, mut q) = (ONE, ZERO);
                for j in 0..n {
                    let next = (Extended::of((2 * j + 1) as f64) * x * p - Extended::of(j as f64) * q)
                        / Extended::of((j + 1) as f64);
                    (p, q) = (next, p);
                }
                slope = Extended::of(n as f64) * (x * p - q) / (x * x - ONE);
                x = x - p / slope;
            }
            let exact_node = (x + ONE) * Extended::of(0.5);
            let exact_weight = ONE / ((ONE - x * x) * slope * slope);
            node = node.max(exact_node.distance(rule.node(k)) / U);
            let ulp = exact_weight.hi.next_up() - exact_weight.hi;
            weight = weight.max(exact_weight.distance(rule.weight(k)) / ulp);
            count += 1;
        }
    }
    println!("Gauss rules, {count} nodes: nodes to {node:.3} u absolutely, weights to {weight:.3} ulp");
    assert!(node <= 1.0 && weight <= 1.0, "{node} {weight}");
}

#[test]
fn references_equal_the_stored_ones() {
    // The file holds 25 digits computed with 60.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/bases.json");
    let rows: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let (mut worst, mut compared) = (0.0f64, 0);
    for row in &rows {
        let number = |v: &Value| v.as_str().unwrap().parse::<f64>().unwrap();
        let t = number(&row["t"]);
        let degree = || row["degree"].as_u64().unwrap() as usize;
        let table = match row["family"].as_str().unwrap() {
            "bernstein" => extended::bernstein(degree(), t).pop().unwrap(),
            "gt" => {
                let shape = row["shape"].as_array().unwrap();
                extended::gt(degree(), [number(&shape[0]), number(&shape[1])], t).pop().unwrap()
            }
            family => extended::order_six(family == "aht", number(&row["alpha"]), t),
        };
        for (r, key) in ["value", "d1", "d2"].into_iter().enumerate() {
            let stored: Vec<Extended> =
                row[key].as_array().unwrap().iter().map(|v| Extended::parse(v.as_str().unwrap())).collect();
            let scale = stored.iter().fold(1.0f64, |m, x| m.max(x.hi.abs()));
            for (ours, stored) in table.iter().zip(&stored) {
                let difference = (ours[r] - *stored).value().abs() / scale;
                worst = if difference <= worst { worst } else { difference };
                compared += 1;
            }
        }
    }
    println!("{compared} stored references differ from these by at most {worst:.1e}");
    assert!(compared > 5000 && worst < 1e-22, "{worst:e}");
    assert!((HALF_PI - Extended::parse("1.570796326794896619231321691639")).value().abs() < 1e-29);
}

#[test]
fn bernstein_within_4u_and_gt_within_8u() {
    polynomial_and_trigonometric(300);
}

#[test]
fn aht_and_at_within_8u() {
    order_six(200);
}

#[test]
fn gauss_rules_within_an_ulp() {
    gauss((1..=40).chain([64, 100]));
}

#[test]
#[ignore = "a minute: the whole table"]
fn the_whole_table() {
    polynomial_and_trigonometric(10_000);
    order_six(10_000);
    gauss((1..=128).chain([200, 333, 512, 1000]));
}
