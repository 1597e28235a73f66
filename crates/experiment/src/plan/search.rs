//! `[search]`: the swarm and its box.

use plateau::{MAX_SEARCH_BUDGET, Search, SearchFault, Variant};

use super::built::built;
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::search::{
    BOX, COGNITIVE, INERTIA, ITERATIONS, NEIGHBOURS, PARTICLES, RUNS, SOCIAL, Topology, VARIANT,
};
use crate::text::{Table, shown};

/// Checks `[search]`.
pub(super) fn search(table: &Table<'_>) -> Option<Search> {
    let topology = table.take_or_default(&VARIANT);
    let particles = table.take_or_default(&PARTICLES);
    let iterations = table.take_or_default(&ITERATIONS);
    let runs = table.take_or_default(&RUNS);
    let inertia = table.take_or_default(&INERTIA);
    let social = table.take_or_default(&SOCIAL);
    let cognitive = table.take_or_default(&COGNITIVE);
    let bounds = bounds(table);
    let neighbours = table.take_or_default(&NEIGHBOURS);
    let [lower, upper] = bounds?;
    let variant = match (topology?, neighbours?) {
        (Topology::Global, _) => Variant::Global,
        (Topology::Local, neighbours) => Variant::Local { neighbours },
    };
    let counts = [particles?, iterations?, runs?];
    let (inertia, social, cognitive) = (inertia?, social?, cognitive?);
    let search = || -> Result<Search, SearchFault> {
        let [particles, iterations, runs] = counts;
        Search::default()
            .with_variant(variant)?
            .with_swarm(particles, iterations, runs)?
            .with_weights(inertia, social, cognitive)?
            .with_box(lower, upper)
    };
    match search() {
        Err(SearchFault::Budget(budget)) => {
            beyond_budget(table, budget, counts);
            None
        }
        made => built(table, table.span(), made),
    }
}

fn bounds(table: &Table<'_>) -> Option<[f64; 2]> {
    let ends = table.take_or_default(&BOX)?;
    let [lower, upper] = ends.as_slice() else { return None };
    let bounds = [*lower.get_ref(), *upper.get_ref()];
    if bounds[0] < bounds[1] {
        return Some(bounds);
    }
    table.faults().inadmissible(
        table.place(&["box"]).unwrap_or(table.span()),
        format!("`box` in [search] is empty: {} is not below {}", shown(bounds[0]), shown(bounds[1])),
        "expected [lower, upper]",
        "write box = [lower, upper] with 0 ≤ lower < upper ≤ 4",
    );
    None
}

fn beyond_budget(table: &Table<'_>, budget: u64, [particles, iterations, runs]: [usize; 3]) {
    let counts = [("particles", particles), ("iterations", iterations), ("runs", runs)];
    let given = counts.iter().filter_map(|&(key, count)| Some((count, table.place(&[key])?)));
    let span = given.max_by_key(|(count, _)| *count).map_or(table.span(), |(_, span)| span);
    table.faults().report(
        Diagnostic::at(
            Fault::Inadmissible,
            span,
            format!(
                "[search] asks for {budget} evaluations: {particles} particles × {iterations} iterations × {runs} runs"
            ),
            "the largest of the three",
        )
        .help(format!(
            "at most {MAX_SEARCH_BUDGET} are admitted: lower `particles`, `iterations` or `runs`, or use search = \
             \"pso-polish\" with a small swarm"
        )),
    );
}
