//! Where sides end.

use super::network::Network;
use crate::{CurveFile, Kind};

/// The nodes in which sides end: where other than two links meet, beside a curve that is no polyline, at corners, and where a
/// file begins another side.
pub(super) fn find(network: &Network, file: &CurveFile, angle: f64, notes: &mut Vec<String>) -> Vec<bool> {
    let incidence = network.incidence();
    let mut is_vertex = vec![false; network.points.len()];
    let mut turns: Vec<f64> = Vec::new();
    let mut sharpest: f64 = 0.0;
    for (node, links) in incidence.iter().enumerate() {
        let [a, b] = links[..] else {
            is_vertex[node] = !links.is_empty();
            continue;
        };
        // A closed curve by itself has no vertex.
        if a == b {
            continue;
        }
        let [first, second] = [a, b].map(|k| &network.links[k]);
        if !(first.is_segment && second.is_segment) {
            is_vertex[node] = true;
            continue;
        }
        let ends = [first, second].map(|link| link.nodes[usize::from(link.nodes[0] == node)]);
        let turn = turn(network, ends, node);
        // Regular polygons with exactly this turn are smooth whatever rounding does.
        if turn > angle * (1.0 + 1e-6) {
            is_vertex[node] = true;
            turns.push(turn);
        } else {
            sharpest = sharpest.max(turn);
            is_vertex[node] = is_joint(file, first.curve, second.curve);
        }
    }
    sharpest = lone_corners(network, file, &mut is_vertex, (angle, sharpest), &mut turns);
    if !turns.is_empty() || sharpest > 0.5 * angle {
        let degrees = |turn: f64| format!("{:.0}°", turn.to_degrees());
        let least = turns.iter().copied().fold(f64::INFINITY, f64::min);
        let corners = match turns.len() {
            0 => "no corners".into(),
            1 => format!("1 corner, turning by {}", degrees(least)),
            count => format!("{count} corners, turning by {} or more", degrees(least)),
        };
        notes.push(format!(
            "polylines have {corners}; elsewhere they turn by {} at most (--corner-angle {:.0})",
            degrees(sharpest),
            angle.to_degrees()
        ));
    }
    is_vertex
}

/// The share of the angle of corners above which a point that stands alone between two corners is one, too: nobody samples a curve by its
/// middle.
const LONE: f64 = 0.25;

/// Makes corners of points that stand alone between two corners; the largest turn of the points that are left.
fn lone_corners(
    network: &Network,
    file: &CurveFile,
    is_vertex: &mut [bool],
    (angle, sharpest): (f64, f64),
    turns: &mut Vec<f64>,
) -> f64 {
    let incidence = network.incidence();
    let before = is_vertex.to_vec();
    let mut left: f64 = 0.0;
    for (node, links) in incidence.iter().enumerate() {
        let [a, b] = links[..] else { continue };
        if before[node] || a == b {
            continue;
        }
        let [first, second] = [a, b].map(|k| &network.links[k]);
        let ends = [first, second].map(|link| link.nodes[usize::from(link.nodes[0] == node)]);
        let turn = turn(network, ends, node);
        // A curve of the file that is no more than these is a side.
        let is_side = first.curve == second.curve && file.curves[first.curve].shape.sampled().len() == 3;
        if !is_side
            && first.is_segment
            && second.is_segment
            && ends.iter().all(|&end| before[end])
            && turn > LONE * angle
        {
            is_vertex[node] = true;
            turns.push(turn);
        } else {
            left = left.max(turn);
        }
    }
    sharpest.min(left)
}

/// By how much segments turn at a node between two others.
fn turn(network: &Network, [from, to]: [usize; 2], node: usize) -> f64 {
    let here = network.points[node];
    let (before, after) = (here - network.points[from], network.points[to] - here);
    libm::atan2(before.cross(after).norm(), before.dot(after))
}

/// Whether the point between two curves of a file ends a side although it is smooth: sides of a table do, and curves of different
/// names that are more than a segment.
fn is_joint(file: &CurveFile, first: usize, second: usize) -> bool {
    let [a, b] = [first, second].map(|k| &file.curves[k]);
    if first == second || a.name == b.name {
        return false;
    }
    let is_more = |k: usize| match &file.curves[k].shape {
        crate::Shape::Polyline(points) => points.len() > 2,
        crate::Shape::Spline(_) | crate::Shape::Arc(_) => true,
    };
    file.kind == Kind::Table || (is_more(first) && is_more(second))
}
