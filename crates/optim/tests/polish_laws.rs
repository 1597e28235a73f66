//! Laws of the polish: KKT conditions, bounds, counts, reasons.

mod functions;

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use functions::{cube, rosenbrock_with_gradient};
use libm::{cos, exp, log, sin};
use optim::{Bound, Bounds, FnSmooth, Polish, PolishError, PolishReason, Polished, Smooth};
use proptest::prelude::*;

/// ½ xᵀA x − bᵀx + c, A = symmetric positive definite, row-major.
#[derive(Clone, Debug)]
struct Quadratic {
    a: Vec<f64>,
    b: Vec<f64>,
    c: f64,
}

impl Smooth for Quadratic {
    fn dimension(&self) -> usize {
        self.b.len()
    }

    fn value_and_gradient(&self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let n = x.len();
        let mut value = self.c;
        for i in 0..n {
            let ax: f64 = (0..n).map(|j| self.a[i * n + j] * x[j]).sum();
            gradient[i] = ax - self.b[i];
            value += x[i] * (0.5 * ax - self.b[i]);
        }
        value
    }
}

/// A = MᵀM + shift · identity.
fn quadratic(m: &[f64], b: Vec<f64>, shift: f64) -> Quadratic {
    let n = b.len();
    let mut a = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            let product = (0..n).map(|k| m[k * n + i] * m[k * n + j]);
            a[i * n + j] = product.sum::<f64>() + if i == j { shift } else { 0.0 };
        }
    }
    Quadratic { a, b, c: 1.0 }
}

prop_compose! {
    /// A quadratic, a box and a start in it, a third of its components on the boundary.
    fn bounded_quadratics()(n in 1..9_usize)(
        m in prop::collection::vec(-1.0..1.0_f64, n * n),
        b in prop::collection::vec(-2.0..2.0_f64, n),
        sides in prop::collection::vec((-2.0..1.0_f64, 0.1..3.0_f64), n),
        fractions in prop::collection::vec(
            prop_oneof![4 => 0.0..1.0_f64, 1 => Just(0.0), 1 => Just(1.0)], n),
    ) -> (Quadratic, Bounds, Vec<f64>) {
        let (lower, widths): (Vec<f64>, Vec<f64>) = sides.into_iter().unzip();
        let upper: Vec<f64> = lower.iter().zip(&widths).map(|(l, w)| l + w).collect();
        let start = (0..lower.len()).map(|i| (lower[i] + fractions[i] * widths[i]).min(upper[i])).collect();
        (quadratic(&m, b, 0.1), Bounds::new(lower, upper).expect("a box"), start)
    }
}

