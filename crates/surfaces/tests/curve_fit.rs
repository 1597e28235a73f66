//! Curves of boundaries as Bézier pieces: how many, how near, and that what is said of them is true.

use std::f64::consts::{FRAC_PI_2, TAU};

use proptest::prelude::*;
use surfaces::{Bezier, BoundaryCurve, CurveError, CurveFit, EllipseArc, Point, SplineCurve};

fn circle(radius: f64) -> EllipseArc {
    EllipseArc::circle(Point::new(0.3, -0.2, 0.1), Point::new(1.0, 2.0, -1.0), radius).unwrap()
}

/// Points of the pieces, `count` a piece.
fn along(fit: &CurveFit, count: usize) -> Vec<Point> {
    let shares = (0..=count).map(move |k| k as f64 / count as f64);
    fit.pieces().iter().flat_map(|piece| shares.clone().map(move |t| piece.point(t))).collect()
}

fn is_chain(fit: &CurveFit, closed: bool) -> bool {
    let joined = fit.pieces().windows(2).all(|pair| pair[0].end() == pair[1].start());
    let (first, last) = (&fit.pieces()[0], &fit.pieces()[fit.pieces().len() - 1]);
    joined && (!closed || last.end() == first.start())
}

/// Distance of a point from the chain through dense points.
fn distance(point: Point, dense: &[Point]) -> f64 {
    let segment = |ends: &[Point]| {
        let along = ends[1] - ends[0];
        let t = ((point - ends[0]).dot(along) / along.dot(along).max(1e-300)).clamp(0.0, 1.0);
        point.distance(ends[0] + along * t)
    };
    dense.windows(2).map(segment).fold(f64::INFINITY, f64::min)
}

/// Four arcs: how far from the circle, and how much of its area they miss, which is far less.
#[test]
fn a_circle_in_four_arcs() {
    for (degree, far, missed) in [(4, 9.2e-5, 1.8e-6), (6, 3.3e-7, 4.5e-11), (8, 7.5e-10, 2e-15)] {
        let fit = BoundaryCurve::from(circle(1.0)).fit(degree, 1e-4).unwrap();
        assert_eq!(fit.pieces().len(), 4);
        assert!(is_chain(&fit, true));
        let center = circle(1.0).center();
        let off = along(&fit, 100).iter().map(|p| (p.distance(center) - 1.0).abs()).fold(0.0, f64::max);
        let said = fit.deviation();
        assert!(off < far && said.largest < far && said.largest > 0.9 * off, "{degree} {said:?} {off:e}");
        let rule = bases::GaussLegendre::new(40).unwrap();
        let area: Point = fit.pieces().iter().fold(Point::ZERO, |sum, piece| {
            let density = |t: f64| (piece.point(t) - center).cross(piece.derivative(t)) * 0.5;
            rule.iter().fold(sum, |sum, (t, w)| sum + density(t) * w)
        });
        let misses = (area.norm() / std::f64::consts::PI - 1.0).abs();
        assert!(misses < missed, "{degree} {misses:e}");
        assert!(said.area > std::f64::consts::PI * misses && said.area < far * TAU, "{degree} {said:?}");
    }
}

#[test]
fn a_tighter_tolerance_takes_more_arcs() {
    let mut before = 0;
    for tolerance in [1e-2, 1e-4, 1e-6, 1e-8] {
        let fit = BoundaryCurve::from(circle(2.0)).fit(3, tolerance).unwrap();
        assert!(fit.deviation().largest <= tolerance && is_chain(&fit, true));
        assert!(fit.pieces().len() > before, "{tolerance}");
        before = fit.pieces().len();
    }
    let error = BoundaryCurve::from(circle(2.0)).fit(1, 1e-12).unwrap_err();
    assert!(matches!(error, CurveError::NotMet { degree: 1, .. }), "{error}");
}

