//! Laws of the dense solvers.

mod families;

use families::{Random, energy};
use proptest::prelude::*;
use solve::{Partition, Place, SolveError};

const SIZES: [usize; 9] = [0, 1, 2, 3, 5, 8, 9, 10, 50];

/// Threshold of LAPACK's tests for ‖b − A x‖ / (‖A‖ ‖x‖ n ε).
const RATIO: f64 = 30.0;

fn multiply(n: usize, a: &[f64], columns: usize, x: &[f64]) -> Vec<f64> {
    (0..n * columns)
        .map(|e| (0..n).map(|k| a[e / columns * n + k] * x[k * columns + e % columns]).sum())
        .collect()
}

#[test]
fn lapack_ratio_stays_below_its_threshold_at_lapacks_sizes() {
    let mut random = Random(1);
    for n in SIZES {
        for columns in [1, 3] {
            let (spd, general) = (random.spd(n), random.vector(n * n));
            let rhs = random.vector(n * columns);
            let solution = solve::solve_spd(n, &spd, columns, &rhs).unwrap();
            assert!(solution.residual <= RATIO, "order {n}: {}", solution.residual);
            assert!(solution.condition >= 1.0);
            let solution = solve::solve_general(n, &general, columns, &rhs).unwrap();
            assert!(solution.residual <= RATIO, "order {n}: {}", solution.residual);
        }
    }
}

#[test]
fn the_ratio_that_is_returned_is_the_one_of_the_solution() {
    // Recomputed here from the definition, so that a residual that is never computed is noticed.
    let mut random = Random(2);
    let (a, b) = (random.spd(20), random.vector(20));
    let solution = solve::solve_spd(20, &a, 1, &b).unwrap();
    let defect: f64 = multiply(20, &a, 1, &solution.x).iter().zip(&b).map(|(p, b)| (b - p).abs()).sum();
    let norm = (0..20).map(|j| (0..20).map(|i| a[i * 20 + j].abs()).sum::<f64>()).fold(0.0, f64::max);
    let ratio = defect / (norm * solution.x.iter().map(|x| x.abs()).sum::<f64>() * 20.0 * f64::EPSILON);
    assert!(ratio > 0.0 && (ratio - solution.residual).abs() <= 0.5 * ratio, "{ratio} {}", solution.residual);
}

#[test]
fn condition_of_the_hilbert_matrix_is_the_known_one() {
    // ‖H‖₁‖H⁻¹‖₁ for orders 3, 5, 8: 748, 943656, 3.387e10 (Higham, table of the Hilbert matrix).
    for (n, known) in [(3, 748.0), (5, 943_656.0), (8, 3.387_279_1e10)] {
        let hilbert: Vec<f64> = (0..n * n).map(|e| 1.0 / (e / n + e % n + 1) as f64).collect();
        let found = solve::Cholesky::new(n, &hilbert).unwrap().condition();
        assert!(found <= known * 1.001 && found >= known / 3.0, "order {n}: {found} for {known}");
        let found = solve::Lu::new(n, &hilbert).unwrap().condition();
        assert!(found <= known * 1.001 && found >= known / 3.0, "order {n}: {found} for {known}");
    }
}

#[test]
fn condition_is_a_close_lower_bound() {
    // Against the inverse itself: never above it, and within the factor 3 that is promised.
    let mut random = Random(6);
    for n in [5usize, 9, 20, 40] {
        for _ in 0..10 {
            let a = random.vector(n * n);
            let lu = solve::Lu::new(n, &a).unwrap();
            let unit: Vec<f64> = (0..n * n).map(|e| if e / n == e % n { 1.0 } else { 0.0 }).collect();
            let inverse = lu.solve(n, &unit).unwrap().x;
            let norm =
                |a: &[f64]| (0..n).map(|j| (0..n).map(|i| a[i * n + j].abs()).sum()).fold(0.0, f64::max);
            let known = norm(&a) * norm(&inverse);
            let ratio = lu.condition() / known;
            assert!((1.0 / 3.0..=1.0 + 1e-9).contains(&ratio), "order {n}: {ratio}");
        }
    }
}

