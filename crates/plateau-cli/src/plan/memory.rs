//! What an experiment keeps until it ends: meshes, patches, histories of searches. Each is bounded by itself; here, together.

use serde_spanned::Spanned;

use super::check::Check;
use super::number::counted;
use super::{Experiment, LARGEST_MESH, PatchExperiment};
use crate::spec::Spec;
use plateau::{Helicoid, SearchMode, Shape};

/// Most vertices in the meshes of all frames of a deformation.
const MOST_VERTICES_OF_FRAMES: usize = (LARGEST_MESH + 1).pow(2);

/// Most vertices in the meshes of all methods: four of the largest meshes take 2.5 GB.
const MOST_VERTICES_OF_METHODS: usize = 4 * (LARGEST_MESH + 1).pow(2);

/// Most patches in all frames of a deformation.
const MOST_PATCHES: usize = 20_000;

/// Most numbers in the histories of all swarms: in `result.json` they take 60 MB, and a larger one is not read again.
const MOST_HISTORY: usize = 1_500_000;

/// Refuses an experiment that would keep too much at once.
pub(super) fn fits(check: &mut Check<'_>, spec: &Spec, experiment: &Experiment, mesh: usize) {
    match experiment {
        Experiment::Helicoid(helicoid) => frames_fit(check, spec, helicoid, mesh),
        Experiment::Patch(experiment) => {
            meshes_fit(check, spec, experiment.methods.len(), mesh);
            histories_fit(check, spec, experiment);
        }
        Experiment::TrapeziumHelicoid(_) | Experiment::Curve(_) => {}
    }
}

fn frames_fit(check: &mut Check<'_>, spec: &Spec, helicoid: &Helicoid, mesh: usize) {
    let Some(frames) = helicoid.deformation.map(|deformation| deformation.frames) else { return };
    let most = MOST_VERTICES_OF_FRAMES / frames;
    let patches: f64 = [helicoid.u_span, helicoid.v_span]
        .map(|span| (span / surfaces::Helicoid::LARGEST_PIECE).ceil())
        .iter()
        .product();
    let key = spec.helicoid.as_ref().and_then(|table| table.get_ref().frames.as_ref());
    let Some(span) = key.map(Spanned::span) else { return };
    if patches * frames as f64 > MOST_PATCHES as f64 {
        check.inadmissible(
            span.clone(),
            format!("{frames} frames of {patches} patches each are too many to be kept at once"),
            format!("at most {MOST_PATCHES} patches in all"),
            "take fewer frames, or shorter spans",
        );
    }
    if (mesh + 1).pow(2) <= most {
        return;
    }
    check.inadmissible(
        span,
        format!("{frames} frames with `mesh` = {mesh} are too many vertices to be kept at once"),
        format!("{} vertices", frames * (mesh + 1).pow(2)),
        format!("take fewer frames, or write mesh = {} in [output]", most.isqrt() - 1),
    );
}

fn meshes_fit(check: &mut Check<'_>, spec: &Spec, methods: usize, mesh: usize) {
    let most = MOST_VERTICES_OF_METHODS / methods;
    let key = spec.output.as_ref().and_then(|table| table.get_ref().mesh.as_ref());
    let Some(key) = key.filter(|_| (mesh + 1).pow(2) > most) else { return };
    check.inadmissible(
        key.span(),
        format!("{methods} methods with `mesh` = {mesh} are too many vertices to be kept at once"),
        format!("{} vertices", methods * (mesh + 1).pow(2)),
        format!("write mesh = {}, or split the methods into several files", most.isqrt() - 1),
    );
}

fn histories_fit(check: &mut Check<'_>, spec: &Spec, experiment: &PatchExperiment) {
    let by_swarm = |shape: Shape| matches!(shape, Shape::Search(SearchMode::Pso | SearchMode::PsoPolish));
    let swarms = experiment.methods.iter().filter(|method| by_swarm(method.shape)).count();
    let (runs, iterations) = (experiment.search.runs, experiment.search.iterations);
    let numbers = swarms * runs * (iterations + 1);
    if numbers <= MOST_HISTORY {
        return;
    }
    let span = match (&spec.search, &spec.method) {
        (Some(table), _) => {
            let keys = [&table.get_ref().iterations, &table.get_ref().runs];
            let largest = keys.into_iter().flatten().max_by_key(|key| key.get_ref().0);
            largest.map_or(table.span(), Spanned::span)
        }
        (None, Some(methods)) => methods.span(),
        (None, None) => return,
    };
    check.inadmissible(
        span,
        format!(
            "{} × {runs} runs × {iterations} iterations have histories too long to be kept at once",
            counted(swarms, "swarm")
        ),
        format!("{numbers} numbers, at most {MOST_HISTORY}"),
        "lower `iterations` or `runs`, or split the methods into several files",
    );
}
