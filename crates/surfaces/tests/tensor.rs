//! Laws of nets, tensor patches, jets and meshes.

use proptest::prelude::*;
use surfaces::{Jet, Mesh, Net, Patch, Point, SurfaceError, TensorPatch, tb_coons};

fn net(rows: usize, cols: usize) -> impl Strategy<Value = Net> {
    prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], rows * cols)
        .prop_map(move |points| Net::new(rows, cols, points.into_iter().map(Point::from).collect()).unwrap())
}

fn sized_net() -> impl Strategy<Value = Net> {
    (3usize..=7, 3usize..=7).prop_flat_map(|(rows, cols)| net(rows, cols))
}

fn patch() -> impl Strategy<Value = TensorPatch> {
    let theta = || 0.2..3.8f64;
    (sized_net(), [theta(), theta(), theta(), theta()], 0..3).prop_map(|(net, shape, kind)| match kind {
        0 => TensorPatch::bernstein(net).unwrap(),
        1 => TensorPatch::gt(net, shape).unwrap(),
        _ => tb_coons(net, shape).unwrap(),
    })
}

/// Fourth-order central difference.
fn derivative(f: impl Fn(f64) -> Point, t: f64) -> Point {
    let h = 1e-3;
    ((f(t - 2.0 * h) - f(t + 2.0 * h)) + (f(t + h) - f(t - h)) * 8.0) * (1.0 / (12.0 * h))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn jets_are_the_derivatives_of_points(patch in patch(), u in 0.1..0.9f64, v in 0.1..0.9f64) {
        let jet = patch.jet(u, v);
        let at = |u, v| patch.jet(u, v);
        for (ours, difference) in [
            (jet.u, derivative(|t| at(t, v).point, u)),
            (jet.v, derivative(|t| at(u, t).point, v)),
            (jet.uu, derivative(|t| at(t, v).u, u)),
            (jet.uv, derivative(|t| at(u, t).u, v)),
            (jet.vv, derivative(|t| at(u, t).v, v)),
        ] {
            prop_assert!(ours.distance(difference) < 1e-6, "{ours:?} {difference:?}");
        }
    }

    #[test]
    fn scattered_points_and_jets_are_those_one_by_one(
        patch in patch(),
        parameters in prop::collection::vec([0.0..=1.0f64, 0.0..=1.0f64], 0..9),
    ) {
        let (points, jets) = (patch.points_at(&parameters), patch.jets_at(&parameters));
        prop_assert_eq!((points.len(), jets.len()), (parameters.len(), parameters.len()));
        for ((&[u, v], point), jet) in parameters.iter().zip(points).zip(jets) {
            prop_assert_eq!(point, patch.point(u, v));
            prop_assert_eq!(jet, patch.jet(u, v));
            prop_assert_eq!(jet.point, point);
        }
    }

    #[test]
    fn corners_are_interpolated_exactly(patch in patch()) {
        let net = patch.net();
        let (m, n) = net.degrees();
        prop_assert_eq!(patch.point(0.0, 0.0), net.point(0, 0));
        prop_assert!(patch.point(1.0, 1.0).distance(net.point(m, n)) < 1e-15);
        prop_assert!(patch.point(1.0, 0.0).distance(net.point(m, 0)) < 1e-15);
        prop_assert!(patch.point(0.0, 1.0).distance(net.point(0, n)) < 1e-15);
    }

    #[test]
    fn tb_coons_keeps_the_bernstein_boundary(net in sized_net(), shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5], t in 0.0..=1.0f64) {
        let (blend, bernstein) = (tb_coons(net.clone(), shape).unwrap(), TensorPatch::bernstein(net).unwrap());
        for (u, v) in [(0.0, t), (1.0, t), (t, 0.0), (t, 1.0)] {
            prop_assert!(blend.point(u, v).distance(bernstein.point(u, v)) < 1e-14);
        }
    }

    #[test]
    fn tb_coons_is_the_sum_of_the_paper(net in net(4, 4), shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5], u in 0.0..=1.0f64, v in 0.0..=1.0f64) {
        // R1 + R2 − T by their own definitions, GT (7.6), (7.7), and (7.1) on the four GT curves.
        use bases::{Basis, Bernstein, Gt};
        let b = Bernstein::new(3).unwrap();
        let (gu, gv) = (Gt::new(3, [shape[0], shape[1]]).unwrap(), Gt::new(3, [shape[2], shape[3]]).unwrap());
        let row = |basis: &dyn Basis, t: f64| basis.evaluate(t, 0).row(0).to_vec();
        let (bu, bv, gu, gv) = (row(&b, u), row(&b, v), row(&gu, u), row(&gv, v));
        let mut sum = Point::ZERO;
        for i in 0..4 {
            for j in 0..4 {
                sum += net.point(i, j) * (bu[i] * gv[j] + gu[i] * bv[j]);
            }
        }
        for k in 0..4 {
            sum = sum - net.point(0, k) * ((1.0 - u) * gv[k]) - net.point(3, k) * (u * gv[k]);
            sum = sum - net.point(k, 0) * ((1.0 - v) * gu[k]) - net.point(k, 3) * (v * gu[k]);
        }
        sum += net.point(0, 0) * ((1.0 - u) * (1.0 - v)) + net.point(0, 3) * ((1.0 - u) * v);
        sum += net.point(3, 0) * (u * (1.0 - v)) + net.point(3, 3) * (u * v);
        prop_assert!(tb_coons(net, shape).unwrap().point(u, v).distance(sum) < 1e-14);
    }

    #[test]
    fn raising_the_degree_moves_nothing(net in sized_net(), k in 1usize..5, u in 0.0..=1.0f64, v in 0.0..=1.0f64) {
        let raised = net.raised(k);
        prop_assert_eq!(raised.degrees(), (net.degrees().0 + k, net.degrees().1 + k));
        let (before, after) = (TensorPatch::bernstein(net).unwrap(), TensorPatch::bernstein(raised).unwrap());
        prop_assert!(before.point(u, v).distance(after.point(u, v)) < 1e-14);
    }

    #[test]
    fn grids_equal_single_points(patch in patch(), u in 0.0..=1.0f64, v in 0.0..=1.0f64) {
        let grid = patch.jets(&[0.25, u], &[v, 0.5, 1.0]);
        prop_assert_eq!(grid[3], patch.jet(u, v));
        prop_assert_eq!(grid[1], patch.jet(0.25, 0.5));
    }

    #[test]
    fn boundaries_make_nets_with_a_free_interior(net in sized_net()) {
        let [u0, u1, v0, v1] = net.boundary();
        let again = Net::from_boundary(&u0, &u1, &v0, &v1).unwrap();
        let (m, n) = net.degrees();
        for i in 0..=m {
            for j in 0..=n {
                let border = i == 0 || i == m || j == 0 || j == n;
                prop_assert_eq!(again.fixed()[i * (n + 1) + j], border);
                prop_assert_eq!(again.point(i, j), if border { net.point(i, j) } else { Point::ZERO });
            }
        }
        let filled = again.with_coordinates(&net.coordinates()).unwrap();
        prop_assert_eq!(filled.points(), net.points());
        prop_assert_eq!(filled.fixed(), again.fixed());
    }
}

