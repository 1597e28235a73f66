//! Films over loops and graphs against closed forms and against each other.

use std::f64::consts::{PI, TAU};
use std::slice::from_ref;

use plateau::{
    AreaEnd, CurveGraph, Fill, FillEnergy, Film, GraphCurve, Loop, MethodError, Warning, Way, fill,
};
use proptest::prelude::*;
use surfaces::{BoundaryCurve, EllipseArc, Point, Vertex};

fn p(x: f64, y: f64, z: f64) -> Point {
    Point::new(x, y, z)
}

fn polygon(corners: &[[f64; 3]]) -> Loop {
    Loop::polygon(&corners.iter().map(|&c| c.into()).collect::<Vec<_>>()).unwrap()
}

fn circle(radius: f64, z: f64) -> Loop {
    let circle = EllipseArc::circle(p(0., 0., z), p(0., 0., 1.), radius).unwrap();
    Loop::new(vec![circle.into()], None).unwrap()
}

/// Exact curves of 4 arcs have an area as near as the table of the circle says, whatever their distance.
fn exactly(degree: usize) -> Fill {
    Fill::default().with_degree(degree).with_tolerance(1e-12).with_rim_tolerance(1e-3)
}

fn assert_area(name: &str, film: &Film, exact: f64, relative: f64) {
    let area = film.figures.area;
    assert!((area.value / exact - 1.0).abs() <= relative, "{name}: {} for {exact}", area.value);
    // That the gains of higher degrees do not fall off says nothing against the area.
    let is_sound = film.warnings.iter().all(|warning| matches!(warning, Warning::NoEstimate(_)));
    assert!(area.settled && is_sound, "{name}: {area:?} {:?}", film.warnings);
    let found = film.extremal.as_ref().unwrap();
    assert_eq!(found.end, AreaEnd::Stationary, "{name}");
    assert!((found.area.value - area.value).abs() <= found.area.error + area.error, "{name}");
}

/// K(¾)/K(¼) of complete elliptic integrals by parameter: the skew quadrilateral of unit edges of a cube.
const SKEW: f64 = 1.279_261_571_171_006;

#[test]
fn edges_of_a_cube() {
    let quadrilateral = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]]);
    let hexagon =
        polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]]);
    for (degree, relative, kink) in [(4, 2e-13, 1e-5), (6, 1e-15, 1e-6)] {
        let film = exactly(degree).with_way(Way::Midpoint).loops(from_ref(&quadrilateral), &()).unwrap();
        assert_area("quadrilateral", &film, SKEW, relative);
        assert!(film.seams.kink.unwrap().max < kink);
    }
    for (degree, relative) in [(4, 1e-11), (6, 1e-13)] {
        let film = exactly(degree).loops(from_ref(&hexagon), &()).unwrap();
        assert_eq!((film.way, film.complex().faces().len()), (Way::Midpoint, 6));
        assert_area("hexagon", &film, 1.5 * SKEW, relative);
    }
    let film = fill(&[quadrilateral], 8).unwrap();
    assert_eq!((film.way, film.seams.kink), (Way::Grid, None));
    assert_area("one patch", &film, SKEW, 1e-13);
}

#[test]
fn a_catenoid_between_rings() {
    let exact = {
        // c cosh(h/c) = 1 for the larger c, by Newton's method.
        let h: f64 = 0.3;
        let mut c: f64 = 1.0;
        for _ in 0..50 {
            let (s, d) = (libm::sinh(h / c), libm::cosh(h / c));
            c -= (c * d - 1.0) / (d - h / c * s);
        }
        PI * c * (2.0 * h + c * libm::sinh(2.0 * h / c))
    };
    for (degree, relative) in [(4, 1e-6), (6, 3e-11), (8, 2e-15)] {
        let film = exactly(degree).loops(&[circle(1.0, -0.3), circle(1.0, 0.3)], &()).unwrap();
        assert_eq!((film.way, film.complex().faces().len()), (Way::Annulus, 4));
        assert_area("catenoid", &film, exact, relative);
        assert!((film.one_by_one.unwrap() / TAU - 1.0).abs() < 2e-6);
        // What the rim can mean bounds what it means.
        assert!((film.figures.area.value - exact).abs() < film.rim.area);
    }
}

