//! The proof of positive definiteness: what is definite is proved so, what is not is never.
#![allow(clippy::print_stdout, reason = "figures worth seeing with --nocapture")]

mod families;

use families::Random;
use solve::{Place, SolveError, proves_positive_definite};

fn proved(n: usize, matrix: &[f64]) -> bool {
    proves_positive_definite(n, matrix).unwrap()
}

/// Cholesky's algorithm without a shift: whether it ends.
fn bare_cholesky_ends(n: usize, matrix: &[f64]) -> bool {
    let mut a = matrix.to_vec();
    for k in 0..n {
        if a[k * n + k] <= 0.0 {
            return false;
        }
        let root = a[k * n + k].sqrt();
        (k..n).for_each(|i| a[i * n + k] /= root);
        for i in k + 1..n {
            (k + 1..=i).for_each(|j| a[i * n + j] -= a[i * n + k] * a[j * n + k]);
        }
    }
    true
}

/// `fl(H … H diag(1 … 1/κ) H … H)` with reflections H: definite, since rounding moves its eigenvalues by some n u only.
fn with_condition(random: &mut Random, n: usize, condition: f64) -> Vec<f64> {
    let mut a = vec![0.0; n * n];
    (0..n).for_each(|k| a[k * n + k] = condition.powf(-(k as f64) / (n.max(2) - 1) as f64));
    for _ in 0..3 {
        let v = random.vector(n);
        let square: f64 = v.iter().map(|v| v * v).sum();
        // A − v wᵀ − w vᵀ with w = 2 (A v − (vᵀ A v / vᵀv) v) / vᵀv.
        let product: Vec<f64> = (0..n).map(|i| (0..n).map(|j| a[i * n + j] * v[j]).sum::<f64>()).collect();
        let mean = v.iter().zip(&product).map(|(v, p)| v * p).sum::<f64>() / square;
        let w: Vec<f64> = v.iter().zip(&product).map(|(v, p)| 2.0 * (p - mean * v) / square).collect();
        for i in 0..n {
            for j in 0..n {
                a[i * n + j] -= v[i] * w[j] + w[i] * v[j];
            }
        }
    }
    a
}

/// `B Bᵀ` of an integer B of `n × rank`: exact in doubles, with n − rank eigenvalues that are exactly 0.
fn integer_square(random: &mut Random, n: usize, rank: usize, size: f64) -> Vec<f64> {
    let b: Vec<f64> = (0..n * rank).map(|_| (size * random.signed()).round()).collect();
    (0..n * n).map(|e| (0..rank).map(|k| b[e / n * rank + k] * b[e % n * rank + k]).sum()).collect()
}

/// C(i + j, i): definite, with determinant 1; one less in the last entry and it is exactly singular.
fn pascal(n: usize) -> Vec<f64> {
    let mut a = vec![1.0; n * n];
    for i in 1..n {
        for j in 1..n {
            a[i * n + j] = a[(i - 1) * n + j] + a[i * n + j - 1];
        }
    }
    a
}

#[test]
fn definite_matrices_are_proved_up_to_conditions_of_1e13_over_n() {
    let mut random = Random(1);
    for n in [1usize, 2, 3, 5, 10, 20, 50, 100] {
        for condition in [1.0, 1e3, 1e6, 1e9, 1e13 / n as f64] {
            for _ in 0..10 {
                let a = with_condition(&mut random, n, condition);
                assert!(proved(n, &a), "order {n}, condition {condition:.0e}");
            }
        }
    }
    assert!(proved(0, &[]));
    // Known in closed form.
    for n in 1..=9 {
        assert!(proved(n, &pascal(n)), "Pascal's matrix of order {n}");
    }
    for n in 1..=8 {
        let hilbert: Vec<f64> = (0..n * n).map(|e| 1.0 / (e / n + e % n + 1) as f64).collect();
        assert!(proved(n, &hilbert), "Hilbert's matrix of order {n}");
    }
}

#[test]
fn no_matrix_with_an_eigenvalue_of_zero_or_below_is_proved_definite() {
    let mut random = Random(2);
    let (mut tried, mut fooled) = (0, 0);
    let mut refused = |n: usize, a: &[f64]| {
        tried += 1;
        fooled += usize::from(bare_cholesky_ends(n, a));
        assert!(!proved(n, a), "order {n}: {a:?}");
    };
    for n in [2usize, 3, 5, 10, 30] {
        for size in [3.0, 1e3, 1e6] {
            for _ in 0..100 {
                let mut a = integer_square(&mut random, n, n - 1, size);
                refused(n, &a);
                // The least step below: every diagonal entry in turn by one ulp, so that an eigenvalue is negative.
                let k = random.next() as usize % n;
                a[k * n + k] = a[k * n + k].next_down();
                refused(n, &a);
            }
        }
    }
    for n in 2..=25 {
        let mut a = pascal(n);
        a[n * n - 1] -= 1.0;
        refused(n, &a);
    }
    refused(1, &[0.0]);
    refused(1, &[-1e-300]);
    for x in [1.0f64.next_down(), 1.0, 1.0f64.next_up()] {
        // (1, 1), (1, x): determinant x − 1 ≤ 0 but for the last, which is definite by less than can be proved.
        assert!(!proved(2, &[1.0, 1.0, 1.0, x]));
    }
    println!("{tried} matrices that are not definite, none proved so; a bare Cholesky ends on {fooled}");
    assert!(fooled * 20 > tried, "the law is about matrices on which a bare factorisation fails: {fooled}");
}

#[test]
fn scaling_by_powers_of_two_changes_nothing() {
    let mut random = Random(3);
    for n in [2usize, 5, 12] {
        for condition in [1e6, 1e12, 1e15, 1e17] {
            let a = with_condition(&mut random, n, condition);
            let expected = proved(n, &a);
            let exponents: Vec<i32> = (0..n).map(|_| (240.0 * random.signed()) as i32).collect();
            let scaled: Vec<f64> = (0..n * n)
                .map(|e| a[e] * 2f64.powi(exponents[e / n]) * 2f64.powi(exponents[e % n]))
                .collect();
            assert_eq!(proved(n, &scaled), expected, "order {n}, condition {condition:.0e}");
        }
    }
    assert!(proved(2, &[4e-320, 0.0, 0.0, 1e300]));
    assert!(!proved(2, &[5e-324, 1e300, 1e300, 1e300]));
}

#[test]
fn what_counts_of_a_matrix_that_is_not_symmetric_is_its_symmetric_part() {
    let h = 2f64.powi(-30);
    // The lower triangle alone is definite by h, the symmetric part is singular; and the other way round.
    assert!(!proved(2, &[1.0, 1.0 + h, 1.0 - h, 1.0]));
    assert!(!proved(2, &[1.0, 1.0 - h, 1.0 + h, 1.0]));
    assert!(proved(2, &[1.0, 0.5 + h, 0.5 - h, 1.0]));
}

#[test]
fn bad_input_is_an_error() {
    assert!(matches!(proves_positive_definite(2, &[1.0; 3]), Err(SolveError::WrongShape { .. })));
    assert_eq!(
        proves_positive_definite(2, &[1.0, 0.0, f64::NAN, 1.0]),
        Err(SolveError::NotFinite { place: Place::Matrix, row: 1, column: 0 })
    );
    assert!(matches!(proves_positive_definite(1 << 40, &[]), Err(SolveError::TooLarge { .. })));
}