#[test]
fn each_kind_of_bad_matrix_has_its_own_error() {
    let ones = |n: usize| vec![1.0; n * n];
    for n in [2, 8, 9, 40] {
        let mut indefinite = vec![0.0; n * n];
        (0..n).for_each(|i| indefinite[i * n + i] = if i == n - 1 { -1.0 } else { 1.0 });
        match solve::solve_spd(n, &indefinite, 1, &vec![1.0; n]) {
            Err(SolveError::NotPositiveDefinite { order, pivot: Some(pivot), .. }) => {
                assert_eq!((order, pivot), (n, n - 1));
            }
            other => panic!("{other:?}"),
        }
        assert!(matches!(
            solve::solve_spd(n, &ones(n), 1, &vec![1.0; n]),
            Err(SolveError::NotPositiveDefinite { .. })
        ));
        assert!(matches!(
            solve::solve_general(n, &ones(n), 1, &vec![1.0; n]),
            Err(SolveError::Singular { .. })
        ));
        let mut skew = vec![0.0; n * n];
        (0..n).for_each(|i| skew[i * n + i] = 1.0);
        skew[1] = 0.25;
        assert_eq!(
            solve::solve_spd(n, &skew, 1, &vec![1.0; n]),
            Err(SolveError::NotSymmetric { row: 1, column: 0, difference: 0.25 })
        );
    }
    // The Hilbert matrix of order 14 is positive definite, but not to working precision.
    let hilbert: Vec<f64> = (0..14 * 14).map(|e| 1.0 / (e / 14 + e % 14 + 1) as f64).collect();
    assert!(matches!(solve::Cholesky::new(14, &hilbert), Err(SolveError::NotPositiveDefinite { .. })));
    assert!(matches!(solve::Lu::new(14, &hilbert), Err(SolveError::Singular { .. })));
}

#[test]
fn numbers_that_are_not_finite_are_reported_where_they_stand() {
    let mut random = Random(3);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut a = random.spd(7);
        let mut b = random.vector(21);
        a[3 * 7 + 5] = bad;
        let at = |place, row, column| SolveError::NotFinite { place, row, column };
        assert_eq!(solve::solve_spd(7, &a, 3, &b).unwrap_err(), at(Place::Matrix, 3, 5));
        assert_eq!(solve::solve_general(7, &a, 3, &b).unwrap_err(), at(Place::Matrix, 3, 5));
        a = random.spd(7);
        b[4 * 3 + 2] = bad;
        assert_eq!(solve::solve_spd(7, &a, 3, &b).unwrap_err(), at(Place::RightHandSide, 4, 2));
        assert_eq!(solve::solve_rank(7, 7, &a, 3, &b, 0.0).unwrap_err(), at(Place::RightHandSide, 4, 2));
        let partition = Partition::new(&[false, true, false, false, true, false, false]);
        assert_eq!(
            solve::solve_partitioned(7, &a, &partition, 3, &b).unwrap_err(),
            at(Place::RightHandSide, 4, 2)
        );
        b[4 * 3 + 2] = 0.0;
        b[3] = 0.5;
        b[0] = bad; // row 0 is free: never read
        assert!(solve::solve_partitioned(7, &a, &partition, 3, &b).is_ok());
    }
}

#[test]
fn wrong_shapes_and_sizes_are_refused_before_any_memory_is_taken() {
    assert!(matches!(
        solve::solve_spd(2, &[1.0; 3], 1, &[1.0; 2]),
        Err(SolveError::WrongShape { expected: 4, found: 3, .. })
    ));
    assert!(matches!(
        solve::solve_spd(1, &[1.0], 3, &[1.0]),
        Err(SolveError::WrongShape { expected: 3, found: 1, .. })
    ));
    assert!(matches!(solve::solve_spd(1 << 40, &[], 1, &[]), Err(SolveError::TooLarge { .. })));
    assert!(matches!(solve::solve_general(usize::MAX, &[], 1, &[]), Err(SolveError::TooLarge { .. })));
    assert!(matches!(Partition::of_net(1 << 40, 1 << 40, &[], &[]), Err(SolveError::TooLarge { .. })));
    assert!(matches!(Partition::of_net(3, 3, &[2, 1], &[]), Err(SolveError::WrongIndex { index: 1, .. })));
    assert!(matches!(
        Partition::of_net(3, 3, &[], &[3]),
        Err(SolveError::WrongIndex { index: 3, bound: 3, .. })
    ));
}

#[test]
fn memory_that_cannot_be_had_is_reported_as_memory() {
    // 2^58 unknowns: within the address space of the check, beyond any machine.
    match Partition::of_net(1 << 29, 1 << 29, &[], &[]) {
        Err(SolveError::OutOfMemory { bytes }) => assert_eq!(bytes, 1 << 58),
        other => panic!("{other:?}"),
    }
}