#[test]
fn rings_too_far_apart() {
    // The discs have less area from h/R = 0.5277 on, and no annulus is stationary beyond 0.66274.
    let rings = |h: f64| [circle(1.0, -h), circle(1.0, h)];
    let film = exactly(6).loops(&rings(0.52), &()).unwrap();
    assert!(film.warnings.is_empty(), "{:?}", film.warnings);
    let film = exactly(6).loops(&rings(0.54), &()).unwrap();
    assert!(matches!(film.warnings[..], [Warning::OneByOne { .. }]), "{:?}", film.warnings);
    let film = exactly(6).loops(&rings(0.6627), &()).unwrap();
    assert!(matches!(film.warnings[..], [Warning::OneByOne { .. }]), "{:?}", film.warnings);
    for h in [0.6628, 0.7, 5.0] {
        let Err(MethodError::Apart { apex, axis, discs }) = exactly(6).loops(&rings(h), &()) else {
            panic!("nothing spans rings at {h}");
        };
        assert!(Point::from(apex).norm() < 1e-3 && axis[2] > 0.999);
        assert!((discs.unwrap() / TAU - 1.0).abs() < 1e-6);
    }
}

/// The cone is found wherever it stands: rings of unequal size, turned and moved, with and without corners.
#[test]
fn loops_in_the_halves_of_a_cone_are_refused_wherever_it_stands() {
    let turned = |z: f64, radius: f64, corners: Option<usize>| {
        let at = |k: f64| {
            let (s, c) = libm::sincos(k);
            // About the axis (1, 2, 2)/3.
            let [e, f, g] =
                [[2.0, -2.0, 1.0], [2.0, 1.0, -2.0], [1.0, 2.0, 2.0]].map(|d| Point::from(d) * (1.0 / 3.0));
            p(5.0, -3.0, 8.0) + e * (radius * c) + f * (radius * s) + g * z
        };
        match corners {
            Some(n) => {
                Loop::polygon(&(0..n).map(|k| at(TAU * k as f64 / n as f64)).collect::<Vec<_>>()).unwrap()
            }
            None => Loop::new(
                vec![
                    BoundaryCurve::through(
                        (0..=200).map(|k| at(TAU * f64::from(k % 200) / 200.0)).collect(),
                        1e-6,
                    )
                    .unwrap(),
                ],
                None,
            )
            .unwrap(),
        }
    };
    let refused = |first: &Loop, second: &Loop| {
        matches!(exactly(4).loops(&[first.clone(), second.clone()], &()), Err(MethodError::Apart { .. }))
    };
    // Together 1.4 wide: the cone holds them from 1.4/1.5089 = 0.9278 on.
    assert!(refused(&turned(0.0, 1.0, None), &turned(0.95, 0.4, None)));
    assert!(!refused(&turned(0.0, 1.0, None), &turned(0.90, 0.4, None)));
    assert!(refused(&turned(0.0, 1.0, Some(5)), &turned(1.4, 1.0, Some(3))));
    assert!(!refused(&turned(0.0, 1.0, Some(5)), &turned(0.8, 1.0, Some(5))));
}

/// A long strip beside another: no cone holds them, and the annulus pinches.
#[test]
fn an_annulus_that_pinches_says_where() {
    let strip = |z: f64| polygon(&[[-4.0, -0.3, z], [4.0, -0.3, z], [4.0, 0.3, z], [-4.0, 0.3, z]]);
    let film = exactly(4).loops(&[strip(-0.6), strip(0.6)], &()).unwrap();
    assert!(
        film.warnings.iter().any(|warning| matches!(warning, Warning::Pinches { .. })),
        "{:?}",
        film.warnings
    );
}

/// The surface z = x² − y² over [−1, 1]² as a rim, and Scherk's z = log(cos x / cos y).
#[test]
fn graphs_over_a_square() {
    let corners = [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)];
    let sides = |f: fn(f64, f64) -> f64| {
        (0..4).map(move |k| {
            let ((a, b), (c, d)) = (corners[k], corners[(k + 1) % 4]);
            move |t: f64| {
                let (x, y) = (a + (c - a) * t, b + (d - b) * t);
                p(x, y, f(x, y))
            }
        })
    };
    let saddle = sides(|x, y| x * x - y * y)
        .map(|f| vec![f(0.0), f(0.5) * 2.0 - (f(0.0) + f(1.0)) * 0.5, f(1.0)])
        .collect();
    let film = exactly(10).loops(&[Loop::sides(saddle).unwrap()], &()).unwrap();
    assert_area("saddle", &film, 7.383_505_602_602, 1e-9);
    let scherk = sides(|x, y| libm::log(libm::cos(x) / libm::cos(y)))
        .map(|f| BoundaryCurve::through((0..=200).map(|k| f(f64::from(k) / 200.0)).collect(), 2e-8).unwrap())
        .collect();
    let film = fill(&[Loop::new(scherk, None).unwrap()], 8).unwrap();
    assert_eq!(film.way, Way::Grid);
    assert_area("Scherk", &film, 5.697_512_211_587_083_5, 2e-8);
}

