//! Least areas of complexes against closed forms.

use std::f64::consts::PI;

use bases::{Bernstein, Nodal};
use plateau::{AreaEnd, AreaExtremal, least_area_complex};
use surfaces::{Bezier, Complex, FixedEdge, Point, Vertex};

fn line(ends: [usize; 2], a: Point, b: Point) -> FixedEdge {
    FixedEdge { ends, curve: Bezier::new(vec![a, b]).unwrap() }
}

/// The midpoint subdivision of a polygon: n quadrilaterals between a corner, the middles of its sides and the centre.
fn polygon(degree: usize, corners: &[[f64; 3]]) -> Complex {
    let n = corners.len();
    let p: Vec<Point> = corners.iter().copied().map(Point::from).collect();
    let middle = |k: usize| (p[k] + p[(k + 1) % n]) * 0.5;
    let mut vertices: Vec<Vertex> = p.iter().map(|&p| Vertex::Fixed(p)).collect();
    vertices.extend((0..n).map(|k| Vertex::Fixed(middle(k))));
    vertices.push(Vertex::Free(None));
    let faces: Vec<[usize; 4]> = (0..n).map(|k| [k, n + k, 2 * n, n + (k + n - 1) % n]).collect();
    let half = |k: usize| {
        let next = (k + 1) % n;
        [line([k, n + k], p[k], middle(k)), line([n + k, next], middle(k), p[next])]
    };
    let rim: Vec<FixedEdge> = (0..n).flat_map(half).collect();
    Complex::new(degree, &vertices, &faces, &rim).unwrap()
}

fn least(complex: &Complex) -> AreaExtremal {
    let (_, found) = least_area_complex(complex, &[], 1e-12, &()).unwrap();
    assert!(found.end == AreaEnd::Stationary && found.area.settled, "{found:?}");
    assert!(found.second_variation.is_some_and(|sigma| sigma > 0.1), "{found:?}");
    found
}

/// K(¾)/K(¼) of complete elliptic integrals by parameter.
const SKEW: f64 = 1.279_261_571_171_006;

#[test]
fn the_skew_quadrilateral_is_spectral() {
    let corners = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]];
    for (degree, tolerance) in [(4, 1e-12), (6, 1e-14)] {
        let found = least(&polygon(degree, &corners));
        assert!((found.area.value / SKEW - 1.0).abs() <= tolerance, "{degree}: {found:?}");
    }
}

#[test]
fn the_hexagon_of_cube_edges_is_spectral() {
    let corners = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]];
    for (degree, tolerance) in [(4, 1e-11), (6, 1e-13)] {
        let found = least(&polygon(degree, &corners));
        assert!((found.area.value / (1.5 * SKEW) - 1.0).abs() <= tolerance, "{degree}: {found:?}");
    }
}

fn corner(k: usize, z: f64) -> Point {
    let [x, y] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][k % 4];
    Point::new(x, y, z)
}

/// A quarter of the circle of radius 1 at height z from the angle k π/2, by interpolation in degree 8.
fn arc(k: usize, z: f64) -> Bezier {
    use bases::Basis;
    let degree = 8;
    let (bernstein, nodes) = (Bernstein::new(degree).unwrap(), Nodal::new(degree).unwrap());
    let angle = |t: f64| 0.5 * PI * (k as f64 + t);
    let matrix: Vec<f64> =
        nodes.nodes().iter().flat_map(|&t| bernstein.evaluate(t, 0).row(0).to_vec()).collect();
    let values: Vec<f64> = nodes.nodes().iter().flat_map(|&t| [angle(t).cos(), angle(t).sin(), z]).collect();
    let x = solve::solve_general(degree + 1, &matrix, 3, &values).unwrap().x;
    let mut points: Vec<Point> = x.chunks_exact(3).map(|c| Point::new(c[0], c[1], c[2])).collect();
    (points[0], points[degree]) = (corner(k, z), corner(k + 1, z));
    Bezier::new(points).unwrap()
}

#[test]
fn the_catenoid_between_two_circles() {
    // c cosh(h/c) = 1 for the larger c; area π c (2h + c sinh(2h/c)).
    let h = 0.3;
    let c = (0..100).fold(1.0f64, |c, _| 1.0 / (h / c).cosh());
    let exact = PI * c * (2.0 * h + c * (2.0 * h / c).sinh());
    let vertices: Vec<Vertex> =
        (0..8).map(|k| Vertex::Fixed(corner(k, if k < 4 { -h } else { h }))).collect();
    let faces: Vec<[usize; 4]> = (0..4).map(|k| [k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k]).collect();
    let both = |k: usize| {
        [
            FixedEdge { ends: [k, (k + 1) % 4], curve: arc(k, -h) },
            FixedEdge { ends: [4 + k, 4 + (k + 1) % 4], curve: arc(k, h) },
        ]
    };
    let rim: Vec<FixedEdge> = (0..4).flat_map(both).collect();
    let found = least(&Complex::new(8, &vertices, &faces, &rim).unwrap());
    assert!((found.area.value / exact - 1.0).abs() <= 1e-11, "{exact} {found:?}");
}

#[test]
fn triple_lines_balance() {
    // Three films of width and height 1 from the edges of a prism to its axis, which starts out of place.
    let outer = |k: usize, z: f64| {
        let angle = 2.0 * PI * k as f64 / 3.0;
        Point::new(angle.cos(), angle.sin(), z)
    };
    let axis = |z: f64| Point::new(0.0, 0.0, z);
    let mut vertices: Vec<Vertex> = Vec::new();
    for z in [0.0, 1.0] {
        vertices.extend((0..3).map(|k| Vertex::Fixed(outer(k, z))));
    }
    vertices.extend([0.0, 1.0].map(|z| Vertex::Fixed(axis(z))));
    vertices.push(Vertex::Free(Some(Point::new(0.2, -0.1, 0.45))));
    vertices.extend((0..3).map(|k| Vertex::Fixed(outer(k, 0.5))));
    let faces: Vec<[usize; 4]> = (0..3).flat_map(|k| [[k, 9 + k, 8, 6], [9 + k, 3 + k, 7, 8]]).collect();
    let around = |k: usize| {
        let (low, middle, high) = (outer(k, 0.0), outer(k, 0.5), outer(k, 1.0));
        [
            line([k, 9 + k], low, middle),
            line([9 + k, 3 + k], middle, high),
            line([k, 6], low, axis(0.0)),
            line([3 + k, 7], high, axis(1.0)),
        ]
    };
    let rim: Vec<FixedEdge> = (0..3).flat_map(around).collect();
    let complex = Complex::new(4, &vertices, &faces, &rim).unwrap();
    let (film, found) = least_area_complex(&complex, &[], 1e-12, &()).unwrap();
    assert!((found.area.value - 3.0).abs() <= 1e-12, "{found:?}");
    let met = film.points()[8];
    assert!(met.x.hypot(met.y) <= 1e-7 && (0.1..0.9).contains(&met.z), "{met:?}");
}
