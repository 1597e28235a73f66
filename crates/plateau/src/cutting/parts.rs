//! A loop cut along diagonals into convex parts.

use std::f64::consts::PI;

use surfaces::{Bezier, BoundaryCurve, Point, Vertex};

use super::graph::{self, CurveGraph, GraphCurve};
use super::rim::{Rim, length};
use super::{Cutting, CuttingError, Quads, Way};

/// Largest angle of a part.
const BLUNT: f64 = PI * 5.0 / 6.0;

/// Most pieces of a loop that is cut in this way: the search for ears takes their third power.
const MOST_PIECES: usize = 96;

/// Pieces that leave their chord by more than this share of it are halved, so that chords stand for them.
const BOWED: f64 = 0.12;

/// The loop seen along its normal, cut along straight lines between its vertices into as few convex parts as a triangulation
/// gives without angles above 150°, each part by its middle.
pub(super) fn cut(rim: Rim, cutting: &Cutting) -> Result<Quads, CuttingError> {
    let unsuitable = || CuttingError::Unsuitable {
        asked: "cutting along diagonals",
        needs: "a loop that does not cross itself, seen from where it is largest, of at most 96 pieces",
    };
    let corners = rim.corner_vertices().len();
    let rim = straightened(rim.with_at_least(4));
    let flat =
        rim.flat().filter(|flat| flat.len() <= MOST_PIECES && is_simple(flat)).ok_or_else(unsuitable)?;
    let triangles = triangulated(&flat).ok_or_else(unsuitable)?;
    let faces = merged(&flat, triangles);
    let vertices =
        rim.pieces.iter().enumerate().map(|(k, p)| (format!("v{k}"), Vertex::Fixed(p.start()))).collect();
    let count = rim.len();
    let curves = rim
        .pieces
        .into_iter()
        .enumerate()
        .map(|(k, piece)| GraphCurve { ends: [k, (k + 1) % count], curve: BoundaryCurve::Bezier(piece) });
    let graph = CurveGraph::new(vertices, curves.collect(), &faces, None)?;
    let (quads, _) = graph::cut(&graph, &cutting.with_way(Way::Midpoint))?;
    Ok(Quads { way: Way::Parts, corners, deviation: rim.deviation, ..quads })
}

/// The rim with pieces so short that they lie near their chords.
fn straightened(mut rim: Rim) -> Rim {
    let mut k = 0;
    while k < rim.len() && rim.len() <= MOST_PIECES {
        let piece = &rim.pieces[k];
        if is_bowed(piece) { rim.halve(k) } else { k += 1 }
    }
    rim
}

fn is_bowed(piece: &Bezier) -> bool {
    let chord = piece.end() - piece.start();
    let off = |t: f64| (piece.point(t) - piece.start()).cross(chord).norm() / chord.norm();
    let most = (1..8).map(|k| off(f64::from(k) / 8.0)).fold(0.0, f64::max);
    // Compared so that a piece in one point, where nothing is a number, counts as straight.
    most > BOWED * chord.norm().min(length(piece))
}

/// Twice the signed area of the triangle a, b, c; positive where it runs counter-clockwise.
fn area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether no two sides of the polygon that are not neighbours meet.
fn is_simple(flat: &[[f64; 2]]) -> bool {
    let n = flat.len();
    let side = |k: usize| (flat[k], flat[(k + 1) % n]);
    // Whether c lies on the segment from a to b.
    let lies_on = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let within = |i: usize| (a[i].min(b[i])..=a[i].max(b[i])).contains(&c[i]);
        area(a, b, c) == 0.0 && within(0) && within(1)
    };
    let meet = |k: usize, l: usize| {
        let ((a, b), (c, d)) = (side(k), side(l));
        let cross = area(a, b, c) * area(a, b, d) < 0.0 && area(c, d, a) * area(c, d, b) < 0.0;
        cross || lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b)
    };
    (0..n).all(|k| (k + 2..n).all(|l| (k == 0 && l == n - 1) || !meet(k, l)))
}

/// The angle at b from c round to a, 0 to 2π: inside a polygon that runs a, b, c counter-clockwise.
fn angle(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let (to_a, to_c) = ([a[0] - b[0], a[1] - b[1]], [c[0] - b[0], c[1] - b[1]]);
    let turn = libm::atan2(to_c[0] * to_a[1] - to_c[1] * to_a[0], to_c[0] * to_a[0] + to_c[1] * to_a[1]);
    if turn < 0.0 { turn + 2.0 * PI } else { turn }
}

/// Triangles of a simple polygon: ears, those with the largest smallest angle first, then diagonals flipped to Delaunay's.
fn triangulated(flat: &[[f64; 2]]) -> Option<Vec<[usize; 3]>> {
    let mut rest: Vec<usize> = (0..flat.len()).collect();
    let mut triangles = Vec::with_capacity(flat.len() - 2);
    while rest.len() > 3 {
        let n = rest.len();
        let corner = |k: usize| [rest[(k + n - 1) % n], rest[k], rest[(k + 1) % n]];
        let is_ear = |k: &usize| {
            let [a, b, c] = corner(*k).map(|v| flat[v]);
            let inside = |&&v: &&usize| {
                let p = flat[v];
                area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0
            };
            area(a, b, c) > 0.0 && !rest.iter().filter(|v| !corner(*k).contains(v)).any(|v| inside(&v))
        };
        let quality = |k: usize| smallest_angle(corner(k).map(|v| flat[v]));
        let best = (0..n).filter(is_ear).max_by(|&k, &l| quality(k).total_cmp(&quality(l)))?;
        triangles.push(corner(best));
        rest.remove(best);
    }
    triangles.push([rest[0], rest[1], rest[2]]);
    flip(flat, &mut triangles);
    Some(triangles)
}