/// The report says of the point what the objective says of it.
fn assert_consistent(objective: &impl Smooth, bounds: &Bounds, report: &Polished) {
    let mut gradient = vec![0.0; bounds.dimension()];
    let value = objective.value_and_gradient(&report.point, &mut gradient);
    assert_eq!(value.to_bits(), report.value.to_bits());
    assert_eq!(gradient, report.gradient);
    assert!(bounds.contains(&report.point));
    let mut residual = 0.0_f64;
    for i in 0..bounds.dimension() {
        let (x, g) = (report.point[i], report.gradient[i]);
        match report.active[i] {
            Bound::Lower => assert!(x == bounds.lower()[i] && g > 0.0),
            Bound::Upper => assert!(x == bounds.upper()[i] && g < 0.0),
            Bound::Free => residual = residual.max(bounds.width(i) * g.abs()),
        }
    }
    assert_eq!(residual, report.residual);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn bounded_quadratics_meet_their_kkt_conditions((objective, bounds, start) in bounded_quadratics()) {
        let report = Polish::default().run(&objective, &bounds, &start).unwrap();
        assert_consistent(&objective, &bounds, &report);
        // A convex problem: a KKT point is the minimum. Written out once more, without `residual`.
        for i in 0..start.len() {
            let (x, g) = (report.point[i], report.gradient[i]);
            let (lower, upper) = (bounds.lower()[i], bounds.upper()[i]);
            prop_assert!(x == lower || g <= 1e-9, "component {} wants down: {}", i, g);
            prop_assert!(x == upper || g >= -1e-9, "component {} wants up: {}", i, g);
        }
        prop_assert!(
            matches!(report.reason, PolishReason::Stationary | PolishReason::Flat),
            "{}", report.reason
        );
        let begin = objective.value_and_gradient(&start, &mut vec![0.0; start.len()]);
        prop_assert!(report.value <= begin + 16.0 * f64::EPSILON * begin.abs());
    }

    #[test]
    fn polishing_a_minimum_again_does_not_raise_it(
        (objective, bounds, start) in bounded_quadratics(), far in -12..-6_i32,
    ) {
        // The value blurs far above its last digits, as if by cancellation within the objective.
        let blurred = FnSmooth::new(start.len(), |x: &[f64], g: &mut [f64]| {
            let value = objective.value_and_gradient(x, g);
            let blur = x.iter().fold(0, |hash: u64, x| hash.rotate_left(9) ^ x.to_bits()) % 64;
            value + 1e-14 * value.abs() * blur as f64
        });
        let minimum = Polish::default().run(&objective, &bounds, &start).unwrap().point;
        let near: Vec<f64> = (0..minimum.len())
            .map(|i| minimum[i] + 10_f64.powi(far) * bounds.width(i))
            .zip(bounds.upper())
            .map(|(x, upper)| x.min(*upper))
            .collect();
        let begin = blurred.value_and_gradient(&near, &mut vec![0.0; near.len()]);
        let report = Polish::default().run(&blurred, &bounds, &near).unwrap();
        prop_assert!(report.value <= begin + 16.0 * f64::EPSILON * begin.abs());
    }

    #[test]
    fn every_point_evaluated_lies_in_the_box((objective, bounds, start) in bounded_quadratics()) {
        let (calls, outside) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let watched = FnSmooth::new(start.len(), |x: &[f64], g: &mut [f64]| {
            calls.fetch_add(1, Relaxed);
            outside.fetch_add(usize::from(!bounds.contains(x)), Relaxed);
            objective.value_and_gradient(x, g)
        });
        let report = Polish::default().run(&watched, &bounds, &start).unwrap();
        prop_assert_eq!(outside.into_inner(), 0);
        prop_assert_eq!(calls.into_inner(), report.evaluations);
    }

    #[test]
    fn a_budget_is_kept((objective, bounds, start) in bounded_quadratics(), evaluations in 1..12_usize) {
        let polish = Polish { evaluations, ..Polish::default() };
        let report = polish.run(&objective, &bounds, &start).unwrap();
        prop_assert!(report.evaluations <= evaluations);
        assert_consistent(&objective, &bounds, &report);
        let begin = objective.value_and_gradient(&start, &mut vec![0.0; start.len()]);
        prop_assert!(report.value <= begin + 16.0 * f64::EPSILON * begin.abs());
        if report.reason == PolishReason::Budget {
            prop_assert_eq!(report.evaluations, evaluations);
        }
    }

    #[test]
    fn units_of_the_components_do_not_matter((objective, bounds, start) in bounded_quadratics()) {
        // Powers of two scale without rounding: the path must be the same bit for bit.
        let unit = |i: usize| [1.0, 1024.0, 1.0 / 4096.0][i % 3];
        let scaled = |x: &[f64]| -> Vec<f64> { (0..x.len()).map(|i| x[i] * unit(i)).collect() };
        let stretched = FnSmooth::new(start.len(), |x: &[f64], g: &mut [f64]| {
            let x: Vec<f64> = (0..x.len()).map(|i| x[i] / unit(i)).collect();
            let value = objective.value_and_gradient(&x, g);
            (0..x.len()).for_each(|i| g[i] /= unit(i));
            value
        });
        let wide = Bounds::new(scaled(bounds.lower()), scaled(bounds.upper())).unwrap();
        let plain = Polish::default().run(&objective, &bounds, &start).unwrap();
        let other = Polish::default().run(&stretched, &wide, &scaled(&start)).unwrap();
        prop_assert_eq!(scaled(&plain.point), other.point);
        prop_assert_eq!(plain.evaluations, other.evaluations);
    }
}

