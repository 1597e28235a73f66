//! Sides: links one after the other, from vertex to vertex.

use std::collections::HashMap;

use surfaces::{BoundaryCurve, CurveError, Point, Samples, SplineCurve};

use super::network::Network;
use super::size::{is_straight, rounding};
use crate::{CurveFile, Shape};

/// A curve between two vertices, or a closed one without any.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// Its name, distinct from those of all others.
    pub name: String,
    /// The line of the file on which its first curve begins.
    pub line: usize,
    /// Indices of the vertices where it begins and ends.
    pub ends: Option<[usize; 2]>,
    /// What it is. Polylines and splines end in their vertices digit for digit; the points of a closed polyline end with the first.
    pub shape: Shape,
}

impl Side {
    /// The side as the boundary of a surface: straight sides and splines as they are, polylines of more points as samples of a
    /// curve that passes each within `tolerance` (a length) and has corners where they turn by more than `corner_angle` (degrees).
    ///
    /// # Errors
    /// [`CurveError`], for a tolerance that is not positive.
    pub fn curve(&self, tolerance: f64, corner_angle: f64) -> Result<BoundaryCurve, CurveError> {
        match &self.shape {
            Shape::Polyline(points) if points.len() == 2 => BoundaryCurve::polyline(points.clone()),
            Shape::Polyline(points) => {
                let samples = Samples::new(points.clone(), tolerance)?;
                Ok(samples.with_corner_degrees(corner_angle).into())
            }
            Shape::Spline(spline) => Ok(spline.clone().into()),
            Shape::Arc(arc) => Ok(arc.clone().into()),
        }
    }

    /// Its control points, if it is one polynomial Bézier curve: a straight line or a spline without inner knots and weights.
    pub fn control_points(&self) -> Option<&[Point]> {
        match &self.shape {
            Shape::Polyline(points) => (points.len() == 2).then_some(points),
            Shape::Spline(spline) => {
                let is_bezier = spline.weights().is_none() && spline.points().len() == spline.degree() + 1;
                // Only where its knots end it in its first and last point.
                (is_bezier && spline.knots()[0] == spline.knots()[spline.degree()]).then(|| spline.points())
            }
            Shape::Arc(_) => None,
        }
    }
}

/// A run of links in its direction of travel: nodes one more than links, or as many where it is closed without a vertex.
struct Run {
    nodes: Vec<usize>,
    links: Vec<usize>,
}

/// The vertices and the sides between them, in the order of the file.
pub(super) fn sides(
    network: &Network,
    file: &CurveFile,
    is_vertex: &[bool],
    size: f64,
) -> (Vec<Point>, Vec<Side>) {
    let runs = runs(network, is_vertex);
    let mut vertices = Vec::new();
    let mut places: HashMap<usize, usize> = HashMap::new();
    let mut vertex = |node: usize| {
        *places.entry(node).or_insert_with(|| {
            vertices.push(network.points[node]);
            vertices.len() - 1
        })
    };
    let mut sides = Vec::new();
    for run in &runs {
        let (first, last) = (run.nodes[0], run.nodes[run.nodes.len() - 1]);
        let ends = is_vertex[first].then(|| [vertex(first), vertex(last)]);
        let link = &network.links[run.links[0]];
        let shape = if link.is_segment {
            let points: Vec<Point> = run.nodes.iter().map(|node| network.points[*node]).collect();
            Shape::Polyline(if is_straight(&points, size) {
                vec![points[0], points[points.len() - 1]]
            } else {
                points
            })
        } else {
            ended(file.curves[link.curve].shape.clone(), [first, last].map(|node| network.points[node]))
        };
        sides.push(Side { name: name(network, file, run), line: file.curves[link.curve].line, ends, shape });
    }
    distinct(&mut sides);
    (vertices, sides)
}

