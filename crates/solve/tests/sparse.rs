//! Laws of the sparse solvers, on the mask systems of triangular nets.

mod families;

use families::Random;
use proptest::prelude::*;
use solve::{Place, SolveError, Triplet, solve_general, solve_sparse, solve_sparse_spd};

type Mask = [([i32; 3], f64)];

/// `4 P_I = Σ w P_{I+s}` of the Dirichlet mask, as `Σ w P_{I+s} = 0` with the point itself.
const DIRICHLET: &Mask = &[
    ([0, 0, 0], -4.0),
    ([-1, -1, 2], 2.0),
    ([-1, 1, 0], -1.0),
    ([1, -1, 0], -1.0),
    ([-1, 2, -1], 1.0),
    ([0, 1, -1], 1.0),
    ([1, 0, -1], 1.0),
    ([2, -1, -1], 1.0),
];

/// The Coons mask, singular for even degrees from 6.
const COONS: &Mask = &[
    ([0, 0, 0], -2.0),
    ([-1, 0, 1], 1.0),
    ([-1, 1, 0], -1.0),
    ([0, -1, 1], 1.0),
    ([0, 1, -1], 1.0),
    ([1, -1, 0], -1.0),
    ([1, 0, -1], 1.0),
];

struct System {
    interior: Vec<[i32; 3]>,
    triplets: Vec<Triplet>,
    rhs: Vec<f64>,
}

/// The system of the interior points of a triangular net of degree n with `boundary` given.
fn mask_system(n: i32, mask: &Mask, boundary: impl Fn([i32; 3]) -> [f64; 3]) -> System {
    let interior: Vec<[i32; 3]> = (1..n).flat_map(|i| (1..n - i).map(move |j| [i, j, n - i - j])).collect();
    let mut triplets = Vec::new();
    let mut rhs = vec![0.0; 3 * interior.len()];
    for (row, at) in interior.iter().enumerate() {
        for (shift, weight) in mask {
            let to = [at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]];
            match interior.binary_search(&to) {
                Ok(column) => triplets.push(Triplet { row, column, value: *weight }),
                Err(_) => (0..3).for_each(|d| rhs[3 * row + d] -= weight * boundary(to)[d]),
            }
        }
    }
    System { interior, triplets, rhs }
}

fn linear(at: [i32; 3]) -> [f64; 3] {
    [0.3 * f64::from(at[0]) - 0.1 * f64::from(at[2]), f64::from(at[1]), 0.2 + f64::from(at[2])]
}

#[test]
fn linear_nets_are_reproduced_up_to_degree_60() {
    for (degree, mask) in [(3, DIRICHLET), (10, DIRICHLET), (60, DIRICHLET), (7, COONS), (15, COONS)] {
        let System { interior, triplets, rhs } = mask_system(degree, mask, linear);
        let solution = solve_sparse(interior.len(), &triplets, 3, &rhs).unwrap();
        assert!(solution.residual <= 30.0, "degree {degree}: {}", solution.residual);
        let size = f64::from(degree);
        for (at, x) in interior.iter().zip(solution.x.chunks(3)) {
            for (x, known) in x.iter().zip(linear(*at)) {
                assert!(
                    (x - known).abs() <= 100.0 * f64::EPSILON * solution.condition * size,
                    "{degree} {at:?}"
                );
            }
        }
    }
    assert_eq!(mask_system(60, DIRICHLET, linear).interior.len(), 1711);
}

#[test]
fn the_coons_mask_is_singular_at_even_degrees() {
    for degree in [6, 8, 10, 12, 20, 30] {
        let System { interior, triplets, rhs } = mask_system(degree, COONS, linear);
        match solve_sparse(interior.len(), &triplets, 3, &rhs) {
            Err(SolveError::Singular { order, reciprocal_condition }) => {
                assert_eq!(order, interior.len());
                assert!(reciprocal_condition < 1e-13, "degree {degree}: {reciprocal_condition:e}");
            }
            other => panic!("degree {degree}: {other:?}"),
        }
    }
    for degree in [7, 9, 15] {
        let System { interior, triplets, rhs } = mask_system(degree, COONS, linear);
        assert!(solve_sparse(interior.len(), &triplets, 3, &rhs).unwrap().condition < 1e5);
    }
}

fn laplacian(side: usize) -> Vec<Triplet> {
    let mut triplets = Vec::new();
    for i in 0..side {
        for j in 0..side {
            let row = i * side + j;
            let mut put = |column, value| triplets.push(Triplet { row, column, value });
            put(row, 4.0);
            if i > 0 {
                put(row - side, -1.0);
            }
            if i + 1 < side {
                put(row + side, -1.0);
            }
            if j > 0 {
                put(row - 1, -1.0);
            }
            if j + 1 < side {
                put(row + 1, -1.0);
            }
        }
    }
    triplets
}

fn dense(n: usize, triplets: &[Triplet]) -> Vec<f64> {
    let mut matrix = vec![0.0; n * n];
    triplets.iter().for_each(|t| matrix[t.row * n + t.column] += t.value);
    matrix
}

