//! Curves of boundaries: what each says of itself, its Bézier pieces, what is refused.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use surfaces::{Bezier, BoundaryCurve, CurveError, EllipseArc, Point, SplineCurve};

fn point() -> impl Strategy<Value = Point> {
    prop::array::uniform3(-1.0..1.0f64).prop_map(Point::from)
}

/// Splines with inner knots of any multiplicity up to the degree, clamped or not, rational or not.
fn spline() -> impl Strategy<Value = SplineCurve> {
    (1usize..5, prop::collection::vec((0.1..1.0f64, 1usize..4), 0..5), any::<bool>(), any::<bool>())
        .prop_flat_map(|(degree, inner, clamped, rational)| {
            let mut knots = Vec::new();
            let mut at = 0.0;
            let mut step = |knots: &mut Vec<f64>, length: f64, times: usize| {
                at += length;
                knots.extend(std::iter::repeat_n(at, times));
            };
            for _ in 0..=degree {
                step(&mut knots, if clamped { 0.0 } else { 0.3 }, 1);
            }
            for (length, times) in inner {
                step(&mut knots, length, times.min(degree));
            }
            step(&mut knots, 0.5, 1);
            for _ in 0..degree {
                step(&mut knots, if clamped { 0.0 } else { 0.2 }, 1);
            }
            let count = knots.len() - degree - 1;
            (prop::collection::vec(point(), count), prop::collection::vec(0.2..3.0f64, count))
                .prop_filter_map("the points coincide", move |(points, weights)| {
                    match SplineCurve::new(degree, knots.clone(), points, rational.then_some(weights)) {
                        Err(CurveError::Point) => None,
                        curve => Some(curve.unwrap()),
                    }
                })
        })
}

fn curve() -> impl Strategy<Value = BoundaryCurve> {
    prop_oneof![
        prop::collection::vec(point(), 2..7).prop_map(|p| BoundaryCurve::bezier(p).unwrap()),
        prop::collection::vec(point(), 2..9).prop_map(|p| BoundaryCurve::polyline(p).unwrap()),
        spline().prop_map(BoundaryCurve::Spline),
        prop::collection::vec(point(), 2..9).prop_map(|p| BoundaryCurve::through(p, 1e-3).unwrap()),
        (point(), 0.1..2.0f64, 0.1..2.0f64, 0.0..6.0f64, 0.1..6.2f64).prop_map(|(c, a, b, from, turn)| {
            let axes = [Point::new(0.6, 0.8, 0.0), Point::new(0.0, 0.0, 1.0)];
            BoundaryCurve::arc(c, axes, [a, b], from, from - turn).unwrap()
        }),
    ]
}

