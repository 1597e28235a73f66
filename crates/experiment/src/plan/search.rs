//! `[search]`: the swarm and its box.

use plateau::{MAX_SEARCH_BUDGET, Search, Variant};

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
    let search = Search {
        variant,
        particles: particles?,
        iterations: iterations?,
        runs: runs?,
        inertia: inertia?,
        social: social?,
        cognitive: cognitive?,
        lower,
        upper,
    };
    is_within_budget(table, &search).then_some(search)
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

fn is_within_budget(table: &Table<'_>, search: &Search) -> bool {
    let counts = [("particles", search.particles), ("iterations", search.iterations), ("runs", search.runs)];
    let budget = counts.iter().fold(1u64, |product, &(_, count)| product.saturating_mul(count as u64));
    if budget <= MAX_SEARCH_BUDGET {
        return true;
    }
    let given = counts.iter().filter_map(|&(key, count)| Some((count, table.place(&[key])?)));
    let span = given.max_by_key(|(count, _)| *count).map_or(table.span(), |(_, span)| span);
    table.faults().report(
        Diagnostic::at(
            Fault::Inadmissible,
            span,
            format!(
                "[search] asks for {budget} evaluations: {} particles × {} iterations × {} runs",
                search.particles, search.iterations, search.runs
            ),
            "the largest of the three",
        )
        .help(format!(
            "at most {MAX_SEARCH_BUDGET} are admitted: lower `particles`, `iterations` or `runs`, or use search = \
             \"pso-polish\" with a small swarm"
        )),
    );
    false
}
