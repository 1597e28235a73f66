//! Where sides end.

use super::network::Network;
use crate::{CurveFile, Kind, Sentence, Setting};

/// The share of the angle of corners above which a point that stands alone between two corners is one, too: nobody samples a curve by its
/// middle.
const LONE: f64 = 0.25;

/// The nodes in which sides end: where other than two links meet, beside a curve that is no polyline, at corners, and where a
/// file begins another side.
pub(super) fn find(network: &Network, file: &CurveFile, angle: f64, notes: &mut Vec<Sentence>) -> Vec<bool> {
    let incidence = network.incidence();
    let mut is_vertex = vec![false; network.points.len()];
    let mut turns: Vec<f64> = Vec::new();
    // How much sides turn where the file begins another one.
    let mut joints: Vec<f64> = Vec::new();
    // Nodes between two segments that are no corners by their turn.
    let mut bends: Vec<(usize, f64)> = Vec::new();
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
        let turn = turn(network, neighbours(network, node, [a, b]), node);
        // Regular polygons with exactly this turn are smooth whatever rounding does.
        let is_corner = turn > angle * (1.0 + 1e-6);
        is_vertex[node] = is_corner || is_joint(file, first.curve, second.curve);
        match (is_corner, is_vertex[node]) {
            (true, _) => turns.push(turn),
            (false, true) => joints.push(turn),
            (false, false) => bends.push((node, turn)),
        }
    }
    let before = is_vertex.clone();
    bends.retain(|&(node, turn)| {
        let links = [incidence[node][0], incidence[node][1]];
        let is_alone = neighbours(network, node, links).iter().all(|&end| before[end]);
        let is_corner = is_alone && turn > LONE * angle && !is_side(network, file, links);
        if is_corner {
            is_vertex[node] = true;
            turns.push(turn);
        }
        !is_corner
    });
    let sharpest = bends.iter().fold(0.0, |sharpest, &(_, turn)| f64::max(sharpest, turn));
    if !turns.is_empty() || sharpest > 0.5 * angle {
        notes.push(said(&turns, &joints, sharpest, angle));
    }
    is_vertex
}

/// A sentence on the corners that were found by their turn, on the ends of sides that a file has besides, and on what is left.
fn said(turns: &[f64], joints: &[f64], sharpest: f64, angle: f64) -> Sentence {
    let degrees = |turn: f64| format!("{:.0}°", turn.to_degrees());
    let least = turns.iter().copied().fold(f64::INFINITY, f64::min);
    let corners = match turns.len() {
        0 => "no corners".into(),
        1 => format!("1 corner, turning by {}", degrees(least)),
        count => format!("{count} corners, turning by {} or more", degrees(least)),
    };
    let most = joints.iter().copied().fold(0.0, f64::max);
    let joints = match joints.len() {
        0 => String::new(),
        1 => format!(", and 1 more where the file begins another side, turning by {}", degrees(most)),
        count => {
            format!(
                ", and {count} more where the file begins another side, turning by {} at most",
                degrees(most)
            )
        }
    };
    let found =
        format!("polylines have {corners}{joints}; elsewhere they turn by {} at most (", degrees(sharpest));
    Sentence::from(found).value(Setting::CornerAngle, format!("{:.0}", angle.to_degrees())).text(")")
}

/// The other ends of two links at a node.
fn neighbours(network: &Network, node: usize, links: [usize; 2]) -> [usize; 2] {
    links.map(|k| &network.links[k]).map(|link| link.nodes[usize::from(link.nodes[0] == node)])
}

/// Whether two segments are a curve of the file and no more of it.
fn is_side(network: &Network, file: &CurveFile, links: [usize; 2]) -> bool {
    let [first, second] = links.map(|k| network.links[k].curve);
    first == second && file.curves[first].shape.sampled().len() == 3
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
