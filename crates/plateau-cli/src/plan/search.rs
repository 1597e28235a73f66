//! `[search]`: the swarm and its box.

use serde_spanned::Spanned;

use super::check::{Check, top};
use super::number::{counted, shown};
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{NumberList, SearchSpec, Section};
use plateau::{MAX_SEARCH_BUDGET, Search, Variant};

/// Ring neighbours on each side, unless said otherwise.
const NEIGHBOURS: usize = 2;

#[derive(Clone, Copy)]
enum Topology {
    Global,
    Local,
}

/// Checks `[search]`; what it leaves out is as in [`Search::default`].
pub(super) fn search(check: &mut Check<'_>, spec: &Spanned<Section<SearchSpec>>) -> Option<Search> {
    let table = check.table("[search]", spec.span(), &top("search"));
    let spec = spec.get_ref();
    let mut search = Search::default();
    let mut sound = true;
    let names = [("global", Topology::Global), ("local", Topology::Local)];
    let topology = match &spec.variant {
        Some(key) => check.choice(&table, "variant", key, &names),
        None => Some(Topology::Global),
    };
    let counts = [
        ("particles", &spec.particles, &mut search.particles, optim::MAX_PARTICLES),
        ("iterations", &spec.iterations, &mut search.iterations, 1_000_000),
        ("runs", &spec.runs, &mut search.runs, 10_000),
    ];
    for (name, key, place, most) in counts {
        let Some(key) = key else { continue };
        let help = format!("GT §5 uses {name} = {}", *place);
        match check.count(&table, name, key, 1..=most, &help) {
            Some(count) => *place = count,
            None => sound = false,
        }
    }
    let weights = [
        ("inertia", &spec.inertia, &mut search.inertia, 1.0),
        ("social", &spec.social, &mut search.social, 10.0),
        ("cognitive", &spec.cognitive, &mut search.cognitive, 10.0),
    ];
    for (name, key, place, most) in weights {
        let Some(key) = key else { continue };
        let help = format!("GT §5 uses {name} = {}", *place);
        let set = format!("in [0, {most}]");
        match check.number(&table, name, key, (|x| (0.0..=most).contains(&x), &set), &help) {
            Some(weight) => *place = weight,
            None => sound = false,
        }
    }
    if let Some(key) = &spec.bounds {
        match bounds(check, key) {
            Some([lower, upper]) => (search.lower, search.upper) = (lower, upper),
            None => sound = false,
        }
    }
    let neighbours = match &spec.neighbours {
        Some(key) => {
            let help = "it is the number of ring neighbours on each side that inform a particle of the local variant";
            check.count(&table, "neighbours", key, 1..=500_000, help)
        }
        None => Some(NEIGHBOURS),
    };
    search.variant = match topology? {
        Topology::Global => neighbours.map(|_| Variant::Global)?,
        Topology::Local => Variant::Local { neighbours: neighbours? },
    };
    (sound && within_budget(check, &search, spec, &table.span)).then_some(search)
}

fn bounds(check: &mut Check<'_>, key: &Spanned<NumberList>) -> Option<[f64; 2]> {
    let help = "write box = [lower, upper] with 0 ≤ lower < upper ≤ 4: the GT functions are nonnegative exactly for \
                shape parameters in [0, 4]; the papers use [0.5, 3.5]";
    let list = &key.get_ref().0;
    let [lower, upper] = list.as_slice() else {
        check.inadmissible(
            key.span(),
            format!("`box` in [search] has {} instead of 2", counted(list.len(), "number")),
            counted(list.len(), "number"),
            help,
        );
        return None;
    };
    let mut sound = true;
    for end in [lower, upper] {
        let value = end.get_ref().0;
        if !(0.0..=4.0).contains(&value) {
            check.inadmissible(
                end.span(),
                format!("`box` in [search] reaches outside [0, 4]: {}", shown(value)),
                "outside [0, 4]",
                help,
            );
            sound = false;
        }
    }
    let (lower, upper) = (lower.get_ref().0, upper.get_ref().0);
    if sound && lower >= upper {
        check.inadmissible(
            key.span(),
            format!("`box` in [search] is empty: {} is not below {}", shown(lower), shown(upper)),
            "expected [lower, upper]",
            help,
        );
        return None;
    }
    sound.then_some([lower, upper])
}

fn within_budget(
    check: &mut Check<'_>,
    search: &Search,
    spec: &SearchSpec,
    header: &std::ops::Range<usize>,
) -> bool {
    let budget = [search.particles, search.iterations, search.runs]
        .iter()
        .fold(1u64, |product, &count| product.saturating_mul(count as u64));
    if budget <= MAX_SEARCH_BUDGET {
        return true;
    }
    let span = [&spec.particles, &spec.iterations, &spec.runs]
        .into_iter()
        .flatten()
        .max_by_key(|key| key.get_ref().0)
        .map_or(header.clone(), Spanned::span);
    check.report(
        Diagnostic::at(
            Fault::Inadmissible,
            span,
            format!(
                "[search] asks for {budget} evaluations: {} particles × {} iterations × {} runs",
                search.particles, search.iterations, search.runs
            ),
            "the largest of the three",
        )
        .help("at most 1000000000 are admitted: lower `particles`, `iterations` or `runs`, or use search = \"pso-polish\" with a small swarm"),
    );
    false
}