#[test]
fn cholesky_lu_and_dense_agree_on_the_laplacian() {
    for side in [0, 1, 2, 7, 20, 45] {
        let (n, triplets) = (side * side, laplacian(side));
        let rhs = Random(side as u64).vector(3 * n);
        let spd = solve_sparse_spd(n, &triplets, 3, &rhs).unwrap();
        let general = solve_sparse(n, &triplets, 3, &rhs).unwrap();
        assert!(spd.residual <= 30.0 && general.residual <= 30.0);
        let size = spd.x.iter().fold(0.0f64, |s, x| s.max(x.abs()));
        let close = |a: &[f64], b: &[f64]| {
            a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 100.0 * f64::EPSILON * spd.condition * size)
        };
        assert!(close(&spd.x, &general.x));
        if n < 500 {
            let dense = solve::solve_spd(n, &dense(n, &triplets), 3, &rhs).unwrap();
            assert!(close(&spd.x, &dense.x));
            assert!(spd.condition <= 3.0 * dense.condition && dense.condition <= 3.0 * spd.condition);
        }
    }
}

#[test]
fn the_pivot_of_an_indefinite_matrix_is_named_in_the_callers_numbers() {
    for (n, bad) in [(3, 1), (40, 17), (900, 333)] {
        // Decoupled, so that only the bad unknown itself can fail; dense enough elsewhere to be blocked.
        let mut triplets = Vec::new();
        for row in 0..n {
            for column in 0..n {
                let value = if row == column { 2.0 * n as f64 } else { 1.0 };
                if row != bad && column != bad {
                    triplets.push(Triplet { row, column, value });
                }
            }
        }
        triplets.push(Triplet { row: bad, column: bad, value: -1.0 });
        match solve_sparse_spd(n, &triplets, 1, &vec![1.0; n]) {
            Err(SolveError::NotPositiveDefinite { pivot, .. }) => assert_eq!(pivot, Some(bad)),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn each_kind_of_bad_input_has_its_own_error() {
    let entry = |row, column, value| Triplet { row, column, value };
    let identity = [entry(0, 0, 1.0), entry(1, 1, 1.0)];
    let rhs = [1.0, 1.0];
    let mut bad = identity;
    bad[1] = entry(1, 2, 1.0);
    assert!(matches!(solve_sparse(2, &bad, 1, &rhs), Err(SolveError::WrongIndex { index: 2, bound: 2, .. })));
    bad[1] = entry(1, 0, f64::NAN);
    let not_finite = |place, row, column| Err(SolveError::NotFinite { place, row, column });
    assert_eq!(solve_sparse(2, &bad, 1, &rhs), not_finite(Place::Matrix, 1, 0));
    assert_eq!(solve_sparse(2, &identity, 1, &[1.0, f64::INFINITY]), not_finite(Place::RightHandSide, 1, 0));
    assert!(matches!(solve_sparse(2, &identity, 1, &[1.0]), Err(SolveError::WrongShape { .. })));
    assert!(matches!(solve_sparse(usize::MAX, &identity, 1, &rhs), Err(SolveError::TooLarge { .. })));
    bad[1] = entry(1, 1, -1.0);
    assert!(matches!(
        solve_sparse_spd(2, &bad, 1, &rhs),
        Err(SolveError::NotPositiveDefinite { order: 2, .. })
    ));
    let skew = [identity[0], identity[1], entry(0, 1, 0.5)];
    assert_eq!(
        solve_sparse_spd(2, &skew, 1, &rhs),
        Err(SolveError::NotSymmetric { row: 1, column: 0, difference: 0.5 })
    );
    // A row, then a column, without entries; then dependent ones, exactly and almost.
    for singular in [
        vec![entry(0, 0, 1.0), entry(0, 1, 1.0)],
        vec![entry(0, 0, 1.0), entry(1, 0, 1.0)],
        vec![entry(0, 0, 1.0), entry(0, 1, 2.0), entry(1, 0, 2.0), entry(1, 1, 4.0)],
        vec![entry(0, 0, 0.1), entry(0, 1, 0.3), entry(1, 0, 0.3), entry(1, 1, 0.9)],
        vec![entry(0, 0, 0.0), entry(1, 1, 1.0)],
        vec![entry(0, 0, 1.0), entry(1, 1, 1e-14)],
    ] {
        assert!(
            matches!(solve_sparse(2, &singular, 1, &rhs), Err(SolveError::Singular { .. })),
            "{singular:?}"
        );
        assert!(solve_sparse_spd(2, &singular, 1, &rhs).is_err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn sparse_is_dense(seed: u64, n in 1usize..30) {
        let mut random = Random(seed);
        // Some places several times: they add up.
        let mut triplets: Vec<Triplet> = (0..4 * n)
            .map(|_| Triplet {
                row: random.next() as usize % n,
                column: random.next() as usize % n,
                value: random.signed(),
            })
            .collect();
        triplets.extend((0..n).map(|row| Triplet { row, column: (row + 1) % n, value: 3.0 }));
        let rhs = random.vector(3 * n);
        match (solve_sparse(n, &triplets, 3, &rhs), solve_general(n, &dense(n, &triplets), 3, &rhs)) {
            (Ok(sparse), Ok(dense)) => {
                prop_assert!(sparse.residual <= 30.0);
                let size = dense.x.iter().fold(0.0f64, |s, x| s.max(x.abs()));
                for (a, b) in sparse.x.iter().zip(&dense.x) {
                    prop_assert!((a - b).abs() <= 100.0 * f64::EPSILON * dense.condition * size);
                }
            }
            (a, b) => prop_assert!(a.is_err() && b.is_err(), "{a:?} {b:?}"),
        }
    }
}
