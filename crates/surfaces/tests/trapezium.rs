//! Right helicoids over a trapezium, by the endpoint rule and by the geometric construction.

use bases::At;
use proptest::prelude::*;
use surfaces::{Curve, CurveJet, Mesh, Patch, Point, SurfaceError, TrapeziumHelicoid};

const U: f64 = f64::EPSILON / 2.0;

/// A trapezium whose sides do not cross: span, γ, β.
fn trapezium() -> impl Strategy<Value = (f64, [f64; 2], [f64; 2])> {
    let span = prop_oneof![1 => (-6.0..0.0f64).prop_map(|x| 10f64.powf(x)), 2 => 0.1..TrapeziumHelicoid::LARGEST_PIECE];
    (span, -5.0..5.0f64, 0.5..8.0f64, -2.0..2.0f64, 0.2..5.0f64).prop_map(|(span, g0, start, b0, end)| {
        // Widths `start` and `end` at the two ends.
        (span, [g0, g0 + start], [b0, b0 + (end - start) / span])
    })
}

fn reach(helicoid: &TrapeziumHelicoid) -> f64 {
    Mesh::of(helicoid, 8).points.iter().fold(0.0, |m, p| m.max(p.norm()))
}

/// How far a point is from satisfying x sin z = y cos z, the equation of the helicoid.
fn off_helicoid(p: Point) -> f64 {
    (p.x * p.z.sin() - p.y * p.z.cos()).abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_patch_is_the_closed_form((span, gamma, beta) in trapezium()) {
        let helicoid = TrapeziumHelicoid::new(span, gamma, beta).unwrap();
        let patch = helicoid.patch().unwrap();
        let reach = reach(&helicoid);
        let deviation = helicoid.deviation(&patch, 8);
        prop_assert!(deviation <= 1e-12 * reach, "{deviation} of {reach}");
        for p in &Mesh::of(&patch, 6).points {
            prop_assert!(off_helicoid(*p) <= 1e-12 * reach);
        }
    }

    #[test]
    fn it_is_minimal((span, gamma, beta) in trapezium()) {
        let helicoid = TrapeziumHelicoid::new(span, gamma, beta).unwrap();
        let reach = reach(&helicoid);
        for (ours, exact) in [(helicoid.patch().unwrap(), &helicoid)].into_iter().flat_map(|(patch, exact)| {
            (0..=4).flat_map(|i| (0..=4).map(move |j| (f64::from(i) / 4.0, f64::from(j) / 4.0)))
                .map(|(x, y)| (patch.jet(x, y * span), exact.jet(x, y * span))).collect::<Vec<_>>()
        }) {
            let w = exact.area_density();
            for (a, b, order) in [(ours.u, exact.u, 0), (ours.v, exact.v, 1), (ours.uv, exact.uv, 1), (ours.vv, exact.vv, 2)] {
                let scale = 1e-12 * (b.norm() + exact.v.norm()) + 64.0 * U * reach * (4.0 / span).powi(order);
                prop_assert!(a.distance(b) <= scale, "{a:?} {b:?}");
            }
            prop_assert_eq!(ours.uu, Point::ZERO);
            // The terms of H, each with the error its derivatives carry.
            let (e, g) = (exact.u.norm(), exact.v.norm());
            let terms = g * g * exact.uu.norm() + e * g * exact.uv.norm() + e * e * exact.vv.norm();
            let rounding = 1024.0 * U * reach * (g * g + e * g / span + e * e / (span * span));
            let mean = exact.mean_curvature().unwrap().abs();
            prop_assert!(mean * 2.0 * w * w <= 64.0 * U * terms, "closed form: {mean}");
            let mean = ours.mean_curvature().unwrap().abs();
            prop_assert!(mean * 2.0 * w * w <= 1e-12 * terms + rounding, "patch: {mean}");
        }
    }

    #[test]
    fn the_geometric_construction_gives_the_same_net((span, gamma, beta) in trapezium()) {
        let helicoid = TrapeziumHelicoid::new(span, gamma, beta).unwrap();
        let (rule, constructed) = (helicoid.patch().unwrap(), helicoid.constructed_net().unwrap());
        let size = rule.net().points().iter().fold(0.0, |m: f64, p| m.max(p.norm()));
        for (a, b) in rule.net().points().iter().zip(constructed.points()) {
            prop_assert!(a.distance(*b) <= 32.0 * U * size, "{a:?} {b:?}");
        }
    }

    #[test]
    fn long_spans_are_cut_and_meet_exactly(turns in 0.1..12.0f64, g0 in -3.0..3.0f64, width in 0.1..5.0f64, slope in -1.0..1.0f64) {
        let span = turns * std::f64::consts::TAU;
        let helicoid = TrapeziumHelicoid::new(span, [g0, g0 + width], [slope, slope]).unwrap();
        let pieces = helicoid.pieces().unwrap();
        // Up to 0.99 of a turn it stays whole, though a piece of a longer one has 0.9 at most.
        let count = if turns <= 0.99 { 1 } else { (turns / 0.9).ceil() as usize };
        prop_assert_eq!(pieces.shape(), [1, count]);
        let reach = reach(&helicoid);
        prop_assert!(helicoid.deviation(&pieces, 31) <= 1e-12 * reach);
        prop_assert!(helicoid.deviation(&helicoid.constructed_pieces().unwrap(), 31) <= 1e-12 * reach);
        for pair in pieces.patches().windows(2) {
            let (here, next) = (&pair[0], &pair[1]);
            let surfaces::Domain::Rectangle { v: (_, end), .. } = here.domain() else { unreachable!() };
            for u in [0.0, 0.3, 0.7, 1.0] {
                prop_assert_eq!(here.point(u, end), next.point(u, 0.0));
            }
        }
    }

    #[test]
    fn subdivision_gives_the_trapeziums_of_the_parts((span, gamma, beta) in trapezium(), x in 0.05..0.95f64, u in 0.1..0.9f64) {
        let helicoid = TrapeziumHelicoid::new(span, gamma, beta).unwrap();
        let patch = helicoid.patch().unwrap();
        let [low, high] = patch.subdivide_v(x * span).unwrap();
        let [inner, outer] = patch.subdivide_u(u).unwrap();
        let size = patch.net().points().iter().fold(0.0, |m: f64, p| m.max(p.norm()));
        let short = TrapeziumHelicoid::new(x * span, gamma, beta).unwrap().patch().unwrap();
        for (ours, exact) in low.net().points().iter().zip(short.net().points()) {
            prop_assert!(ours.distance(*exact) <= 1e-13 * size);
        }
        let blend = |[a, b]: [f64; 2]| a + (b - a) * u;
        let narrow = TrapeziumHelicoid::new(span, [gamma[0], blend(gamma)], [beta[0], blend(beta)]).unwrap();
        for (ours, exact) in inner.net().points().iter().zip(narrow.patch().unwrap().net().points()) {
            prop_assert!(ours.distance(*exact) <= 1e-13 * size);
        }
        for k in 0..=4 {
            let y = f64::from(k) / 4.0;
            prop_assert!(high.point(u, y * (span - x * span)).distance(helicoid.point(u, x * span + y * (span - x * span))) <= 1e-12 * size);
            prop_assert!(outer.point(y, x * span).distance(helicoid.point(u + (1.0 - u) * y, x * span)) <= 1e-12 * size);
        }
    }
}