/// The B-spline by the definition of its functions (Cox and de Boor).
fn by_definition(curve: &SplineCurve, knot: f64) -> Point {
    fn function(knots: &[f64], i: usize, d: usize, t: f64, last: f64) -> f64 {
        if d == 0 {
            let inside = knots[i] <= t && (t < knots[i + 1] || (t == last && knots[i + 1] == last));
            return if inside && knots[i] < knots[i + 1] { 1.0 } else { 0.0 };
        }
        let part = |from: f64, to: f64, t: f64| if from != to { (t - from) / (to - from) } else { 0.0 };
        part(knots[i], knots[i + d], t) * function(knots, i, d - 1, t, last)
            + part(knots[i + d + 1], knots[i + 1], t) * function(knots, i + 1, d - 1, t, last)
    }
    let (mut sum, mut total) = (Point::ZERO, 0.0);
    for (i, &p) in curve.points().iter().enumerate() {
        let last = curve.knots()[curve.points().len()];
        let f = function(curve.knots(), i, curve.degree(), knot, last)
            * curve.weights().map_or(1.0, |weights| weights[i]);
        sum += p * f;
        total += f;
    }
    sum * (1.0 / total)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_spline_is_the_sum_of_its_functions(curve in spline(), t in 0.0..1.0f64) {
        let (from, to) = (curve.knots()[curve.degree()], curve.knots()[curve.points().len()]);
        let knot = from * (1.0 - t) + to * t;
        prop_assert!(curve.jet(t).point.distance(by_definition(&curve, knot)) < 1e-12);
    }

    #[test]
    fn derivatives_of_a_spline_are_difference_quotients(curve in spline(), t in 0.01..0.99f64) {
        let h = 1e-6;
        prop_assume!(curve.breaks().iter().all(|b| (b - t).abs() > 2.0 * h));
        let [before, here, after] = [t - h, t, t + h].map(|t| curve.jet(t));
        let d1 = (after.point - before.point) * (0.5 / h);
        let d2 = (after.d1 - before.d1) * (0.5 / h);
        let scale = 1.0 + here.d1.norm() + here.d2.norm();
        prop_assert!(d1.distance(here.d1) < 1e-6 * scale * scale, "{:?} {:?}", d1, here.d1);
        prop_assert!(d2.distance(here.d2) < 1e-5 * scale * scale, "{:?} {:?}", d2, here.d2);
    }

    #[test]
    fn the_pieces_of_a_spline_are_the_spline(curve in spline(), s in 0.0..1.0f64) {
        let pieces = curve.bezier_pieces();
        prop_assert_eq!(pieces.is_none(), curve.weights().is_some());
        let Some(pieces) = pieces else { return Ok(()) };
        let mut cuts = curve.breaks();
        cuts.insert(0, 0.0);
        cuts.push(1.0);
        prop_assert_eq!(cuts.len(), pieces.len() + 1);
        for (k, piece) in pieces.iter().enumerate() {
            prop_assert_eq!(piece.degree(), curve.degree());
            let t = cuts[k] * (1.0 - s) + cuts[k + 1] * s;
            prop_assert!(piece.point(s).distance(curve.jet(t).point) < 1e-11);
            if k > 0 {
                prop_assert_eq!(piece.start(), pieces[k - 1].end());
            }
        }
    }

    #[test]
    fn a_reversed_curve_runs_back(curve in curve(), t in 0.0..1.0f64) {
        let back = curve.reversed();
        prop_assert!(curve.point(t).distance(back.point(1.0 - t)) < 1e-10);
        prop_assert!(curve.start().distance(back.end()) < 1e-14);
        prop_assert_eq!(curve.is_closed(), back.is_closed());
        prop_assert!(curve.point(t).distance(curve.start()) <= 1.01 * curve.size());
    }

    #[test]
    fn the_pieces_of_a_bezier_curve_are_the_curve(p in prop::collection::vec(point(), 2..8), t in 0.0..1.0f64, s in 0.0..1.0f64) {
        let curve = Bezier::new(p).unwrap();
        let [left, right] = curve.split(t);
        prop_assert_eq!(left.end(), right.start());
        prop_assert!(left.point(s).distance(curve.point(t * s)) < 1e-14);
        prop_assert!(right.point(s).distance(curve.point(t + (1.0 - t) * s)) < 1e-14);
        prop_assert!(curve.raised(9).point(t).distance(curve.point(t)) < 1e-14);
        let h = 1e-6;
        let quotient = (curve.point(t + h) - curve.point(t - h)) * (0.5 / h);
        prop_assert!(curve.derivative(t).distance(quotient) < 1e-7);
    }
}

#[test]
fn a_circle_is_round_and_closed() {
    let normal = Point::new(1.0, -2.0, 0.5);
    let center = Point::new(3.0, 1.0, -1.0);
    let circle = EllipseArc::circle(center, normal, 2.5).unwrap();
    let curve = BoundaryCurve::from(circle.clone());
    assert!(curve.is_closed());
    assert_eq!(curve.start(), curve.end());
    for k in 0..10 {
        let off = curve.point(0.1 * f64::from(k)) - center;
        assert!((off.norm() - 2.5).abs() < 1e-14 && off.dot(normal).abs() < 1e-14);
    }
    let half = BoundaryCurve::from(circle.between(0.0, PI).unwrap());
    assert!(!half.is_closed());
    assert!(half.start().distance(half.end()) > 4.999_999);
}