#[test]
fn enneper_in_one_loop() {
    let r: f64 = 0.7;
    let point = |a: f64| {
        let (u, v) = (r * libm::cos(a), r * libm::sin(a));
        p(u - u * u * u / 3.0 + u * v * v, -v + v * v * v / 3.0 - u * u * v, u * u - v * v)
    };
    let mut samples: Vec<Point> = (0..200).map(|k| point(TAU * f64::from(k) / 200.0)).collect();
    samples.push(samples[0]);
    let rim = Loop::new(vec![BoundaryCurve::through(samples, 1e-6).unwrap()], None).unwrap();
    let film = fill(&[rim], 8).unwrap();
    assert_eq!(film.way, Way::Ring);
    assert_area("Enneper", &film, PI * (r * r + r.powi(4) + r.powi(6) / 3.0), 1e-7);
}

fn line(ends: [usize; 2], points: &[Point]) -> GraphCurve {
    let curve = BoundaryCurve::bezier(vec![points[ends[0]], points[ends[1]]]).unwrap();
    GraphCurve { ends, curve }
}

/// Six flat films from the edges of a regular tetrahedron to its middle, three at each of four lines.
#[test]
fn films_in_a_tetrahedron() {
    let corners = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]].map(Point::from);
    let mut vertices: Vec<(String, Vertex)> =
        corners.iter().enumerate().map(|(k, &c)| (format!("v{k}"), Vertex::Fixed(c))).collect();
    vertices.push(("o".into(), Vertex::Free(Some(p(0.2, 0.1, -0.1)))));
    let edges: Vec<[usize; 2]> = (0..4).flat_map(|a| (a + 1..4).map(move |b| [a, b])).collect();
    let curves = edges.iter().map(|&ends| line(ends, &corners)).collect();
    let faces: Vec<Vec<usize>> = edges.iter().map(|&[a, b]| vec![a, b, 4]).collect();
    let graph = CurveGraph::new(vertices, curves, &faces, None).unwrap();
    let film = exactly(3).graph(&graph, &()).unwrap();
    assert_eq!(film.complex().faces().len(), 18);
    // Edges of length √8: 3/(2√2) · 8.
    assert_area("tetrahedron", &film, 6.0 * 2f64.sqrt(), 1e-12);
    assert!(film.complex().points()[4].norm() < 1e-6, "the films meet in the middle");
    assert_eq!(film.complex().orientation().joints().len(), 8);
    let names: Vec<[&str; 4]> = film.faces().map(|face| face.vertices).collect();
    assert_eq!(names.iter().filter(|names| names.contains(&"o")).count(), 6);
}

/// Thirteen films in a cube: Surface Evolver has 4.23956324 with 14799 unknowns.
#[test]
fn films_in_a_cube() {
    let cube: Vec<Point> = (0..8)
        .map(|k| [k & 1, (k >> 1) & 1, (k >> 2) & 1])
        .map(|[x, y, z]| p(x as f64, y as f64, z as f64))
        .collect();
    let mut vertices: Vec<(String, Vertex)> =
        cube.iter().enumerate().map(|(k, &c)| (format!("c{k}"), Vertex::Fixed(c))).collect();
    vertices.extend((0..4).map(|k| (format!("s{k}"), Vertex::Free(None))));
    let edges: Vec<[usize; 2]> = (0..8)
        .flat_map(|k| [1, 2, 4].into_iter().filter(move |bit| k & bit == 0).map(move |bit| [k, k | bit]))
        .collect();
    let curves = edges.iter().map(|&ends| line(ends, &cube)).collect();
    let mut faces = vec![vec![8, 9, 11, 10]];
    faces.extend(edges.iter().map(|&[a, b]| match [8 + (a & 3), 8 + (b & 3)] {
        [i, j] if i == j => vec![a, b, i],
        [i, j] => vec![a, b, j, i],
    }));
    let graph = CurveGraph::new(vertices, curves, &faces, None).unwrap();
    let film = exactly(4).graph(&graph, &()).unwrap();
    assert_area("cube", &film, 4.239_563_1, 1e-7);
}

