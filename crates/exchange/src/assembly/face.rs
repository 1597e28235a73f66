//! Faces of a graph of curves: its smallest cycles.

use surfaces::Point;

use super::cycle_basis::{self, Arc};
use super::walk::named;
use super::{AssemblyError, Side, Walk};

/// Most paths between junctions.
const MOST_ARCS: usize = 400;

/// The faces of the sides that meet in threes and more; none where there are no such sides.
pub(super) fn faces(
    vertices: &[Point],
    sides: &[Side],
    at: &[Vec<usize>],
) -> Result<Option<Vec<Vec<Walk>>>, AssemblyError> {
    if at.iter().all(|sides| sides.len() == 2) {
        return Ok(None);
    }
    let paths = paths(sides, at);
    if paths.len() > MOST_ARCS {
        return Err(AssemblyError::TooMany(
            format!(
                "the curves are a graph of {} paths between junctions; the faces of up to {MOST_ARCS} are found, those of more have to \
                 be said by [[face]] tables in an experiment",
                paths.len()
            )
            .into(),
        ));
    }
    let arcs: Vec<Arc> = paths
        .iter()
        .map(|walks| {
            let (first, last) = (walks[0], walks[walks.len() - 1]);
            Arc {
                nodes: [end(sides, first, false), end(sides, last, true)],
                length: walks.iter().map(|walk| length(&sides[walk.side])).sum(),
            }
        })
        .collect();
    let chosen = cycle_basis::shortest(vertices.len(), &arcs);
    let cycle = |arcs_of: &[(usize, bool)]| -> Vec<Walk> {
        let walk = |(arc, forward): &(usize, bool)| -> Vec<Walk> {
            let path = &paths[*arc];
            if *forward {
                path.clone()
            } else {
                path.iter().rev().map(|walk| Walk { side: walk.side, forward: !walk.forward }).collect()
            }
        };
        arcs_of.iter().flat_map(walk).collect()
    };
    if let Some(bridge) = chosen.in_no_cycle.first() {
        return Err(AssemblyError::Ambiguous(format!(
            "{} bounds no face: no way leads back from its end to its beginning; leave it out",
            named(sides, &paths[*bridge])
        )));
    }
    if let Some((one, other)) = &chosen.rivals {
        let [one, other] = [one, other].map(|arcs| cycle(arcs));
        return Err(AssemblyError::Ambiguous(format!(
            "the curves are a graph, and which of its cycles are faces is open: ({}) may be one as well as ({}), they are about as long; \
             say it by [[face]] tables in an experiment, or leave out the curves that bound no face",
            named(sides, &one),
            named(sides, &other),
        )));
    }
    Ok(Some(chosen.cycles.iter().map(|arcs| cycle(arcs)).collect()))
}

/// Sides one after the other through vertices of two, from junction to junction.
fn paths(sides: &[Side], at: &[Vec<usize>]) -> Vec<Vec<Walk>> {
    let mut is_done = vec![false; sides.len()];
    let mut paths = Vec::new();
    for start in 0..sides.len() {
        let Some(ends) = sides[start].ends else { continue };
        let Some(forward) =
            [true, false].into_iter().find(|forward| at[ends[usize::from(!forward)]].len() != 2)
        else {
            continue;
        };
        if is_done[start] {
            continue;
        }
        let mut walks = vec![Walk { side: start, forward }];
        loop {
            let last = walks[walks.len() - 1];
            is_done[last.side] = true;
            let vertex = end(sides, last, true);
            let [a, b] = at[vertex][..] else { break };
            let side = if a == last.side { b } else { a };
            let forward = sides[side].ends.is_some_and(|ends| ends[0] == vertex);
            walks.push(Walk { side, forward });
        }
        paths.push(walks);
    }
    paths
}

/// The vertex where a walk ends or begins.
fn end(sides: &[Side], walk: Walk, at_end: bool) -> usize {
    sides[walk.side].ends.map_or(0, |ends| ends[usize::from(walk.forward == at_end)])
}

fn length(side: &Side) -> f64 {
    side.shape.sampled().windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}
