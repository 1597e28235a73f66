//! Boundaries cut into quadrilaterals: which way, how many, and that what comes out hangs together.

use std::f64::consts::{PI, TAU};
use std::slice::from_ref;

use plateau::{CurveGraph, CutBoundary, Cutting, CuttingError, FaceSide, GraphCurve, Loop, Way};
use proptest::prelude::*;
use surfaces::{Bezier, BoundaryCurve, Complex, EllipseArc, Point, Vertex};

fn cutting(degree: usize) -> Cutting {
    Cutting::new(degree, 1e-5).unwrap()
}

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

fn regular(n: usize) -> Loop {
    let corner = |k: usize| TAU * k as f64 / n as f64;
    polygon(&(0..n).map(|k| [libm::cos(corner(k)), libm::sin(corner(k)), 0.0]).collect::<Vec<_>>())
}

/// Edges with one face; all are fixed, each end of them lies on two, and every other edge has two faces that run through it
/// in opposite senses.
fn rim(complex: &Complex) -> Vec<usize> {
    let edges = complex.edges();
    let mut at = vec![0; complex.vertices()];
    for edge in edges {
        match edge.uses() {
            [_] => {
                assert!(edge.is_fixed());
                edge.ends().into_iter().for_each(|end| at[end] += 1);
            }
            [a, b] => {
                let forward = |u: &surfaces::EdgeUse| u.side.runs_round() != u.reversed;
                assert_ne!(forward(a), forward(b), "faces of a disc or annulus are oriented alike");
            }
            other => panic!("{} faces at an edge", other.len()),
        }
    }
    assert!(at.iter().all(|count| [0, 2].contains(count)));
    (0..edges.len()).filter(|&e| edges[e].uses().len() == 1).collect()
}

/// V − E + F.
fn euler(complex: &Complex) -> isize {
    complex.vertices() as isize - complex.edges().len() as isize + complex.faces().len() as isize
}

/// Every point of the loop lies on the rim, to within `far`.
fn assert_rim_is(cut: &CutBoundary, loops: &[Loop], far: f64) {
    let complex = cut.complex();
    let rim: Vec<Bezier> = rim(complex).into_iter().map(|edge| complex.edge_curve(edge)).collect();
    for curve in loops.iter().flat_map(Loop::curves) {
        for k in 0..7 {
            let point = curve.point(f64::from(k) / 7.0);
            let nearest = rim
                .iter()
                .flat_map(|edge| (0..=100).map(move |k| edge.point(f64::from(k) / 100.0)))
                .map(|q| q.distance(point))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < far, "{nearest:e}");
        }
    }
}

#[test]
fn loops_are_cut_by_their_corners() {
    let hexagon =
        polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]]);
    let skew = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]]);
    let ell = polygon(&[[0., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.], [1., 2., 0.], [0., 2., 0.]]);
    let sharp = polygon(&[[0., 0., 0.], [4., 0., 0.], [4., 1., 0.]]);
    let lens = Loop::sides(vec![
        vec![p(-1., 0., 0.), p(0., 1., 0.), p(1., 0., 0.)],
        vec![p(1., 0., 0.), p(0., -1., 0.), p(-1., 0., 0.)],
    ])
    .unwrap();
    for (name, around, way, faces, corners) in [
        ("skew", skew, Way::Grid, 1, 4),
        ("hexagon", hexagon, Way::Midpoint, 6, 6),
        ("triangle", regular(3), Way::Midpoint, 3, 3),
        ("decagon", regular(10), Way::Midpoint, 10, 10),
        ("circle", circle(1.0, 0.0), Way::Ring, 5, 0),
        ("lens", lens, Way::Ring, 5, 2),
        ("a corner that looks in", ell, Way::Ring, 18, 6),
        ("a sharp corner", sharp, Way::Ring, 5, 3),
    ] {
        let cut = cutting(6).loops(from_ref(&around)).unwrap();
        assert_eq!((cut.way(), cut.complex().faces().len(), cut.corners()), (way, faces, corners), "{name}");
        assert_eq!(euler(cut.complex()), 1, "{name} is a disc");
        assert_rim_is(&cut, &[around], 0.03);
        assert_eq!(cut.names().len(), cut.complex().vertices());
    }
}

