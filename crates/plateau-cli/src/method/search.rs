//! The search for shape parameters: the reduced energy J(α), a swarm over it, a polish of what the swarm found.

use std::ops::ControlFlow;

use optim::{Bounds, Observer, Polish, Polished, Pso, Reason, Topology};
use surfaces::Net;

use super::reduced::Reduced;
use super::{Context, MethodError};
use crate::{Method, Progress, SearchMode, Variant};

/// What a search found.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SearchOutcome {
    /// The best shape (α1, α2, β1, β2) of all runs.
    pub shape: [f64; 4],
    /// The reduced energy there.
    pub minimum: f64,
    /// Evaluations of the reduced energy, those of the polish included.
    pub evaluations: u64,
    /// How many of them failed.
    pub nan_evaluations: u64,
    /// How it was evaluated: `parametric` from polynomials of the shape, `separable` from samples.
    pub engine: &'static str,
    /// Which arithmetic evaluated it: results repeat bit for bit on the same one only.
    pub arithmetic: &'static str,
    /// Every run, in order.
    pub runs: Vec<SearchRun>,
}

/// One run of a search.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SearchRun {
    /// The seed of the experiment.
    pub seed: u64,
    /// Index of the run; seed and index determine it.
    pub index: usize,
    /// The least energy it found, after the polish if there was one.
    pub value: f64,
    /// Where.
    pub shape: [f64; 4],
    /// Why it ended.
    pub reason: String,
    /// Evaluations of the reduced energy.
    pub evaluations: u64,
    /// How many of them failed.
    pub nan_evaluations: u64,
    /// The best energy of the swarm after its initialisation and after each iteration.
    pub history: Vec<f64>,
    /// The polish of the swarm's best point, or the descent from a start.
    pub polish: Option<Polished>,
    on_budget: bool,
}

impl SearchRun {
    /// Whether the run ended because its budget was spent, with nothing known of convergence.
    pub fn stopped_on_budget(&self) -> bool {
        self.on_budget
    }
}

impl SearchRun {
    /// Whether a polish showed the run's end to be a stationary point of the box, or as near as rounding allows.
    pub fn is_stationary(&self) -> bool {
        use optim::PolishReason::{Flat, Stationary};
        self.polish.as_ref().is_some_and(|p| matches!(p.reason, Stationary | Flat))
    }
}

impl SearchOutcome {
    /// The difference between the worst and the best run.
    pub fn spread(&self) -> f64 {
        self.runs.iter().map(|run| run.value - self.minimum).fold(0.0, f64::max)
    }
}

/// Searches the shape of `method` over `net`.
pub(super) fn search(
    net: &Net,
    method: &Method,
    mode: SearchMode,
    context: &Context<'_>,
) -> Result<SearchOutcome, MethodError> {
    let options = &context.experiment.search;
    let reduced = Reduced::new(net, method, context.arithmetic, context.progress)?;
    let bounds = Bounds::cube(4, options.lower, options.upper)?;
    let (polish, watch) = (Polish::default(), Watch(context.progress));
    let runs: Vec<SearchRun> = match mode {
        SearchMode::Polish => {
            context.progress.begin(&format!("descending for {}", method.name), Some(options.runs as u64));
            let descents = polish.run_starts(&reduced, &bounds, options.runs, context.seed)?;
            descents.into_iter().enumerate().map(|(k, p)| from_descent(context.seed, k, p)).collect()
        }
        SearchMode::Pso | SearchMode::PsoPolish => {
            let pso = Pso {
                particles: options.particles,
                iterations: options.iterations,
                inertia: options.inertia,
                social: options.social,
                cognitive: options.cognitive,
                topology: match options.variant {
                    Variant::Global => Topology::Global,
                    Variant::Local { neighbours } => Topology::Ring { neighbours },
                },
                ..Pso::new(context.seed)
            };
            let steps = options.runs as u64 * (options.iterations as u64 + 1);
            context.progress.begin(&format!("searching for {}", method.name), Some(steps));
            let found = pso.search(&reduced, &bounds, options.runs, &watch)?;
            let mut runs: Vec<SearchRun> = found.runs.iter().filter_map(from_swarm).collect();
            if mode == SearchMode::PsoPolish {
                for run in &mut runs {
                    run.polish_with(&polish, &reduced, &bounds)?;
                }
            }
            if runs.is_empty() {
                context.progress.end();
                return Err(MethodError::NothingFound { evaluations: found.evaluations() });
            }
            runs
        }
    };
    context.progress.end();
    if context.progress.cancelled() {
        return Err(MethodError::Interrupted);
    }
    let best = runs.iter().reduce(|best, run| if run.value < best.value { run } else { best });
    let Some(best) = best.filter(|best| best.value.is_finite()) else {
        return Err(MethodError::NothingFound { evaluations: runs.iter().map(|r| r.evaluations).sum() });
    };
    Ok(SearchOutcome {
        shape: best.shape,
        minimum: best.value,
        evaluations: runs.iter().map(|run| run.evaluations).sum(),
        nan_evaluations: runs.iter().map(|run| run.nan_evaluations).sum(),
        engine: reduced.engine(),
        arithmetic: reduced.arithmetic(),
        runs,
    })
}

fn shape(point: &[f64]) -> [f64; 4] {
    std::array::from_fn(|k| point[k])
}

fn from_swarm(run: &optim::Run) -> Option<SearchRun> {
    let best = run.best.as_ref()?;
    Some(SearchRun {
        seed: run.seed,
        index: run.run,
        value: best.value,
        shape: shape(&best.point),
        reason: run.reason.to_string(),
        evaluations: run.evaluations,
        nan_evaluations: run.nan_evaluations,
        history: run.history.clone(),
        polish: None,
        on_budget: run.reason == Reason::Budget,
    })
}

fn from_descent(seed: u64, index: usize, polished: Polished) -> SearchRun {
    SearchRun {
        seed,
        index,
        value: polished.value,
        shape: shape(&polished.point),
        reason: polished.reason.to_string(),
        evaluations: polished.evaluations as u64,
        nan_evaluations: 0,
        history: Vec::new(),
        on_budget: polished.reason == optim::PolishReason::Budget,
        polish: Some(polished),
    }
}

impl SearchRun {
    /// Descends from the best point; what the run ended with is then a stationary point, not a spent budget.
    fn polish_with(
        &mut self,
        polish: &Polish,
        reduced: &Reduced<'_>,
        bounds: &Bounds,
    ) -> Result<(), MethodError> {
        let polished = polish.run(reduced, bounds, &self.shape)?;
        self.evaluations += polished.evaluations as u64;
        self.value = polished.value;
        self.shape = shape(&polished.point);
        self.on_budget = polished.reason == optim::PolishReason::Budget;
        self.polish = Some(polished);
        Ok(())
    }
}

/// Passes the iterations of a swarm on to whoever watches.
struct Watch<'a>(&'a dyn Progress);

impl Observer for Watch<'_> {
    fn observe(&self, _: &optim::Progress<'_>) -> ControlFlow<()> {
        self.0.step();
        if self.0.cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
