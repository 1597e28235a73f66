//! Gauss–Legendre rules against known values and the monomials they must integrate.
#![allow(clippy::excessive_precision, reason = "references are quoted with the digits they were computed to")]

use bases::{BasisError, GaussLegendre};

const U: f64 = f64::EPSILON / 2.0;

#[test]
fn five_points_as_tabulated() {
    // Abramowitz & Stegun 25.4, continued to 20 digits.
    let rule = GaussLegendre::new(5).unwrap().on(-1.0, 1.0);
    let nodes = [-0.906_179_845_938_663_992_8, -0.538_469_310_105_683_091_04, 0.0];
    let weights = [0.236_926_885_056_189_087_51, 0.478_628_670_499_366_468_04, 0.568_888_888_888_888_888_89];
    for k in 0..3 {
        assert!((rule.node(k) - nodes[k]).abs() <= U);
        assert!((rule.weight(k) - weights[k]).abs() <= f64::EPSILON * weights[k]);
        assert_eq!(rule.weight(k), rule.weight(4 - k));
        assert_eq!(rule.node(k), -rule.node(4 - k));
    }
}

#[test]
fn monomials_are_integrated_to_rounding() {
    for n in [1, 2, 3, 8, 20, 37, 64, 100, 333] {
        let rule = GaussLegendre::new(n).unwrap();
        for degree in 0..2 * n {
            let sum: f64 = rule.iter().map(|(t, w)| w * t.powi(degree as i32)).sum();
            let exact = 1.0 / (degree as f64 + 1.0);
            // The power itself costs about degree/2 roundings where it matters, near t = 1.
            let bound = U * (16.0 + degree as f64 + (n as f64).sqrt());
            assert!((sum / exact - 1.0).abs() <= bound, "{n} points, degree {degree}");
        }
        let missed: f64 = rule.iter().map(|(t, w)| w * (2.0 * t - 1.0).powi(2 * n as i32)).sum();
        if n <= 8 {
            let gap = (1.0 / (2.0 * n as f64 + 1.0) - missed).abs();
            assert!(gap > 1e-9, "degree 2n is where the rule must fail, {n}: {gap}");
        }
    }
}

#[test]
fn nodes_ascend_inside_and_weights_are_positive() {
    for n in [1, 2, 7, 100, 1001, 4000] {
        let rule = GaussLegendre::new(n).unwrap();
        let mut last = 0.0;
        for (t, w) in rule.iter() {
            assert!(t > last && t < 1.0 && w > 0.0, "{n}");
            last = t;
        }
    }
}

#[test]
fn the_first_node_is_relatively_accurate() {
    // First node of the 100-point rule on [0, 1]: (1 − x)/2 for the largest root x = 0.999713726773441233678…
    let first = GaussLegendre::new(100).unwrap().node(0);
    let exact = 1.431_366_132_793_831_608_66e-4;
    assert!((first / exact - 1.0).abs() < 1e-15, "{first:e}");
}

#[test]
fn impossible_sizes_are_refused() {
    assert_eq!(GaussLegendre::new(0), Err(BasisError::Points { points: 0, max: 10_000 }));
    assert!(GaussLegendre::new(1_000_000_000_000).is_err());
}
