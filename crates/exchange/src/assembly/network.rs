//! Points that curves share, and the links between them.

use std::collections::HashMap;

use surfaces::Point;

use super::AssemblyError;
use super::copies::Copies;
use crate::{CurveFile, Sentence, Shape};

/// A segment of a polyline or a whole curve of another kind, from node to node.
#[derive(Debug, Clone)]
pub(super) struct Link {
    pub(super) nodes: [usize; 2],
    /// The curve of the file it belongs to.
    pub(super) curve: usize,
    pub(super) is_segment: bool,
}

/// The curves of a file as a graph of segments and curves.
pub(super) struct Network {
    pub(super) points: Vec<Point>,
    pub(super) links: Vec<Link>,
    /// First and last node of every curve of the file.
    pub(super) ends: Vec<[usize; 2]>,
    /// Curves that are closed if nothing meets their ends.
    closes: Vec<bool>,
    /// What stands for a node that was welded to another: itself for most.
    merged: Vec<usize>,
    /// Whether only arcs end in the node, whose ends cannot be moved.
    pub(super) is_of_arcs: Vec<bool>,
    /// How much of each curve there is: length, to a few per cent.
    pub(super) lengths: Vec<f64>,
}

impl Network {
    pub(super) fn new(file: &CurveFile, notes: &mut Vec<Sentence>) -> Result<Self, AssemblyError> {
        let mut network = Self {
            points: Vec::new(),
            links: Vec::new(),
            ends: Vec::new(),
            closes: file.curves.iter().map(|curve| curve.closes).collect(),
            merged: Vec::new(),
            is_of_arcs: Vec::new(),
            lengths: Vec::new(),
        };
        // Bits, not distances: what is near but not equal is welded later, and told.
        let mut places: HashMap<[u64; 3], usize> = HashMap::new();
        let mut repeats = Vec::new();
        for (curve, read) in file.curves.iter().enumerate() {
            let points = read.shape.sampled();
            network.lengths.push(points.windows(2).map(|pair| pair[0].distance(pair[1])).sum());
            match &read.shape {
                Shape::Polyline(points) => {
                    let nodes: Vec<usize> =
                        points.iter().map(|p| network.node(&mut places, *p, false)).collect();
                    // Samples that repeat the one before are no segments, and are told of.
                    let equal: Vec<usize> = (1..nodes.len()).filter(|k| nodes[*k] == nodes[k - 1]).collect();
                    if !equal.is_empty() {
                        repeats.push((curve, equal));
                    }
                    network.ends.push([nodes[0], nodes[nodes.len() - 1]]);
                    for pair in nodes.windows(2).filter(|pair| pair[0] != pair[1]) {
                        network.links.push(Link { nodes: [pair[0], pair[1]], curve, is_segment: true });
                    }
                }
                Shape::Spline(_) | Shape::Arc(_) => {
                    let is_arc = matches!(read.shape, Shape::Arc(_));
                    let nodes = read.shape.ends().map(|p| network.node(&mut places, p, is_arc));
                    network.ends.push(nodes);
                    network.links.push(Link { nodes, curve, is_segment: false });
                }
            }
        }
        if !repeats.is_empty() {
            notes.push(said(file, &repeats).into());
        }
        Ok(network)
    }

