//! Complexes: shared points, the Coons start, raised degrees, what the constructor refuses.

use proptest::prelude::*;
use surfaces::{Bezier, Complex, ComplexError, FixedEdge, Patch, Point, Side, Vertex};

/// A cyclic loop of n quads around a free centre: v0 … v(n−1), m0 … m(n−1), c; quad k is (v_k, m_k, c, m_{k−1}).
struct Fan {
    vertices: Vec<Vertex>,
    faces: Vec<[usize; 4]>,
    rim: Vec<FixedEdge>,
}

fn fan(sides: &[Bezier]) -> Fan {
    let n = sides.len();
    let (mut vertices, mut rim) = (Vec::new(), Vec::new());
    let halves: Vec<[Bezier; 2]> = sides.iter().map(|side| side.split(0.5)).collect();
    vertices.extend(halves.iter().map(|[first, _]| Vertex::Fixed(first.start())));
    vertices.extend(halves.iter().map(|[first, _]| Vertex::Fixed(first.end())));
    vertices.push(Vertex::Free(None));
    for (k, [first, second]) in halves.into_iter().enumerate() {
        rim.push(FixedEdge { ends: [k, n + k], curve: first });
        rim.push(FixedEdge { ends: [n + k, (k + 1) % n], curve: second });
    }
    let faces = (0..n).map(|k| [k, n + k, 2 * n, n + (k + n - 1) % n]).collect();
    Fan { vertices, faces, rim }
}

impl Fan {
    fn complex(&self, degree: usize) -> Result<Complex, ComplexError> {
        Complex::new(degree, &self.vertices, &self.faces, &self.rim)
    }
}