#[test]
fn any_loop_can_be_cut_in_every_way_it_has_corners_for() {
    let square = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]]);
    for (way, faces) in [(Way::Grid, 1), (Way::Midpoint, 4), (Way::Ring, 5), (Way::TurnedRing, 12)] {
        let cut = cutting(4).with_way(way).loops(from_ref(&square)).unwrap();
        assert_eq!((cut.way(), cut.complex().faces().len()), (way, faces));
        assert_eq!(euler(cut.complex()), 1);
        assert_rim_is(&cut, from_ref(&square), 0.03);
    }
    for way in [Way::Annulus, Way::Faces] {
        let refused = cutting(4).with_way(way).loops(from_ref(&square));
        assert!(matches!(refused, Err(CuttingError::Unsuitable { .. })));
    }
    let refused = cutting(4).with_way(Way::Grid).loops(&[circle(1.0, 0.0)]);
    assert!(matches!(refused, Err(CuttingError::Unsuitable { .. })));
}

/// Nothing of a flat loop lies outside it, and no quad turns over: every corner of every quad turns the same way.
fn assert_flat_quads(cut: &CutBoundary) {
    for face in cut.complex().faces() {
        let corners = face.vertices().map(|vertex| cut.complex().points()[vertex]);
        for k in 0..4 {
            let [a, b, c] = [0, 1, 2].map(|j| corners[(k + j) % 4]);
            assert!((b - a).cross(c - b).z > 0.0, "{:?} {corners:?}", face.vertices());
        }
    }
}

#[test]
fn loops_that_look_in_have_convex_parts() {
    let ell = [[0., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.], [1., 2., 0.], [0., 2., 0.]];
    let u = [[0., 0.], [3., 0.], [3., 3.], [2., 3.], [2., 1.], [1., 1.], [1., 3.], [0., 3.]]
        .map(|[x, y]| [x, y, 0.]);
    let comb = [
        [0., 0.],
        [5., 0.],
        [5., 2.],
        [4., 2.],
        [4., 1.],
        [3., 1.],
        [3., 2.],
        [2., 2.],
        [2., 1.],
        [1., 1.],
        [1., 2.],
        [0., 2.],
    ]
    .map(|[x, y]| [x, y, 0.]);
    for (around, parts) in [(polygon(&ell), 8), (polygon(&u), 12), (polygon(&comb), 24)] {
        let cut = cutting(4).with_way(Way::Parts).loops(from_ref(&around)).unwrap();
        assert_eq!((cut.way(), euler(cut.complex())), (Way::Parts, 1));
        assert!(cut.complex().faces().len() <= parts, "{}", cut.complex().faces().len());
        assert_flat_quads(&cut);
        assert_rim_is(&cut, &[around], 0.05);
    }
    let crossed = polygon(&[[0., 0., 0.], [2., 2., 0.], [2., 0., 0.1], [0., 1.9, 0.]]);
    let refused = cutting(4).with_way(Way::Parts).loops(&[crossed]);
    assert!(matches!(refused, Err(CuttingError::Unsuitable { .. })));
}

#[test]
fn a_flat_loop_that_crosses_itself_is_refused_with_the_place() {
    let at = |loops: &[Loop]| match cutting(6).loops(loops) {
        Err(CuttingError::Crosses { at }) => Some(Point::from(at)),
        Err(_) | Ok(_) => None,
    };
    let crossed = polygon(&[[0., 0., 0.], [2., 2., 0.], [2., 0., 0.], [0., 2., 0.]]);
    assert!(at(from_ref(&crossed)).unwrap().distance(p(1., 1., 0.)) < 1e-12);
    assert!(at(&[circle(9.0, 1.0), crossed]).is_some());
    // Smooth ones, in a plane that leans: samples of a lemniscate, and sides that come near one another without touching.
    let point = |t: f64| p(t.sin(), 0.6 * (2.0 * t).sin(), 0.8 * (2.0 * t).sin());
    let lobes: Vec<Point> = (0..=63).map(|k| point(0.05 + TAU * f64::from(k % 63) / 63.0)).collect();
    let eight = Loop::new(vec![BoundaryCurve::through(lobes, 1e-4).unwrap()], None).unwrap();
    assert!(at(&[eight]).unwrap().norm() < 1e-2);
    let bow = |height: f64| vec![p(0., 0., 0.), p(1., height, 0.), p(2., height, 0.), p(3., 0., 0.)];
    let crescent = |inner: f64| {
        let sides = vec![bow(2.0), bow(inner).into_iter().rev().collect()];
        Loop::sides(sides).unwrap()
    };
    assert_eq!(at(&[crescent(1.999)]), None);
    assert!(
        at(&[Loop::sides(vec![bow(2.0), vec![p(3., 0., 0.), p(2., 3., 0.), p(1., 0., 0.), p(0., 0., 0.)]])
            .unwrap()])
        .is_some()
    );
    // In space nothing is looked for: such a loop has a surface.
    assert!(cutting(6).loops(&[polygon(&[[0., 0., 0.], [2., 2., 0.], [2., 0., 1.], [0., 2., 1.]])]).is_ok());
}