/// A circle sampled with six digits is met by four pieces of degree 6 or less; eight exact digits need no more.
#[test]
fn samples_of_a_circle() {
    let sampled = |count: usize, digits: f64| -> Vec<Point> {
        let mut points: Vec<Point> = (0..count)
            .map(|k| circle(1.0).jet(k as f64 / count as f64).point)
            .map(|p| [p.x, p.y, p.z].map(|x| (x * digits).round() / digits).into())
            .collect();
        points.push(points[0]);
        points
    };
    for (count, digits, tolerance) in [(48, 1e6, 2e-6), (64, 1e6, 2e-6), (200, 1e10, 1e-8), (32, 1e8, 1e-6)] {
        let samples = sampled(count, digits);
        let fit = BoundaryCurve::through(samples.clone(), tolerance).unwrap().fit(8, 1.0).unwrap();
        assert_eq!(fit.pieces().len(), 4, "{count}");
        assert!(is_chain(&fit, true) && fit.deviation().largest <= tolerance);
        let off = along(&fit, 50)
            .iter()
            .map(|p| (p.distance(circle(1.0).center()) - 1.0).abs())
            .fold(0.0, f64::max);
        assert!(off < 8.0 * tolerance, "{count} {off:e}: between the samples, too");
    }
}

#[test]
fn straight_samples_are_a_segment() {
    let samples: Vec<Point> =
        [0.0, 0.1, 0.35, 0.5, 0.8, 1.0].iter().map(|&t| Point::new(3.0 * t, 1.0 - t, 2.0 * t)).collect();
    let fit = BoundaryCurve::through(samples, 1e-9).unwrap().fit(6, 1e-6).unwrap();
    assert_eq!(fit.pieces().len(), 1);
    assert_eq!(fit.pieces()[0].degree(), 1);
}

#[test]
fn samples_with_a_spike_are_not_smoothed_over() {
    let mut samples: Vec<Point> = (0..=20).map(|k| Point::new(f64::from(k), 0.0, 0.0)).collect();
    samples[10].y = 5.0;
    let fit = BoundaryCurve::through(samples.clone(), 1e-6).unwrap().fit(8, 1e-6).unwrap();
    let dense = along(&fit, 200);
    for sample in samples {
        assert!(distance(sample, &dense) < 1e-3, "{sample:?}");
    }
    assert!(dense.windows(2).all(|pair| pair[1].x >= pair[0].x - 1e-9), "it never turns back");
}

#[test]
fn points_on_straight_runs_of_a_polyline_are_left_out() {
    let p = |x: f64, y: f64| Point::new(x, y, 0.0);
    let chain = vec![p(0., 0.), p(1., 0.), p(2., 0.), p(3., 0.), p(3., 1.), p(3., 2.), p(2.5, 2.0)];
    let fit = BoundaryCurve::polyline(chain).unwrap().fit(3, 1.0).unwrap();
    let ends: Vec<Point> = fit.pieces().iter().map(Bezier::end).collect();
    assert_eq!(ends, [p(3., 0.), p(3., 2.), p(2.5, 2.0)]);
    // There and back is no straight run.
    let back = BoundaryCurve::polyline(vec![p(0., 0.), p(2., 0.), p(1., 0.)]).unwrap();
    assert_eq!(back.fit(3, 1.0).unwrap().pieces().len(), 2);
}

#[test]
fn a_spline_of_many_spans_is_met_by_fewer_pieces() {
    let count = 40;
    let mut knots = vec![0.0; 4];
    knots.extend((1..count - 3).map(|k| k as f64));
    knots.extend([(count - 3) as f64; 4]);
    // Control points f(ξ) − ½ v f''(ξ) at the means ξ of three knots, which reproduce quadratics: near a smooth curve.
    let control = |k: usize| {
        let [a, b, c] = [1, 2, 3].map(|i| 0.05 * knots[k + i]);
        let x = (a + b + c) / 3.0;
        let v = x * x - (a * b + b * c + c * a) / 3.0;
        Point::new(x, libm::sin(x) * (1.0 + 0.5 * v), 0.2 * (x * x - v))
    };
    let points = (0..count).map(control).collect();
    let curve = BoundaryCurve::spline(3, knots, points, None).unwrap();
    let exact = curve.fit(3, 1e-300).unwrap();
    assert_eq!((exact.pieces().len(), exact.deviation().largest), (37, 0.0));
    let near = curve.fit(6, 1e-5).unwrap();

    assert!(near.pieces().len() < 8 && near.deviation().largest <= 1e-5 && is_chain(&near, false));
    assert!(near.deviation().largest > 0.0);
    let dense = along(&exact, 200);
    for point in along(&near, 30) {
        assert!(distance(point, &dense) < 1.2e-5, "{point:?}");
    }
}

