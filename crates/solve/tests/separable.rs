//! Laws of the separable solver and of its parametric form.

mod families;

use families::{
    GtSamples, Random, add_kronecker, bernstein_patch, bernstein_samples, energy, example_5_1,
    exponential_net, gram, gt_dirichlet, gt_samples, interior, smooth_net,
};
use proptest::prelude::*;
use solve::{Parametric, Partition, Place, Samples, Separable, SeparableParametric, SolveError};

/// ½ (K_u ⊗ M_v + M_u ⊗ K_v) of the whole net.
fn dirichlet(u: &Samples, v: &Samples) -> Vec<f64> {
    let (m, n) = (u.functions, v.functions);
    let grams = |s: &Samples| {
        (gram(&s.weights, s.functions, &s.derivatives), gram(&s.weights, s.functions, &s.values))
    };
    let ((ku, mu), (kv, mv)) = (grams(u), grams(v));
    let mut matrix = vec![0.0; (m * n).pow(2)];
    add_kronecker(&mut matrix, 0.5, &ku, m, &mv, n);
    add_kronecker(&mut matrix, 0.5, &mu, m, &kv, n);
    matrix
}

fn gt_at(degree: usize, theta: [f64; 2]) -> Samples {
    let samples = GtSamples::new(degree);
    let (values, derivatives) = samples.at(theta);
    let GtSamples { points, functions, weights, .. } = samples;
    Samples { points, functions, weights, values, derivatives }
}

/// Largest distance of the patch from (x, y, eˣ cos y).
fn sup_error(degree: usize, net: &[f64]) -> f64 {
    let mut error = 0.0f64;
    for i in 0..=40 {
        for j in 0..=40 {
            let (s, t) = (i as f64 / 40.0, j as f64 / 40.0);
            let point = bernstein_patch(degree, net, s, t);
            for (found, known) in point.into_iter().zip([s, t, s.exp() * t.cos()]) {
                error = error.max((found - known).abs());
            }
        }
    }
    error
}

#[test]
fn harmonic_patches_of_high_degree_are_accurate() {
    for (degree, bound) in [(16, 1e-13), (20, 1e-12), (30, 1e-8)] {
        let samples = bernstein_samples(degree);
        let free = interior(degree);
        let separable = Separable::new(&samples, &samples, &free, &free).unwrap();
        let solution = separable.solve(&exponential_net(degree)).unwrap();
        let error = sup_error(degree, &solution.x);
        assert!(error <= bound, "degree {degree}: {error:e}");
        assert!(solution.residual <= 30.0, "degree {degree}: {}", solution.residual);
        // ½ ∫ 1 + 1 + e^{2x}: the Dirichlet energy of the harmonic surface.
        let known = 0.5 * (2.0 + (2f64.exp() - 1.0) / 2.0);
        assert!(
            (solution.energy - known).abs() <= 1e-12 * known + bound * bound,
            "{} {known}",
            solution.energy
        );
    }
}

#[test]
fn example_5_1_has_the_known_minimum() {
    let free = interior(3);
    let system =
        SeparableParametric::new(gt_samples(3), gt_samples(3), &free, &free, &example_5_1()).unwrap();
    assert!((system.value(&[0.870_556; 4]) - 37.439_561_196_6).abs() < 1e-10);
    assert!((system.solve(&[0.870_556; 4]).unwrap().energy - 37.439_561_196_6).abs() < 1e-10);
}

#[test]
fn tables_and_samples_agree_up_to_degree_12() {
    // The Gram matrices of the tables have conditions up to 1e12 there; J still keeps nine digits.
    let mut random = Random(12);
    for degree in [8, 10, 12] {
        let net = smooth_net(&mut random, [degree, degree]);
        let free = interior(degree);
        let system =
            SeparableParametric::new(gt_samples(degree), gt_samples(degree), &free, &free, &net).unwrap();
        let parametric = Parametric::new(&gt_dirichlet([degree, degree], net)).unwrap();
        for _ in 0..3 {
            let at = point(&mut random);
            let (known, found) = (system.value(&at), parametric.value(&at));
            assert!((found - known).abs() <= 1e-9 * known, "degree {degree}: {found} {known}");
            // J is c − Σ b²/(λ + μ), the energy of the solution a sum of squares.
            let solution = system.solve(&at).unwrap();
            assert!((solution.energy - known).abs() <= 1e-12 * known && solution.residual <= 30.0);
        }
    }
}

