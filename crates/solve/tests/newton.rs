//! Newton's method on functions whose minima are known, and the two small decompositions around it.

use std::ops::ControlFlow;

use proptest::prelude::*;
use solve::{
    NewtonEnd, NewtonParams, NewtonReport, SmoothFunction, SolveError, eigen_symmetric, newton,
    orthonormalise, smallest_relative_eigenvalue, solve_spd,
};

/// A function of n unknowns given by its value, gradient and Hessian.
struct Given<F> {
    n: usize,
    f: F,
}

impl<F: FnMut(&[f64], &mut [f64], &mut [f64]) -> f64> SmoothFunction for Given<F> {
    fn unknowns(&self) -> usize {
        self.n
    }
    fn value_and_gradient(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        (self.f)(x, gradient, &mut vec![0.0; self.n * self.n])
    }
    fn hessian(&mut self, x: &[f64], hessian: &mut [f64]) {
        (self.f)(x, &mut vec![0.0; self.n], hessian);
    }
}

type Derivatives<'a> = Box<dyn FnMut(&[f64], &mut [f64], &mut [f64]) -> f64 + 'a>;

fn quadratic<'a>(n: usize, a: &'a [f64], b: &'a [f64]) -> Given<Derivatives<'a>> {
    let f = move |x: &[f64], g: &mut [f64], h: &mut [f64]| {
        h.copy_from_slice(a);
        let ax: Vec<f64> = (0..n).map(|i| (0..n).map(|j| a[i * n + j] * x[j]).sum()).collect();
        (0..n).for_each(|i| g[i] = ax[i] - b[i]);
        1.0 + (0..n).map(|i| (0.5 * ax[i] - b[i]) * x[i]).sum::<f64>()
    };
    Given { n, f: Box::new(f) }
}

/// Rosenbrock's curved valley, with a floor that rises as slowly as `floor` says.
fn valley(floor: f64) -> Given<Derivatives<'static>> {
    let f = move |x: &[f64], g: &mut [f64], h: &mut [f64]| {
        let (r, s) = (x[1] - x[0] * x[0], x[0] - 1.0);
        g.copy_from_slice(&[-4.0 * r * x[0] + 2.0 * floor * s, 2.0 * r]);
        let cross = -4.0 * x[0];
        h.copy_from_slice(&[8.0 * x[0] * x[0] - 4.0 * r + 2.0 * floor, cross, cross, 2.0]);
        r * r + floor * s * s + 1.0
    };
    Given { n: 2, f: Box::new(f) }
}

fn matrix(n: usize, entries: &[f64]) -> Vec<f64> {
    (0..n * n).map(|k| entries[(7 * (k / n) + k % n) % entries.len()]).collect()
}

