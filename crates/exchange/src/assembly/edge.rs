//! The shortest edges near the ends of curves, beside which a gap has to be small.

use surfaces::Point;

use super::network::Network;
use super::size::rounding;
use crate::{CurveFile, Shape};

/// The length of the shortest edge of a polygon; edges that are no longer than rounding of its coordinates are none. Infinite where there
/// is none at all.
pub fn shortest_edge(points: &[Point]) -> f64 {
    let is_more = |pair: &&[Point]| pair[0].distance(pair[1]) > rounding(pair[0]).max(rounding(pair[1]));
    let lengths = points.windows(2).filter(is_more).map(|pair| pair[0].distance(pair[1]));
    lengths.fold(f64::INFINITY, f64::min)
}

/// The lengths of shortest edges.
pub(super) struct ShortestEdges {
    /// By curve: of its own edges and of those of the curves that meet it in its ends.
    pub(super) of_curves: Vec<f64>,
    /// By node: of the curves that run through it.
    pub(super) at_nodes: Vec<f64>,
}

impl ShortestEdges {
    /// A polyline has segments for edges, any other curve is one.
    pub(super) fn new(network: &Network, file: &CurveFile) -> Self {
        let own = file.curves.iter().zip(&network.lengths).map(|(curve, &length)| match &curve.shape {
            Shape::Polyline(points) => shortest_edge(points),
            Shape::Spline(_) | Shape::Arc(_) => length,
        });
        let own: Vec<f64> = own.collect();
        let near = at_nodes(network, &own);
        let of_curves: Vec<f64> =
            network.ends.iter().map(|ends| f64::min(near[ends[0]], near[ends[1]])).collect();
        let at_nodes = at_nodes(network, &of_curves);
        Self { of_curves, at_nodes }
    }
}

/// The least value of the curves through each node.
fn at_nodes(network: &Network, of_curves: &[f64]) -> Vec<f64> {
    let mut at_nodes = vec![f64::INFINITY; network.points.len()];
    for link in &network.links {
        for node in link.nodes {
            at_nodes[node] = f64::min(at_nodes[node], of_curves[link.curve]);
        }
    }
    at_nodes
}