#[test]
fn two_loops_make_an_annulus() {
    let loops = [circle(1.0, -0.3), circle(1.0, 0.3)];
    let cut = cutting(6).loops(&loops).unwrap();
    assert_eq!((cut.way(), cut.complex().faces().len(), euler(cut.complex())), (Way::Annulus, 4, 0));
    assert_rim_is(&cut, &loops, 0.03);
    // A ring that begins elsewhere and runs the other way is turned back: no face is twisted.
    let other = EllipseArc::new(p(0., 0., 0.3), [p(0., 1., 0.), p(1., 0., 0.)], [1.0; 2], 0.0, TAU).unwrap();
    let turned = [circle(1.0, -0.3), Loop::new(vec![other.into()], None).unwrap()];
    let cut = cutting(6).loops(&turned).unwrap();
    rim(cut.complex());
    for face in cut.complex().faces() {
        let [a, b, c, d] = face.vertices().map(|v| cut.complex().points()[v]);
        assert!(a.distance(d) < 0.61 && b.distance(c) < 0.61);
    }
    // A square and a circle: the square's sides are as many as the arcs.
    let square = polygon(&[[2., 2., 1.], [-2., 2., 1.], [-2., -2., 1.], [2., -2., 1.]]);
    let cut = cutting(6).loops(&[square, circle(1.0, 0.0)]).unwrap();
    assert_eq!((cut.complex().faces().len(), cut.corners()), (4, 4));
    let three = [circle(1.0, 0.0), circle(1.0, 1.0), circle(1.0, 2.0)];
    assert!(matches!(cutting(6).loops(&three), Err(CuttingError::Loops { found: 3 })));
    assert!(matches!(cutting(6).loops(&[]), Err(CuttingError::Loops { found: 0 })));
}

#[test]
fn slender_quads_are_cut_across() {
    let strip = polygon(&[[0., 0., 0.], [10., 0., 0.], [10., 1., 1.], [0., 1., 0.]]);
    let cut = cutting(4).loops(from_ref(&strip)).unwrap();
    assert_eq!((cut.way(), cut.complex().faces().len()), (Way::Grid, 4));
    assert_rim_is(&cut, &[strip], 0.02);
    // Two rings close together: every quad of the annulus is slender.
    let loops = [circle(1.0, 0.0), circle(1.0, 0.2)];
    let cut = cutting(6).loops(&loops).unwrap();
    assert_eq!((cut.complex().faces().len(), euler(cut.complex())), (16, 0));
    assert_rim_is(&cut, &loops, 0.03);
}

/// A square whose sides are pieced together of 1, 2, 1 and 3 pieces: opposite sides are cut alike.
#[test]
fn sides_of_several_pieces_make_a_grid() {
    let sides = vec![
        vec![p(0., 0., 0.), p(1., 0., 1.), p(2., 0., 0.)],
        vec![p(2., 0., 0.), p(2., 0.5, 0.5), p(2., 1., 0.5)],
        vec![p(2., 1., 0.5), p(2., 1.5, 0.5), p(2., 2., 0.)],
        vec![p(2., 2., 0.), p(0., 2., 0.)],
        vec![p(0., 2., 0.), p(0., 1., 0.), p(0., 0., 0.)],
    ];
    let around = Loop::sides(sides).unwrap();
    let cut = cutting(4).loops(from_ref(&around)).unwrap();
    assert_eq!((cut.way(), cut.corners(), cut.complex().faces().len()), (Way::Grid, 4, 2));
    assert_rim_is(&cut, &[around], 0.03);
}