/// AᵀA + δ.
fn definite(n: usize, entries: &[f64], delta: f64) -> Vec<f64> {
    let a = matrix(n, entries);
    let entry = |i: usize, j: usize| (0..n).map(|k| a[k * n + i] * a[k * n + j]).sum::<f64>();
    (0..n * n).map(|k| entry(k / n, k % n) + if k / n == k % n { delta } else { 0.0 }).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn convex_quadratics_end_at_the_solution_of_their_system(
        n in 1usize..9, entries in prop::collection::vec(-1.0..1.0f64, 41), b in prop::collection::vec(-1.0..1.0f64, 8),
    ) {
        let a = definite(n, &entries, 0.1);
        let report = newton(&mut quadratic(n, &a, &b[..n]), &vec![0.0; n], NewtonParams::new(1e-9, 0.5)).unwrap();
        prop_assert_eq!(report.end, NewtonEnd::Minimum);
        let x = solve_spd(n, &a, 1, &b[..n]).unwrap().x;
        for (x, y) in report.x.iter().zip(&x) {
            prop_assert!((x - y).abs() <= 1e-7, "{x} {y}");
        }
    }

    #[test]
    fn directions_without_curvature_are_left_alone(
        n in 2usize..9, entries in prop::collection::vec(-1.0..1.0f64, 41), b in prop::collection::vec(-1.0..1.0f64, 8),
    ) {
        // Curvature in all directions but the last unknown's.
        let mut a = definite(n, &entries, 0.1);
        (0..n).for_each(|k| { a[k * n + n - 1] = 0.0; a[(n - 1) * n + k] = 0.0; });
        let mut b = b[..n].to_vec();
        b[n - 1] = 0.0;
        let start: Vec<f64> = (0..n).map(|k| k as f64).collect();
        let report = newton(&mut quadratic(n, &a, &b), &start, NewtonParams::new(1e-9, 0.5)).unwrap();
        prop_assert_eq!(report.end, NewtonEnd::Minimum);
        prop_assert!((report.x[n - 1] - start[n - 1]).abs() <= 1e-6, "{}", report.x[n - 1]);
    }

    #[test]
    fn valleys_are_followed_to_their_lowest_point(x in -2.0..2.0f64, y in -1.0..3.0f64, floor in 1e-4..1.0f64) {
        let report = newton(&mut valley(floor), &[x, y], NewtonParams::new(1e-10, 0.5)).unwrap();
        prop_assert_eq!(report.end, NewtonEnd::Minimum);
        prop_assert!(report.gradient_norm <= 1e-10);
        prop_assert!((report.x[0] - 1.0).abs() <= 1e-5 && (report.x[1] - 1.0).abs() <= 1e-5, "{:?}", report.x);
        prop_assert!(report.iterations <= 60, "{}", report.iterations);
    }

    #[test]
    fn values_never_rise_and_saddles_are_left(x in -2.0..2.0f64, y in -2.0..2.0f64, exact in any::<bool>()) {
        // x² − y² + y⁴ + 1: minima at (0, ±√½), value ¾, a saddle at 0, reached along y = 0.
        let y = if exact { 0.0 } else { y };
        let f = |x: &[f64], g: &mut [f64], h: &mut [f64]| {
            let s = x[1] * x[1];
            g.copy_from_slice(&[2.0 * x[0], (4.0 * s - 2.0) * x[1]]);
            h.copy_from_slice(&[2.0, 0.0, 0.0, 12.0 * s - 2.0]);
            x[0] * x[0] - s + s * s + 1.0
        };
        let report = newton(&mut Given { n: 2, f }, &[x, y], NewtonParams::new(1e-10, 0.3)).unwrap();
        prop_assert_eq!(report.end, NewtonEnd::Minimum);
        prop_assert!((report.value - 0.75).abs() <= 1e-14, "{}", report.value);
    }

    #[test]
    fn combinations_are_orthonormal_and_span_the_columns(
        rows in 1usize..20, cols in 1usize..8, entries in prop::collection::vec(-1.0..1.0f64, 97),
    ) {
        let samples: Vec<f64> = (0..rows * cols).map(|k| entries[(13 * (k / cols) + 29 * (k % cols)) % 97]).collect();
        match orthonormalise(rows, cols, &samples) {
            Err(SolveError::WrongShape { .. }) => prop_assert!(rows < cols),
            Err(SolveError::NotPositiveDefinite { .. }) => {}
            Err(error) => prop_assert!(false, "{error}"),
            Ok(map) => {
                let q = |i: usize, j: usize| (0..cols).map(|k| samples[i * cols + k] * map[k * cols + j]).sum::<f64>();
                let size = map.iter().fold(1.0f64, |m, a| m.max(a.abs()));
                for i in 0..cols {
                    prop_assert!((0..i).all(|j| map[i * cols + j] == 0.0) && map[i * cols + i] != 0.0);
                    for j in 0..cols {
                        let product: f64 = (0..rows).map(|p| q(p, i) * q(p, j)).sum();
                        let expected = if i == j { 1.0 } else { 0.0 };
                        prop_assert!((product - expected).abs() <= 1e-13 * size, "{product}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_smallest_relative_eigenvalue_makes_the_pencil_singular(
        n in 1usize..8, entries in prop::collection::vec(-1.0..1.0f64, 53),
    ) {
        let raw = matrix(n, &entries);
        let a: Vec<f64> = (0..n * n).map(|k| raw[k] + raw[k % n * n + k / n]).collect();
        let b = definite(n, &entries[5..], 0.5);
        let smallest = smallest_relative_eigenvalue(n, &a, &b).unwrap().unwrap();
        let pencil: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - smallest * b).collect();
        let values = eigen_symmetric(n, &pencil).unwrap().values;
        prop_assert!(values[0].abs() <= 1e-12 * (1.0 + smallest.abs()) * n as f64, "{values:?}");
    }
}

#[test]
fn points_where_the_function_is_not_defined_are_not_entered() {
    // x − log x for x > 0: the first full step from 4 would lead to −8.
    let f = |x: &[f64], g: &mut [f64], h: &mut [f64]| {
        g[0] = 1.0 - 1.0 / x[0];
        h[0] = 1.0 / (x[0] * x[0]);
        if x[0] > 0.0 { x[0] - x[0].ln() } else { f64::NAN }
    };
    let report = newton(&mut Given { n: 1, f }, &[4.0], NewtonParams::new(1e-12, 100.0)).unwrap();
    assert_eq!(report.end, NewtonEnd::Minimum);
    assert!((report.x[0] - 1.0).abs() < 1e-12);
    let report = newton(&mut Given { n: 1, f }, &[-1.0], NewtonParams::new(1e-12, 1.0)).unwrap();
    assert_eq!((report.end, report.iterations), (NewtonEnd::NotFinite, 0));
}

#[test]
fn budgets_flats_and_nothing_to_do_are_told() {
    let params = NewtonParams { iterations: 2, ..NewtonParams::new(1e-12, 0.1) };
    let report = newton(&mut valley(0.01), &[-1.0, 1.0], params).unwrap();
    assert_eq!((report.end, report.iterations), (NewtonEnd::Budget, 2));
    let params = NewtonParams { value_tolerance: 0.5, ..NewtonParams::new(0.0, 0.1) };
    assert_eq!(newton(&mut valley(1e-8), &[-1.0, 1.0], params).unwrap().end, NewtonEnd::Flat);
    let none = |_: &[f64], _: &mut [f64], _: &mut [f64]| 3.0;
    let report = newton(&mut Given { n: 0, f: none }, &[], NewtonParams::new(0.0, 1.0)).unwrap();
    assert_eq!((report.end, report.value, report.iterations), (NewtonEnd::Minimum, 3.0, 0));
    // |x|: no gradient is small anywhere.
    let kink = |x: &[f64], g: &mut [f64], _: &mut [f64]| {
        g[0] = 1f64.copysign(x[0]);
        1.0 + x[0].abs()
    };
    let report = newton(&mut Given { n: 1, f: kink }, &[0.3], NewtonParams::new(1e-12, 1.0)).unwrap();
    assert!(matches!(report.end, NewtonEnd::NoDecrease | NewtonEnd::Flat), "{:?}", report.end);
    assert!(report.x[0].abs() < 1e-6, "{:?}", report.x);
}

#[test]
fn bad_input_is_an_error() {
    let wrong = newton(&mut valley(1.0), &[0.0], NewtonParams::new(1e-9, 1.0));
    assert!(matches!(wrong, Err(SolveError::WrongShape { .. })));
    let wrong = newton(&mut valley(1.0), &[0.0, f64::NAN], NewtonParams::new(1e-9, 1.0));
    assert!(matches!(wrong, Err(SolveError::NotFinite { .. })));
    assert!(matches!(
        orthonormalise(2, 2, &[1.0, 2.0, 2.0, 4.0]),
        Err(SolveError::NotPositiveDefinite { .. })
    ));
    assert!(matches!(orthonormalise(1, 1, &[f64::NAN]), Err(SolveError::NotFinite { .. })));
    let not_definite = smallest_relative_eigenvalue(2, &[1.0, 0.0, 0.0, 1.0], &[1.0, 0.0, 0.0, -1.0]);
    assert!(matches!(not_definite, Err(SolveError::NotPositiveDefinite { .. })));
    assert_eq!(smallest_relative_eigenvalue(0, &[], &[]), Ok(None));
}

#[test]
fn a_function_that_asks_to_stop_is_left_where_it_is() {
    struct Watched(Given<Derivatives<'static>>, usize);
    impl SmoothFunction for Watched {
        fn unknowns(&self) -> usize {
            self.0.unknowns()
        }
        fn value_and_gradient(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
            self.0.value_and_gradient(x, gradient)
        }
        fn hessian(&mut self, x: &[f64], hessian: &mut [f64]) {
            self.0.hessian(x, hessian);
        }
        fn watch(&mut self, reached: &NewtonReport) -> ControlFlow<()> {
            self.1 += 1;
            assert_eq!(reached.iterations, self.1);
            if self.1 < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        }
    }
    let start = [-1.0, 1.0];
    let mut watched = Watched(valley(0.1), 0);
    let report = newton(&mut watched, &start, NewtonParams::new(1e-10, 0.5)).unwrap();
    assert_eq!((report.end, report.iterations, watched.1), (NewtonEnd::Stopped, 3, 3));
    assert!(report.value < valley(0.1).value_and_gradient(&start, &mut [0.0; 2]));
}