#[test]
fn the_minimum_may_be_a_corner() {
    let slope = [1.0, -2.0, 3.0, -4.0];
    let linear = FnSmooth::new(4, |x: &[f64], g: &mut [f64]| {
        g.copy_from_slice(&slope);
        x.iter().zip(&slope).map(|(x, s)| x * s).sum()
    });
    let bounds = cube(4, [0.5, 3.5]);
    for start in [[2.0; 4], [0.5; 4], [3.5; 4]] {
        let report = Polish::default().run(&linear, &bounds, &start).unwrap();
        assert_eq!(report.point, [0.5, 3.5, 0.5, 3.5]);
        let sides = [Bound::Lower, Bound::Upper, Bound::Lower, Bound::Upper];
        assert_eq!((report.active.as_slice(), report.residual), (sides.as_slice(), 0.0));
        assert_eq!(report.reason, PolishReason::Stationary);
        assert!(report.binds() && report.evaluations <= 10, "{report}");
    }
}

#[test]
fn a_constant_is_stationary_everywhere() {
    for value in [0.0, -3.0] {
        let constant = FnSmooth::new(3, move |_: &[f64], g: &mut [f64]| {
            g.fill(0.0);
            value
        });
        let report = Polish::default().run(&constant, &cube(3, [0.0, 1.0]), &[0.0, 0.3, 1.0]);
        let report = report.unwrap();
        assert_eq!(report.point, [0.0, 0.3, 1.0]);
        assert_eq!((report.reason, report.evaluations), (PolishReason::Stationary, 1));
        assert!(!report.binds());
    }
}

#[test]
fn dimensions_one_to_sixty_four() {
    for n in [1, 2, 3, 5, 8, 16, 33, 64] {
        // A stiff chain, pulled beyond the box on its left half.
        let chain = FnSmooth::new(n, |x: &[f64], g: &mut [f64]| {
            let mut value = 1.0;
            g.fill(0.0);
            for i in 0..n {
                let t = x[i] - if 2 * i < n { 1.5 } else { 0.25 };
                value += t * t + t * t * t * t;
                g[i] += 2.0 * t + 4.0 * t * t * t;
                if i + 1 < n {
                    let s = x[i + 1] - x[i];
                    value += 5.0 * s * s;
                    g[i] -= 10.0 * s;
                    g[i + 1] += 10.0 * s;
                }
            }
            value
        });
        let bounds = cube(n, [-1.0, 1.0]);
        for start in [vec![-1.0; n], vec![0.1; n]] {
            let report = Polish::default().run(&chain, &bounds, &start).unwrap();
            assert_consistent(&chain, &bounds, &report);
            assert!(report.residual <= 1e-9 * report.value, "dimension {n}: {report}");
        }
    }
}

#[test]
fn noise_in_the_value_ends_the_descent() {
    // Value and gradient disagree below 1e-9: stationary is out of reach, flat is the truth.
    let noisy = FnSmooth::new(2, |x: &[f64], g: &mut [f64]| {
        g[0] = 2.0 * x[0] + 1e-9;
        g[1] = 2.0 * x[1] - 1e-9;
        1.0 + x[0] * x[0] + x[1] * x[1] + 1e-9 * sin(1e12 * x[0])
    });
    let report = Polish::default().run(&noisy, &cube(2, [-1.0, 2.0]), &[1.3, -0.7]).unwrap();
    assert!(report.value <= 1.0 + 2e-9 && report.evaluations < 100, "{report}");
    assert_ne!(report.reason, PolishReason::Budget);
}

#[test]
fn walls_of_nan_are_walked_around() {
    // log is NaN left of 0 and −∞ at 0; the minimum lies at 0.05.
    let barrier = FnSmooth::new(1, |x: &[f64], g: &mut [f64]| {
        g[0] = 1.0 - 0.05 / x[0];
        x[0] - 0.05 * log(x[0])
    });
    let report = Polish::default().run(&barrier, &cube(1, [-10.0, 10.0]), &[9.0]).unwrap();
    assert!((report.point[0] - 0.05).abs() < 1e-10, "{report}");

    let report = Polish::default().run(&barrier, &cube(1, [-10.0, 10.0]), &[-1.0]).unwrap();
    assert_eq!((report.reason, report.evaluations), (PolishReason::NotFinite, 1));
    assert_eq!(report.point, [-1.0]);
}