/// Two squares at a right angle on a common wire: no kink is counted there; without the wire the edge between them goes.
#[test]
fn a_wire_may_bend_the_surface() {
    let corners =
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [0., 0., 1.], [0., 1., 1.]].map(Point::from);
    let film = |wire: bool| {
        let vertices =
            corners.iter().enumerate().map(|(k, &c)| (format!("v{k}"), Vertex::Fixed(c))).collect();
        let rim = [[0, 1], [1, 2], [2, 3], [3, 5], [5, 4], [4, 0]];
        let curves = rim.into_iter().chain(wire.then_some([0, 3])).map(|ends| line(ends, &corners)).collect();
        let graph = CurveGraph::new(vertices, curves, &[vec![0, 1, 2, 3], vec![0, 3, 5, 4]], None).unwrap();
        exactly(4).graph(&graph, &()).unwrap()
    };
    let (held, free) = (film(true), film(false));
    assert_area("two squares", &held, 2.0, 1e-14);
    assert!(held.seams.kink.unwrap().max < 1e-12 && !held.seams.folds());
    assert!(free.figures.area.value < 1.9 && free.seams.kink.unwrap().max < 0.1, "{:?}", free.seams);
}

#[test]
fn a_flat_loop_that_looks_in_is_cut_so_that_nothing_folds() {
    let corners = [[0., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.], [1., 2., 0.], [0., 2., 0.]];
    let film = fill(&[polygon(&corners)], 6).unwrap();
    assert_area("an ell", &film, 3.0, 1e-14);
    assert!(film.seams.jacobian_ratio > 0.2 && !film.seams.folds());
    let u = [
        [0., 0., 0.],
        [3., 0., 0.],
        [3., 3., 0.],
        [2., 3., 0.],
        [2., 1., 0.],
        [1., 1., 0.],
        [1., 3., 0.],
        [0., 3., 0.],
    ];
    let film = fill(&[polygon(&u)], 5).unwrap();
    assert_area("a u", &film, 7.0, 1e-13);
    // Asked for by name, midpoints fold here, and that is said.
    let folded = Fill::default().with_way(Way::Midpoint).loops(&[polygon(&u)], &());
    match folded {
        Ok(film) => {
            assert!(film.warnings.iter().any(|w| matches!(w, Warning::Folded { .. })), "{:?}", film.warnings)
        }
        Err(error) => assert!(matches!(error, MethodError::Energy(_)), "{error}"),
    }
}

#[test]
fn the_dirichlet_energy_of_a_film_is_least() {
    let hexagon =
        polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]]);
    let dirichlet = Fill::default().with_degree(6).with_energy(FillEnergy::Dirichlet);
    let (extremal, least) =
        (dirichlet.loops(from_ref(&hexagon), &()).unwrap(), fill(from_ref(&hexagon), 6).unwrap());
    let [a, b] = [&extremal, &least].map(|film| (film.figures.dirichlet.value, film.figures.area.value));
    assert!(a.0 < b.0 && b.1 < a.1, "{a:?} {b:?}");
    assert!(extremal.extremal.is_none() && least.extremal.is_some());
    assert!(a.0 >= a.1 && b.0 >= b.1 * (1.0 - 1e-14));
}

/// Samples with more pieces than twelve at degree 6 get a higher degree, unless one is asked for.
#[test]
fn the_degree_is_raised_rather_than_the_rim_cut() {
    let point = |t: f64| {
        let a = TAU * t;
        p(
            (1.0 + 0.2 * libm::cos(5.0 * a)) * libm::cos(a),
            (1.0 + 0.2 * libm::cos(5.0 * a)) * libm::sin(a),
            0.1 * libm::sin(3.0 * a),
        )
    };
    let mut samples: Vec<Point> = (0..600).map(|k| point(f64::from(k) / 600.0)).collect();
    samples.push(samples[0]);
    let rim = [Loop::new(vec![BoundaryCurve::through(samples, 1e-6).unwrap()], None).unwrap()];
    let dirichlet = Fill::default().with_energy(FillEnergy::Dirichlet);
    let (usual, six) =
        (dirichlet.loops(&rim, &()).unwrap(), dirichlet.with_degree(6).loops(&rim, &()).unwrap());
    assert_eq!(six.complex().degree(), 6);
    assert!(usual.complex().degree() > 6 && usual.complex().faces().len() < six.complex().faces().len());
}

