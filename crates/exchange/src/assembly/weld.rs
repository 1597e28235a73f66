//! Ends that should meet become one point.

use std::collections::HashMap;

use surfaces::Point;

use super::AssemblyError;
use super::network::Network;
use crate::{Sentence, Setting};

/// What was welded.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weld {
    /// The largest distance allowed; beside short edges it is less ([`AssemblyOptions::reach`](super::AssemblyOptions::reach)).
    pub tolerance: f64,
    /// How many ends were moved.
    pub count: usize,
    /// The farthest any of them was moved.
    pub largest: f64,
}

/// The largest tolerance, as a share of the size of the curves.
pub(super) const MOST_WELDED: f64 = 0.25;

/// Most pairs of points looked at.
const MOST_PAIRS: usize = 4_000_000;

/// Welds every end that nothing meets to all such ends within reach, else to the nearest other point of another curve. No two nodes reach
/// each other farther than the tolerance.
pub(super) fn weld(
    network: &mut Network,
    tolerance: f64,
    reach: impl Fn(usize, usize) -> f64,
) -> Result<Weld, AssemblyError> {
    let mut done = Weld { tolerance, ..Weld::default() };
    if tolerance == 0.0 {
        return Ok(done);
    }
    let degrees = network.degrees();
    let dangling: Vec<usize> = (0..degrees.len()).filter(|node| degrees[*node] == 1).collect();
    let curves = curves_of(network, &degrees);
    let grid = Grid::new(network, tolerance, &dangling);
    let mut pairs = Vec::new();
    let mut looked_at = 0;
    for &end in &dangling {
        let mut nearest_other: Option<(f64, usize)> = None;
        let mut meets_end = false;
        for other in grid.near(network.points[end]) {
            looked_at += 1;
            if looked_at > MOST_PAIRS {
                let many = format!(
                    "too many points lie within {tolerance:.2e} of each other to find which ends should meet: give a smaller "
                );
                return Err(AssemblyError::TooMany(Sentence::from(many).setting(Setting::Weld)));
            }
            let distance = network.points[end].distance(network.points[other]);
            if other == end || distance > reach(end, other) {
                continue;
            }
            let is_own = curves[other] == curves[end];
            if degrees[other] == 1 {
                // A curve closes upon itself only if it goes somewhere between.
                if !is_own || network.lengths[curves[end]] > 4.0 * tolerance {
                    meets_end = true;
                    pairs.push((distance, end, other));
                }
            } else if (!is_own || curves[other] == usize::MAX)
                && nearest_other.is_none_or(|(best, _)| distance < best)
            {
                nearest_other = Some((distance, other));
            }
        }
        if let (Some((distance, other)), false) = (nearest_other, meets_end) {
            pairs.push((distance, end, other));
        }
    }
    for (_, end, other) in pairs {
        network.merge(end, other);
    }
    for node in dangling {
        let moved = network.points[node].distance(network.points[network.root(node)]);
        if network.root(node) != node {
            done.count += 1;
            done.largest = done.largest.max(moved);
        }
    }
    network.settle();
    Ok(done)
}

/// The curve each node belongs to; none for a point of several.
fn curves_of(network: &Network, degrees: &[usize]) -> Vec<usize> {
    let mut curves = vec![None; degrees.len()];
    for link in &network.links {
        for node in link.nodes {
            curves[node] = match curves[node] {
                None => Some(link.curve),
                Some(curve) if curve == link.curve => Some(curve),
                Some(_) => Some(usize::MAX),
            };
        }
    }
    curves.into_iter().map(|curve| curve.unwrap_or(usize::MAX)).collect()
}

/// Nodes by cubes as wide as the tolerance, around free ends only.
struct Grid {
    cell: f64,
    nodes: HashMap<[i64; 3], Vec<usize>>,
}

impl Grid {
    fn new(network: &Network, cell: f64, dangling: &[usize]) -> Self {
        let mut grid = Self { cell, nodes: HashMap::new() };
        // Only cubes near a free end are ever asked for.
        for &end in dangling {
            for key in grid.around(network.points[end]) {
                grid.nodes.entry(key).or_default();
            }
        }
        for node in 0..network.points.len() {
            let key = grid.key(network.points[node]);
            if let Some(nodes) = grid.nodes.get_mut(&key) {
                nodes.push(node);
            }
        }
        grid
    }

    fn key(&self, p: Point) -> [i64; 3] {
        // Casts saturate: far away all is one cube, where distances still decide.
        [p.x, p.y, p.z].map(|x| libm::floor(x / self.cell) as i64)
    }

    fn around(&self, p: Point) -> impl Iterator<Item = [i64; 3]> + use<> {
        let [x, y, z] = self.key(p);
        (0..27_i64).map(move |k| {
            [x.saturating_add(k % 3 - 1), y.saturating_add(k / 3 % 3 - 1), z.saturating_add(k / 9 - 1)]
        })
    }

    fn near(&self, p: Point) -> impl Iterator<Item = usize> + '_ {
        let mut keys: Vec<[i64; 3]> = self.around(p).collect();
        // Saturated keys repeat.
        keys.dedup();
        keys.into_iter().flat_map(|key| self.nodes.get(&key).into_iter().flatten().copied())
    }
}