#[test]
fn a_gradient_of_nan_is_no_result() {
    // The value falls into the region without gradient.
    let torn = FnSmooth::new(1, |x: &[f64], g: &mut [f64]| {
        g[0] = if x[0] < 0.5 { f64::NAN } else { 1.0 };
        x[0] + 2.0
    });
    let report = Polish::default().run(&torn, &cube(1, [-1.0, 1.0]), &[0.9]).unwrap();
    assert!(report.gradient[0] == 1.0 && report.residual == 2.0, "{report}");
    assert!(report.value < 2.9 && report.point[0] >= 0.5);
    assert_ne!(report.reason, PolishReason::Stationary);
}

#[test]
fn the_last_evaluation_of_a_budget_is_not_lost() {
    let slope = FnSmooth::new(1, |x: &[f64], g: &mut [f64]| {
        g[0] = -1.0;
        -x[0]
    });
    let polish = Polish { evaluations: 2, ..Polish::default() };
    let report = polish.run(&slope, &cube(1, [0.0, 100.0]), &[1.0]).unwrap();
    assert_eq!((report.reason, report.evaluations), (PolishReason::Budget, 2));
    assert!(report.value < -1.0, "{report}");
}

#[test]
fn a_hill_is_descended_to_the_boundary() {
    let hill = FnSmooth::new(2, |x: &[f64], g: &mut [f64]| {
        (g[0], g[1]) = (-2.0 * x[0], -sin(x[1]));
        cos(x[1]) - x[0] * x[0]
    });
    let report = Polish::default().run(&hill, &cube(2, [-2.0, 2.0]), &[0.1, -0.1]).unwrap();
    assert_eq!(report.point, [2.0, -2.0]);
    assert_eq!(report.active, [Bound::Upper, Bound::Lower]);
}

type Gradient = fn(&[f64], &mut [f64]) -> f64;

/// Like a Dirichlet energy minimised over its interior: c(x) − b(x)²/a(x).
fn reduced_energy(x: &[f64], g: &mut [f64]) -> f64 {
    let (mut a, mut b, mut c) = (2.0, 1.0, 40.0);
    let (mut da, mut dc) = ([0.0; 4], [0.0; 4]);
    for i in 0..4 {
        let w = 1.0 + 0.2 * i as f64;
        let t = x[i] - 1.2 + 0.1 * i as f64;
        a += 0.3 * w * x[i] * x[i];
        da[i] += 0.6 * w * x[i];
        b += 0.9 * x[i];
        c += 0.6 * w * t * t + 0.05 * x[i] * x[(i + 2) % 4];
        dc[i] += 1.2 * w * t + 0.1 * x[(i + 2) % 4];
    }
    for i in 0..4 {
        g[i] = dc[i] - 2.0 * b * 0.9 / a + b * b * da[i] / (a * a);
    }
    c - b * b / a
}

/// Its minimum binds two upper bounds of [0.5, 3.5]⁴ and more.
fn reciprocals(x: &[f64], g: &mut [f64]) -> f64 {
    let s = x[0] * x[1];
    let mut value = 50.0 + 0.02 * s * s;
    for i in 0..4 {
        let t = x[i] + 0.2 * i as f64;
        value += 3.0 / t;
        g[i] = -3.0 / (t * t);
    }
    g[0] += 0.04 * s * x[1];
    g[1] += 0.04 * s * x[0];
    value
}

/// A sum of exponentials whose size falls by orders of magnitude on the way.
fn exponentials(x: &[f64], g: &mut [f64]) -> f64 {
    let mut value = 0.0;
    g.fill(0.0);
    for k in 0..12 {
        let c = |i: usize| ((7 * k + 5 * i) % 11) as f64 / 5.0 - 1.0;
        let t: f64 = (0..4).map(|i| c(i) * x[i]).sum();
        let e = exp(t - 0.1 * k as f64);
        value += e;
        (0..4).for_each(|i| g[i] += c(i) * e);
    }
    value
}

