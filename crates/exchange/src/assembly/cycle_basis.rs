//! The shortest cycles that make all others, and whether they are the only ones.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// An edge of a graph with a length; several may join the same nodes.
pub(super) struct Arc {
    pub(super) nodes: [usize; 2],
    pub(super) length: f64,
}

/// Arcs in the order of travel, and whether each is run forward.
type Cycle = Vec<(usize, bool)>;

/// What [`shortest`] found.
pub(super) struct Chosen {
    /// The cycles of the basis, the shortest first.
    pub(super) cycles: Vec<Cycle>,
    /// Arcs that lie on no cycle at all.
    pub(super) in_no_cycle: Vec<usize>,
    /// A cycle outside the basis and one inside that it could replace, being hardly longer, without more cycles meeting in an arc
    /// than in the basis, or than two.
    pub(super) rivals: Option<(Cycle, Cycle)>,
}

/// A cycle this much longer than the one it could replace is no rival.
const RIVAL: f64 = 1.1;

/// Most swaps looked at.
const MOST_SWAPS: usize = 20_000;

/// Sets of arcs as bits.
type Bits = Vec<u64>;

/// A basis of least total length (Horton): candidates are, for every node and arc, the shortest paths to the arc's ends and the arc;
/// of these, from the shortest on, those that are no sum of shorter ones. Deterministic: equal lengths keep the order of the arcs.
pub(super) fn shortest(nodes: usize, arcs: &[Arc]) -> Chosen {
    let candidates = candidates(nodes, arcs);
    let mut rows: Vec<Row> = Vec::new();
    let mut basis: Vec<&Candidate> = Vec::new();
    // Cycles outside the basis with those inside they could replace.
    let mut swaps: Vec<(Candidate, usize)> = Vec::new();
    for candidate in &candidates {
        let mut row =
            Row { arcs: candidate.arcs.clone(), sum_of: vec![0; arcs.len().div_ceil(64) + 1], lead: 0 };
        for known in &rows {
            if has(&row.arcs, known.lead) {
                add(&mut row.arcs, &known.arcs);
                add(&mut row.sum_of, &known.sum_of);
            }
        }
        let lead = ones(&row.arcs).next();
        if let Some(lead) = lead {
            // Its own place in the basis.
            let place = basis.len();
            row.sum_of[place / 64] |= 1 << (place % 64);
            row.lead = lead;
            rows.push(row);
            basis.push(candidate);
        } else {
            let parts: Vec<usize> =
                ones(&row.sum_of).filter(|part| candidate.length < RIVAL * basis[*part].length).collect();
            swaps.extend(parts.into_iter().map(|part| (candidate.clone(), part)));
            swaps.truncate(MOST_SWAPS);
        }
    }
    swaps.extend(sums(arcs, &basis));
    let mut uses = vec![0_usize; arcs.len()];
    for arc in basis.iter().flat_map(|candidate| ones(&candidate.arcs)) {
        uses[arc] += 1;
    }
    let most = uses.iter().copied().max().unwrap_or(0).max(2);
    let is_rival = |(candidate, part): &&(Candidate, usize)| {
        ones(&candidate.arcs).all(|arc| uses[arc] - usize::from(has(&basis[*part].arcs, arc)) < most)
    };
    let rivals = swaps
        .iter()
        .find(is_rival)
        .map(|(candidate, part)| (ordered(arcs, &candidate.arcs), ordered(arcs, &basis[*part].arcs)));
    Chosen {
        cycles: basis.iter().map(|candidate| ordered(arcs, &candidate.arcs)).collect(),
        in_no_cycle: (0..arcs.len()).filter(|arc| uses[*arc] == 0).collect(),
        rivals,
    }
}

#[derive(Clone)]
struct Candidate {
    arcs: Bits,
    length: f64,
}

/// A reduced cycle, the cycles of the basis it is the sum of, its first arc.
struct Row {
    arcs: Bits,
    sum_of: Bits,
    lead: usize,
}