#[test]
fn nothing_free_leaves_the_net_as_it_is() {
    let mut random = Random(11);
    let net = smooth_net(&mut random, [3, 4]);
    let (u, v) = (gt_at(3, [1.0, 2.0]), gt_at(4, [2.0, 0.5]));
    let known = energy(20, &dirichlet(&u, &v), &net);
    for (free_u, free_v) in [(vec![], vec![]), (vec![1, 2], vec![]), (vec![], vec![2])] {
        let solution = Separable::new(&u, &v, &free_u, &free_v).unwrap().solve(&net).unwrap();
        assert_eq!((&solution.x, solution.residual, solution.condition), (&net, 0.0, 1.0));
        assert!((solution.energy - known).abs() <= 1e-14 * known);
        let system = SeparableParametric::new(gt_samples(3), gt_samples(4), &free_u, &free_v, &net).unwrap();
        let mut gradient = [0.0; 4];
        let value = system.value_and_gradient(&[1.0, 2.0, 2.0, 0.5], &mut gradient);
        assert!((value - known).abs() <= 1e-14 * known && gradient.iter().all(|g| g.is_finite()));
    }
}

#[test]
fn dependent_functions_and_undetermined_nets_are_not_positive_definite() {
    // At θ = 0 the middle function of degree 2 vanishes.
    let zero = gt_at(2, [0.0, 0.0]);
    assert!(matches!(
        Separable::new(&zero, &zero, &[1], &[1]),
        Err(SolveError::NotPositiveDefinite { pivot: Some(0), .. })
    ));
    let system = SeparableParametric::new(gt_samples(2), gt_samples(2), &[1], &[1], &[1.0; 27]).unwrap();
    let mut out = [0.0; 3];
    system.values(&[1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, f64::NAN], &mut out).unwrap();
    assert!(out[0].is_finite() && out[1].is_nan() && out[2].is_nan());
    let mut gradient = [0.0; 4];
    assert!(
        system.value_and_gradient(&[0.0; 4], &mut gradient).is_nan() && gradient.iter().all(|g| g.is_nan())
    );
    // A net without any fixed point may be moved at no cost.
    let samples = bernstein_samples(3);
    let all = [0, 1, 2, 3];
    let separable = Separable::new(&samples, &samples, &all, &all).unwrap();
    assert!(matches!(separable.solve(&[1.0; 48]), Err(SolveError::NotPositiveDefinite { .. })));
}

#[test]
fn everything_wrong_with_the_samples_is_named() {
    let good = bernstein_samples(3);
    let error = |change: &dyn Fn(&mut Samples)| {
        let mut samples = good.clone();
        change(&mut samples);
        Separable::new(&samples, &good, &[1, 2], &[1, 2]).unwrap_err()
    };
    assert!(matches!(
        error(&|s| s.values.truncate(15)),
        SolveError::WrongShape { expected: 16, found: 15, .. }
    ));
    assert!(matches!(error(&|s| s.weights[2] = 0.0), SolveError::NotPositiveWeight { index: 2 }));
    assert!(matches!(error(&|s| s.points = 1 << 40), SolveError::TooLarge { .. }));
    assert!(matches!(
        error(&|s| s.derivatives[6] = f64::NAN),
        SolveError::NotFinite { place: Place::Matrix, row: 1, column: 2 }
    ));
    assert!(matches!(
        Separable::new(&good, &good, &[2, 1], &[]).unwrap_err(),
        SolveError::WrongIndex { index: 1, bound: 4, .. }
    ));
    let few = Samples {
        points: 1,
        weights: vec![1.0],
        values: vec![1.0; 4],
        derivatives: vec![1.0; 4],
        ..good.clone()
    };
    assert!(matches!(
        Separable::new(&few, &good, &[1, 2], &[]),
        Err(SolveError::WrongShape { expected: 2, found: 1, .. })
    ));
    let separable = Separable::new(&good, &good, &[1, 2], &[1, 2]).unwrap();
    assert!(matches!(separable.solve(&[0.0; 47]), Err(SolveError::WrongShape { expected: 48, .. })));
    let mut net = vec![1.0; 48];
    net[3 * 7 + 1] = f64::INFINITY;
    assert_eq!(
        separable.solve(&net).unwrap_err(),
        SolveError::NotFinite { place: Place::RightHandSide, row: 7, column: 1 }
    );
}

