//! Areas against closed forms, and the gradient against differences.

use energy::{area, area_derivative, area_with_gradient};
use proptest::prelude::*;
use surfaces::{Net, Point, TensorPatch};

/// Enneper's surface x(u, v) = (u − u³/3 + uv², v − v³/3 + vu², u² − v²) over [0, 1]²: bicubic, conformal with
/// √(EG − F²) = (1 + u² + v²)².
fn enneper() -> TensorPatch {
    // Blossoms of 1, t, t², t³ at the cubic control parameters.
    let power = [[1., 1., 1., 1.], [0., 1. / 3., 2. / 3., 1.], [0., 0., 1. / 3., 1.], [0., 0., 0., 1.]];
    let points = (0..16)
        .map(|k| {
            let (u, v) = (|e: usize| power[e][k / 4], |e: usize| power[e][k % 4]);
            Point::new(u(1) - u(3) / 3. + u(1) * v(2), v(1) - v(3) / 3. + v(1) * u(2), u(2) - v(2))
        })
        .collect();
    TensorPatch::bernstein(Net::new(4, 4, points).unwrap()).unwrap()
}

#[test]
fn enneper_patch() {
    // ∫∫ (1 + u² + v²)² = 1 + 4/3 + 2/5 + 2/9.
    let exact = 1.0 + 4.0 / 3.0 + 2.0 / 5.0 + 2.0 / 9.0;
    let area = area(&enneper()).unwrap();
    assert!(area.settled);
    assert!((area.value - exact).abs() <= area.error, "{area:?}");
    assert!(area.error < 1e-12);
}

#[test]
fn folds_are_reported_with_the_error_that_remains() {
    // x = (u − u²)…: the sheet folds back on itself along u = ½, where the density has a kink |1 − 2u|.
    let points = (0..9).map(|k| Point::new([0.0, 0.5, 0.0][k / 3], (k % 3) as f64 / 2.0, 0.0)).collect();
    let area = area(&TensorPatch::bernstein(Net::new(3, 3, points).unwrap()).unwrap()).unwrap();
    assert!((area.value - 0.5).abs() <= area.error, "{area:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn gradients_are_those_of_the_area(
        bumps in prop::collection::vec([-0.2..0.2f64, -0.2..0.2, -0.2..0.2], 12),
        at in 0usize..36,
        shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5],
    ) {
        // A graph-like net, bumped: immersed, so that the area is smooth in the net.
        let points = bumps.iter().enumerate().map(|(k, &b)| Point::new((k / 4) as f64, (k % 4) as f64, 0.0) + Point::from(b));
        let net = Net::new(3, 4, points.collect()).unwrap();
        let value = |x: &[f64]| area(&TensorPatch::gt(net.with_coordinates(x).unwrap(), shape).unwrap()).unwrap().value;
        let x = net.coordinates();
        let (integral, gradient) = area_with_gradient(&TensorPatch::gt(net.clone(), shape).unwrap()).unwrap();
        prop_assert_eq!(integral.value, value(&x));
        let h = 1e-4;
        let shifted = |d: f64| {
            let mut y = x.clone();
            y[at] += d;
            value(&y)
        };
        let difference = (shifted(-2.0 * h) - shifted(2.0 * h) + 8.0 * (shifted(h) - shifted(-h))) / (12.0 * h);
        prop_assert!((gradient[at] - difference).abs() < 1e-7, "{} {}", gradient[at], difference);
    }

    #[test]
    fn derivatives_along_a_patch_are_those_of_the_gradient(
        bumps in prop::collection::vec([-0.2..0.2f64, -0.2..0.2, -0.2..0.2], 12),
        along in prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], 12),
        shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5],
    ) {
        let grid = |k: usize| Point::new((k / 4) as f64, (k % 4) as f64, 0.0);
        let points = bumps.iter().enumerate().map(|(k, &b)| grid(k) + Point::from(b)).collect();
        let moves: Vec<Point> = along.iter().copied().map(Point::from).collect();
        let patch = TensorPatch::gt(Net::new(3, 4, points).unwrap(), shape).unwrap();
        let direction = TensorPatch::gt(Net::new(3, 4, moves.clone()).unwrap(), shape).unwrap();
        let (integral, gradient) = area_with_gradient(&patch).unwrap();
        let by_gradient: f64 = gradient.chunks(3).zip(&moves).map(|(g, m)| g[0] * m.x + g[1] * m.y + g[2] * m.z).sum();
        let derivative = area_derivative(&patch, &direction, integral.points).unwrap();
        prop_assert!((derivative - by_gradient).abs() < 1e-11, "{derivative} {by_gradient}");
    }
}
