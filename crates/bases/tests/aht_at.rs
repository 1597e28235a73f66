//! The AHT and AT bases: 60-digit references, laws over the whole range of spans, subdivision.

use std::f64::consts::TAU;

use bases::{Aht, At, Basis, BasisError, Bernstein, Gt, Matrix, Samples, gram};
use proptest::prelude::*;
use serde_json::Value;

const U: f64 = f64::EPSILON / 2.0;

/// What both families offer beside the traits.
trait OrderSix: Basis {
    fn control(&self, end_jets: [[f64; 3]; 2]) -> [f64; 6];
    fn rule(&self) -> [f64; 3];
    fn margin_to_bound(&self) -> f64;
    fn maps(&self) -> [Matrix; 2];
}

macro_rules! order_six {
    ($family:ty) => {
        impl OrderSix for $family {
            fn control(&self, end_jets: [[f64; 3]; 2]) -> [f64; 6] {
                self.control_values(end_jets)
            }
            fn rule(&self) -> [f64; 3] {
                self.endpoint_rule()
            }
            fn margin_to_bound(&self) -> f64 {
                self.margin()
            }
            fn maps(&self) -> [Matrix; 2] {
                [self.monomials(), self.transform()]
            }
        }
    };
}
order_six!(Aht);
order_six!(At);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Family {
    Aht,
    At,
}

impl Family {
    fn bound(self) -> f64 {
        if self == Self::Aht { Aht::SUPREMUM } else { At::SUPREMUM }
    }

    fn on(self, span: f64) -> Box<dyn OrderSix> {
        match self {
            Self::Aht => Box::new(Aht::new(span).expect("admissible")),
            Self::At => Box::new(At::new(span).expect("admissible")),
        }
    }

    /// Value and derivatives to order 2 of the six monomials, in the order of the transform matrices.
    fn monomials(self, t: f64) -> [[f64; 3]; 6] {
        let (s, c) = t.sin_cos();
        match self {
            Self::Aht => [
                [1.0, 0.0, 0.0],
                [t, 1.0, 0.0],
                [s, c, -s],
                [c, -s, -c],
                [t.sinh(), t.cosh(), t.sinh()],
                [t.cosh(), t.sinh(), t.cosh()],
            ],
            Self::At => [
                [1.0, 0.0, 0.0],
                [t, 1.0, 0.0],
                [c, -s, -c],
                [s, c, -s],
                [t * s, s + t * c, 2.0 * c - t * s],
                [t * c, c - t * s, -2.0 * s - t * c],
            ],
        }
    }

    /// `F^{(r)}(t)` by the closed forms of the papers.
    fn closed(self, t: f64, r: usize) -> f64 {
        let trig = [t.sin(), t.cos(), -t.sin(), -t.cos()];
        let polynomial = [t, 1.0, 0.0, 0.0, 0.0][r];
        match self {
            Self::Aht => {
                0.5 * (if r.is_multiple_of(2) { t.sinh() } else { t.cosh() } + trig[r % 4]) - polynomial
            }
            Self::At => 2.0 * polynomial - 3.0 * trig[r % 4] + t * trig[(r + 1) % 4] + r as f64 * trig[r % 4],
        }
    }

    /// The basis values by the formulas of the papers as they stand.
    fn naive(self, span: f64, t: f64) -> [f64; 6] {
        let [f0, f1, f2, f3, f4] = [0, 1, 2, 3, 4].map(|r| self.closed(span, r));
        let (e, g, h) = (f1 * f1 - f0 * f2, f0 * f3 - f1 * f2, f2 * f2 - f1 * f3);
        let norm = h / ((f2 * h + f3 * g + f4 * e) * e);
        let upper = |t: f64| {
            let [a, b, c] = [0, 1, 2].map(|r| self.closed(t, r));
            [norm * (h * a + g * b + e * c), f1 / e * (b - f1 * a / f0), a / f0]
        };
        let ([b3, b4, b5], [b2, b1, b0]) = (upper(t), upper(span - t));
        [b0, b1, b2, b3, b4, b5]
    }
}