fn point(random: &mut Random) -> [f64; 4] {
    [0.0; 4].map(|_: f64| 2.0 + 1.5 * random.signed())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn dense_separable_and_parametric_are_one(seed: u64, m in 2usize..8, n in 2usize..8) {
        let mut random = Random(seed);
        let net = smooth_net(&mut random, [m, n]);
        let at = point(&mut random);
        let (u, v) = (gt_at(m, [at[0], at[1]]), gt_at(n, [at[2], at[3]]));
        let matrix = dirichlet(&u, &v);
        let order = (m + 1) * (n + 1);
        let (free_u, free_v) = (interior(m), interior(n));
        let partition = Partition::of_net(m + 1, n + 1, &free_u, &free_v).unwrap();
        let dense = solve::solve_partitioned(order, &matrix, &partition, 3, &net).unwrap();
        let least = energy(order, &matrix, &dense.x);
        let tolerance = 100.0 * f64::EPSILON * dense.condition;

        let separable = Separable::new(&u, &v, &free_u, &free_v).unwrap().solve(&net).unwrap();
        // Rounding leaves something: a residual of exactly 0 would not have been measured.
        prop_assert!(separable.residual <= 30.0 && (separable.residual > 0.0 || m * n < 12));
        let system = SeparableParametric::new(gt_samples(m), gt_samples(n), &free_u, &free_v, &net).unwrap();
        let other = system.solve(&at).unwrap();
        let size = dense.x.iter().fold(0.0f64, |s, x| s.max(x.abs()));
        for ((x, y), z) in dense.x.iter().zip(&separable.x).zip(&other.x) {
            prop_assert!((x - y).abs() <= tolerance * size && (x - z).abs() <= tolerance * size);
        }
        let parametric = Parametric::new(&gt_dirichlet([m, n], net)).unwrap();
        for j in [separable.energy, other.energy, system.value(&at), parametric.value(&at)] {
            prop_assert!((j - least).abs() <= tolerance.min(1e-10) * least, "{j} {least}");
        }
    }

    #[test]
    fn the_gradient_is_the_one_of_the_parametric_tables(seed: u64, m in 2usize..7, n in 2usize..7) {
        // Which is held against differences in its own tests.
        let mut random = Random(seed);
        let net = smooth_net(&mut random, [m, n]);
        let system =
            SeparableParametric::new(gt_samples(m), gt_samples(n), &interior(m), &interior(n), &net).unwrap();
        let parametric = Parametric::new(&gt_dirichlet([m, n], net)).unwrap();
        let at = point(&mut random);
        let (mut found, mut known) = ([0.0; 4], [0.0; 4]);
        let value = system.value_and_gradient(&at, &mut found);
        prop_assert_eq!(value.to_bits(), system.value(&at).to_bits());
        parametric.value_and_gradient(&at, &mut known);
        for k in 0..4 {
            prop_assert!((found[k] - known[k]).abs() <= 1e-9 * value, "{found:?} {known:?}");
        }
    }

    #[test]
    fn the_extremal_has_the_least_energy(seed: u64, degree in 2usize..16) {
        let mut random = Random(seed);
        let samples = bernstein_samples(degree);
        let free = interior(degree);
        let separable = Separable::new(&samples, &samples, &free, &free).unwrap();
        let solution = separable.solve(&smooth_net(&mut random, [degree, degree])).unwrap();
        // The energy of another net is what remains when nothing of it is free.
        let all_fixed = Separable::new(&samples, &samples, &[], &[]).unwrap();
        for size in [1.0, 1e-3, 1e-6] {
            let mut other = solution.x.clone();
            for &i in &free {
                for &j in &free {
                    (0..3).for_each(|d| other[3 * (i * (degree + 1) + j) + d] += size * random.signed());
                }
            }
            let energy = all_fixed.solve(&other).unwrap().energy;
            prop_assert!(energy >= solution.energy * (1.0 - 30.0 * degree as f64 * f64::EPSILON));
        }
    }
}
