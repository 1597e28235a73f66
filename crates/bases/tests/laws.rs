//! Laws of the families, swept over degrees, shapes and parameters.

use std::sync::Arc;

use bases::{Basis, BasisError, Bernstein, Gt, GtParts, Matrix, Samples, Stacked, gram};
use proptest::prelude::*;

const U: f64 = f64::EPSILON / 2.0;

fn gt(degree: usize, shape: [f64; 2]) -> Gt {
    Gt::new(degree, shape).expect("admissible")
}

/// Shapes over the whole admissible square, its edges and corners included.
fn shape() -> impl Strategy<Value = [f64; 2]> {
    let theta = prop_oneof![4 => 0.0..=4.0f64, 1 => Just(0.0), 1 => Just(4.0)];
    [theta.clone(), theta].prop_filter("not both 0", |s| *s != [0.0, 0.0])
}

/// A family of either kind with a parameter of its domain.
fn family() -> impl Strategy<Value = (Arc<dyn Basis>, f64)> {
    let bernstein = (0usize..=30).prop_map(|n| Arc::new(Bernstein::new(n).unwrap()) as Arc<dyn Basis>);
    let gt = (2usize..=30, shape()).prop_map(|(n, s)| Arc::new(gt(n, s)) as Arc<dyn Basis>);
    (prop_oneof![bernstein, gt], prop_oneof![8 => 0.0..=1.0f64, 1 => 0.0..1e-6f64])
}

/// The recursion GT (2.4) with GT (A.2) continued to any order, as an independent second way.
fn by_recursion(n: usize, shape: [f64; 2], t: f64, order: usize) -> Vec<Vec<f64>> {
    if n == 2 {
        let seed = gt(2, shape).evaluate(t, order);
        return (0..=order).map(|r| seed.row(r).to_vec()).collect();
    }
    let low = by_recursion(n - 1, shape, t, order);
    let at = |r: usize, k: isize| if (0..n as isize).contains(&k) { low[r][k as usize] } else { 0.0 };
    (0..=order)
        .map(|r| {
            (0..=n as isize)
                .map(|k| {
                    let raised = (1.0 - t) * at(r, k) + t * at(r, k - 1);
                    if r == 0 { raised } else { raised + r as f64 * (at(r - 1, k - 1) - at(r - 1, k)) }
                })
                .collect()
        })
        .collect()
}