/// The net as AT (0.4) prints it: z multiplied by β too.
fn printed(span: f64, [gamma, beta]: [f64; 2]) -> Curve {
    let circle = Curve::circular_arc(1.0, 0.0, span).unwrap();
    let spiral = Curve::conical_spiral(0.0, span).unwrap();
    let points = circle.points().iter().zip(spiral.points()).map(|(&c, &a)| c * gamma + a * beta).collect();
    Curve::new(circle.basis().clone(), points).unwrap()
}

#[test]
fn the_printed_control_points_leave_the_helicoid_unless_the_slope_is_one() {
    let distance = |beta: f64| {
        printed(3.9, [6.2, beta]).samples(40).iter().fold(0.0, |m: f64, (_, j)| m.max(off_helicoid(j.point)))
    };
    assert!(distance(1.0) < 1e-13);
    assert!(distance(0.5) > 1.0, "{}", distance(0.5));
    // Ours at the same slope.
    let helicoid = TrapeziumHelicoid::new(3.9, [6.2, 12.5], [0.5, 0.5]).unwrap();
    for p in &Mesh::of(&helicoid.patch().unwrap(), 20).points {
        assert!(off_helicoid(*p) < 1e-13);
    }
}

#[test]
fn the_second_point_factor_of_theorem_2_is_m_less_delta() {
    // (2g₀ − f₀)e/(h f₁) with 2g₀ − f₀ = f₂ = sin α − α cos α.
    for a in [0.5f64, 2.0, 5.0, 6.0] {
        let (s, c) = a.sin_cos();
        let (f0, f1, f2, f3) = (3.0 * (a - s) - a * (1.0 - c), 2.0 - 2.0 * c - a * s, s - a * c, a * s);
        let (e, h) = (f1 * f1 - f0 * f2, f2 * f2 - f1 * f3);
        let [delta, m, _] = At::new(a).unwrap().endpoint_rule();
        assert!((2.0 * (a - s) - f0 - f2).abs() < 1e-14 * f0.max(1.0));
        assert!(((m - delta) - f2 * e / (h * f1)).abs() < 1e-9 * m, "{a}");
    }
}

