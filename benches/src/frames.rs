//! Frames whose films have a known area.

use std::f64::consts::PI;

use bases::{Basis, Bernstein};
use plateau::{CurveGraph, Cutting, GraphCurve, Loop};
use solve::solve_general;
use surfaces::{
    BoundaryCurve, Complex, EllipseArc, Net, Point, TensorPatch, TriangleNet, TrianglePatch, Vertex,
};

use crate::FixtureError;

/// How near rims are to curves that no polynomial is: rounding, as far as the degree allows.
const RIM: f64 = 1e-3;

/// Six edges of a cube in a loop, in its Coons start: six patches of degree `degree`. The least area is 3K(¾)/(2K(¼)) =
/// 1.918892356756509, K(m) the complete elliptic integral by parameter.
///
/// # Errors
/// Those of [`Cutting::loops`].
pub fn hexagon(degree: usize) -> Result<Complex, FixtureError> {
    let corners =
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]].map(Point::from);
    Ok(Cutting::new(degree, RIM)?.loops(&[Loop::polygon(&corners)?])?.into_complex())
}

/// Circles of radius 1 at distance 0.6 around one axis, in their Coons start: four patches of degree `degree`. The least
/// area is π c (0.6 + c sinh(0.6/c)) for the larger c with c cosh(0.3/c) = 1.
///
/// # Errors
/// Those of [`Cutting::loops`].
pub fn catenoid(degree: usize) -> Result<Complex, FixtureError> {
    let ring = |z: f64| -> Result<Loop, FixtureError> {
        let circle = EllipseArc::circle(Point::new(0.0, 0.0, z), Point::new(0.0, 0.0, 1.0), 1.0)?;
        Ok(Loop::new(vec![circle.into()], None)?)
    };
    Ok(Cutting::new(degree, RIM)?.loops(&[ring(-0.3)?, ring(0.3)?])?.into_complex())
}

/// The twelve edges of a cube with thirteen films between them, a square in their middle, in their Coons start.
///
/// # Errors
/// Those of [`Cutting::graph`].
pub fn cube(degree: usize) -> Result<Complex, FixtureError> {
    let bit = |k: usize, b: usize| ((k >> b) & 1) as f64;
    let corners: Vec<Point> = (0..8).map(|k| Point::new(bit(k, 0), bit(k, 1), bit(k, 2))).collect();
    let mut vertices: Vec<(String, Vertex)> =
        corners.iter().enumerate().map(|(k, &c)| (format!("c{k}"), Vertex::Fixed(c))).collect();
    vertices.extend((0..4).map(|k| (format!("s{k}"), Vertex::Free(None))));
    let edges: Vec<[usize; 2]> = (0..8)
        .flat_map(|k| [1, 2, 4].into_iter().filter(move |bit| k & bit == 0).map(move |bit| [k, k | bit]))
        .collect();
    let curves = edges
        .iter()
        .map(|&ends| {
            let curve = BoundaryCurve::bezier(ends.map(|k| corners[k]).to_vec())?;
            Ok(GraphCurve { ends, curve })
        })
        .collect::<Result<Vec<_>, FixtureError>>()?;
    let mut faces = vec![vec![8, 9, 11, 10]];
    faces.extend(edges.iter().map(|&[a, b]| match [8 + (a & 3), 8 + (b & 3)] {
        [i, j] if i == j => vec![a, b, i],
        [i, j] => vec![a, b, j, i],
    }));
    Ok(Cutting::new(degree, RIM)?.graph(&CurveGraph::new(vertices, curves, &faces, None)?)?.into_complex())
}

/// The frame of z = x² − y² over [−1, 1]², a patch of degree `degree` ≥ 2. The least area is 7.383505602602.
///
/// # Errors
/// Those of [`Net::from_boundary`].
pub fn saddle(degree: usize) -> Result<TensorPatch, FixtureError> {
    let side = |a: [f64; 2], b: [f64; 2]| {
        let at = |t: f64| [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
        let z = |[x, y]: [f64; 2]| x * x - y * y;
        let [m0, m1] = at(0.5);
        let middle = Point::new(m0, m1, 2.0 * z([m0, m1]) - 0.5 * (z(a) + z(b)));
        vec![Point::new(a[0], a[1], z(a)), middle, Point::new(b[0], b[1], z(b))]
    };
    let [c00, c01, c10, c11] = [[-1., -1.], [-1., 1.], [1., -1.], [1., 1.]];
    let net = Net::from_boundary(&side(c00, c01), &side(c10, c11), &side(c00, c10), &side(c01, c11))?;
    Ok(TensorPatch::bernstein(net.raised(degree.saturating_sub(2)))?)
}

/// A ribbon between helices of radius 3 and 5, pitch 8, 1.25 turns, its long sides by interpolation in degree `degree` at
/// Chebyshev points. The least area is that of the right helicoid, 65.997329.
///
/// # Errors
/// Those of [`Net::from_boundary`], and of the interpolation for degrees that are not offered.
pub fn ribbon(degree: usize) -> Result<TensorPatch, FixtureError> {
    let bernstein = Bernstein::new(degree)?;
    let nodes: Vec<f64> = (0..=degree).map(|k| 0.5 - 0.5 * f64::cos(PI * k as f64 / degree as f64)).collect();
    let values: Vec<f64> = nodes.iter().flat_map(|&t| bernstein.evaluate(t, 0).row(0).to_vec()).collect();
    let helix = |radius: f64| -> Result<Vec<Point>, FixtureError> {
        let at = |t: &f64| [radius * f64::cos(2.5 * PI * t), radius * f64::sin(2.5 * PI * t), 10.0 * t];
        let points: Vec<f64> = nodes.iter().flat_map(at).collect();
        let x = solve_general(degree + 1, &values, 3, &points)?.x;
        Ok(x.chunks_exact(3).map(|c| Point::new(c[0], c[1], c[2])).collect())
    };
    let (inner, outer) = (helix(3.0)?, helix(5.0)?);
    let across = |a: Point, b: Point| -> Vec<Point> {
        (0..=degree).map(|k| k as f64 / degree as f64).map(|t| a * (1.0 - t) + b * t).collect()
    };
    let (first, last) = (across(inner[0], outer[0]), across(inner[degree], outer[degree]));
    Ok(TensorPatch::bernstein(Net::from_boundary(&inner, &outer, &first, &last)?)?)
}

/// A triangle of degree `degree` ≥ 3 over three cubic sides that rise and fall.
///
/// # Errors
/// Those of [`TriangleNet::from_boundary`].
pub fn triangle(degree: usize) -> Result<TrianglePatch, FixtureError> {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.9, 0.0]].map(Point::from);
    let side = |k: usize| -> Vec<Point> {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let at = |t: f64, z: f64| a * (1.0 - t) + b * t + Point::new(0.0, 0.0, z);
        vec![a, at(1.0 / 3.0, 0.5), at(2.0 / 3.0, -0.3), b]
    };
    let net = TriangleNet::from_boundary(&side(0), &side(1), &side(2))?;
    Ok(TrianglePatch::new(net.raised(degree.saturating_sub(3))?)?)
}
