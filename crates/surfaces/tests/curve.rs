//! Curves of any family: derivatives, curvature, subdivision.

use std::sync::Arc;

use bases::{Aht, At, Basis, BasisError, Bernstein, Gt};
use proptest::prelude::*;
use surfaces::{Curve, CurveJet, Net, Patch, Point, SurfaceError, TensorPatch, tb_coons};

fn family() -> impl Strategy<Value = Arc<dyn Basis>> {
    prop_oneof![
        (1usize..10).prop_map(|n| Arc::new(Bernstein::new(n).unwrap()) as Arc<dyn Basis>),
        (0.01..7.0f64).prop_map(|a| Arc::new(Aht::new(a).unwrap()) as Arc<dyn Basis>),
        (0.01..5.6f64).prop_map(|a| Arc::new(At::new(a).unwrap()) as Arc<dyn Basis>),
    ]
}

fn curve(planar: bool) -> impl Strategy<Value = Curve> {
    (family(), prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 10)).prop_map(
        move |(basis, points)| {
            let points = points.iter().take(basis.count());
            let points = points.map(|p| Point::new(p[0], p[1], if planar { 0.0 } else { p[2] })).collect();
            Curve::new(basis, points).unwrap()
        },
    )
}

fn largest_distance(a: &[Point], b: &[Point]) -> f64 {
    a.iter().zip(b).fold(0.0, |m, (a, b)| m.max(a.distance(*b)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_reversed_polygon_turns_the_other_way(c in curve(true), x in 0.0..=1.0f64) {
        let (_, end) = c.basis().domain();
        let back = Curve::new(c.basis().clone(), c.points().iter().rev().copied().collect()).unwrap();
        let (there, back) = (c.jet(x * end), back.jet(end - x * end));
        prop_assume!(there.d1.norm() > 0.1 / end);
        let (k, m) = (there.signed_curvature().unwrap(), back.signed_curvature().unwrap());
        prop_assert!((k + m).abs() <= 1e-9 * (1.0 + k.abs()), "{k} {m}");
        prop_assert!((there.curvature().unwrap() - k.abs()).abs() <= 1e-12 * (1.0 + k.abs()));
    }

    #[test]
    fn curvature_is_the_inverse_of_length_under_scaling(c in curve(false), x in 0.0..=1.0f64, scale in 1e-3..1e3f64) {
        let t = x * c.basis().domain().1;
        let large = Curve::new(c.basis().clone(), c.points().iter().map(|p| *p * scale).collect()).unwrap();
        prop_assume!(c.jet(t).d1.norm() > 0.1 / c.basis().domain().1);
        let (k, m) = (c.jet(t).curvature().unwrap(), large.jet(t).curvature().unwrap() * scale);
        prop_assert!((k - m).abs() <= 1e-9 * (1.0 + k), "{k} {m}");
    }

    #[test]
    fn the_two_pieces_are_the_curve(c in curve(false), x in 0.02..0.98f64, y in 0.0..=1.0f64) {
        let (_, end) = c.basis().domain();
        let [left, right] = c.subdivide(x * end).unwrap();
        prop_assert_eq!(left.points().last(), right.points().first());
        prop_assert!(left.points().last().unwrap().distance(c.jet(x * end).point) < 1e-13);
        let scale = (left.basis().domain().1, right.basis().domain().1);
        let (l, r) = (left.jet(y * scale.0).point, right.jet(y * scale.1).point);
        prop_assert!(l.distance(c.jet(y * x * end).point) < 1e-12);
        prop_assert!(r.distance(c.jet(x * end + y * (1.0 - x) * end).point) < 1e-12);
    }

    #[test]
    fn repeated_halving_converges_to_the_curve(c in curve(false)) {
        let (start, end) = c.basis().domain();
        // The control point i of a piece lies near the curve at the i-th part of it.
        let distance = |levels: u32| {
            let pieces = c.refined(levels).unwrap();
            let n = c.points().len() - 1;
            let count = (pieces.len() * n) as f64;
            let polygon: Vec<Point> = pieces.iter().flat_map(|p| p.points()[..n].to_vec()).collect();
            let curve: Vec<Point> = (0..polygon.len())
                .map(|k| c.jet(start + (end - start) * (k as f64 / count)).point)
                .collect();
            largest_distance(&polygon, &curve)
        };
        let (d5, d7) = (distance(5), distance(7));
        prop_assert!(d7 <= d5 / 12.0 + 1e-12, "{d5} {d7}");
    }

    #[test]
    fn derivatives_are_those_of_the_points(c in curve(false), x in 0.1..0.9f64) {
        let (_, end) = c.basis().domain();
        let (t, h) = (x * end, 1e-4 * end);
        let [m, here, p] = [t - h, t, t + h].map(|t| c.jet(t));
        let d1 = (p.point - m.point) * (0.5 / h);
        let d2 = (p.d1 - m.d1) * (0.5 / h);
        // h² times third derivatives, at most (2 · degree)³ of the size of the points.
        prop_assert!(d1.distance(here.d1) * end <= 1e-4, "{d1:?} {here:?}");
        prop_assert!(d2.distance(here.d2) * end * end <= 1e-3);
    }
}

#[test]
fn a_parabola_has_its_curvature() {
    // (t, t²): κ = 2/(1 + 4t²)^{3/2}.
    let points = vec![Point::ZERO, Point::new(0.5, 0.0, 0.0), Point::new(1.0, 1.0, 0.0)];
    let parabola = Curve::new(Arc::new(Bernstein::new(2).unwrap()), points).unwrap();
    for (t, jet) in parabola.samples(11) {
        let exact = 2.0 / (1.0 + 4.0 * t * t).powf(1.5);
        assert!((jet.signed_curvature().unwrap() - exact).abs() < 1e-14);
    }
    let ends: Vec<f64> = parabola.samples(4).iter().map(|(t, _)| *t).collect();
    assert_eq!((ends[0], ends[3]), (0.0, 1.0));
    assert_eq!((parabola.samples(1).len(), parabola.samples(0).len()), (1, 0));
}

#[test]
fn there_is_no_curvature_where_a_curve_stands_still() {
    assert_eq!(CurveJet::default().curvature(), None);
    assert_eq!(CurveJet::default().signed_curvature(), None);
    let upright =
        CurveJet { d1: Point::new(0.0, 0.0, 1.0), d2: Point::new(1.0, 0.0, 0.0), ..CurveJet::default() };
    assert_eq!((upright.signed_curvature(), upright.curvature()), (None, Some(1.0)));
}

#[test]
fn bad_curves_are_errors() {
    let basis: Arc<dyn Basis> = Arc::new(Aht::new(1.0).unwrap());
    let error = Curve::new(basis.clone(), vec![Point::ZERO; 5]).unwrap_err();
    assert_eq!(error, SurfaceError::PolygonLength { expected: 6, found: 5 });
    let mut points = vec![Point::ZERO; 6];
    points[4].y = f64::NAN;
    assert_eq!(Curve::new(basis.clone(), points).unwrap_err(), SurfaceError::NotFinite { index: 4 });
    let curve = Curve::new(basis, vec![Point::ZERO; 6]).unwrap();
    assert!(matches!(curve.subdivide(2.0), Err(SurfaceError::Basis(BasisError::Cut { .. }))));
    assert_eq!(curve.refined(17).unwrap_err(), SurfaceError::Levels { levels: 17, max: 16 });
    let gt = Curve::new(Arc::new(Gt::new(3, [1.0, 1.0]).unwrap()), vec![Point::ZERO; 4]).unwrap();
    assert_eq!(gt.subdivide(0.5).unwrap_err(), SurfaceError::Basis(BasisError::NotSubdivisible));
}

#[test]
fn tensor_patches_are_subdivided_unless_they_are_blends() {
    let point = |k: usize| Point::new(k as f64, (k * k % 7) as f64, (k * 5 % 11) as f64);
    let net = Net::new(3, 4, (0..12).map(point).collect()).unwrap();
    let patch = TensorPatch::bernstein(net.clone()).unwrap();
    let [left, right] = patch.subdivide_u(0.25).unwrap();
    let [low, high] = patch.subdivide_v(0.75).unwrap();
    for (x, y) in [(0.0, 0.0), (0.3, 0.8), (1.0, 0.5)] {
        assert!(left.point(x, y).distance(patch.point(0.25 * x, y)) < 1e-13);
        assert!(right.point(x, y).distance(patch.point(0.25 + 0.75 * x, y)) < 1e-13);
        assert!(low.point(x, y).distance(patch.point(x, 0.75 * y)) < 1e-13);
        assert!(high.point(x, y).distance(patch.point(x, 0.75 + 0.25 * y)) < 1e-13);
    }
    let blend = tb_coons(net, [1.0; 4]).unwrap();
    assert_eq!(blend.subdivide_u(0.5).unwrap_err(), SurfaceError::SeveralProducts { found: 3 });
    assert_eq!(blend.subdivide_v(0.5).unwrap_err(), SurfaceError::SeveralProducts { found: 3 });
}