    /// The node at a point, equal digit for digit.
    fn node(&mut self, places: &mut HashMap<[u64; 3], usize>, p: Point, is_arc: bool) -> usize {
        // 0 and −0 are equal.
        let key = [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
        let next = self.points.len();
        let node = *places.entry(key).or_insert(next);
        if node == next {
            self.points.push(p);
            self.merged.push(node);
            self.is_of_arcs.push(is_arc);
        } else {
            self.is_of_arcs[node] &= is_arc;
        }
        node
    }

    /// What stands for a node.
    pub(super) fn root(&self, mut node: usize) -> usize {
        while self.merged[node] != node {
            node = self.merged[node];
        }
        node
    }

    /// Makes two nodes one: the first in the file stays, unless only arcs end there.
    pub(super) fn merge(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        if a == b {
            return;
        }
        // An arc cannot end elsewhere than it does: the other node moves to it.
        let (low, high) = (a.min(b), a.max(b));
        let (keep, go) =
            if self.is_of_arcs[low] && !self.is_of_arcs[high] { (high, low) } else { (low, high) };
        self.merged[go] = keep;
    }

    /// Writes the standing nodes into all links; segments that have become points go.
    pub(super) fn settle(&mut self) {
        let mut links = std::mem::take(&mut self.links);
        for link in &mut links {
            link.nodes = link.nodes.map(|node| self.root(node));
        }
        // A curve that ends where it begins is a loop and stays.
        links.retain(|link| !link.is_segment || link.nodes[0] != link.nodes[1]);
        self.links = links;
        self.ends = self.ends.iter().map(|ends| ends.map(|node| self.root(node))).collect();
    }

    /// How many ends of links meet in each node.
    pub(super) fn degrees(&self) -> Vec<usize> {
        let mut degrees = vec![0; self.points.len()];
        for node in self.links.iter().flat_map(|link| link.nodes) {
            degrees[node] += 1;
        }
        degrees
    }

    /// The links at each node, a closed one twice.
    pub(super) fn incidence(&self) -> Vec<Vec<usize>> {
        let mut incidence = vec![Vec::new(); self.points.len()];
        for (k, link) in self.links.iter().enumerate() {
            for node in link.nodes {
                incidence[node].push(k);
            }
        }
        incidence
    }

    /// Closes the curves that are said to be loops and do not come back to their beginning.
    pub(super) fn close_loops(&mut self) {
        let incidence = self.incidence();
        // A curve may have run through its ends before, but nothing else does: one that something joins is part of a net, whatever the file
        // says.
        let is_open = |curve: usize, node: usize| {
            let links = &incidence[node];
            links.len() % 2 == 1 && links.iter().all(|link| self.links[*link].curve == curve)
        };
        let mut closing = Vec::new();
        for (curve, &[start, end]) in self.ends.iter().enumerate().filter(|(curve, _)| self.closes[*curve]) {
            if start != end && is_open(curve, start) && is_open(curve, end) {
                closing.push(Link { nodes: [end, start], curve, is_segment: true });
            }
        }
        // A segment that is run again counts once.
        closing.retain(|link| {
            !incidence[link.nodes[0]].iter().any(|other| self.links[*other].nodes.contains(&link.nodes[1]))
        });
        for link in closing {
            self.ends[link.curve] = [link.nodes[1]; 2];
            self.links.push(link);
        }
    }

    /// Drops what stands twice: segments between the same nodes, curves of other kinds with the same nodes and the same middle. A note
    /// says which.
    pub(super) fn drop_copies(&mut self, file: &CurveFile, size: f64, notes: &mut Vec<Sentence>) {
        let mut segments: HashMap<[usize; 2], usize> = HashMap::new();
        let mut middles: HashMap<[usize; 2], Vec<(Point, usize)>> = HashMap::new();
        let mut copies = Copies::new(self.links.iter().map(|link| link.curve), file);
        self.links.retain(|link| {
            let [a, b] = link.nodes;
            let nodes = [a.min(b), a.max(b)];
            let first = if link.is_segment {
                let next = segments.len();
                let first = *segments.entry(nodes).or_insert(link.curve);
                (segments.len() == next).then_some(first)
            } else {
                let points = file.curves[link.curve].shape.sampled();
                // The same ends and the same middle: two curves of a lens share their ends, but not this.
                let middle = points[points.len() / 2];
                let known = middles.entry(nodes).or_default();
                let first = known.iter().find(|(other, _)| other.distance(middle) <= 1e-9 * size);
                let first = first.map(|(_, curve)| *curve);
                known.push((middle, link.curve));
                first
            };
            if let Some(first) = first {
                copies.add(first, link.curve);
            }
            first.is_none()
        });
        notes.extend(copies.said().map(Sentence::from));
    }
}

/// A sentence on samples that are equal to the one before them: all of them.
fn said(file: &CurveFile, repeats: &[(usize, Vec<usize>)]) -> String {
    /// Most samples named.
    const NAMED: usize = 60;
    let total: usize = repeats.iter().map(|(_, equal)| equal.len()).sum();
    let mut left = NAMED;
    let mut sides = Vec::new();
    for (curve, equal) in repeats {
        let shown: Vec<String> = equal.iter().take(left).map(usize::to_string).collect();
        left -= shown.len();
        let name = file.curves[*curve].called();
        let rest = if shown.len() < equal.len() { ", …" } else { "" };
        sides.push(format!("{name}: {}{rest}", shown.join(", ")));
        if left == 0 {
            break;
        }
    }
    format!(
        "{total} samples are equal to the one before them and count once, counted from 0 ({})",
        sides.join("; ")
    )
}