fn sides() -> impl Strategy<Value = Vec<Bezier>> {
    let point = prop::array::uniform3(-1.0..1.0f64).prop_map(Point::from);
    (3usize..8, 1usize..4)
        .prop_flat_map(move |(n, degree)| {
            prop::collection::vec(prop::collection::vec(point.clone(), degree), n)
        })
        .prop_map(|loops| {
            let n = loops.len();
            let side = |k: usize| {
                let mut points = loops[k].clone();
                points.push(loops[(k + 1) % n][0]);
                Bezier::new(points).unwrap()
            };
            (0..n).map(side).collect()
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn faces_at_an_edge_have_the_same_points_there(sides in sides(), degree in 3usize..7, t in 0.0..1.0f64) {
        let complex = fan(&sides).complex(degree).unwrap();
        prop_assert_eq!(complex.edges().iter().map(|e| e.uses().len()).sum::<usize>(), 4 * complex.faces().len());
        for (number, edge) in complex.edges().iter().enumerate() {
            let nodes = complex.edge_nodes(number);
            prop_assert_eq!([nodes[0], nodes[degree]], edge.ends());
            let curve = Bezier::new(nodes.iter().map(|&k| complex.points()[k]).collect()).unwrap();
            for here in edge.uses() {
                prop_assert_eq!(complex.faces()[here.face].edges()[here.side as usize], number);
                let (u, v) = here.side.parameters(if here.reversed { 1.0 - t } else { t });
                let point = complex.patch(here.face).unwrap().point(u, v);
                prop_assert!(point.distance(curve.point(t)) < 1e-14, "{:?}", here);
            }
        }
    }

    #[test]
    fn the_rim_stays_on_its_curves(sides in sides(), degree in 3usize..7, t in 0.0..1.0f64) {
        let fan = fan(&sides);
        let complex = fan.complex(degree).unwrap();
        let fixed = complex.edges().iter().filter(|edge| edge.is_fixed()).count();
        prop_assert_eq!(fixed, fan.rim.len());
        for FixedEdge { ends, curve } in &fan.rim {
            let same = |edge: &surfaces::Edge| edge.ends() == *ends || edge.ends() == [ends[1], ends[0]];
            let number = complex.edges().iter().position(same).unwrap();
            let nodes = complex.edge_nodes(number);
            prop_assert!(nodes.iter().all(|&k| complex.fixed()[k]));
            let raised = Bezier::new(nodes.iter().map(|&k| complex.points()[k]).collect()).unwrap();
            let along = if nodes[0] == ends[0] { t } else { 1.0 - t };
            prop_assert!(raised.point(along).distance(curve.point(t)) < 1e-14);
        }
    }

    #[test]
    fn a_raised_complex_is_the_same_surface(sides in sides(), k in 0usize..4, u in 0.0..1.0f64, v in 0.0..1.0f64) {
        let complex = fan(&sides).complex(4).unwrap();
        let raised = complex.with_degree(4 + k).unwrap();
        prop_assert_eq!(raised.degree(), 4 + k);
        prop_assert_eq!(raised.points().len(), raised.fixed().len());
        for face in 0..complex.faces().len() {
            let (a, b) = (complex.patch(face).unwrap().point(u, v), raised.patch(face).unwrap().point(u, v));
            prop_assert!(a.distance(b) < 1e-13, "{} {:?} {:?}", face, a, b);
        }
        let free = |c: &Complex| (0..c.vertices()).filter(|&v| !c.fixed()[v]).count();
        prop_assert_eq!(free(&complex), free(&raised));
    }

    #[test]
    fn the_start_moves_with_the_frame(sides in sides(), angle in 0.0..6.0f64, shift in -5.0..5.0f64) {
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let moved = |p: Point| Point::new(c * p.x - s * p.y + shift, s * p.x + c * p.y, p.z - shift);
        let image: Vec<Bezier> = sides
            .iter()
            .map(|side| Bezier::new(side.points().iter().map(|&p| moved(p)).collect()).unwrap())
            .collect();
        let (a, b) = (fan(&sides).complex(4).unwrap(), fan(&image).complex(4).unwrap());
        for (&p, &q) in a.points().iter().zip(b.points()) {
            prop_assert!(moved(p).distance(q) < 1e-12);
        }
    }
}

/// A grid of n × n unit squares whose rim is the graph of a linear function: the start is that graph.
#[test]
fn the_start_over_a_plane_is_the_plane() {
    let n = 7;
    let height = |x: f64, y: f64| 0.3 * x - 0.7 * y + 0.1;
    let at = |k: usize| {
        let (x, y) = ((k % (n + 1)) as f64, (k / (n + 1)) as f64);
        Point::new(x, y, height(x, y))
    };
    let on_rim = |k: usize| [k % (n + 1), k / (n + 1)].iter().any(|&x| x == 0 || x == n);
    let vertices: Vec<Vertex> = (0..(n + 1) * (n + 1))
        .map(|k| if on_rim(k) { Vertex::Fixed(at(k)) } else { Vertex::Free(None) })
        .collect();
    let faces: Vec<[usize; 4]> =
        (0..n * n).map(|k| (k / n) * (n + 1) + k % n).map(|a| [a, a + 1, a + n + 2, a + n + 1]).collect();
    let complex = Complex::new(3, &vertices, &faces, &[]).unwrap();
    for (k, &point) in complex.points()[..vertices.len()].iter().enumerate() {
        assert!(point.distance(at(k)) < 1e-13, "{k} {point:?}");
    }
    let off = complex.points().iter().map(|p| (p.z - height(p.x, p.y)).abs()).fold(0.0, f64::max);
    assert!(off < 1e-13, "{off}");
}

/// Three squares at one edge, as pages of a book.
#[test]
fn three_faces_share_an_edge() {
    let point = |angle: f64, z: f64| Point::new(libm::cos(angle), libm::sin(angle), z);
    let mut vertices = vec![Vertex::Fixed(Point::ZERO), Vertex::Fixed(Point::new(0.0, 0.0, 1.0))];
    let mut faces = Vec::new();
    for k in 0..3 {
        let angle = 2.0 * k as f64;
        vertices.extend([0.0, 1.0].map(|z| Vertex::Fixed(point(angle, z))));
        // The second page runs the other way.
        faces.push(if k == 1 { [1, 0, 4, 5] } else { [0, 1, 2 * k + 3, 2 * k + 2] });
    }
    let complex = Complex::new(4, &vertices, &faces, &[]).unwrap();
    let spine = complex.edges().iter().find(|edge| edge.ends() == [0, 1]).unwrap();
    let uses: Vec<(usize, Side, bool)> = spine.uses().iter().map(|u| (u.face, u.side, u.reversed)).collect();
    assert_eq!(uses, [(0, Side::V0, false), (1, Side::V0, true), (2, Side::V0, false)]);
}

#[test]
fn unsound_complexes_are_refused() {
    let corners = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(Point::from);
    let fixed = corners.map(Vertex::Fixed);
    let quad = [[0, 1, 2, 3]];
    let line = |a: usize, b: usize| FixedEdge {
        ends: [a, b],
        curve: Bezier::new(vec![corners[a], corners[b]]).unwrap(),
    };
    let new = |degree, vertices: &[Vertex], faces: &[[usize; 4]], curves: &[FixedEdge]| {
        Complex::new(degree, vertices, faces, curves).unwrap_err()
    };
    assert_eq!(new(3, &fixed, &[], &[]), ComplexError::NoFace);
    assert!(matches!(new(0, &fixed, &quad, &[]), ComplexError::Degree { degree: 0, .. }));
    assert!(matches!(new(3, &fixed, &[[0, 1, 2, 9]], &[]), ComplexError::UnknownVertex { vertex: 9, .. }));
    assert!(matches!(
        new(3, &fixed, &[[0, 1, 2, 1]], &[]),
        ComplexError::RepeatedVertex { face: 0, vertex: 1 }
    ));
    assert_eq!(new(3, &fixed, &quad, &[line(0, 2)]), ComplexError::UnusedCurve { ends: [0, 2] });
    let twice = new(3, &fixed, &quad, &[line(0, 1), line(1, 0)]);
    assert_eq!(twice, ComplexError::TwoCurves { ends: [1, 0] });
    let elsewhere = FixedEdge { ends: [0, 1], curve: Bezier::new(vec![corners[0], corners[2]]).unwrap() };
    assert!(matches!(new(3, &fixed, &quad, &[elsewhere]), ComplexError::Corner { vertex: 1, .. }));
    let cubic = FixedEdge {
        ends: [0, 1],
        curve: Bezier::new(vec![corners[0], corners[3], corners[2], corners[1]]).unwrap(),
    };
    assert!(matches!(new(2, &fixed, &quad, &[cubic]), ComplexError::CurveDegree { found: 3, degree: 2, .. }));
    let mut one_free = fixed;
    one_free[1] = Vertex::Free(None);
    assert_eq!(new(3, &one_free, &quad, &[line(0, 1)]), ComplexError::FreeEnd { vertex: 1 });
    assert!(matches!(new(3, &[Vertex::Free(None); 4], &quad, &[]), ComplexError::Loose { .. }));
    let mut five = fixed.to_vec();
    five.push(Vertex::Free(None));
    assert_eq!(new(3, &five, &quad, &[]), ComplexError::UnusedVertex { vertex: 4 });
    five[4] = Vertex::Fixed(Point::new(f64::NAN, 0.0, 0.0));
    assert!(matches!(
        new(3, &five, &[[0, 1, 2, 4], [0, 1, 2, 3]], &[]),
        ComplexError::NotFinite { vertex: 4 }
    ));

    let complex = Complex::new(3, &fixed, &quad, &[line(0, 1)]).unwrap();
    let moved = complex.points().iter().map(|&p| p + Point::new(0.0, 0.0, 1.0)).collect();
    assert_eq!(complex.with_points(moved).unwrap_err(), ComplexError::FixedPoint { index: 0 });
    assert!(matches!(complex.with_points(Vec::new()), Err(ComplexError::Points { expected: 16, found: 0 })));
    assert!(matches!(complex.with_degree(2), Err(ComplexError::Lowered { degree: 2, own: 3 })));
    assert!(matches!(complex.with_degree(1000), Err(ComplexError::Degree { .. })));
}

/// Three pages of a book have no sides; a ring of quads glued with a half turn has one; a ring without it two.
#[test]
fn sides_are_told_where_there_are_two() {
    let ring = |twisted: bool| {
        let n = 5;
        let mut vertices = Vec::new();
        for k in 0..n {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            let half = if twisted { 0.5 * angle } else { 0.0 };
            let at = |s: f64| {
                let r = 2.0 + s * libm::cos(half);
                Point::new(r * libm::cos(angle), r * libm::sin(angle), s * libm::sin(half))
            };
            vertices.extend([Vertex::Fixed(at(-0.5)), Vertex::Fixed(at(0.5))]);
        }
        let faces: Vec<[usize; 4]> = (0..n)
            .map(|k| {
                let (a, b) = (2 * k, 2 * k + 1);
                let next = 2 * ((k + 1) % n);
                let turn = usize::from(twisted && k + 1 == n);
                let quad = [a, b, next + 1 - turn, next + turn];
                // One face the other way round.
                if k == 2 { [quad[3], quad[2], quad[1], quad[0]] } else { quad }
            })
            .collect();
        Complex::new(3, &vertices, &faces, &[]).unwrap()
    };
    let (band, mobius) = (ring(false), ring(true));
    assert!(band.orientation().is_consistent());
    assert_eq!(band.orientation().flipped().iter().filter(|f| **f).count(), 1);
    assert_eq!(mobius.orientation().torn().len(), 1);
    for (complex, torn) in [(band, 0), (mobius, 4)] {
        let mesh = complex.mesh(4).unwrap();
        let mut directed = std::collections::HashMap::new();
        for &[a, b, c] in &mesh.mesh.triangles {
            for edge in [[a, b], [b, c], [c, a]] {
                *directed.entry(edge).or_insert(0) += 1;
            }
        }
        assert_eq!(
            directed.values().filter(|count| **count > 1).count(),
            torn,
            "edges run through twice alike"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn meshes_are_watertight(sides in sides(), n in 1usize..6) {
        let complex = fan(&sides).complex(4).unwrap();
        let meshed = complex.mesh(n).unwrap();
        let mesh = &meshed.mesh;
        let faces = complex.faces().len();
        prop_assert_eq!((mesh.triangles.len(), meshed.faces.len()), (2 * n * n * faces, 2 * n * n * faces));
        prop_assert_eq!(mesh.points.len(), faces * n * n + faces * n + 1, "a disc of quads around a vertex");
        let mut times = std::collections::HashMap::new();
        for &[a, b, c] in &mesh.triangles {
            for [a, b] in [[a, b], [b, c], [c, a]] {
                *times.entry([a.min(b), a.max(b)]).or_insert(0usize) += 1;
            }
        }
        let rim: Vec<&[u32; 2]> = times.iter().filter(|(_, count)| **count == 1).map(|(edge, _)| edge).collect();
        prop_assert_eq!(rim.len(), 2 * n * faces);
        prop_assert!(times.values().all(|count| *count <= 2));
        for (number, run) in meshed.edges.iter().enumerate() {
            let curve = complex.edge_curve(number);
            for (k, &vertex) in run.iter().enumerate() {
                let point = curve.point(k as f64 / n as f64);
                prop_assert!(mesh.points[vertex as usize].distance(point) < 1e-13);
            }
        }
        prop_assert!(mesh.normals.iter().all(|normal| (normal.norm() - 1.0).abs() < 1e-12));
    }
}

/// A grid of parallelograms under the graph of a polynomial of degree 2, the rim fixed on it, with a wing of two more faces along the line
/// x = 2 where it has one: there three faces meet.
fn graph_with_a_wing(has_wing: bool) -> (Complex, impl Fn(f64, f64) -> f64) {
    let height = |x: f64, y: f64| 0.3 * x * x - 0.2 * x * y + 0.5 * y * y - 0.4 * x + 0.1;
    let at = move |x: f64, y: f64| Point::new(x + 0.3 * y, y, height(x, y));
    let mut corners: Vec<Point> = (0..9).map(|k| at(f64::from(k % 3) * 2.0, f64::from(k / 3))).collect();
    let mut faces = vec![[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]];
    let mut rim = vec![[0, 1], [1, 2], [2, 5], [5, 8], [8, 7], [7, 6], [6, 3], [3, 0]];
    if has_wing {
        corners.extend((0..3).map(|j| at(2.0, f64::from(j)) + Point::new(0.0, 0.0, 1.0)));
        faces.extend([[1, 9, 10, 4], [4, 10, 11, 7]]);
        rim.extend([[1, 9], [9, 10], [10, 11], [11, 7]]);
    }
    let curve = |[a, b]: [usize; 2]| {
        // A parabola through its ends and middle.
        let (p, q) = (corners[a], corners[b]);
        let of = |p: Point| [p.x - 0.3 * p.y, p.y];
        let ([x0, y0], [x1, y1]) = (of(p), of(q));
        let up = if a >= 9 && b >= 9 { 1.0 } else { 0.0 };
        let straight = x0 == x1 && y0 == y1;
        let middle = at(0.5 * (x0 + x1), 0.5 * (y0 + y1)) + Point::new(0.0, 0.0, up);
        let control = if straight { (p + q) * 0.5 } else { middle * 2.0 - (p + q) * 0.5 };
        FixedEdge { ends: [a, b], curve: Bezier::new(vec![p, control, q]).unwrap() }
    };
    let fixed: Vec<FixedEdge> = rim.iter().map(|&ends| curve(ends)).collect();
    let vertices: Vec<Vertex> = corners.iter().map(|&p| Vertex::Fixed(p)).collect();
    let degree = 4;
    let complex = Complex::new(degree, &vertices, &faces, &fixed).unwrap();
    // Coons patches of quadratic borders miss the products of u and v: bend the inner edges and faces onto the graph.
    let mut points = complex.points().to_vec();
    for face in complex.faces().iter().take(4) {
        let [a, b, _, d] = face.vertices().map(|v| corners[v]);
        let of = |p: Point| [p.x - 0.3 * p.y, p.y];
        let ([x0, y0], [x1, _], [_, y1]) = (of(a), of(b), of(d));
        let blossom = |i: usize, j: usize| {
            // Of x(u)^k y(v)^l with u, v in Bernstein form of degree 4: sums over the arguments of the blossom.
            let (s, t) = (i as f64 / 4.0, j as f64 / 4.0);
            let (x, y) = (x0 + (x1 - x0) * s, y0 + (y1 - y0) * t);
            let (s2, t2) = ((i * i.saturating_sub(1)) as f64 / 12.0, (j * j.saturating_sub(1)) as f64 / 12.0);
            let x2 = x0 * x0 + 2.0 * x0 * (x1 - x0) * s + (x1 - x0).powi(2) * s2;
            let y2 = y0 * y0 + 2.0 * y0 * (y1 - y0) * t + (y1 - y0).powi(2) * t2;
            Point::new(x + 0.3 * y, y, 0.3 * x2 - 0.2 * x * y + 0.5 * y2 - 0.4 * x + 0.1)
        };
        for (k, &node) in face.nodes().iter().enumerate() {
            if !complex.fixed()[node] {
                points[node] = blossom(k / 5, k % 5);
            }
        }
    }
    (complex.with_points(points).unwrap(), height)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Parts of a quadratic graph are bilinear in its arguments, so degree 4 holds them: layers change nothing. Edges are shared, also
    /// by three faces, and the rim stays.
    #[test]
    fn layers_keep_what_the_degree_holds(
        has_wing: bool,
        chosen in prop::collection::vec(0..9_usize, 0..6),
        share in 0.05..0.6f64,
        [u, v] in prop::array::uniform2(0.0..1.0f64),
    ) {
        let (complex, height) = graph_with_a_wing(has_wing);
        let graded = complex.graded(&chosen, share).unwrap();
        let before = complex.vertices();
        prop_assert_eq!(&graded.points()[..before], &complex.points()[..before]);
        prop_assert_eq!(&graded.fixed()[..before], &complex.fixed()[..before]);
        let fixed = |complex: &Complex| complex.edges().iter().filter(|edge| edge.is_fixed()).count();
        prop_assert!(fixed(&graded) >= fixed(&complex) + chosen.iter().any(|&v| v != 4) as usize);
        for edge in graded.edges() {
            prop_assert_eq!(edge.uses().len() == 1, edge.is_fixed(), "an open edge");
        }
        for face in 0..graded.faces().len() {
            let corners = graded.faces()[face].vertices().iter().filter(|v| chosen.contains(v)).count();
            prop_assert!(corners < 2);
            let point = graded.patch(face).unwrap().point(u, v);
            // On the wing x − 0.3 y is 2.
            let x = point.x - 0.3 * point.y;
            let is_wing = has_wing && (x - 2.0).abs() < 1e-9 && point.z > height(x, point.y) + 1e-9;
            if !is_wing {
                prop_assert!((point.z - height(x, point.y)).abs() < 1e-13, "{:?}", point);
            }
        }
    }
}

/// Three faces for one, at the share asked for; two corners at an edge have the strip between them halved.
#[test]
fn a_layer_is_where_it_should_be() {
    let (complex, _) = graph_with_a_wing(false);
    let one = complex.graded(&[0], 0.25).unwrap();
    assert_eq!((one.faces().len(), one.vertices()), (6, 12));
    let near = one.edges().iter().filter(|edge| edge.ends().contains(&0)).map(|edge| edge.ends()[1]);
    let along: Vec<f64> = near.map(|v| one.points()[v]).map(|p| (p.x - 0.3 * p.y).max(p.y)).collect();
    assert_eq!(along.len(), 2);
    assert!(along.iter().any(|x| (x - 0.5).abs() < 1e-15) && along.iter().any(|y| (y - 0.25).abs() < 1e-15));
    // 0 and 1 share an edge: its strip, two faces, is halved; then 0 has one face and 1 two.
    let two = complex.graded(&[0, 1], 0.25).unwrap();
    assert_eq!(two.faces().len(), 6 + 2 * 3);
    assert!(matches!(complex.graded(&[9], 0.25), Err(ComplexError::UnknownVertex { vertex: 9, count: 9 })));
    for share in [0.0, 1.0, f64::NAN] {
        assert!(matches!(complex.graded(&[0], share), Err(ComplexError::Share { .. })));
    }
    assert_eq!(complex.graded(&[], 0.25).unwrap().faces().len(), 4);
}

/// The strip of an edge is halved as far as it goes, and the surface stays.
#[test]
fn a_strip_is_halved_across() {
    let (complex, height) = graph_with_a_wing(true);
    // From 1 to 4 three faces meet: the edge of each opposite is cut with it, and what lies beyond.
    let cut = |ends: [usize; 2]| {
        let edge = complex.edges().iter().position(|edge| edge.ends() == ends).unwrap();
        complex.halved_across(&[edge]).unwrap()
    };
    let (through, along) = (cut([1, 4]), cut([0, 1]));
    assert_eq!((through.faces().len(), through.vertices()), (6 + 3, 12 + 4));
    assert_eq!((along.faces().len(), along.vertices()), (6 + 2, 12 + 3));
    for face in 0..along.faces().len() {
        let point = along.patch(face).unwrap().point(0.3, 0.7);
        let is_wing = (point.x - 0.3 * point.y - 2.0).abs() < 1e-9;
        assert!(is_wing || (point.z - height(point.x - 0.3 * point.y, point.y)).abs() < 1e-13, "{point:?}");
    }
    assert_eq!(complex.halved_across(&[]).unwrap().faces().len(), 6);
    let count = complex.edges().len();
    assert!(
        matches!(complex.halved_across(&[count]), Err(ComplexError::UnknownEdge { edge, .. }) if edge == count)
    );
}