/// Cycles that are the sum of two of a basis or of all of it, each with the ones it could replace: of equally short paths between two
/// nodes the candidates hold one only, so these may be missing there.
fn sums(arcs: &[Arc], basis: &[&Candidate]) -> Vec<(Candidate, usize)> {
    let count = basis.len();
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| vec![i, j]));
    let mut swaps = Vec::new();
    for parts in pairs.chain((count > 2).then(|| (0..count).collect())) {
        let mut bits = vec![0; arcs.len().div_ceil(64)];
        for part in &parts {
            add(&mut bits, &basis[*part].arcs);
        }
        let length: f64 = ones(&bits).map(|k| arcs[k].length).sum();
        // Apart from each other two cycles are none.
        if parts.iter().any(|part| length < RIVAL * basis[*part].length) && is_simple(arcs, &bits) {
            let replaced = parts.iter().filter(|part| length < RIVAL * basis[**part].length);
            swaps.extend(replaced.map(|part| (Candidate { arcs: bits.clone(), length }, *part)));
        }
    }
    swaps
}

fn candidates(nodes: usize, arcs: &[Arc]) -> Vec<Candidate> {
    let words = arcs.len().div_ceil(64);
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for (k, arc) in arcs.iter().enumerate() {
        for node in arc.nodes {
            at[node].push(k);
        }
    }
    let mut candidates: Vec<Candidate> = Vec::new();
    for root in (0..nodes).filter(|node| !at[*node].is_empty()) {
        let paths = paths(root, arcs, &at);
        for (k, arc) in arcs.iter().enumerate() {
            let [Some(a), Some(b)] = arc.nodes.map(|node| paths[node].as_ref()) else { continue };
            let mut bits = vec![0; words];
            add(&mut bits, a);
            add(&mut bits, b);
            bits[k / 64] ^= 1 << (k % 64);
            let length = ones(&bits).map(|k| arcs[k].length).sum();
            if is_simple(arcs, &bits) {
                candidates.push(Candidate { arcs: bits, length });
            }
        }
    }
    candidates.sort_by(|a, b| a.length.total_cmp(&b.length).then_with(|| b.arcs.cmp(&a.arcs)));
    candidates.dedup_by(|a, b| a.arcs == b.arcs);
    candidates
}

/// A node to go on from, the nearest first.
struct Reached {
    distance: f64,
    node: usize,
}

impl PartialEq for Reached {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Reached {}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.distance.total_cmp(&self.distance).then(other.node.cmp(&self.node))
    }
}

/// The arcs of the shortest paths from a root to every node (Dijkstra).
fn paths(root: usize, arcs: &[Arc], at: &[Vec<usize>]) -> Vec<Option<Bits>> {
    let mut distances = vec![f64::INFINITY; at.len()];
    let mut paths: Vec<Option<Bits>> = vec![None; at.len()];
    let mut heap = BinaryHeap::from([Reached { distance: 0.0, node: root }]);
    distances[root] = 0.0;
    paths[root] = Some(vec![0; arcs.len().div_ceil(64)]);
    while let Some(Reached { distance, node }) = heap.pop() {
        if distance > distances[node] {
            continue;
        }
        for &k in &at[node] {
            let [a, b] = arcs[k].nodes;
            let next = if a == node { b } else { a };
            let reached = distance + arcs[k].length;
            if reached < distances[next] {
                let mut path = paths[node].clone().unwrap_or_default();
                path[k / 64] |= 1 << (k % 64);
                distances[next] = reached;
                paths[next] = Some(path);
                heap.push(Reached { distance: reached, node: next });
            }
        }
    }
    paths
}

/// Whether a set of arcs is one cycle.
fn is_simple(arcs: &[Arc], bits: &Bits) -> bool {
    let count = ones(bits).count();
    count > 0
        && ordered(arcs, bits).len() == count
        && ones(bits).all(|k| {
            arcs[k]
                .nodes
                .iter()
                .all(|node| ones(bits).flat_map(|j| arcs[j].nodes).filter(|other| other == node).count() == 2)
        })
}

