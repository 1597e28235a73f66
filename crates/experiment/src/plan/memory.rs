//! What an experiment keeps until it ends: meshes, patches, histories of searches. Each is bounded by itself; here, together.

use plateau::{Helicoid, Method, SearchMode, counted};

use super::{Experiment, PatchExperiment};
use crate::keys::output::LARGEST_MESH;
use crate::text::Table;

/// Most vertices in the meshes of all frames of a deformation.
const MOST_VERTICES_OF_FRAMES: usize = (LARGEST_MESH + 1).pow(2);

/// Most vertices in the meshes of all methods: four of the largest meshes take 2.5 GB.
const MOST_VERTICES_OF_METHODS: usize = 4 * (LARGEST_MESH + 1).pow(2);

/// Most patches in all frames of a deformation.
const MOST_PATCHES: usize = 20_000;

/// Most numbers in the histories of all swarms: in `result.json` they take 60 MB, and a larger one is not read again.
const MOST_HISTORY: usize = 1_500_000;

/// Refuses an experiment that would keep too much at once.
pub(super) fn fits(root: &Table<'_>, experiment: &Experiment, mesh: usize) {
    match experiment {
        Experiment::Helicoid(helicoid) => frames_fit(root, helicoid, mesh),
        Experiment::Patch(experiment) => {
            meshes_fit(root, experiment.methods.len(), mesh);
            histories_fit(root, experiment);
        }
        Experiment::Film(film) => meshes_fit(root, film.methods.len(), mesh),
        Experiment::TrapeziumHelicoid(..) | Experiment::Net(_) | Experiment::Curve(_) => {}
    }
}

fn frames_fit(root: &Table<'_>, helicoid: &Helicoid, mesh: usize) {
    let frames = helicoid.frames();
    if frames == 0 {
        return;
    }
    let most = MOST_VERTICES_OF_FRAMES / frames;
    let patches: f64 = helicoid
        .form()
        .spans()
        .map(|span| (span / surfaces::Helicoid::LARGEST_PIECE).ceil())
        .iter()
        .product();
    let Some(span) = root.place(&["helicoid", "frames"]) else { return };
    if patches * frames as f64 > MOST_PATCHES as f64 {
        root.faults().inadmissible(
            span.clone(),
            format!("{frames} frames of {patches} patches each are too many to be kept at once"),
            format!("at most {MOST_PATCHES} patches in all"),
            "take fewer frames, or shorter spans",
        );
    }
    if (mesh + 1).pow(2) <= most {
        return;
    }
    root.faults().inadmissible(
        span,
        format!("{frames} frames with `mesh` = {mesh} are too many vertices to be kept at once"),
        format!("{} vertices", frames * (mesh + 1).pow(2)),
        format!("take fewer frames, or write mesh = {} in [output]", most.isqrt() - 1),
    );
}

fn meshes_fit(root: &Table<'_>, methods: usize, mesh: usize) {
    let most = MOST_VERTICES_OF_METHODS / methods;
    let key = root.place(&["output", "mesh"]);
    let Some(span) = key.filter(|_| (mesh + 1).pow(2) > most) else { return };
    root.faults().inadmissible(
        span,
        format!("{methods} methods with `mesh` = {mesh} are too many vertices to be kept at once"),
        format!("{} vertices", methods * (mesh + 1).pow(2)),
        format!("write mesh = {}, or split the methods into several files", most.isqrt() - 1),
    );
}

fn histories_fit(root: &Table<'_>, experiment: &PatchExperiment) {
    let by_swarm = |method: &&Method| match method.search_mode() {
        Some(SearchMode::Pso | SearchMode::PsoPolish) => true,
        Some(SearchMode::Polish) | None => false,
    };
    let swarms = experiment.methods.iter().filter(by_swarm).count();
    let (runs, iterations) = (experiment.search.runs(), experiment.search.iterations());
    let numbers = swarms * runs * (iterations + 1);
    if numbers <= MOST_HISTORY {
        return;
    }
    let counts = [("iterations", iterations), ("runs", runs)];
    let given = counts.into_iter().filter_map(|(key, count)| Some((count, root.place(&["search", key])?)));
    let largest = given.max_by_key(|(count, _)| *count).map(|(_, span)| span);
    let Some(span) = largest.or(root.place(&["search"])).or(root.place(&["method"])) else { return };
    root.faults().inadmissible(
        span,
        format!(
            "{} × {runs} runs × {iterations} iterations have histories too long to be kept at once",
            counted(swarms, "swarm")
        ),
        format!("{numbers} numbers, at most {MOST_HISTORY}"),
        "lower `iterations` or `runs`, or split the methods into several files",
    );
}
