//! The area to second order, against differences of the gradient, in the Bernstein functions and in others.

mod interior;

use bases::Matrix;
use energy::{
    AreaExpansion, DenseForm, EnergyError, Functional, TangentSamples, area, area_with_gradient,
    triangle_area_with_gradient,
};
use interior::{enneper, extremal, ni, solve};
use proptest::prelude::*;
use surfaces::{Net, Point, TensorPatch, TriangleNet, TrianglePatch, tb_coons};

const RULE: usize = 24;

/// A bumped flat net with its interior free.
fn tensor() -> impl Strategy<Value = TensorPatch> {
    let bumps = prop::collection::vec([-0.2..0.2f64, -0.2..0.2, -0.6..0.6], 20);
    (bumps, [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5], 0..3).prop_map(|(bumps, shape, kind)| {
        let point = |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[5 * i + j]);
        let row = |i: usize| (0..5).map(|j| point(i, j)).collect::<Vec<_>>();
        let col = |j: usize| (0..4).map(|i| point(i, j)).collect::<Vec<_>>();
        let net = Net::from_boundary(&row(0), &row(3), &col(0), &col(4)).unwrap();
        let all: Vec<f64> = (0..20).flat_map(|p| <[f64; 3]>::from(point(p / 5, p % 5))).collect();
        let net = net.with_coordinates(&all).unwrap();
        match kind {
            0 => TensorPatch::bernstein(net).unwrap(),
            1 => TensorPatch::gt(net, shape).unwrap(),
            _ => tb_coons(net, shape).unwrap(),
        }
    })
}

fn triangle() -> impl Strategy<Value = TrianglePatch> {
    (3usize..=5, prop::collection::vec([-0.15..0.15f64, -0.15..0.15, -0.6..0.6], 21)).prop_map(
        |(n, bumps)| {
            let flat = ni([false; 3], n);
            let all: Vec<f64> = flat
                .indices()
                .zip(bumps)
                .flat_map(|([i, j, _], b)| [i as f64 + b[0], j as f64 + b[1], b[2]])
                .collect();
            // The same corners in both polygons: the net is made whole again from its own border.
            let [ab, bc, ca] = flat.with_coordinates(&all).unwrap().boundary();
            let net = TriangleNet::from_boundary(&ab, &bc, &ca).unwrap().with_coordinates(&all).unwrap();
            TrianglePatch::new(net).unwrap()
        },
    )
}

/// Coordinates of the free points, as positions in the net's coordinates.
fn free(fixed: &[bool]) -> Vec<usize> {
    (0..3 * fixed.len()).filter(|c| !fixed[c / 3]).collect()
}

/// Column `at` of the Hessian by fourth-order differences of gradients.
fn differences(x: &[f64], at: usize, gradient: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let h = 1e-3;
    let shifted = |d: f64| {
        let mut y = x.to_vec();
        y[at] += d;
        gradient(&y)
    };
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|s| shifted(s * h));
    (0..a.len()).map(|k| ((a[k] - d[k]) + 8.0 * (c[k] - b[k])) / (12.0 * h)).collect()
}