/// Quadratic Bézier net of z = x² + c y² over [0, 1]².
fn paraboloid(c: f64) -> TensorPatch {
    let square = [0.0, 0.0, 1.0];
    let points = (0..9)
        .map(|k| Point::new((k / 3) as f64 / 2.0, (k % 3) as f64 / 2.0, square[k / 3] + c * square[k % 3]))
        .collect();
    TensorPatch::bernstein(Net::new(3, 3, points).unwrap()).unwrap()
}

#[test]
fn curvatures_of_a_paraboloid() {
    let c = -0.7;
    for (x, y) in [(0.0, 0.0), (0.3, 0.8), (1.0, 0.1)] {
        let jet: Jet = paraboloid(c).jet(x, y);
        let (p, q) = (2.0 * x, 2.0 * c * y);
        let w2 = 1.0 + p * p + q * q;
        let h = ((1.0 + q * q) * 2.0 + (1.0 + p * p) * 2.0 * c) / (2.0 * w2.powf(1.5));
        assert!((jet.mean_curvature().unwrap() - h).abs() < 1e-14);
        assert!((jet.gauss_curvature().unwrap() - 4.0 * c / (w2 * w2)).abs() < 1e-14);
        assert!((jet.area_density() - w2.sqrt()).abs() < 1e-15);
        assert!((jet.first_form().determinant() - w2).abs() < 1e-14);
    }
}