#[test]
fn extreme_units_change_exponents_only() {
    let mut random = Random(4);
    for n in [5, 20] {
        let (a, b) = (random.spd(n), random.vector(3 * n));
        let plain = solve::solve_spd(n, &a, 3, &b).unwrap();
        for e in [-1000, 1000] {
            let scaled: Vec<f64> = b.iter().map(|x| x * 2f64.powi(e)).collect();
            let solution = solve::solve_spd(n, &a, 3, &scaled).unwrap();
            assert!(solution.x.iter().zip(&plain.x).all(|(s, p)| *s == p * 2f64.powi(e)));
            assert_eq!(solution.residual, plain.residual);
            let scaled: Vec<f64> = a.iter().map(|x| x * 2f64.powi(e)).collect();
            let solution = solve::solve_general(n, &scaled, 3, &b).unwrap();
            assert!(solution.residual <= RATIO);
        }
    }
    assert!(matches!(
        solve::solve_spd(1, &[1e-300], 1, &[1e300]),
        Err(SolveError::NotFinite { place: Place::Solution, row: 0, column: 0 })
    ));
}

#[test]
fn rank_of_a_product_is_found_and_conflicts_are_counted() {
    let mut random = Random(5);
    for (rows, cols, rank) in [(6, 4, 4), (6, 4, 2), (4, 6, 3), (5, 5, 0), (0, 3, 0), (3, 0, 0), (40, 30, 17)]
    {
        let (left, right) = (random.vector(rows * rank), random.vector(rank * cols));
        let a: Vec<f64> = (0..rows * cols)
            .map(|e| (0..rank).map(|k| left[e / cols * rank + k] * right[k * cols + e % cols]).sum())
            .collect();
        let x = random.vector(cols * 3);
        let b: Vec<f64> =
            (0..rows * 3).map(|e| (0..cols).map(|k| a[e / 3 * cols + k] * x[k * 3 + e % 3]).sum()).collect();
        let solution = solve::solve_rank(rows, cols, &a, 3, &b, 1e-12).unwrap();
        assert_eq!((solution.rank, solution.nullity, solution.inconsistent), (rank, cols - rank, 0));
        if rank == cols {
            assert!(solution.x.iter().zip(&x).all(|(s, x)| (s - x).abs() < 1e-10));
        }
        if rows > rank {
            let conflict = solve::solve_rank(rows, cols, &a, 3, &random.vector(rows * 3), 1e-12).unwrap();
            assert!(conflict.inconsistent > 0 && conflict.residual > 1e-6);
        }
    }
}

#[test]
fn eigenvalues_of_the_second_difference_are_the_known_ones() {
    for n in [1usize, 2, 7, 30] {
        let a: Vec<f64> = (0..n * n)
            .map(|e| match (e / n).abs_diff(e % n) {
                0 => 2.0,
                1 => -1.0,
                _ => 0.0,
            })
            .collect();
        let eigen = solve::eigen_symmetric(n, &a).unwrap();
        for k in 0..n {
            let known = 4.0 * (std::f64::consts::PI * (k + 1) as f64 / (2 * (n + 1)) as f64).sin().powi(2);
            assert!((eigen.values[k] - known).abs() < 1e-14 * 4.0 * n as f64);
            for i in 0..n {
                let product: f64 = (0..n).map(|j| a[i * n + j] * eigen.vectors[j * n + k]).sum();
                assert!((product - known * eigen.vectors[i * n + k]).abs() < 1e-13 * n as f64);
            }
        }
        assert_eq!(solve::smallest_eigenvalue(n, &a).unwrap(), Some(eigen.values[0]));
    }
    assert_eq!(solve::smallest_eigenvalue(0, &[]).unwrap(), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_partitioned_answer_is_the_minimum(seed: u64, n in 1usize..24) {
        let mut random = Random(seed);
        let q = random.spd(n);
        let mask: Vec<bool> = (0..n).map(|_| random.signed() > 0.0).collect();
        let partition = Partition::new(&mask);
        let values = random.vector(3 * n);
        let solution = solve::solve_partitioned(n, &q, &partition, 3, &values).unwrap();
        prop_assert_eq!(partition.gather_fixed(3, &solution.x).unwrap(), partition.gather_fixed(3, &values).unwrap());
        let least = energy(n, &q, &solution.x);
        for size in [1.0, 1e-3] {
            let mut other = solution.x.clone();
            for &i in partition.free() {
                (0..3).for_each(|d| other[3 * i + d] += size * random.signed());
            }
            prop_assert!(energy(n, &q, &other) >= least * (1.0 - 30.0 * n as f64 * f64::EPSILON));
        }
    }

    #[test]
    fn cholesky_and_lu_agree(seed: u64, n in 1usize..40) {
        let mut random = Random(seed);
        let (a, b) = (random.spd(n), random.vector(3 * n));
        let spd = solve::solve_spd(n, &a, 3, &b).unwrap();
        let general = solve::solve_general(n, &a, 3, &b).unwrap();
        let size = spd.x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for (s, g) in spd.x.iter().zip(&general.x) {
            prop_assert!((s - g).abs() <= 100.0 * f64::EPSILON * spd.condition * size);
        }
    }
}