#[test]
fn smooth_problems_take_twenty_evaluations() {
    let problems: [(&str, Gradient); 3] =
        [("reduced energy", reduced_energy), ("reciprocals", reciprocals), ("exponentials", exponentials)];
    for (name, function) in problems {
        let smooth = FnSmooth::new(4, function);
        let bounds = cube(4, [0.5, 3.5]);
        let reports = Polish::default().run_starts(&smooth, &bounds, 101, 5).unwrap();
        let least = reports.iter().map(|r| r.value).fold(f64::INFINITY, f64::min);
        for (i, report) in reports.iter().enumerate() {
            assert_consistent(&smooth, &bounds, report);
            assert!(report.value - least <= 1e-12 * least, "{name}, start {i}: {report}");
        }
        let mut evaluations: Vec<usize> = reports.iter().map(|r| r.evaluations).collect();
        evaluations.sort_unstable();
        assert!(evaluations[50] <= 20, "{name}: median {}", evaluations[50]);
        assert!(evaluations[100] <= 40, "{name}: most {}", evaluations[100]);
    }
}

#[test]
fn starts_do_not_depend_on_threads_or_number() {
    let smooth = FnSmooth::new(4, rosenbrock_with_gradient);
    let bounds = cube(4, [-2.0, 2.0]);
    let reference = Polish::default().run_starts(&smooth, &bounds, 9, 3).unwrap();
    for threads in [1, 2, 4] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let starts = Polish::default().run_starts(&smooth, &bounds, 9, 3).unwrap();
            assert_eq!(starts, reference);
        });
    }
    let fewer = Polish::default().run_starts(&smooth, &bounds, 4, 3).unwrap();
    assert_eq!(fewer, reference[..4]);
    assert_ne!(Polish::default().run_starts(&smooth, &bounds, 9, 4).unwrap(), reference);
}

#[test]
fn bad_parameters_are_errors() {
    let smooth = FnSmooth::new(4, reduced_energy);
    let bounds = cube(4, [0.5, 3.5]);
    let run = |polish: Polish, start: &[f64]| polish.run(&smooth, &bounds, start).unwrap_err();
    let good = Polish::default();
    let cases = [
        (run(Polish { tolerance: f64::NAN, ..good.clone() }, &[1.0; 4]), "tolerance is NaN"),
        (run(Polish { tolerance: -1.0, ..good.clone() }, &[1.0; 4]), "tolerance is -1"),
        (run(Polish { evaluations: 0, ..good.clone() }, &[1.0; 4]), "evaluations is 0"),
        (run(good.clone(), &[1.0; 3]), "3 components"),
        (run(good.clone(), &[1.0, 1.0, 9.0, 1.0]), "component 2"),
        (run(good.clone(), &[1.0, f64::NAN, 1.0, 1.0]), "component 1"),
    ];
    for (error, words) in cases {
        assert!(error.to_string().contains(words), "{error} does not say {words:?}");
    }
    assert_eq!(
        good.run(&smooth, &cube(2, [0.0, 1.0]), &[0.5; 2]),
        Err(PolishError::Dimension { objective: 4, bounds: 2 })
    );
    assert!(good.run_starts(&smooth, &bounds, 0, 1).is_err());
    assert!(good.run_starts(&smooth, &bounds, usize::MAX, 1).is_err());
}

/// Values that rounding blurs say of steps what they like: here the first step seems to gain, then the slope turns so steeply beyond it that its
/// zero, seen from the start, lies before that step, where nothing seems gained.
#[test]
fn a_step_is_never_shortened_to_less_than_one_that_was_good() {
    let slope = 2.2e-7;
    // How far the first step goes in a box of width 1 where the value is 1.
    let first = slope;
    let wall = FnSmooth::new(1, |x: &[f64], gradient: &mut [f64]| {
        gradient[0] = slope * (14.0 * (x[0] / (4.0 * first)).powi(13) - 1.0);
        if (0.9 * first..3.0 * first).contains(&x[0]) { 1.0 - 5e-14 } else { 1.0 }
    });
    let bounds = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let found = Polish::default().run(&wall, &bounds, &[0.0]).unwrap();
    assert!(found.value <= 1.0 && (0.0..4.0 * first).contains(&found.point[0]), "{found:?}");
}