/// One closed line of samples with four corners, begun in the middle of a side.
#[test]
fn corners_of_samples_are_found() {
    let mut samples = Vec::new();
    for side in 0..4 {
        for k in 0..12 {
            let t = f64::from(k) / 12.0;
            let bow = 0.6 * t * (1.0 - t);
            samples.push(match side {
                0 => p(t, 0.0, bow),
                1 => p(1.0, t, -bow),
                2 => p(1.0 - t, 1.0, bow),
                _ => p(0.0, 1.0 - t, -bow),
            });
        }
    }
    samples.rotate_left(5);
    samples.push(samples[0]);
    let around = Loop::new(vec![BoundaryCurve::through(samples, 1e-8).unwrap()], None).unwrap();
    let cut = cutting(6).loops(from_ref(&around)).unwrap();
    assert_eq!((cut.way(), cut.corners(), cut.complex().faces().len()), (Way::Grid, 4, 1));
    assert_rim_is(&cut, &[around], 0.03);
    assert!(cut.deviation().largest < 1e-8);
}

#[test]
fn ends_within_the_weld_are_one() {
    let sides = |gap: f64| {
        vec![
            BoundaryCurve::bezier(vec![p(0., 0., 0.), p(1., 0., 0.)]).unwrap(),
            BoundaryCurve::bezier(vec![p(1., gap, 0.), p(1., 1., 0.)]).unwrap(),
            BoundaryCurve::bezier(vec![p(1., 1., 0.), p(0., 1., 0.3), p(0., 0., 0.)]).unwrap(),
        ]
    };
    let error = Loop::new(sides(4e-4), None).unwrap_err();
    assert!(matches!(error, CuttingError::Gap { curve: 1, .. }), "{error}");
    let around = Loop::new(sides(4e-4), Some(1e-3)).unwrap();
    assert!((around.welded() - 4e-4).abs() < 1e-15);
    let cut = cutting(4).loops(&[around]).unwrap();
    assert!((cut.welded() - 4e-4).abs() < 1e-15);
    assert!(cut.deviation().largest >= 4e-4 && cut.deviation().area > 1e-4);
    rim(cut.complex());
    assert_eq!(Loop::new(sides(0.0), None).unwrap().welded(), 0.0);
}

fn line(a: Point, b: Point) -> BoundaryCurve {
    BoundaryCurve::bezier(vec![a, b]).unwrap()
}

/// A cube film's graph: wires along the edges of a cube, an inner square parallel to a face, thirteen films.
#[test]
fn films_share_triple_lines() {
    let cube: Vec<Point> =
        (0..8).map(|k| p((k & 1) as f64, ((k >> 1) & 1) as f64, ((k >> 2) & 1) as f64)).collect();
    let mut vertices: Vec<(String, Vertex)> =
        cube.iter().enumerate().map(|(k, &c)| (format!("c{k}"), Vertex::Fixed(c))).collect();
    // The inner square z = ½, vertices 8 … 11 next to the vertical edges.
    vertices.extend((0..4).map(|k| (format!("s{k}"), Vertex::Free(None))));
    let edges: Vec<[usize; 2]> = (0..8)
        .flat_map(|k| [1, 2, 4].into_iter().filter(move |bit| k & bit == 0).map(move |bit| [k, k | bit]))
        .collect();
    let curves: Vec<GraphCurve> =
        edges.iter().map(|&ends| GraphCurve { ends, curve: line(cube[ends[0]], cube[ends[1]]) }).collect();
    let mut faces = vec![vec![8, 9, 11, 10]];
    for &[a, b] in &edges {
        let [i, j] = [a & 3, b & 3];
        faces.push(if i == j { vec![a, b, 8 + i] } else { vec![a, b, 8 + j, 8 + i] });
    }
    let graph = CurveGraph::new(vertices, curves, &faces, None).unwrap();
    let cut = cutting(4).graph(&graph).unwrap();
    let complex = cut.complex();
    assert_eq!(cut.complex().faces().len(), 4 + 4 * 3 + 8 * 4);
    let with = |count: usize| complex.edges().iter().filter(|e| e.uses().len() == count).count();
    // Every wire carries one film here, and three films meet at the inner square and at the eight lines to it.
    assert_eq!((with(1), with(3)), (24, 2 * (4 + 8)));
    assert!((0..12).all(|k| cut.names()[k] == graph.names()[k]));
    assert!(complex.points()[8].distance(p(0.25, 0.25, 0.5)) < 0.2, "{:?}", complex.points()[8]);
}