/// Spans from 10⁻⁸ to 0.9999 of the bound, small, middling and large ones.
fn family() -> impl Strategy<Value = (Family, f64)> {
    let part = prop_oneof![2 => (-8.0..0.0f64).prop_map(|x| 10f64.powf(x)), 3 => 1e-3..0.9999f64];
    (prop_oneof![Just(Family::Aht), Just(Family::At)], part)
        .prop_map(|(f, p)| (f, (p * f.bound()).clamp(1e-8, 0.9999 * f.bound())))
}

/// A parameter in [0, 1], often close to an end.
fn place() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.0..=1.0f64, 1 => 0.0..1e-6f64, 1 => (0.0..1e-6f64).prop_map(|x| 1.0 - x)]
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

fn references(name: &str) -> Vec<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/bases.json");
    let text = std::fs::read_to_string(path).expect("the reference file is part of the repository");
    let all: Vec<Value> = serde_json::from_str(&text).expect("valid JSON");
    all.into_iter().filter(|row| row["family"] == name).collect()
}

fn number(v: &Value) -> f64 {
    v.as_str().expect("numbers are written as strings").parse().expect("a number")
}

fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().expect("a list").iter().map(number).collect()
}

fn check_references(family: Family, name: &str) {
    let rows = references(name);
    assert!(rows.len() >= 64);
    for row in &rows {
        let (span, t) = (number(&row["alpha"]), number(&row["t"]));
        let basis = family.on(span);
        let table = basis.evaluate(t, 2);
        for (r, key) in ["value", "d1", "d2"].into_iter().enumerate() {
            let exact = numbers(&row[key]);
            // Promised at every span are 256u/(1 − α/α*), tenfold for derivatives; kept are 8u and 32u.
            let (kept, factor) = if r == 0 { (8.0, 1.0) } else { (32.0, largest(&exact)) };
            let promised = if r == 0 { 256.0 } else { 2560.0 } / basis.margin_to_bound();
            let bound = f64::min(kept, promised) * factor * U;
            for (i, (ours, exact)) in table.row(r).iter().zip(&exact).enumerate() {
                let error = (ours - exact).abs();
                assert!(error <= bound, "b{i}, order {r}: {} u of {factor} in {row}", error / U);
            }
        }
    }
}

#[test]
fn aht_equals_its_reference() {
    check_references(Family::Aht, "aht");
}

#[test]
fn at_equals_its_reference() {
    check_references(Family::At, "at");
}