#[test]
fn circles_and_spirals_are_exact_curves() {
    for (start, span) in [(0.0, 1e-6), (1.0, 2.0), (-40.0, 5.6)] {
        let (circle, spiral) =
            (Curve::circular_arc(2.5, start, span).unwrap(), Curve::conical_spiral(start, span).unwrap());
        for (t, jet) in circle.samples(9) {
            let v: f64 = start + t;
            assert!(jet.point.distance(Point::new(2.5 * v.cos(), 2.5 * v.sin(), 0.0)) < 1e-13);
            if span > 0.1 {
                assert!((jet.signed_curvature().unwrap() - 0.4).abs() < 1e-12);
                assert!((jet.curvature().unwrap() - 0.4).abs() < 1e-12);
            }
        }
        for (t, CurveJet { point, .. }) in spiral.samples(9) {
            let v: f64 = start + t;
            assert!(point.distance(Point::new(v * v.cos(), v * v.sin(), v)) < 1e-12 * v.abs().max(1.0));
        }
    }
}

#[test]
fn bad_trapeziums_are_errors() {
    let make = |span, gamma, beta| TrapeziumHelicoid::new(span, gamma, beta).map(|_| ());
    for span in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(make(span, [0.0, 1.0], [0.0, 0.0]), Err(SurfaceError::Interval { name: "v", .. })));
    }
    assert!(matches!(make(1.0, [0.0, f64::NAN], [0.0, 0.0]), Err(SurfaceError::Side { side: 1, .. })));
    assert!(matches!(make(1.0, [f64::INFINITY, 0.0], [0.0, 0.0]), Err(SurfaceError::Side { side: 0, .. })));
    assert_eq!(make(2.0, [0.0, 1.0], [1.0, 0.0]), Err(SurfaceError::Crossing { v: 1.0 }));
    assert_eq!(make(2.0, [1.0, 0.5], [0.0, 0.5]), Err(SurfaceError::Crossing { v: 1.0 }));
    assert!(matches!(make(2.0, [1.0, 1.0], [1.0, 1.0]), Err(SurfaceError::Crossing { .. })));
    // A triangle is a trapezium with one side of length 0.
    assert_eq!(make(2.0, [0.0, 2.0], [1.0, 0.0]), Ok(()));
    assert_eq!(make(2.0, [1.0, 1.0], [0.0, 1.0]), Ok(()));
    assert!(TrapeziumHelicoid::new(6.3, [0.0, 1.0], [0.0, 0.0]).unwrap().patch().is_err());
}
