//! Proved lower bounds, held against areas known in closed form.

use plateau::{Competitors, NoBound, lower_bound};
use surfaces::{Bezier, Complex, FixedEdge, Point, Vertex};

/// The quadrilateral with straight sides, as one face of degree p in its Coons start.
fn quadrilateral(corners: [[f64; 3]; 4], degree: usize) -> Complex {
    let corners = corners.map(Point::from);
    let vertices = corners.map(Vertex::Fixed);
    let edges: Vec<FixedEdge> = (0..4)
        .map(|k| {
            let ends = [k, (k + 1) % 4];
            FixedEdge { ends, curve: Bezier::new(ends.map(|v| corners[v]).to_vec()).expect("two points") }
        })
        .collect();
    Complex::new(degree, &vertices, &[[0, 1, 2, 3]], &edges).expect("a sound complex")
}

#[test]
fn the_skew_quadrilateral_has_at_least_its_area() {
    // K(¾)/K(¼), complete elliptic integrals by parameter.
    let least = 1.279261571171006;
    let mut gaps = Vec::new();
    for degree in [2, 4, 6] {
        let frame = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]];
        let bound = lower_bound(&quadrilateral(frame, degree)).expect("a graph over a convex region");
        assert_eq!(bound.competitors, Competitors::Surfaces);
        assert!(bound.value <= least, "{degree}: {}", bound.value);
        gaps.push(least - bound.value);
    }
    assert!(gaps[0] > gaps[1] && gaps[1] > gaps[2] && gaps[2] < 1e-7, "{gaps:?}");
}

#[test]
fn a_rim_that_is_not_convex_bounds_graphs_only() {
    let corners = [[0., 0., 0.], [1., 0., 0.2], [1., 1., 0.], [0., 1., 0.2]].map(Point::from);
    let edges: Vec<FixedEdge> = (0..4)
        .map(|k| {
            let ends = [k, (k + 1) % 4];
            // The first side dips into the square.
            let middle = (corners[ends[0]] + corners[ends[1]]) * 0.5
                + Point::new(0.0, if k == 0 { 0.2 } else { 0.0 }, 0.0);
            let curve = Bezier::new(vec![corners[ends[0]], middle, corners[ends[1]]]).expect("three points");
            FixedEdge { ends, curve }
        })
        .collect();
    let frame =
        Complex::new(4, &corners.map(Vertex::Fixed), &[[0, 1, 2, 3]], &edges).expect("a sound complex");
    let bound = lower_bound(&frame).expect("a graph");
    assert_eq!(bound.competitors, Competitors::Graphs);
}

#[test]
fn a_surface_that_turns_over_is_no_graph() {
    // A band round a cylinder: its normals point everywhere.
    let at = |k: usize, radius: f64, height: f64| {
        let angle = (k % 6) as f64 * std::f64::consts::TAU / 6.0;
        Point::new(radius * angle.cos(), radius * angle.sin(), height)
    };
    let corner = |v: usize| at(2 * (v % 3), 1.0, f64::from(u8::from(v >= 3)));
    let vertices: Vec<Vertex> = (0..6).map(|v| Vertex::Fixed(corner(v))).collect();
    let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
    let edges: Vec<FixedEdge> = (0..6)
        .map(|v| {
            let ends = [v, 3 * (v / 3) + (v + 1) % 3];
            let middle = at(2 * (v % 3) + 1, 2.0, f64::from(u8::from(v >= 3)));
            let curve = Bezier::new(vec![corner(ends[0]), middle, corner(ends[1])]).expect("three points");
            FixedEdge { ends, curve }
        })
        .collect();
    let band = Complex::new(3, &vertices, &faces, &edges).expect("a sound complex");
    assert_eq!(lower_bound(&band), Err(NoBound::NoGraph));
}