#[test]
fn unsound_graphs_are_refused() {
    let corners = [p(0., 0., 0.), p(1., 0., 0.), p(1., 1., 0.)];
    let vertices = || corners.iter().enumerate().map(|(k, &c)| (k.to_string(), Vertex::Fixed(c))).collect();
    let curve = |a: usize, b: usize| GraphCurve { ends: [a, b], curve: line(corners[a], corners[b]) };
    let new = |curves, faces: &[&[usize]]| {
        CurveGraph::new(vertices(), curves, &faces.iter().map(|f| f.to_vec()).collect::<Vec<_>>(), None)
            .unwrap_err()
    };
    assert!(matches!(new(vec![], &[&[0, 1, 7]]), CuttingError::UnknownVertex { vertex: 7, .. }));
    assert!(matches!(new(vec![], &[&[0, 1]]), CuttingError::Polygon { face: 0, found: 2 }));
    assert!(matches!(new(vec![], &[&[0, 1, 2, 1]]), CuttingError::Polygon { face: 0, .. }));
    let twice = new(vec![curve(0, 1), curve(1, 0)], &[&[0, 1, 2]]);
    assert!(matches!(twice, CuttingError::TwoCurves { curves: [0, 1], .. }));
    let mut far = curve(0, 1);
    far.ends = [0, 2];
    assert!(matches!(new(vec![far], &[&[0, 1, 2]]), CuttingError::Apart { vertex: 2, .. }));
    let mut closed = curve(0, 1);
    closed.curve = EllipseArc::circle(Point::ZERO, p(0., 0., 1.), 1.0).unwrap().into();
    assert!(matches!(new(vec![closed], &[&[0, 1, 2]]), CuttingError::ClosedCurve { curve: 0 }));
    let graph = CurveGraph::new(vertices(), vec![], &[vec![0, 1, 2]], None).unwrap();
    assert!(cutting(3).graph(&graph).is_ok());
    assert!(matches!(cutting(3).with_way(Way::Annulus).graph(&graph), Err(CuttingError::Unsuitable { .. })));
}

/// Two vertices, three arches between them, two lenses: the middle arch carries both.
#[test]
fn curves_between_the_same_vertices() {
    let ends = [p(-1., 0., 0.), p(1., 0., 0.)];
    let vertices: Vec<(String, Vertex)> =
        ["a", "b"].into_iter().zip(ends).map(|(name, end)| (name.to_owned(), Vertex::Fixed(end))).collect();
    let arch = |y: f64| GraphCurve {
        ends: [0, 1],
        curve: BoundaryCurve::bezier(vec![ends[0], p(0., y, 1.0), ends[1]]).unwrap(),
    };
    let curves = vec![arch(-1.0), arch(0.0), arch(1.0)];
    let lens = |k: usize| {
        vec![FaceSide { ends: [0, 1], curve: Some(k) }, FaceSide { ends: [1, 0], curve: Some(k + 1) }]
    };
    let graph =
        CurveGraph::with_sides(vertices.clone(), curves.clone(), vec![lens(0), lens(1)], None).unwrap();
    let cut = cutting(4).graph(&graph).unwrap();
    let shared = cut.complex().edges().iter().filter(|e| e.is_fixed() && e.uses().len() == 2).count();
    assert_eq!((shared, euler(cut.complex())), (2, 1));
    let twice = CurveGraph::new(vertices.clone(), curves.clone(), &[vec![0, 1]], None).unwrap_err();
    assert!(matches!(twice, CuttingError::TwoCurves { .. }));
    let mut broken = lens(0);
    broken[1].ends = [0, 1];
    let error = CurveGraph::with_sides(vertices, curves, vec![broken, lens(1)], None).unwrap_err();
    assert!(matches!(error, CuttingError::Polygon { .. } | CuttingError::Side { .. }), "{error}");
}

