//! The area over displacements: products of functions against the sum over all points; normal displacements against
//! differences.

use bases::Matrix;
use energy::{AreaExpansion, EnergyError, NormalVariation, ProductArea, SampledArea, TangentSamples};
use proptest::prelude::*;
use surfaces::{Net, Patch, Point, TensorPatch};

fn patch() -> impl Strategy<Value = TensorPatch> {
    let bumps = prop::collection::vec([-0.2..0.2f64, -0.2..0.2, -0.6..0.6], 20);
    (bumps, any::<bool>()).prop_map(|(bumps, gt)| {
        let point = |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[5 * i + j]);
        let row = |i: usize| (0..5).map(|j| point(i, j)).collect::<Vec<_>>();
        let col = |j: usize| (0..4).map(|i| point(i, j)).collect::<Vec<_>>();
        let net = Net::from_boundary(&row(0), &row(3), &col(0), &col(4)).unwrap();
        let all: Vec<f64> = (0..20).flat_map(|p| <[f64; 3]>::from(point(p / 5, p % 5))).collect();
        let net = net.with_coordinates(&all).unwrap();
        if gt {
            TensorPatch::gt(net, [1.0, 2.0, 0.7, 3.0]).unwrap()
        } else {
            TensorPatch::bernstein(net).unwrap()
        }
    })
}

fn free(patch: &TensorPatch) -> Vec<bool> {
    patch.net().fixed().iter().map(|fixed| !fixed).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn products_of_functions_see_the_area_that_control_points_see(
        patch in patch(), moves in prop::collection::vec(-0.1..0.1f64, 18), scale in prop::collection::vec(0.5..2.0f64, 6),
    ) {
        let identity = (Matrix::identity(2), Matrix::identity(3));
        let area = ProductArea::new(&patch, &identity.0, &identity.1, &scale, 9).unwrap();
        let batches = TangentSamples::of_tensor(&patch, 9).unwrap();
        let factors = Matrix::from_fn(6, 6, |i, j| if i == j { scale[i] } else { 0.0 });
        let sampled = batches
            .map(|b| (b.selected(&free(&patch)).combined(&factors).unwrap(), b.tangents(patch.net().points())))
            .collect();
        let sampled = SampledArea::new(sampled).unwrap();
        let mut x = patch.net().coordinates();
        let mut at = 0;
        for (c, fixed) in x.chunks_exact_mut(3).zip(patch.net().fixed()) {
            if !fixed {
                (0..3).for_each(|d| c[d] += moves[3 * at + d] * scale[at]);
                at += 1;
            }
        }
        let moved = patch.with_net(patch.net().with_coordinates(&x).unwrap()).unwrap();
        let expected = AreaExpansion::of_tensor(&moved, 9).unwrap();
        let (mut gradient, mut hessian) = (vec![0.0; 18], vec![0.0; 324]);
        let (mut other_gradient, mut other_hessian) = (vec![0.0; 18], vec![0.0; 324]);
        let value = area.value_and_gradient(&moves, &mut gradient).unwrap();
        area.hessian(&moves, &mut hessian).unwrap();
        let other = sampled.value_and_gradient(&moves, &mut other_gradient).unwrap();
        sampled.hessian(&moves, &mut other_hessian).unwrap();
        prop_assert!((value - expected.value).abs() <= 1e-13 * value && (other - value).abs() <= 1e-13 * value);
        let size = expected.hessian.max_abs() * 4.0;
        for k in 0..18 {
            prop_assert!((gradient[k] - expected.gradient[k] * scale[k / 3]).abs() <= 1e-13 * size);
            prop_assert!((gradient[k] - other_gradient[k]).abs() <= 1e-13 * size);
            for l in 0..18 {
                let entry = expected.hessian[(k, l)] * scale[k / 3] * scale[l / 3];
                prop_assert!((hessian[18 * k + l] - entry).abs() <= 1e-13 * size, "({k}, {l})");
                prop_assert!((other_hessian[18 * k + l] - entry).abs() <= 1e-13 * size, "({k}, {l})");
                prop_assert_eq!(hessian[18 * k + l], hessian[18 * l + k]);
            }
        }
        for (a, b) in area.dirichlet_projection().iter().zip(sampled.dirichlet_projection()) {
            prop_assert!((a - b).abs() <= 1e-13 * size);
        }
    }

    #[test]
    fn the_normal_variation_is_the_second_difference_of_the_area(patch in patch(), f in prop::collection::vec(-1.0..1.0f64, 6)) {
        let ones = vec![1.0; 6];
        let area = ProductArea::new(&patch, &Matrix::identity(2), &Matrix::identity(3), &ones, 12).unwrap();
        let (samples, values) = area.samples().unwrap();
        let [us, vs] = area.nodes();
        let jets = patch.jets(us, vs);
        let mut variation = NormalVariation::zero(6);
        variation.add(&samples, &values, &jets).unwrap();
        let form = |m: &Matrix| -> f64 { (0..36).map(|k| f[k / 6] * m[(k / 6, k % 6)] * f[k % 6]).sum() };
        let expected = form(&variation.gradient) + form(&variation.curvature);
        let h = 1e-5;
        let normal = |u: f64, v: f64| patch.jet(u, v).normal().unwrap();
        let of = |row: &[f64]| -> f64 { row.iter().zip(&f).map(|(a, b)| a * b).sum() };
        let displaced = |t: f64| -> f64 {
            (0..samples.points()).map(|p| {
                let [u, v] = samples.parameters()[p];
                let (value, by_u, by_v) = (of(values.row(p)), of(samples.u().row(p)), of(samples.v().row(p)));
                let n_u = (normal(u + h, v) - normal(u - h, v)) * (0.5 / h);
                let n_v = (normal(u, v + h) - normal(u, v - h)) * (0.5 / h);
                let n = normal(u, v);
                let x_u = jets[p].u + (n * by_u + n_u * value) * t;
                let x_v = jets[p].v + (n * by_v + n_v * value) * t;
                samples.weights()[p] * x_u.cross(x_v).norm()
            }).sum()
        };
        let t = 1e-3;
        let difference = (displaced(t) - 2.0 * displaced(0.0) + displaced(-t)) / (t * t);
        prop_assert!((difference - expected).abs() <= 1e-3 * form(&variation.gradient), "{difference} {expected}");
    }
}