#[test]
fn singular_points_have_no_curvature_but_a_normal_in_the_mesh() {
    // All of row i = 0 in one point: x_v = 0 there.
    let mut points = vec![Point::ZERO; 3];
    points.extend(
        [[1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [2., 0., 1.], [2., 2., 1.], [0., 2., 1.]].map(Point::from),
    );
    let patch = TensorPatch::bernstein(Net::new(3, 3, points).unwrap()).unwrap();
    assert_eq!(patch.jet(0.0, 0.5).mean_curvature(), None);
    let mesh = Mesh::of(&patch, 4);
    assert_eq!(mesh.mean_curvature[2], None);
    assert!(mesh.normals.iter().all(|n| (n.norm() - 1.0).abs() < 1e-14));
}

proptest! {
    #[test]
    fn a_side_in_one_point_is_singular_wherever_it_lies(
        net in sized_net(),
        pole in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        (direction, exponent) in ([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], -3..7i32),
    ) {
        let far = Point::from(direction) * 10f64.powi(exponent) + Point::from(pole);
        let cols = net.cols();
        // One side in a point; the others lie on a smooth sheet, so that only it is singular.
        let at = |k: usize| match (k / cols, k % cols) {
            (0, _) => Point::ZERO,
            (i, j) => Point::new(i as f64, j as f64, 0.1 * net.points()[k].z),
        };
        let points = (0..net.points().len()).map(|k| far + at(k)).collect();
        let patch = TensorPatch::bernstein(Net::new(net.rows(), cols, points).unwrap()).unwrap();
        let mesh = Mesh::of(&patch, 8);
        for (parameters, h) in mesh.parameters.iter().zip(&mesh.mean_curvature) {
            prop_assert_eq!(h.is_none(), parameters[0] == 0.0, "{:?} {:?}", parameters, h);
        }
    }
}

#[test]
fn meshes_converge_to_the_patch_and_face_its_normals() {
    let patch = paraboloid(1.0);
    let (coarse, fine) = (Mesh::of(&patch, 16), Mesh::of(&patch, 64));
    assert_eq!((fine.points.len(), fine.triangles.len()), (65 * 65, 2 * 64 * 64));
    // ∫∫ √(1 + 4x² + 4y²) over the unit square.
    let exact = 1.861_563_653;
    let (e1, e2) = ((coarse.area() - exact).abs(), (fine.area() - exact).abs());
    assert!(e1 < 1e-3 && e2 < e1 / 10.0, "{} {}", coarse.area(), fine.area());
    for &[a, b, c] in &fine.triangles {
        let [p, q, r] = [a, b, c].map(|k| fine.points[k as usize]);
        assert!((q - p).cross(r - p).dot(fine.normals[a as usize]) > 0.0);
    }
}

#[test]
fn bad_boundaries_are_errors_that_name_the_row() {
    let p = |x: f64, y: f64| Point::new(x, y, 0.0);
    let u0 = [p(0., 0.), p(0., 1.)];
    let u1 = [p(1., 0.), p(1., 1.)];
    let (v0, v1) = ([p(0., 0.), p(1., 0.)], [p(0., 1.), p(1., 1.)]);
    assert!(Net::from_boundary(&u0, &u1, &v0, &v1).is_ok());
    let crossed = Net::from_boundary(&u0, &u1, &v1, &v0).unwrap_err();
    assert!(matches!(crossed, SurfaceError::Corner { first: "the start of u0", .. }));
    let long = [p(0., 0.), p(0., 0.5), p(0., 1.)];
    let length = Net::from_boundary(&u0, &long, &v0, &v1).unwrap_err();
    assert_eq!(length, SurfaceError::Length { name: "u1", expected: 2, found: 3 });
    assert!(matches!(
        Net::from_boundary(&u0[..1], &u1, &v0, &v1),
        Err(SurfaceError::TooShort { name: "u0", .. })
    ));
    let bad = vec![p(0., 0.), p(f64::NAN, 0.)];
    assert_eq!(Net::new(1, 2, bad).unwrap_err(), SurfaceError::NotFinite { index: 1 });
    assert!(matches!(Net::new(2, 2, vec![]), Err(SurfaceError::Size { .. })));
}