fn check(expansion: &AreaExpansion, at: usize, column: &[f64]) -> Result<(), TestCaseError> {
    let scale = expansion.hessian.max_abs();
    for (k, difference) in column.iter().enumerate() {
        let entry = expansion.hessian[(k, at)];
        prop_assert!((entry - difference).abs() <= 1e-6 * scale, "({k}, {at}): {entry} {difference}");
        prop_assert_eq!(entry, expansion.hessian[(at, k)]);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn tensor_hessians_are_differences_of_gradients(patch in tensor(), at in 0usize..18) {
        let expansion = AreaExpansion::of_tensor(&patch, RULE).unwrap();
        let (x, free) = (patch.net().coordinates(), free(patch.net().fixed()));
        prop_assert_eq!(free.len(), expansion.gradient.len());
        let moved = |x: &[f64]| patch.with_net(patch.net().with_coordinates(x).unwrap()).unwrap();
        let column = differences(&x, free[at], |x| AreaExpansion::of_tensor(&moved(x), RULE).unwrap().gradient);
        check(&expansion, at, &column)?;
        let (integral, gradient) = area_with_gradient(&patch).unwrap();
        prop_assert!((expansion.value - integral.value).abs() <= 1e-8 * integral.value);
        for (k, &c) in free.iter().enumerate() {
            prop_assert!((expansion.gradient[k] - gradient[c]).abs() <= 1e-6, "{} {}", expansion.gradient[k], gradient[c]);
        }
    }

    #[test]
    fn triangular_hessians_are_differences_of_gradients(patch in triangle(), at in 0usize..1000) {
        let expansion = AreaExpansion::of_triangle(&patch, RULE).unwrap();
        let (x, free) = (patch.net().coordinates(), free(patch.net().fixed()));
        let at = at % free.len();
        let moved = |x: &[f64]| TrianglePatch::new(patch.net().with_coordinates(x).unwrap()).unwrap();
        let column = differences(&x, free[at], |x| AreaExpansion::of_triangle(&moved(x), RULE).unwrap().gradient);
        check(&expansion, at, &column)?;
        let (integral, gradient) = triangle_area_with_gradient(&patch).unwrap();
        prop_assert!((expansion.value - integral.value).abs() <= 1e-8 * integral.value);
        for (k, &c) in free.iter().enumerate() {
            prop_assert!((expansion.gradient[k] - gradient[c]).abs() <= 1e-6);
        }
    }

    #[test]
    fn other_functions_see_the_same_area(patch in triangle(), entries in prop::collection::vec(-1.0..1.0f64, 36)) {
        // ψ = φ map: gradients and Hessians transform with the map.
        let net = patch.net();
        let interior: Vec<bool> = net.fixed().iter().map(|fixed| !fixed).collect();
        let count = interior.iter().filter(|free| **free).count();
        let map = Matrix::from_fn(count, count, |k, l| entries[(6 * k + l) % 36] + if k == l { 3.0 } else { 0.0 });
        let direct = AreaExpansion::of_triangle(&patch, RULE).unwrap();
        let mut other = AreaExpansion::zero(count);
        for batch in TangentSamples::of_triangle(net.degree(), RULE).unwrap() {
            let samples = batch.selected(&interior).combined(&map).unwrap();
            other.add(&samples, &batch.tangents(net.points())).unwrap();
        }
        prop_assert!((direct.value - other.value).abs() <= 1e-13 * direct.value);
        let wide = Matrix::from_fn(3 * count, 3 * count, |k, l| if k % 3 == l % 3 { map[(k / 3, l / 3)] } else { 0.0 });
        let expected = wide.transpose().times(&direct.hessian).times(&wide);
        for (a, b) in other.hessian.as_slice().iter().zip(expected.as_slice()) {
            prop_assert!((a - b).abs() <= 1e-12 * expected.max_abs(), "{a} {b}");
        }
        for k in 0..3 * count {
            let expected: f64 = (0..3 * count).map(|c| wide[(c, k)] * direct.gradient[c]).sum();
            prop_assert!((other.gradient[k] - expected).abs() <= 1e-12);
        }
    }
}

#[test]
fn newton_steps_reach_the_stationary_point_of_the_area() {
    // NI1 of degree 3: from the Dirichlet extremal (0.99793) to the area's own minimum, quadratically.
    let net = ni([true, false, false], 3);
    let mut net = extremal(&DenseForm::of_triangle(Functional::Dirichlet, 3).unwrap(), &net);
    let mut norms = Vec::new();
    for _ in 0..6 {
        let patch = TrianglePatch::new(net.clone()).unwrap();
        let step = AreaExpansion::of_triangle(&patch, 32).unwrap();
        norms.push(step.gradient.iter().map(|g| g * g).sum::<f64>().sqrt());
        let rows = (0..3).map(|r| step.hessian.row(r).to_vec()).collect();
        let change = solve(rows, step.gradient.iter().map(|g| [-g, 0.0, 0.0]).collect());
        let mut x = net.coordinates();
        let at = 3 * net.position(1, 1);
        (0..3).for_each(|d| x[at + d] += change[d][0]);
        net = net.with_coordinates(&x).unwrap();
    }
    assert!(norms[0] > 1e-3 && norms[5] < 1e-14, "{norms:?}");
    let minimum = area(&TrianglePatch::new(net).unwrap()).unwrap();
    assert!((minimum.value - 0.99546).abs() < 5e-6, "{minimum:?}");
}

#[test]
fn minimal_surfaces_have_no_gradient_along_any_function() {
    let net = extremal(&DenseForm::of_triangle(Functional::Dirichlet, 3).unwrap(), &enneper());
    let expansion = AreaExpansion::of_triangle(&TrianglePatch::new(net).unwrap(), 16).unwrap();
    assert!(expansion.gradient.iter().all(|g| g.abs() <= 1e-14), "{:?}", expansion.gradient);
    assert!((expansion.value - 421.0 / 90.0).abs() <= 1e-13);
}

#[test]
fn singular_points_are_errors_that_name_them() {
    let net = ni([false; 3], 3);
    let flat = net.with_coordinates(&vec![0.5; 30]).unwrap();
    let error = AreaExpansion::of_triangle(&TrianglePatch::new(flat).unwrap(), 4).unwrap_err();
    assert!(matches!(error, EnergyError::Singular { u, .. } if u > 0.0), "{error}");
    let line = |s: f64| Point::new(s, s, s);
    let points = (0..9).map(|k| line((k / 3 + k % 3) as f64)).collect();
    let patch = TensorPatch::bernstein(Net::new(3, 3, points).unwrap()).unwrap();
    assert!(matches!(AreaExpansion::of_tensor(&patch, 4), Err(EnergyError::Singular { .. })));
    // Nothing free: only the value.
    let patch = TrianglePatch::new(TriangleNet::new(3, ni([true; 3], 3).points().to_vec()).unwrap()).unwrap();
    let expansion = AreaExpansion::of_triangle(&patch, 8).unwrap();
    assert!(expansion.value > 0.0 && expansion.gradient.is_empty());
}

#[test]
fn sizes_that_disagree_are_errors() {
    let samples = TangentSamples::of_triangle(2, 3).unwrap().next().unwrap();
    let tangents = samples.tangents(&[Point::new(1.0, 2.0, 3.0); 6]);
    let shape = |result: Result<(), EnergyError>| matches!(result, Err(EnergyError::Shape { .. }));
    assert!(shape(AreaExpansion::zero(5).add(&samples, &tangents)));
    assert!(shape(AreaExpansion::zero(6).add(&samples, &tangents[1..])));
    assert!(shape(samples.combined(&Matrix::zeros(5, 6)).map(|_| ())));
    let (u, v) = (samples.u().clone(), samples.v().clone());
    let (at, weights) = (samples.parameters().to_vec(), samples.weights().to_vec());
    assert_eq!(TangentSamples::new(at.clone(), weights.clone(), u.clone(), v.clone()), Ok(samples));
    assert!(shape(TangentSamples::new(at.clone(), vec![], u.clone(), v.clone()).map(|_| ())));
    assert!(shape(TangentSamples::new(at, weights, u, Matrix::zeros(3, 5)).map(|_| ())));
}