/// A loop with 1 … 12 sides around the axis: straight or bowed, in and out, up and down.
fn wild() -> impl Strategy<Value = Loop> {
    (1usize..=12, 1usize..4).prop_flat_map(|(n, degree)| {
        // One and two sides need control points between their ends to be more than a point or a segment.
        let degree = if n < 3 { 4 } else { degree };
        let controls = prop::collection::vec((0.3..1.5f64, -0.8..0.8f64), n * degree);
        controls.prop_map(move |controls| {
            let control = |k: usize| {
                let (radius, z) = controls[k % controls.len()];
                let angle = TAU * (k % controls.len()) as f64 / controls.len() as f64;
                p(radius * libm::cos(angle), radius * libm::sin(angle), z)
            };
            let side = |k: usize| (0..=degree).map(|j| control(k * degree + j)).collect();
            Loop::sides((0..n).map(side).collect()).unwrap()
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_loop_makes_a_disc(around in wild(), degree in 4usize..7) {
        let cut = cutting(degree).loops(from_ref(&around)).unwrap();
        prop_assert_eq!(euler(cut.complex()), 1);
        prop_assert!(cut.deviation().largest == 0.0);
        assert_rim_is(&cut, from_ref(&around), 0.05);
        for way in [Way::Ring, Way::TurnedRing] {
            let cut = cutting(degree).with_way(way).loops(from_ref(&around)).unwrap();
            prop_assert_eq!(euler(cut.complex()), 1);
            rim(cut.complex());
        }
    }

    #[test]
    fn any_two_loops_make_an_annulus(a in wild(), b in wild()) {
        let cut = cutting(4).loops(&[a.clone(), b.clone()]).unwrap();
        prop_assert_eq!(euler(cut.complex()), 0);
        rim(cut.complex());
    }

    /// A star-shaped flat polygon, however deep its corners.
    #[test]
    fn flat_loops_have_convex_parts(radii in prop::collection::vec(0.2..1.0f64, 3..14)) {
        let angle = |k: usize| TAU * k as f64 / radii.len() as f64;
        let corner = |(k, r): (usize, &f64)| [r * libm::cos(angle(k)), r * libm::sin(angle(k)), 0.0];
        let around = polygon(&radii.iter().enumerate().map(corner).collect::<Vec<_>>());
        let cut = cutting(4).with_way(Way::Parts).loops(from_ref(&around)).unwrap();
        prop_assert_eq!(euler(cut.complex()), 1);
        rim(cut.complex());
    }

    /// The cut does not depend on where the frame lies, or on its unit.
    #[test]
    fn the_way_is_the_same_in_every_frame(around in wild(), angle in 0.0..TAU, scale in 1e-3..1e3f64) {
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let moved = |q: Point| p(c * q.x - s * q.z + 3.0, q.y - 1.0, s * q.x + c * q.z) * scale;
        let sides = around.curves().iter().map(|curve| match curve {
            BoundaryCurve::Bezier(curve) => curve.points().iter().map(|&q| moved(q)).collect(),
            _ => unreachable!("sides are Bézier curves"),
        });
        let image = Loop::sides(sides.collect()).unwrap();
        let (a, b) = (cutting(4).loops(&[around]).unwrap(), cutting(4).loops(&[image]).unwrap());
        prop_assert_eq!((a.way(), a.complex().faces().len()), (b.way(), b.complex().faces().len()));
        for (&q, &r) in a.complex().points().iter().zip(b.complex().points()) {
            prop_assert!(moved(q).distance(r) < 1e-9 * scale);
        }
    }
}

#[test]
fn too_many_pieces_are_refused() {
    let refused = cutting(3).loops(&[regular(1500)]);
    assert!(matches!(refused, Err(CuttingError::TooManyPieces { found: 1500, .. })));
}

#[test]
fn angles_are_those_of_corners() {
    // The corner angle decides what is a corner: 24 sides turn by 15°.
    let around = regular(24);
    let plain = cutting(3).loops(from_ref(&around)).unwrap();
    assert_eq!((plain.corners(), plain.way()), (0, Way::Ring));
    let fine = cutting(3).with_corner_angle(PI / 18.0).loops(&[around]).unwrap();
    assert_eq!((fine.corners(), fine.way()), (24, Way::Ring), "165° is no corner of a quad");
}
