//! The search for shape parameters: the reduced energy J(α), a swarm over it, a polish of what the swarm found.

use std::ops::ControlFlow;

use energy::{ShapeForm, ShapedPatch};
use optim::{Bounds, Objective, Observer, Polish, Polished, Pso, Reason, Smooth, Topology};
use solve::{Parametric, ParametricProblem, Path, PolynomialMatrix, Term};
use surfaces::Net;

use super::{Context, MethodError, extremal_energy, functional};
use crate::{Arithmetic, Method, Patch, Progress, SearchMode, Variant};

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
    let reduced = Reduced::new(net, method, context.arithmetic)?;
    let bounds = Bounds::cube(4, options.lower, options.upper)?;
    let (polish, watch) = (Polish::default(), Watch(context.progress));
    let runs: Vec<SearchRun> = match mode {
        SearchMode::Polish => {
            context.progress.begin(&format!("descending for {}", method.name), options.runs as u64);
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
            context.progress.begin(&format!("searching for {}", method.name), steps);
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
        arithmetic: match reduced.parametric.path() {
            Path::Fma => "fma",
            Path::Portable => "portable",
        },
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
        reduced: &Reduced,
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

/// The reduced energy J(α) = min over the free points, as the swarm and the polish ask for it.
struct Reduced {
    parametric: Parametric,
}

impl Reduced {
    fn new(net: &Net, method: &Method, arithmetic: Arithmetic) -> Result<Self, MethodError> {
        if extremal_energy(method).is_some_and(|energy| energy != method.search_energy) {
            return Err(MethodError::Unavailable {
                what: "a search-energy other than the energy whose extremal is taken",
            });
        }
        let energy = functional(method.search_energy)
            .ok_or(MethodError::Unavailable { what: "a search on the area" })?;
        let kind = if method.patch == Patch::TbCoons { ShapedPatch::TbCoons } else { ShapedPatch::Gt };
        let form = ShapeForm::of(energy, kind, net.degrees())?;
        let parametric = Parametric::new(&problem(&form, net))?;
        let parametric = match arithmetic {
            Arithmetic::Auto => parametric,
            Arithmetic::Portable => parametric.with_path(Path::Portable)?,
            Arithmetic::Fma => parametric.with_path(Path::Fma)?,
        };
        Ok(Self { parametric })
    }
}

/// The numbers of a shape form over a net, as the solver takes them.
fn problem(form: &ShapeForm, net: &Net) -> ParametricProblem {
    let matrices = |grams: &[energy::GramPolynomial]| {
        grams
            .iter()
            .map(|gram| PolynomialMatrix {
                rows: gram.coefficients[0].rows(),
                cols: gram.coefficients[0].cols(),
                coefficients: gram.coefficients.each_ref().map(|c| c.as_slice().to_vec()),
            })
            .collect()
    };
    let (m, n) = net.degrees();
    let solved_for = net.fixed().contains(&false);
    let interior = |degree: usize| if solved_for { (1..degree).collect() } else { Vec::new() };
    ParametricProblem {
        left: matrices(&form.left),
        right: matrices(&form.right),
        terms: form
            .terms
            .iter()
            .map(|t| Term { coefficient: t.coefficient, left: t.left, right: t.right })
            .collect(),
        free_left: interior(m),
        free_right: interior(n),
        values: net.coordinates(),
    }
}

impl Objective for Reduced {
    fn dimension(&self) -> usize {
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        // Points come four numbers each; should they ever not, NaN loses to everything and is counted.
        if self.parametric.values(points, values).is_err() {
            values.fill(f64::NAN);
        }
    }
}

impl Smooth for Reduced {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        let mut by_shape = [0.0; 4];
        let value = self.parametric.value_and_gradient(&shape(point), &mut by_shape);
        gradient.copy_from_slice(&by_shape);
        value
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