fn smallest_angle([a, b, c]: [[f64; 2]; 3]) -> f64 {
    angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b))
}

/// Flips diagonals of convex quadrilaterals while the smallest angle grows.
fn flip(flat: &[[f64; 2]], triangles: &mut [[usize; 3]]) {
    // Every flip enlarges an angle; the bound ends ties that rounding keeps alive.
    for _ in 0..triangles.len().pow(2) {
        let pairs = (0..triangles.len()).flat_map(|s| (s + 1..triangles.len()).map(move |t| (s, t)));
        let found = pairs.into_iter().find_map(|(s, t)| {
            let [a, b, c, d] = quadrilateral(triangles[s], triangles[t])?;
            let [p, q, r, o] = [a, b, c, d].map(|v| flat[v]);
            let is_convex =
                area(p, q, r) > 0.0 && area(q, r, o) > 0.0 && area(r, o, p) > 0.0 && area(o, p, q) > 0.0;
            let before = smallest_angle([p, q, r]).min(smallest_angle([p, r, o]));
            let after = smallest_angle([p, q, o]).min(smallest_angle([q, r, o]));
            (is_convex && after > before * (1.0 + 1e-9)).then_some((s, t, [a, b, c, d]))
        });
        let Some((s, t, [a, b, c, d])) = found else { break };
        (triangles[s], triangles[t]) = ([a, b, d], [b, c, d]);
    }
}

/// The quadrilateral a, b, c, d of two triangles a, b, c and a, c, d with a common side.
fn quadrilateral(first: [usize; 3], second: [usize; 3]) -> Option<[usize; 4]> {
    let apart = first.iter().position(|v| !second.contains(v))?;
    let d = *second.iter().find(|v| !first.contains(v))?;
    let [c, a, b] = [first[(apart + 1) % 3], first[(apart + 2) % 3], first[apart]];
    (second.contains(&a) && second.contains(&c)).then_some([a, b, c, d])
}

/// The triangles put together across their longest common sides first, as long as no angle becomes blunt.
fn merged(flat: &[[f64; 2]], triangles: Vec<[usize; 3]>) -> Vec<Vec<usize>> {
    let n = flat.len();
    let mut parts: Vec<Vec<usize>> = triangles.into_iter().map(|t| t.to_vec()).collect();
    let mut diagonals: Vec<[usize; 2]> = parts
        .iter()
        .flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]])
        .filter(|[a, b]| a < b && b - a != 1 && b - a != n - 1)
        .collect();
    let long = |[a, b]: &[usize; 2]| libm::hypot(flat[*a][0] - flat[*b][0], flat[*a][1] - flat[*b][1]);
    diagonals.sort_by(|d, e| long(e).total_cmp(&long(d)).then(d.cmp(e)));
    for [a, b] in diagonals {
        // The part that runs from a to b, and the one that runs back.
        let place = |parts: &[Vec<usize>], a: usize, b: usize| {
            parts
                .iter()
                .position(|part| (0..part.len()).any(|k| part[k] == a && part[(k + 1) % part.len()] == b))
        };
        let (Some(first), Some(second)) = (place(&parts, a, b), place(&parts, b, a)) else { continue };
        let run = |part: &[usize], from: usize| {
            let start = part.iter().position(|&v| v == from).unwrap_or(0);
            (0..part.len() - 1).map(|k| part[(start + k) % part.len()]).collect::<Vec<_>>()
        };
        // From b round the first part to before a, then from a round the second to before b.
        let whole = [run(&parts[first], b), run(&parts[second], a)].concat();
        let count = whole.len();
        let is_blunt = (0..count).any(|k| {
            let [before, here, after] = [k + count - 1, k, k + 1].map(|k| flat[whole[k % count]]);
            angle(before, here, after) > BLUNT
        });
        if !is_blunt {
            parts[first] = whole;
            parts.remove(second);
        }
    }
    parts
}

impl Rim {
    /// The vertices seen along the normal of the loop, which runs counter-clockwise; none where it has no plane.
    fn flat(&self) -> Option<Vec<[f64; 2]>> {
        let normal = self.normal()?;
        let axes = [Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0), Point::new(0.0, 0.0, 1.0)];
        let across = axes.into_iter().map(|axis| axis - normal * normal.dot(axis));
        let first = across.max_by(|a, b| a.norm().total_cmp(&b.norm()))?.unit()?;
        let second = normal.cross(first);
        let origin = self.pieces[0].start();
        let seen = |piece: &Bezier| {
            let p = piece.start() - origin;
            [p.dot(first), p.dot(second)]
        };
        Some(self.pieces.iter().map(seen).collect())
    }
}