/// A quarter of a circle is a rational quadratic.
#[test]
fn a_rational_quarter_is_round() {
    let points = [[1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(Point::from).to_vec();
    let weights = vec![1.0, 0.5f64.sqrt(), 1.0];
    let curve = SplineCurve::new(2, vec![0., 0., 0., 1., 1., 1.], points, Some(weights)).unwrap();
    for k in 0..=20 {
        assert!((curve.jet(f64::from(k) / 20.0).point.norm() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn unsound_curves_are_refused() {
    let p = |x: f64| Point::new(x, 0.0, 0.0);
    let some = |n: usize| (0..n).map(|k| p(k as f64)).collect::<Vec<_>>();
    assert!(matches!(BoundaryCurve::polyline(vec![p(0.0)]), Err(CurveError::Count { found: 1, .. })));
    assert_eq!(BoundaryCurve::polyline(vec![p(1.0); 5]), Err(CurveError::Point));
    assert_eq!(BoundaryCurve::bezier(vec![p(0.0), p(f64::NAN)]), Err(CurveError::NotFinite { index: 1 }));
    assert!(matches!(BoundaryCurve::bezier(some(200)), Err(CurveError::Count { found: 200, .. })));
    assert!(BoundaryCurve::polyline(vec![p(-1e308), p(1e308)]).is_err(), "its size is not finite");
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(BoundaryCurve::through(some(4), tolerance), Err(CurveError::Tolerance { .. })));
    }
    let spline = |degree, knots: &[f64], points| BoundaryCurve::spline(degree, knots.to_vec(), points, None);
    assert!(matches!(spline(0, &[], some(3)), Err(CurveError::Degree { degree: 0, .. })));
    assert!(matches!(spline(1, &[0., 1., 2.], some(3)), Err(CurveError::KnotCount { expected: 5, .. })));
    assert!(matches!(spline(1, &[0., 0., 2., 1., 1.], some(3)), Err(CurveError::KnotOrder { index: 3, .. })));
    assert!(matches!(
        spline(1, &[0., 0., 1., 1., 2., 2.], some(4)),
        Err(CurveError::KnotMultiplicity { knot: 1.0, degree: 1 })
    ));
    let weighted =
        |weights: &[f64]| BoundaryCurve::spline(1, vec![0., 0., 1., 2., 2.], some(3), Some(weights.to_vec()));
    assert!(matches!(weighted(&[1.0, 1.0]), Err(CurveError::WeightCount { found: 2, .. })));
    for weight in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-12] {
        assert!(matches!(weighted(&[1.0, weight, 1.0]), Err(CurveError::Weight { .. })), "{weight}");
    }
    let (x, y) = (Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0));
    let arc = |axes, radii, from, to| BoundaryCurve::arc(Point::ZERO, axes, radii, from, to);
    assert!(matches!(arc([x, x], [1.0, 1.0], 0.0, 1.0), Err(CurveError::Axes { .. })));
    assert!(matches!(arc([x, y * f64::NAN], [1.0, 1.0], 0.0, 1.0), Err(CurveError::Axes { .. })));
    assert_eq!(arc([x, y], [1.0, -1.0], 0.0, 1.0), Err(CurveError::Radius { radius: -1.0 }));
    for to in [0.0, 7.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(arc([x, y], [1.0, 1.0], 0.0, to), Err(CurveError::Angles { .. })), "{to}");
    }
    assert!(arc([x, y], [1.0, 1.0], 1.0, 1.0 - TAU).unwrap().is_closed());
}