/// A polygon around the axis; flat, or up and down by turns.
fn around(flat: bool) -> impl Strategy<Value = Vec<Point>> {
    (2usize..4, 0.1..0.6f64).prop_flat_map(move |(half, height)| {
        prop::collection::vec(if flat { 0.4..1.2f64 } else { 0.8..1.2f64 }, 2 * half).prop_map(move |radii| {
            let corner = |(k, radius): (usize, &f64)| {
                let angle = TAU * k as f64 / radii.len() as f64;
                let z = match (flat, k % 2) {
                    (true, _) => 0.0,
                    (false, 0) => height,
                    (false, _) => -height,
                };
                p(radius * libm::cos(angle), radius * libm::sin(angle), z)
            };
            radii.iter().enumerate().map(corner).collect()
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5))]

    #[test]
    fn flat_polygons_have_their_area(corners in around(true)) {
        let n = corners.len();
        let exact = (0..n).map(|k| 0.5 * corners[k].cross(corners[(k + 1) % n]).z).sum::<f64>();
        let film = fill(&[Loop::polygon(&corners).unwrap()], 4).unwrap();
        prop_assert!(!film.seams.folds(), "{:?} {:?}", film.way, film.seams);
        prop_assert!((film.figures.area.value / exact - 1.0).abs() < 1e-9, "{:?} {} {exact}", film.way, film.figures.area.value);
    }

    #[test]
    fn every_way_of_cutting_leads_to_the_same_area(corners in around(false)) {
        let rim = [Loop::polygon(&corners).unwrap()];
        let areas = [Way::Midpoint, Way::Ring, Way::TurnedRing].map(|way| {
            Fill::default().with_degree(6).with_way(way).loops(&rim, &()).unwrap().figures.area.value
        });
        let spread = areas.iter().fold(0.0, |spread, area| f64::max(spread, (area / areas[0] - 1.0).abs()));
        prop_assert!(spread < 1e-6, "{areas:?}");
    }

    #[test]
    fn a_film_moves_with_its_loop(corners in around(false), angle in 0.0..TAU, scale in 1e-2..1e2f64) {
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let moved = |q: Point| p(c * q.x - s * q.z + 3.0, q.y - 1.0, s * q.x + c * q.z) * scale;
        let image: Vec<Point> = corners.iter().map(|&q| moved(q)).collect();
        let [a, b] = [corners, image].map(|corners| fill(&[Loop::polygon(&corners).unwrap()], 4).unwrap());
        prop_assert_eq!((a.way, a.complex().faces().len()), (b.way, b.complex().faces().len()));
        prop_assert!((b.figures.area.value / (scale * scale) / a.figures.area.value - 1.0).abs() < 1e-11);
        for (&q, &r) in a.complex().points().iter().zip(b.complex().points()) {
            // Points may slide along the surface at hardly any price; what rounding moves grows from step to step.
            prop_assert!(moved(q).distance(r) < 1e-5 * scale);
        }
    }
}

#[test]
fn a_rim_of_circles_follows_the_accuracy_that_is_asked() {
    let usual = Fill::default().loops(&[circle(2.0, 0.0)], &()).unwrap();
    for accuracy in [1e-8, 1e-10] {
        for loops in [&[circle(2.0, 0.0)][..], &[circle(1.0, 0.0), circle(1.0, 0.8)]] {
            let film = Fill::default().with_accuracy(accuracy).loops(loops, &()).unwrap();
            let area = film.figures.area.value;
            assert!(film.rim.area <= accuracy * area, "{accuracy:e}: {:e}", film.rim.area);
            assert!(film.rim.largest < 0.1 * usual.rim.largest);
        }
    }
    // Parabolas would have to be very many: the rim stays in few, and says what it costs.
    let few = Fill::default().with_degree(2).with_accuracy(1e-10).loops(&[circle(2.0, 0.0)], &()).unwrap();
    assert!(few.rim.largest > 1e-9 && few.complex().faces().len() < 200, "{:?}", few.rim);
    let asked = Fill::default().with_rim_tolerance(1e-11).loops(&[circle(2.0, 0.0)], &()).unwrap();
    assert!(asked.rim.largest <= 1e-11 && asked.complex().faces().len() < 30);
}
