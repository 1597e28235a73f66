//! Integrated Legendre polynomials.

use bases::{Basis, BasisError, Bernstein, Gt, GtBubbleParts, GtBubbles, Lobatto, Matrix, gram};

#[test]
fn they_vanish_at_both_ends_and_their_derivatives_are_orthogonal() {
    for domain in [(0.0, 1.0), (-2.0, 5.0)] {
        let basis = Lobatto::new(30, domain).unwrap();
        for end in [domain.0, domain.1] {
            assert!(basis.evaluate(end, 0).max_abs() < 1e-15 * (domain.1 - domain.0));
        }
        let stiffness = gram(&basis, 1, 1).unwrap();
        for i in 0..30 {
            for j in 0..30 {
                // ∫ P_k P_l = length / (2k + 1) δ_kl.
                let exact = if i == j { (domain.1 - domain.0) / (2 * i + 3) as f64 } else { 0.0 };
                assert!((stiffness[(i, j)] - exact).abs() < 1e-14 * (domain.1 - domain.0));
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_values() {
    let basis = Lobatto::new(8, (0.0, 2.0)).unwrap();
    let h = 1e-3;
    for t in [0.1, 0.7, 1.0, 1.85] {
        for r in 0..3 {
            let at = |d: f64| basis.evaluate(t + d, r).row(r).to_vec();
            let (m2, m1, p1, p2) = (at(-2.0 * h), at(-h), at(h), at(2.0 * h));
            let exact = basis.evaluate(t, r + 1);
            for k in 0..8 {
                let difference = (m2[k] - p2[k] + 8.0 * (p1[k] - m1[k])) / (12.0 * h);
                assert!((difference - exact[(r + 1, k)]).abs() < 1e-5, "order {r}, function {k}");
            }
        }
    }
}

#[test]
fn impossible_families_are_refused() {
    assert!(Lobatto::new(0, (0.0, 1.0)).is_err());
    assert!(Lobatto::new(3, (1.0, 1.0)).is_err());
    assert!(Lobatto::new(3, (0.0, f64::INFINITY)).is_err());
}

/// The largest difference between a family and combinations of another, over the sizes of the terms of the sums.
fn misfit(combined: &dyn Basis, of: &dyn Basis, map: &Matrix, order: usize) -> f64 {
    let mut worst = 0.0f64;
    for p in 0..=40 {
        let t = f64::from(p) / 40.0;
        let (direct, terms) = (combined.evaluate(t, order), of.evaluate(t, order));
        for r in 0..=order {
            for k in 0..map.cols() {
                let term = |i: usize| map[(i, k)] * terms[(r, i)];
                let (sum, size) =
                    (0..map.rows()).fold((0.0, 1.0f64), |(s, a), i| (s + term(i), a.max(term(i).abs())));
                worst = worst.max((sum - direct[(r, k)]).abs() / size);
            }
        }
    }
    worst
}

#[test]
fn control_points_of_lobatto_polynomials_give_them_back() {
    for degree in [2, 3, 7, 20, 41, 64] {
        let points = Lobatto::bernstein_coefficients(degree).unwrap();
        let lobatto = Lobatto::new(degree - 1, (0.0, 1.0)).unwrap();
        let bernstein = Bernstein::new(degree).unwrap();
        assert!((0..degree - 1).all(|k| points[(0, k)] == 0.0 && points[(degree, k)] == 0.0));
        let worst = misfit(&lobatto, &bernstein, &points, 2);
        // Second derivatives reach n⁴ where their terms are smaller.
        assert!(worst < 1e-15 * (degree as f64).powi(3), "degree {degree}: {worst:e}");
    }
    for degree in [0, 1, 65] {
        let refused = Lobatto::bernstein_coefficients(degree);
        assert!(matches!(refused, Err(BasisError::Degree { degree: d, .. }) if d == degree));
    }
}

#[test]
fn control_points_of_high_lobatto_polynomials_are_exact() {
    // φ_{n−1} has the leading part of P_n, with coefficients (−1)^{n+i} C(n, i): 2^53 < C(64, 32).
    let points = Lobatto::bernstein_coefficients(64).unwrap();
    // C(64,32) = 1832624140942590534; P_62 raised twice has −(C(62,31)² · 2 − 2 C(62,30)²) C(64,32)⁻¹ there.
    let (choose, middle, beside) =
        (1_832_624_140_942_590_534_i128, 465_428_353_255_261_088_i128, 450_883_717_216_034_179_i128);
    let below = (2 * (beside * beside - middle * middle)) as f64 / choose as f64;
    let exact = (choose as f64 - below) / 254.0;
    assert!((points[(32, 62)] / exact - 1.0).abs() < 1e-15, "{} {exact}", points[(32, 62)]);
}

#[test]
fn gt_bubbles_are_the_gt_functions_with_these_control_points() {
    for degree in [2, 3, 6, 15, 30] {
        let points = Lobatto::bernstein_coefficients(degree).unwrap();
        for shape in [[1.0, 1.0], [0.5, 3.5], [4.0, 0.01], [2.0, 0.0]] {
            let (gt, bubbles) = (Gt::new(degree, shape).unwrap(), GtBubbles::new(degree, shape).unwrap());
            let worst = misfit(&bubbles, &gt, &points, 3);
            assert!(worst < 1e-14 * (degree as f64).powi(3), "degree {degree}, {shape:?}: {worst:e}");
        }
        let parts = GtBubbleParts::new(degree).unwrap();
        let (shape, count) = ([0.7, 2.9], degree - 1);
        let whole = GtBubbles::new(degree, shape).unwrap();
        for t in [0.0, 0.01, 0.3, 0.5, 0.99, 1.0] {
            let (parts, whole) = (parts.evaluate(t, 2), whole.evaluate(t, 2));
            for r in 0..3 {
                let largest = whole.row(r).iter().fold(1.0f64, |a, x| a.max(x.abs()));
                for k in 0..count {
                    let part = |p: usize| parts[(r, p * count + k)];
                    let sum = part(0) + shape[0] * part(1) + shape[1] * part(2);
                    assert!((sum - whole[(r, k)]).abs() < 1e-13 * largest);
                }
            }
        }
    }
    assert!(GtBubbles::new(1, [1.0, 1.0]).is_err() && GtBubbles::new(4, [5.0, 1.0]).is_err());
}

#[test]
fn bubbles_stay_well_conditioned() {
    for degree in [10, 30, 64] {
        let lobatto = Lobatto::new(degree - 1, (0.0, 1.0)).unwrap();
        let bubbles = |shape| GtBubbles::new(degree, shape).unwrap();
        let families: [&dyn Basis; 4] =
            [&lobatto, &bubbles([1.0, 1.2]), &bubbles([0.5, 3.5]), &bubbles([0.01, 4.0])];
        for family in families {
            let mass = gram(family, 0, 0).unwrap();
            let n = degree - 1;
            // Gershgorin of the mass matrix in functions of length 1, its least eigenvalue by Rayleigh quotients of a power
            // iteration on 3 − A, whose spectrum is (0, 3).
            let scaled = Matrix::from_fn(n, n, |i, j| mass[(i, j)] / (mass[(i, i)] * mass[(j, j)]).sqrt());
            let shifted = Matrix::from_fn(n, n, |i, j| if i == j { 2.0 } else { -scaled[(i, j)] });
            let mut x = Matrix::from_fn(n, 1, |i, _| 1.0 + libm::sin(i as f64));
            let mut least = 0.0;
            for _ in 0..4000 {
                let y = shifted.times(&x);
                let norm = y.as_slice().iter().map(|a| a * a).sum::<f64>().sqrt();
                let dot: f64 = x.as_slice().iter().zip(y.as_slice()).map(|(a, b)| a * b).sum();
                let square: f64 = x.as_slice().iter().map(|a| a * a).sum();
                least = 3.0 - dot / square;
                x = Matrix::from_fn(n, 1, |i, _| y[(i, 0)] / norm);
            }
            assert!(least > 5.0 / (degree * degree) as f64, "degree {degree}: {least:e}");
        }
    }
}