fn runs(network: &Network, is_vertex: &[bool]) -> Vec<Run> {
    let incidence = network.incidence();
    let mut is_done = vec![false; network.links.len()];
    let mut runs = Vec::new();
    let next = |node: usize, link: usize| incidence[node].iter().copied().find(|k| *k != link);
    for start in 0..network.links.len() {
        if is_done[start] {
            continue;
        }
        // Back to a vertex, or once around.
        let (mut link, mut node) = (start, network.links[start].nodes[0]);
        while !is_vertex[node] {
            let Some(before) = next(node, link).filter(|before| *before != start) else { break };
            link = before;
            node = other(network, link, node);
        }
        if !is_vertex[node] {
            (link, node) = (start, network.links[start].nodes[0]);
        }
        let mut run = Run { nodes: vec![node], links: Vec::new() };
        loop {
            is_done[link] = true;
            run.links.push(link);
            node = other(network, link, node);
            run.nodes.push(node);
            if is_vertex[node] {
                break;
            }
            match next(node, link).filter(|after| !is_done[*after]) {
                Some(after) => link = after,
                None => break,
            }
        }
        runs.push(run);
    }
    runs
}

fn other(network: &Network, link: usize, node: usize) -> usize {
    let [a, b] = network.links[link].nodes;
    if a == node { b } else { a }
}

/// A curve with its ends in two points they were welded to. Polynomials and splines are moved there by their end points; arcs become
/// splines where rounding does not explain the distance.
fn ended(shape: Shape, ends: [Point; 2]) -> Shape {
    let off = |shape: &Shape, ends: [Point; 2]| {
        shape.ends().iter().zip(ends).map(|(p, q)| p.distance(q)).fold(0.0, f64::max)
    };
    // A curve may be run from its end: the run of a single link begins in its first node, so it is not.
    let moved = off(&shape, ends);
    match shape {
        Shape::Spline(spline) if moved > 0.0 => Shape::Spline(spline_ended(&spline, ends).unwrap_or(spline)),
        Shape::Arc(arc)
            if !arc.is_closed() && moved > rounding(ends[0]) + 1e-12 * arc.radii()[0].max(arc.radii()[1]) =>
        {
            let spline = Shape::Arc(arc.clone()).as_spline();
            spline.and_then(|spline| spline_ended(&spline, ends)).map_or(Shape::Arc(arc), Shape::Spline)
        }
        Shape::Polyline(_) | Shape::Spline(_) | Shape::Arc(_) => shape,
    }
}

fn spline_ended(spline: &SplineCurve, [first, last]: [Point; 2]) -> Option<SplineCurve> {
    let mut points = spline.points().to_vec();
    let count = points.len();
    points[0] = first;
    points[count - 1] = last;
    SplineCurve::new(spline.degree(), spline.knots().to_vec(), points, spline.weights().map(<[f64]>::to_vec))
        .ok()
}

/// The name of the curves a side is made of, if they share one.
fn name(network: &Network, file: &CurveFile, run: &Run) -> String {
    let mut names = run.links.iter().map(|link| &file.curves[network.links[*link].curve].name);
    let first = names.next().cloned().unwrap_or_default();
    if names.all(|name| *name == first) { first } else { String::new() }
}

/// Gives every side a name that no other has: its own, numbered where several share it.
fn distinct(sides: &mut [Side]) {
    let mut counts: HashMap<String, usize> = HashMap::new();
    for side in sides.iter() {
        *counts.entry(side.name.clone()).or_default() += 1;
    }
    let mut taken: std::collections::HashSet<String> = std::collections::HashSet::new();
    let mut numbers: HashMap<String, usize> = HashMap::new();
    for side in sides.iter_mut() {
        // A name that begins with a minus would read as a side run backwards.
        let stem = side.name.trim_start_matches('-').trim().to_owned();
        let is_alone = !stem.is_empty() && counts[&side.name] == 1;
        let stem = if stem.is_empty() { "side".to_owned() } else { stem };
        let number = numbers.entry(stem.clone()).or_insert(0);
        side.name = if is_alone && taken.insert(stem.clone()) {
            stem
        } else {
            loop {
                *number += 1;
                let name = format!("{stem}-{number}");
                if taken.insert(name.clone()) {
                    break name;
                }
            }
        };
    }
}