#[test]
fn the_formulas_as_printed_lose_every_digit_where_these_do_not() {
    for (family, name) in [(Family::Aht, "aht"), (Family::At, "at")] {
        for row in references(name).iter().filter(|row| (1e-4..=0.05).contains(&number(&row["alpha"]))) {
            let (span, t) = (number(&row["alpha"]), number(&row["t"]));
            if !(0.2..0.8).contains(&(t / span)) {
                continue;
            }
            let exact = numbers(&row["value"]);
            let error = |values: &[f64]| {
                values.iter().zip(&exact).fold(0.0, |m: f64, (a, b)| {
                    // A comparison that fails for what is not a number.
                    if (a - b).abs() <= m { m } else { (a - b).abs() }
                })
            };
            let bound = 256.0 * U / family.on(span).margin_to_bound();
            let naive = error(&family.naive(span, t));
            assert!(
                naive.is_nan() || naive >= 1e4 * bound,
                "{name} at {span}, {t}: only {} bounds",
                naive / bound
            );
            assert!(error(family.on(span).evaluate(t, 0).row(0)) <= bound);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn values_sum_to_one_are_nonnegative_and_derivatives_sum_to_zero((f, span) in family(), x in place()) {
        let table = f.on(span).evaluate(x * span, 4);
        let sum: f64 = table.row(0).iter().sum();
        prop_assert!((sum - 1.0).abs() <= 8.0 * U, "{sum}");
        prop_assert!(table.row(0).iter().all(|b| *b >= 0.0), "{:?}", table.row(0));
        for r in 1..=4 {
            let sum: f64 = table.row(r).iter().sum();
            prop_assert!(sum.abs() <= 128.0 * U * largest(table.row(r)), "order {r}: {sum}");
        }
    }

    #[test]
    fn ends_are_exact_with_zeros_of_their_order((f, span) in family()) {
        let basis = f.on(span);
        let (start, end) = (basis.evaluate(0.0, 4), basis.evaluate(span, 4));
        prop_assert_eq!(start.row(0), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        prop_assert_eq!(end.row(0), [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        for i in 0..6 {
            for r in 0..=4 {
                // An i-fold zero at 0, no more; mirrored at the other end.
                prop_assert_eq!(start[(r, i)] == 0.0, r < i, "b{} order {}", i, r);
                prop_assert_eq!(end[(r, i)] == 0.0, r < 5 - i, "b{} order {}", i, r);
            }
        }
    }

    #[test]
    fn reversal_keeps_every_bit(f in prop_oneof![Just(Family::Aht), Just(Family::At)], m in 1u32..6 << 20, k in 0.0..=1.0f64) {
        // On this grid α − t is exact.
        let grid = |k: u32| f64::from(k) / f64::from(1u32 << 20);
        let k = (k * f64::from(m)) as u32;
        let basis = f.on(grid(m));
        let (there, back) = (basis.evaluate(grid(k), 5), basis.evaluate(grid(m - k), 5));
        for r in 0..=5 {
            for i in 0..6 {
                let mirrored = if r % 2 == 0 { back[(r, 5 - i)] } else { -back[(r, 5 - i)] };
                prop_assert_eq!(there[(r, i)], mirrored, "b{} order {}", i, r);
            }
        }
    }

    #[test]
    fn derivatives_of_every_order_stay_in_the_space((f, span) in family(), x in place()) {
        // AHT: φ⁗ − φ is affine; AT: φ⁗ + 2φ″ + φ is affine, with the same coefficients at every t.
        let basis = f.on(span);
        let invariant = |t: f64, r: usize| {
            let d = basis.evaluate(t, r + 4);
            (0..6).map(|i| match f {
                Family::Aht => d[(r + 4, i)] - d[(r, i)],
                Family::At => d[(r + 4, i)] + 2.0 * d[(r + 2, i)] + d[(r, i)],
            }).collect::<Vec<f64>>()
        };
        for r in [1usize, 2, 3] {
            let (here, start) = (invariant(x * span, r), invariant(0.0, r));
            let scale = largest(basis.evaluate(0.0, r + 4).row(r + 4));
            for i in 0..6 {
                let rest = if r == 1 { here[i] - start[i] } else { here[i] };
                prop_assert!(rest.abs() <= 256.0 * U * scale, "order {r}, b{i}: {rest} of {scale}");
            }
        }
    }

    #[test]
    fn the_endpoint_rule_reproduces_every_function((f, span) in family(), x in place(), start in -3.0..3.0f64, w in proptest::array::uniform6(-1.0..1.0f64)) {
        // φ(start + t) for a random φ of the space: the space is invariant under translation.
        let basis = f.on(span);
        let jet = |t: f64| {
            let m = f.monomials(start + t);
            [0, 1, 2].map(|r| (0..6).map(|k| w[k] * m[k][r]).sum::<f64>())
        };
        let control = basis.control([jet(0.0), jet(span)]);
        let d = basis.evaluate(x * span, 0);
        let terms: Vec<f64> = d.row(0).iter().zip(control).map(|(b, p)| b * p).collect();
        let size = largest(&(0..6).map(|k| w[k] * f.monomials(start + span)[k][0]).collect::<Vec<_>>()).max(1.0);
        // Near the bound the control points of a bounded function grow, and with them what their sum can keep.
        let condition = largest(&terms) + size / basis.margin_to_bound();
        let error = (terms.iter().sum::<f64>() - jet(x * span)[0]).abs();
        prop_assert!(error <= 512.0 * U * condition, "{error} against {}", U * condition);
    }

    #[test]
    fn the_endpoint_rule_reads_unit_control_points_off_the_functions((f, span) in family()) {
        let basis = f.on(span);
        let (start, end) = (basis.evaluate(0.0, 2), basis.evaluate(span, 2));
        let [_, m, epsilon] = basis.rule();
        for j in 0..6 {
            let jet = |d: &Matrix| [d[(0, j)], d[(1, j)], d[(2, j)]];
            let control = basis.control([jet(&start), jet(&end)]);
            for (i, p) in control.into_iter().enumerate() {
                let condition = 1.0 + m * start.row(1)[0].abs() + epsilon * largest(start.row(2));
                let unit = if i == j { 1.0 } else { 0.0 };
                prop_assert!((p - unit).abs() <= 16.0 * U * condition, "control point {i} of b{j}: {p}");
            }
        }
    }

    #[test]
    fn transform_matrices_are_inverse((f, span) in family()) {
        let basis = f.on(span);
        let [s, t] = basis.maps();
        let product = s.times(&t);
        let norm = |m: &Matrix| (0..6).map(|i| m.row(i).iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
        let condition = norm(&s) * norm(&t);
        for i in 0..6 {
            for j in 0..6 {
                let unit = if i == j { 1.0 } else { 0.0 };
                prop_assert!((product[(i, j)] - unit).abs() <= 64.0 * U * condition, "({i}, {j}): {}", product[(i, j)]);
            }
        }
    }

    #[test]
    fn subdivision_reproduces_the_parent((f, span) in family(), cut in 0.01..0.99f64, x in place(), p in proptest::array::uniform6(-1.0..1.0f64)) {
        let basis = f.on(span);
        let whole = |t: f64| basis.evaluate(t, 0).row(0).iter().zip(p).map(|(b, p)| b * p).sum::<f64>();
        let cut = cut * span;
        let parts = basis.subdivide(cut).unwrap();
        prop_assert_eq!(parts.left_map.row(5), parts.right_map.row(0));
        let amplification = 8.0 / basis.margin_to_bound();
        for (part, map, offset) in [(&parts.left, &parts.left_map, 0.0), (&parts.right, &parts.right_map, cut)] {
            let control: Vec<f64> = (0..6).map(|i| map.row(i).iter().zip(p).map(|(m, p)| m * p).sum()).collect();
            for i in 0..6 {
                let sum: f64 = map.row(i).iter().sum();
                prop_assert!((sum - 1.0).abs() <= 16.0 * U * amplification, "row {i} sums to {sum}");
                prop_assert!(map.row(i).iter().all(|w| *w >= -16.0 * U * amplification), "{:?}", map.row(i));
            }
            let t = x * part.domain().1;
            let value: f64 = part.evaluate(t, 0).row(0).iter().zip(&control).map(|(b, p)| b * p).sum();
            prop_assert!((value - whole(offset + t)).abs() <= 32.0 * U * amplification, "{value}");
        }
    }

    #[test]
    fn small_spans_tend_to_the_quintic_bernstein_basis(
        f in prop_oneof![Just(Family::Aht), Just(Family::At)], exponent in -8.0..-4.0f64, x in place(), cut in 0.01..0.99f64,
    ) {
        let span = 10f64.powf(exponent);
        let (basis, quintic) = (f.on(span), Bernstein::new(5).unwrap());
        let (ours, limit) = (basis.evaluate(x * span, 2), quintic.evaluate(x, 2));
        for r in 0..=2 {
            for i in 0..6 {
                let scaled = ours[(r, i)] * span.powi(r as i32);
                let scale = if r == 0 { 1.0 } else { 20.0 };
                prop_assert!((scaled - limit[(r, i)]).abs() <= scale * (64.0 * U + span * span), "order {r}, b{i}");
            }
        }
        let (ours, limit) = (basis.subdivide(cut * span).unwrap(), quintic.subdivide(cut).unwrap());
        for (ours, limit) in [(ours.left_map, limit.left_map), (ours.right_map, limit.right_map)] {
            for (a, b) in ours.as_slice().iter().zip(limit.as_slice()) {
                prop_assert!((a - b).abs() <= 64.0 * U + span * span, "{a} {b}");
            }
        }
    }
}

#[test]
fn the_bounds_are_sharp() {
    let middle = |f: Family, span: f64, i: usize| f.naive(span, 0.5 * span)[i];
    // Just below the bound these functions are positive, just above negative: by the formulas as printed, which
    // are accurate enough here.
    for (f, i) in [(Family::Aht, 2), (Family::Aht, 3), (Family::At, 1), (Family::At, 4)] {
        assert!(middle(f, f.bound() * (1.0 - 1e-5), i) > 0.0);
        assert!(middle(f, f.bound() * (1.0 + 1e-5), i) < 0.0);
    }
    // AHT prints 5π/2.
    assert!(middle(Family::Aht, 1.25 * TAU * (1.0 - 1e-9), 2) < 0.0);
    let root = |a: f64| a.cos() * a.cosh() - 1.0;
    assert!(root(Aht::SUPREMUM - 1e-12) * root(Aht::SUPREMUM + 1e-12) < 0.0);
}

#[test]
fn the_usual_gauss_rule_integrates_them_at_every_span() {
    for family in [Family::Aht, Family::At] {
        for part in [1e-6, 0.3, 0.9, 0.9999] {
            let basis = family.on(part * family.bound());
            for r in 0..=2 {
                let ours = gram(basis.as_ref(), r, r).unwrap();
                let finer = Samples::new(basis.as_ref(), 120, r).unwrap();
                let finer = finer.gram(r, &finer, r);
                for (a, b) in ours.as_slice().iter().zip(finer.as_slice()) {
                    assert!((a - b).abs() <= 1e-14 * ours.max_abs(), "{family:?} {part}, order {r}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn spans_beyond_the_bounds_are_errors_that_name_them() {
    for span in [0.0, -1.0, 1e-101, Aht::SUPREMUM, 2.5 * std::f64::consts::PI, f64::INFINITY, f64::NAN] {
        let error = Aht::new(span).unwrap_err();
        assert!(matches!(error, BasisError::Span { family: "AHT", .. }));
        assert!(error.to_string().contains("7.853204624095837"), "{error}");
    }
    for span in [0.0, -1.0, 1e-101, TAU, 7.0, f64::INFINITY, f64::NAN] {
        let error = At::new(span).unwrap_err();
        assert!(error.to_string().contains("6.283185307179586"), "{error}");
    }
    let (aht, at) = (Aht::new(Aht::SUPREMUM.next_down()).unwrap(), At::new(TAU.next_down()).unwrap());
    assert!(aht.is_ill_conditioned() && at.is_ill_conditioned());
    assert!(!Aht::new(7.4).unwrap().is_ill_conditioned() && !At::new(5.9).unwrap().is_ill_conditioned());
    for basis in [&aht as &dyn Basis, &at] {
        assert!(basis.evaluate(3.0, 4).as_slice().iter().all(|x| x.is_finite()));
    }
}

#[test]
fn cuts_outside_the_domain_are_errors() {
    let basis = Aht::new(2.0).unwrap();
    for cut in [0.0, 2.0, -1.0, f64::NAN] {
        assert!(matches!(basis.subdivide(cut), Err(BasisError::Cut { .. })));
        assert!(matches!(Bernstein::new(3).unwrap().subdivide(cut), Err(BasisError::Cut { .. })));
    }
}

#[test]
fn a_family_without_subdivision_says_so() {
    assert_eq!(Gt::new(3, [1.0, 1.0]).unwrap().subdivide(0.5).unwrap_err(), BasisError::NotSubdivisible);
}

#[test]
fn what_is_not_a_number_is_not_hidden() {
    for basis in [&Aht::new(1.0).unwrap() as &dyn Basis, &At::new(1.0).unwrap()] {
        assert!(basis.evaluate(f64::NAN, 6).as_slice().iter().all(|x| x.is_nan()));
    }
}

#[test]
fn the_smallest_span_has_finite_third_derivatives() {
    for basis in [&Aht::new(1e-100).unwrap() as &dyn Basis, &At::new(1e-100).unwrap()] {
        let table = basis.evaluate(0.5e-100, 3);
        assert!((table.row(0)[2] - 0.3125).abs() <= 8.0 * U);
        assert!(table.as_slice().iter().all(|x| x.is_finite()));
    }
}