#[test]
fn sizes_and_singular_points_are_errors() {
    let flat =
        |z: f64| (0..9).map(|k| Point::new((k / 3) as f64, (k % 3) as f64 * z, 0.0)).collect::<Vec<_>>();
    let patch = TensorPatch::bernstein(Net::new(3, 3, flat(1.0)).unwrap()).unwrap();
    let one = Matrix::identity(1);
    let wrong = |result: Result<ProductArea, EnergyError>| matches!(result, Err(EnergyError::Shape { .. }));
    assert!(wrong(ProductArea::new(&patch, &Matrix::identity(2), &one, &[1.0], 4)));
    assert!(wrong(ProductArea::new(&patch, &one, &Matrix::identity(2), &[1.0], 4)));
    assert!(wrong(ProductArea::new(&patch, &one, &one, &[1.0; 2], 4)));
    let area = ProductArea::new(&patch, &one, &one, &[1.0], 4).unwrap();
    let (samples, values) = area.samples().unwrap();
    let mut variation = NormalVariation::zero(2);
    assert!(matches!(variation.add(&samples, &values, &[]), Err(EnergyError::Shape { .. })));
    let line = TensorPatch::bernstein(Net::new(3, 3, flat(0.0)).unwrap()).unwrap();
    let area = ProductArea::new(&line, &one, &one, &[1.0], 4).unwrap();
    let singular = area.value_and_gradient(&[0.0; 3], &mut [0.0; 3]).unwrap_err();
    assert!(matches!(singular, EnergyError::Singular { u, v } if u > 0.0 && v > 0.0));
    assert!(area.hessian(&[0.0; 3], &mut [0.0; 9]).is_err());
    let mut variation = NormalVariation::zero(1);
    let [us, vs] = area.nodes();
    let (samples, values) = area.samples().unwrap();
    assert!(matches!(
        variation.add(&samples, &values, &line.jets(us, vs)),
        Err(EnergyError::Singular { .. })
    ));
    assert!(SampledArea::new(vec![(samples, vec![])]).is_err());
}