#[test]
fn bad_demands_are_refused() {
    let curve = BoundaryCurve::from(circle(1.0));
    assert!(matches!(curve.fit(0, 1.0), Err(CurveError::Degree { degree: 0, .. })));
    assert!(matches!(curve.fit(1000, 1.0), Err(CurveError::Degree { .. })));
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert!(matches!(curve.fit(4, tolerance), Err(CurveError::Tolerance { .. })));
    }
    assert_eq!(curve.fit(4, f64::INFINITY).unwrap().pieces().len(), 4);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn arcs_of_ellipses_are_met(
        radii in prop::array::uniform2(0.2..3.0f64),
        from in -6.0..6.0f64,
        turn in 0.01..6.25f64,
        degree in 3usize..9,
        digits in 3.0..9.0f64,
    ) {
        let (x, y) = (Point::new(0.0, 0.6, 0.8), Point::new(1.0, 0.0, 0.0));
        let arc = EllipseArc::new(Point::ZERO, [x, y], radii, from, from + turn).unwrap();
        let tolerance = libm::exp10(-digits);
        let fit = BoundaryCurve::from(arc.clone()).fit(degree, tolerance).unwrap();
        prop_assert!(is_chain(&fit, false));
        prop_assert!(fit.pieces().len() as f64 >= turn / FRAC_PI_2 - 1e-6);
        prop_assert_eq!(fit.pieces()[0].start(), arc.jet(0.0).point);
        for p in along(&fit, 23) {
            // To first order, the distance from the level line of (x/a)² + (y/b)².
            let (a, b) = (p.dot(x) / radii[0], p.dot(y) / radii[1]);
            let slope = 2.0 * ((a / radii[0]).powi(2) + (b / radii[1]).powi(2)).sqrt();
            let off = (a * a + b * b - 1.0).abs() / slope;
            prop_assert!(off <= 1.3 * tolerance + 1e-14, "{:e} {:e}", off, tolerance);
        }
    }

    #[test]
    fn rational_splines_are_met(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 7),
        weights in prop::collection::vec(0.3..3.0f64, 7),
    ) {
        let knots = vec![0., 0., 0., 0., 1., 2., 2.5, 4., 4., 4., 4.];
        let points = points.into_iter().map(Point::from).collect();
        let curve = SplineCurve::new(3, knots, points, Some(weights)).unwrap();
        let fit = BoundaryCurve::from(curve.clone()).fit(8, 1e-6).unwrap();
        prop_assert!(is_chain(&fit, false) && fit.deviation().largest <= 1e-6);
        let dense: Vec<Point> = (0..=20_000).map(|k| curve.jet(f64::from(k) / 20_000.0).point).collect();
        for point in along(&fit, 5) {
            prop_assert!(distance(point, &dense) < 1.3e-6);
        }
    }

    /// What a fit says of its distance from the samples holds, and smooth samples take few pieces.
    #[test]
    fn samples_of_a_smooth_curve_are_met(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 4),
        count in 12usize..80,
        digits in 3.0..7.0f64,
    ) {
        let curve = Bezier::new(points.into_iter().map(Point::from).collect()).unwrap();
        let samples: Vec<Point> = (0..=count).map(|k| curve.point(k as f64 / count as f64)).collect();
        let tolerance = libm::exp10(-digits);
        let fit = BoundaryCurve::through(samples.clone(), tolerance).unwrap().fit(7, 1.0).unwrap();
        prop_assert!(is_chain(&fit, false) && fit.deviation().largest <= tolerance);
        prop_assert_eq!((fit.pieces()[0].start(), fit.pieces()[fit.pieces().len() - 1].end()), (samples[0], samples[count]));
        let dense = along(&fit, 800);
        for sample in samples {
            prop_assert!(distance(sample, &dense) <= 1.05 * tolerance + 1e-5);
        }
    }

    /// Whatever the samples, there is a fit, and it passes them.
    #[test]
    fn any_samples_are_met(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 2..40),
        close in any::<bool>(),
        degree in 1usize..9,
    ) {
        let mut points: Vec<Point> = points.into_iter().map(Point::from).collect();
        if close {
            points.push(points[0]);
        }
        let fit = BoundaryCurve::through(points.clone(), 1e-3).unwrap().fit(degree, 1.0).unwrap();
        prop_assert!(is_chain(&fit, close) && fit.deviation().largest <= 1e-3);
        let dense = along(&fit, 300);
        for point in points {
            prop_assert!(distance(point, &dense) <= 2e-3);
        }
    }
}