proptest! {
    #[test]
    fn values_sum_to_one_and_derivatives_to_zero((basis, t) in family()) {
        let table = basis.evaluate(t, 3);
        let sum: f64 = table.row(0).iter().sum();
        prop_assert!((sum - 1.0).abs() <= 8.0 * U, "sum {sum}");
        for r in 1..=3 {
            let sum: f64 = table.row(r).iter().sum();
            let scale: f64 = table.row(r).iter().map(|x| x.abs()).sum();
            prop_assert!(sum.abs() <= 100.0 * U * scale.max(1.0), "order {r}: {sum} of {scale}");
        }
    }

    #[test]
    fn values_are_nonnegative((basis, t) in family()) {
        for &value in basis.evaluate(t, 0).row(0) {
            prop_assert!(value >= -8.0 * U, "{value}");
        }
    }

    #[test]
    fn ends_are_interpolated_exactly((basis, _) in family()) {
        let n = basis.count() - 1;
        let unit = |k: usize| (0..=n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        prop_assert_eq!(basis.evaluate(0.0, 0).as_slice().to_vec(), unit(0));
        prop_assert_eq!(basis.evaluate(1.0, 0).as_slice().to_vec(), unit(n));
    }

    #[test]
    fn reversal_keeps_every_bit(n in 2usize..=30, s in shape(), k in 0u64..=1 << 40) {
        // On this grid both t and 1 − t are exact.
        let t = k as f64 / (1u64 << 40) as f64;
        let (there, back) = (gt(n, s).evaluate(t, 2), gt(n, [s[1], s[0]]).evaluate(1.0 - t, 2));
        let (straight, mirrored) = (Bernstein::new(n).unwrap().evaluate(t, 0), Bernstein::new(n).unwrap().evaluate(1.0 - t, 0));
        for i in 0..=n {
            prop_assert_eq!(there[(0, i)], back[(0, n - i)]);
            prop_assert_eq!(straight[(0, i)], mirrored[(0, n - i)]);
            for r in 1..=2 {
                let scale: f64 = there.row(r).iter().fold(1.0, |m, x| m.max(x.abs()));
                let sign = if r == 1 { -1.0 } else { 1.0 };
                prop_assert!((there[(r, i)] - sign * back[(r, n - i)]).abs() <= 80.0 * U * scale);
            }
        }
    }

    #[test]
    fn recursion_equals_closed_form(n in 3usize..=30, s in shape(), t in 0.0..=1.0f64) {
        let order = 4;
        let (closed, raised) = (gt(n, s).evaluate(t, order), by_recursion(n, s, t, order));
        for r in 0..=order {
            let scale = closed.row(r).iter().fold(1.0f64, |m, x| m.max(x.abs()));
            for k in 0..=n {
                let difference = (closed[(r, k)] - raised[r][k]).abs();
                prop_assert!(difference <= 40.0 * (n as f64) * U * scale, "order {r}, function {k}: {difference}");
            }
        }
    }

    #[test]
    fn gt_is_affine_in_its_shape(n in 2usize..=30, s in shape(), t in 0.0..=1.0f64) {
        let (whole, parts) = (gt(n, s).evaluate(t, 2), GtParts::new(n).unwrap().evaluate(t, 2));
        for r in 0..=2 {
            let scale = whole.row(r).iter().fold(1.0f64, |m, x| m.max(x.abs()));
            for k in 0..=n {
                let sum = parts[(r, k)] + s[0] * parts[(r, n + 1 + k)] + s[1] * parts[(r, 2 * (n + 1) + k)];
                prop_assert!((sum - whole[(r, k)]).abs() <= 40.0 * U * scale);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values((basis, t) in family(), r in 0usize..4) {
        // Fourth-order central difference of the r-th derivative, inside the interval.
        let h = 1e-3;
        let t = 0.01 + 0.98 * t;
        let d = |x: f64| basis.evaluate(x, r).row(r).to_vec();
        let exact = basis.evaluate(t, r + 1);
        let (m2, m1, p1, p2) = (d(t - 2.0 * h), d(t - h), d(t + h), d(t + 2.0 * h));
        let degree = basis.count() as f64 + 2.0;
        for k in 0..basis.count() {
            let difference = (m2[k] - p2[k] + 8.0 * (p1[k] - m1[k])) / (12.0 * h);
            // Its error is h⁴/30 times a derivative five orders up, bounded as for polynomials and sines of that degree.
            let bound = h.powi(4) / 30.0 * (2.0 * degree).powi(5 + r as i32) + 1e-9 * degree.powi(r as i32);
            prop_assert!((difference - exact[(r + 1, k)]).abs() <= bound, "order {}, function {k}", r + 1);
        }
    }

    #[test]
    fn gt_end_tangent(n in 2usize..=30, s in shape()) {
        let d1 = gt(n, s).evaluate(0.0, 1);
        let speed = n as f64 - 2.0 + s[0] * std::f64::consts::FRAC_PI_4;
        prop_assert!((d1[(1, 1)] - speed).abs() <= 80.0 * U * speed.max(1.0));
        prop_assert!((d1[(1, 0)] + speed).abs() <= 80.0 * U * speed.max(1.0));
    }

    #[test]
    fn gram_matrices_are_symmetric_and_integrate_by_parts(n in 2usize..=12, s in shape()) {
        let basis = gt(n, s);
        let (mass, cross) = (gram(&basis, 0, 0).unwrap(), gram(&basis, 0, 1).unwrap());
        prop_assert_eq!(&mass, &mass.transpose());
        for i in 0..=n {
            for j in 0..=n {
                // ∫ φ_i φ_j' + φ_i' φ_j = [φ_i φ_j], and only the end functions do not vanish at the ends.
                let ends = if i == j && i == n { 1.0 } else if i == j && i == 0 { -1.0 } else { 0.0 };
                prop_assert!((cross[(i, j)] + cross[(j, i)] - ends).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn bernstein_gram_has_its_closed_form() {
    // ∫ B_i B_j = C(n,i) C(n,j) / ((2n+1) C(2n, i+j)).
    let choose = |n: u32, k: u32| (1..=k).fold(1.0, |c, i| c * f64::from(n + 1 - i) / f64::from(i));
    for n in [1u32, 3, 8, 20] {
        let mass = gram(&Bernstein::new(n as usize).unwrap(), 0, 0).unwrap();
        for i in 0..=n {
            for j in 0..=n {
                let exact = choose(n, i) * choose(n, j) / (f64::from(2 * n + 1) * choose(2 * n, i + j));
                assert!((mass[(i as usize, j as usize)] / exact - 1.0).abs() < 1e-14, "{n} {i} {j}");
            }
        }
    }
}

#[test]
fn a_larger_rule_changes_no_gram_matrix() {
    for basis in [gt(2, [4.0, 0.0]), gt(3, [0.5, 3.5]), gt(30, [4.0, 4.0])] {
        let ours = gram(&basis, 2, 2).unwrap();
        let finer = Samples::new(&basis, 120, 2).unwrap();
        let finer = finer.gram(2, &finer, 2);
        for (a, b) in ours.as_slice().iter().zip(finer.as_slice()) {
            assert!((a - b).abs() <= 1e-14 * ours.max_abs());
        }
    }
}

#[test]
fn stacked_families_are_the_combinations_of_their_parts() {
    let (cubic, linear) = (Arc::new(Bernstein::new(3).unwrap()), Arc::new(Bernstein::new(1).unwrap()));
    // B_i − ℓ_i: vanishes at both ends for every i.
    let map = Matrix::from_fn(4, 6, |i, j| match (i, j) {
        (0, 4) | (3, 5) => -1.0,
        _ if i == j => 1.0,
        _ => 0.0,
    });
    let blend = Stacked::new(vec![cubic.clone(), linear], map).unwrap();
    assert_eq!(blend.evaluate(0.0, 0).row(0), [0.0; 4]);
    assert_eq!(blend.evaluate(1.0, 0).row(0), [0.0; 4]);
    assert_eq!(blend.evaluate(0.5, 0).row(0), [0.125 - 0.5, 0.375, 0.375, 0.125 - 0.5]);
    assert_eq!(blend.evaluate(0.5, 1)[(1, 0)], -0.75 + 1.0);
    let wrong = Stacked::new(vec![cubic], Matrix::zeros(2, 3)).unwrap_err();
    assert_eq!(wrong, BasisError::Map { expected: 4, found: 3 });
}

#[test]
fn bad_parameters_are_errors_that_name_them() {
    assert_eq!(Gt::new(3, [-0.1, 1.0]), Err(BasisError::Shape { index: 1, value: -0.1, range: Gt::SHAPES }));
    assert_eq!(Gt::new(3, [1.0, 4.5]), Err(BasisError::Shape { index: 2, value: 4.5, range: Gt::SHAPES }));
    assert!(matches!(Gt::new(3, [f64::NAN, 1.0]), Err(BasisError::Shape { index: 1, .. })));
    assert_eq!(Gt::new(3, [0.0, 0.0]), Err(BasisError::Dependent));
    assert!(matches!(Gt::new(1, [1.0, 1.0]), Err(BasisError::Degree { degree: 1, min: 2, .. })));
    assert!(matches!(Bernstein::new(1_000_000_000), Err(BasisError::Degree { max: 1000, .. })));
}

#[test]
fn high_degree_stays_finite_and_sums_to_one() {
    let basis = Bernstein::new(1000).unwrap();
    for t in [0.0, 1e-9, 0.3, 0.5, 0.99, 1.0] {
        let sum: f64 = basis.evaluate(t, 0).row(0).iter().sum();
        assert!((sum - 1.0).abs() < 64.0 * U, "{t}: {sum}");
    }
}