/// The arcs of a cycle in the order of travel, beginning with the first; fewer where it is not one cycle.
fn ordered(arcs: &[Arc], bits: &Bits) -> Cycle {
    let mut left: Vec<usize> = ones(bits).collect();
    if left.is_empty() {
        return Vec::new();
    }
    let first = left.remove(0);
    let mut cycle = vec![(first, true)];
    let mut node = arcs[first].nodes[1];
    while let Some(place) = left.iter().position(|k| arcs[*k].nodes.contains(&node)) {
        let k = left.remove(place);
        let forward = arcs[k].nodes[0] == node;
        node = arcs[k].nodes[usize::from(forward)];
        cycle.push((k, forward));
    }
    cycle
}

fn has(bits: &Bits, arc: usize) -> bool {
    bits[arc / 64] >> (arc % 64) & 1 == 1
}

fn add(sum: &mut Bits, other: &Bits) {
    for (a, b) in sum.iter_mut().zip(other) {
        *a ^= b;
    }
}

fn ones(bits: &[u64]) -> impl Iterator<Item = usize> + '_ {
    bits.iter()
        .enumerate()
        .flat_map(|(word, bits)| (0..64).filter(move |k| bits >> k & 1 == 1).map(move |k| 64 * word + k))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(arcs: &[(usize, usize, f64)]) -> Vec<Arc> {
        arcs.iter().map(|&(a, b, length)| Arc { nodes: [a, b], length }).collect()
    }

    #[test]
    fn cells_of_a_grid_are_its_faces() {
        // 2 by 1 squares: the rim around both is no rival.
        let arcs =
            graph(&[(0, 1, 1.), (1, 2, 1.), (3, 4, 1.), (4, 5, 1.), (0, 3, 1.), (1, 4, 1.), (2, 5, 1.)]);
        let chosen = shortest(6, &arcs);
        assert_eq!(chosen.cycles.len(), 2);
        assert!(
            chosen.cycles.iter().all(|cycle| cycle.len() == 4)
                && chosen.rivals.is_none()
                && chosen.in_no_cycle.is_empty()
        );
    }

    #[test]
    fn rivals_are_named() {
        // Three equal meridians: any two of the three lenses.
        assert!(shortest(2, &graph(&[(0, 1, 1.), (0, 1, 1.), (1, 0, 1.)])).rivals.is_some());
        // One far longer: the two short ones, and one of them with it.
        assert!(shortest(2, &graph(&[(0, 1, 1.), (0, 1, 1.), (1, 0, 5.)])).rivals.is_some());
        // A bar across a rectangle.
        let chosen = shortest(2, &graph(&[(0, 1, 3.), (0, 1, 1.), (1, 0, 3.)]));
        assert!(chosen.rivals.is_none() && chosen.cycles.len() == 2);
        // A narrow strip between two panels: taken with one of them it would make three faces meet in its far side.
        let strip = [(0, 1, 10.), (0, 1, 4.), (0, 2, 0.1), (1, 3, 0.1), (2, 3, 4.), (2, 3, 10.)];
        assert!(shortest(4, &graph(&strip)).rivals.is_none());
        // A tetrahedron.
        let tetrahedron = graph(&[(0, 1, 1.), (0, 2, 1.), (0, 3, 1.), (1, 2, 1.), (1, 3, 1.), (2, 3, 1.)]);
        assert!(shortest(4, &tetrahedron).rivals.is_some());
    }

    #[test]
    fn bridges_lie_on_no_cycle() {
        let chosen = shortest(4, &graph(&[(0, 1, 1.), (0, 1, 2.), (1, 2, 1.), (2, 2, 1.)]));
        assert_eq!((chosen.in_no_cycle, chosen.cycles.len()), (vec![2], 2));
    }
}
