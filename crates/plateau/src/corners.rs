//! Corners at which a surface of least area is not smooth.

use std::f64::consts::PI;

use surfaces::{Complex, ComplexError, Patch, Point, Side};

/// How far from a corner a layer of smaller patches reaches, as a share of the patch there.
const SHARE: f64 = 0.15;

/// Angles this near 180° are none: where pieces of a fitted curve meet they are never quite that.
const SMOOTH: f64 = PI / 36.0;

/// A part of 180° counts as such if dividing gives a whole number to this; sides count as straight if no control point is farther from
/// the line than this share of their length.
const WHOLE: f64 = 1e-6;
const STRAIGHT: f64 = 1e-10;

/// Parameters of the corners of a face, and how far within it its angle is seen.
const AT: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
const WITHIN: f64 = 0.3;

/// A surface that opens by so much more or less than its corner, seen that far within, turns too fast near it for one patch.
const TURNING: f64 = PI / 12.0;

/// The vertices of the rim, and of wires, at which the surface of least area cannot be continued across the border, so that no
/// polynomial comes near it fast: all corners but those of angle π/k between straight sides, where reflections continue it and
/// the surface does not turn away within a patch. Corners within 5° of 180° are left out.
pub fn odd_corners(complex: &Complex) -> Vec<usize> {
    let mut at: Vec<Vec<(usize, usize)>> = vec![Vec::new(); complex.vertices()];
    for (face, quad) in complex.faces().iter().enumerate() {
        quad.vertices().into_iter().enumerate().for_each(|(corner, vertex)| at[vertex].push((face, corner)));
    }
    let is_odd =
        |vertex: &usize| sectors(complex, &at[*vertex]).iter().any(|sector| sector.is_odd(complex, *vertex));
    (0..complex.vertices()).filter(|vertex| complex.fixed()[*vertex]).filter(is_odd).collect()
}

/// The complex with a layer of smaller patches around each of these vertices, on the same surface but for what polynomials of its degree
/// do not follow.
pub(crate) fn graded(complex: &Complex, corners: &[usize]) -> Result<Complex, ComplexError> {
    complex.graded(corners, SHARE)
}

/// Faces side by side around a vertex, between edges that are fixed, or where more than two faces meet.
struct Sector {
    /// The sum of the angles of the faces.
    angle: f64,
    /// The edges on either side; none if it goes all round.
    borders: Vec<usize>,
}

fn sectors(complex: &Complex, around: &[(usize, usize)]) -> Vec<Sector> {
    let mut open: Vec<(usize, usize)> = around.to_vec();
    let mut sectors = Vec::new();
    while let Some(first) = open.pop() {
        let mut sector = Sector { angle: 0.0, borders: Vec::new() };
        let mut reached = vec![first];
        while let Some((face, corner)) = reached.pop() {
            let edges = edges_at(complex, face, corner);
            sector.angle += opening(complex, face, corner);
            for edge in edges {
                let here = &complex.edges()[edge];
                if here.is_fixed() || here.uses().len() != 2 {
                    sector.borders.push(edge);
                    continue;
                }
                open.retain(|&next| {
                    let is_beside = here.uses().iter().any(|beside| beside.face == next.0);
                    if is_beside {
                        reached.push(next);
                    }
                    !is_beside
                });
            }
        }
        sectors.push(sector);
    }
    sectors
}

/// The angle of a face at one of its corners, seen from there to points so far within it that it does not matter if the parameters crowd
/// towards the corner.
fn opening(complex: &Complex, face: usize, corner: usize) -> f64 {
    let Ok(patch) = complex.patch(face) else { return 0.0 };
    let [(u, v), (across_u, across_v)] = [corner, (corner + 2) % 4].map(|k| AT[k]);
    let place = |s: f64, t: f64| patch.point(u + (across_u - u) * s, v + (across_v - v) * t);
    let from = place(0.0, 0.0);
    let seen = [(WITHIN, 0.0), (WITHIN, WITHIN), (0.0, WITHIN)].map(|(s, t)| place(s, t) - from);
    seen.windows(2).map(|pair| between(pair[0], pair[1])).sum()
}

fn between(a: Point, b: Point) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b))
}

/// The two edges of a face at one of its corners.
fn edges_at(complex: &Complex, face: usize, corner: usize) -> [usize; 2] {
    let at: Vec<usize> = Side::ALL
        .into_iter()
        .zip(complex.faces()[face].edges())
        .filter(|(side, _)| side.corners().contains(&corner))
        .map(|(_, edge)| edge)
        .collect();
    [at[0], at[1]]
}

/// The direction in which an edge leaves a vertex.
fn direction(complex: &Complex, edge: usize, vertex: usize) -> Point {
    let curve = complex.edge_curve(edge);
    if complex.edges()[edge].ends()[0] == vertex { curve.direction() } else { curve.reversed().direction() }
}

fn is_straight(complex: &Complex, edge: usize) -> bool {
    let curve = complex.edge_curve(edge);
    let chord = curve.end() - curve.start();
    let off = |p: &Point| (*p - curve.start()).cross(chord).norm();
    curve.points().iter().all(|p| off(p) <= STRAIGHT * chord.dot(chord))
}

impl Sector {
    fn is_odd(&self, complex: &Complex, vertex: usize) -> bool {
        let [first, second] = self.borders[..] else { return false };
        let [a, b] = [first, second].map(|edge| direction(complex, edge, vertex));
        // A side in one point makes no corner.
        if a == Point::ZERO || b == Point::ZERO {
            return false;
        }
        let seen = between(a, b);
        let inside = if self.angle > PI { 2.0 * PI - seen } else { seen };
        if (inside - PI).abs() < SMOOTH {
            return false;
        }
        let is_part = || {
            let parts = PI / inside;
            parts > 1.5 && (parts - parts.round()).abs() <= WHOLE * parts
        };
        let is_line = |edge: usize| complex.edges()[edge].is_fixed() && is_straight(complex, edge);
        let turns = (self.angle - inside).abs() > TURNING;
        turns || !(is_line(first) && is_line(second) && is_part())
    }
}
