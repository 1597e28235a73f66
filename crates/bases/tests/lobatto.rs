//! Integrated Legendre polynomials.

use bases::{Basis, Lobatto, gram};

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
