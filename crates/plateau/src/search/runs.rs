//! The search for shape parameters: the reduced energy J(α), a swarm over it, a polish of what the swarm found.

use std::ops::ControlFlow;

use optim::{Bounds, Objective, Observer, Polish, PolishReason, Polished, Pso, Reason, Topology};
use rayon::prelude::*;
use surfaces::{Net, ShapedFamily};

use super::reduced::Reduced;
use super::{SearchMode, SearchOutcome, SearchRun, Swarm, Variant};
use crate::{Context, MethodError, SearchEnergy, TensorInterior};

/// What all runs of a search share.
struct Search<'a> {
    reduced: &'a Reduced<'a>,
    bounds: &'a Bounds,
    mode: SearchMode,
    context: &'a Context<'a>,
}

impl Search<'_> {
    /// Every run that found something, in order, and the evaluations of all.
    fn runs(&self, name: &str) -> Result<(Vec<SearchRun>, u64), MethodError> {
        let (options, progress) = (&self.context.search, self.context.progress);
        let kept = |k| {
            let run = self.context.keeper.run(self.context.index, k)?;
            if self.can_have_made(k, &run) {
                return Some(run);
            }
            self.context.keeper.refuse(self.context.index, k);
            None
        };
        let kept: Vec<Option<SearchRun>> = (0..options.runs()).map(kept).collect();
        let ahead = kept.iter().filter(|run| run.is_none()).count() as u64;
        let pso = self.swarm();
        match self.mode {
            SearchMode::Polish => {
                Polish::default().validate_starts(self.bounds.dimension(), self.bounds, options.runs())?;
                progress.begin(&format!("descending for {name}"), Some(ahead));
            }
            SearchMode::Pso | SearchMode::PsoPolish => {
                pso.validate_search(self.bounds.dimension(), self.bounds, options.runs())?;
                let steps = ahead * (options.iterations() as u64 + 1);
                progress.begin(&format!("searching for {name}"), Some(steps));
            }
        }
        let run = |(k, kept): (usize, Option<SearchRun>)| match kept {
            Some(run) => Ok((run.evaluations(), Some(run))),
            None => self.run(&pso, k),
        };
        let ended: Vec<(u64, Option<SearchRun>)> =
            kept.into_par_iter().enumerate().map(run).collect::<Result<_, MethodError>>()?;
        self.context.keeper.search_ended();
        let evaluations = ended.iter().map(|(evaluations, _)| evaluations).sum();
        Ok((ended.into_iter().filter_map(|(_, run)| run).collect(), evaluations))
    }

    /// Whether a run that was kept agrees with this search: its place lies in the box, its value is the energy there, and its
    /// history leads down to it.
    fn can_have_made(&self, k: usize, run: &SearchRun) -> bool {
        const ROUNDING: f64 = 1e-9;
        let near = |x: f64| (x - run.value()).abs() <= ROUNDING * run.value().abs();
        if run.seed() != self.context.seed || run.index() != k || !self.bounds.contains(run.shape()) {
            return false;
        }
        let mut value = [f64::NAN];
        self.reduced.evaluate(run.shape(), &mut value);
        let descends = run.history().is_sorted_by(|a, b| a >= b);
        let leads_there = run.history().last().is_none_or(|last| *last >= run.value() || near(*last));
        near(value[0]) && descends && leads_there && self.is_as_set(run)
    }

    /// Whether the parts of a run that the settings determine are what they make of them: which parts there are, the
    /// length of the history, the evaluations, and whether a budget was spent.
    fn is_as_set(&self, run: &SearchRun) -> bool {
        let (swarms, descends) = match self.mode {
            SearchMode::Pso => (true, false),
            SearchMode::Polish => (false, true),
            SearchMode::PsoPolish => (true, true),
        };
        let (particles, iterations) = (self.context.search.particles(), self.context.search.iterations());
        let spent = |swarm: &Swarm| {
            let evaluations = (particles * (iterations + 1)) as u64;
            // Neither stagnation nor collapse ends a swarm here, and no run without a finite value is kept.
            swarm.reason == Reason::Budget
                && swarm.history.len() == iterations + 1
                && swarm.evaluations == evaluations
                && swarm.nan_evaluations <= evaluations
        };
        run.swarm().is_some() == swarms
            && run.swarm().is_none_or(spent)
            && run.polish().is_some() == descends
            && run.polish().is_none_or(ends_as_it_says)
    }

    /// One run and its evaluations; seed and index determine it.
    fn run(&self, pso: &Pso, k: usize) -> Result<(u64, Option<SearchRun>), MethodError> {
        if self.context.progress.cancelled() {
            return Ok((0, None));
        }
        let (polish, seed) = (Polish::default(), self.context.seed);
        let mut run = match self.mode {
            SearchMode::Polish => {
                let polished = polish.run_start(self.reduced, self.bounds, k, seed)?;
                self.context.progress.step();
                SearchRun::of_descent((seed, k), None, polished)
            }
            SearchMode::Pso | SearchMode::PsoPolish => {
                let report = pso.run(self.reduced, self.bounds, k, &Watch(self.context))?;
                match from_swarm(&report) {
                    Some(run) => run,
                    None => return Ok((report.evaluations, None)),
                }
            }
        };
        if self.mode == SearchMode::PsoPolish && !self.context.progress.cancelled() {
            let polished = polish.run(self.reduced, self.bounds, run.shape())?;
            run = run.followed_by(polished);
        }
        // What was cut short is no finished run.
        if !self.context.progress.cancelled() {
            self.context.keeper.keep(self.context.index, &run);
        }
        Ok((run.evaluations(), Some(run)))
    }

    fn swarm(&self) -> Pso {
        let options = &self.context.search;
        let [inertia, social, cognitive] = options.weights();
        Pso {
            particles: options.particles(),
            iterations: options.iterations(),
            inertia,
            social,
            cognitive,
            topology: match options.variant() {
                Variant::Global => Topology::Global,
                Variant::Local { neighbours } => Topology::Ring { neighbours },
            },
            ..Pso::new(self.context.seed)
        }
    }
}

/// Searches the shape of a family for the least `energy` over `net`, where the interior is found as said; `name` is what the search is for.
pub(crate) fn search(
    net: &Net,
    name: &str,
    (family, energy): (ShapedFamily, SearchEnergy),
    interior: TensorInterior,
    mode: SearchMode,
    context: &Context<'_>,
) -> Result<SearchOutcome, MethodError> {
    let options = &context.search;
    let ([lower, upper], range) = (options.bounds(), family.range());
    if !(range.0 <= lower && lower < upper && upper <= range.1) {
        return Err(MethodError::SearchBox { lower, upper, family: family.title(), range });
    }
    let reduced = Reduced::new(net, (family, energy), interior, context.arithmetic, context.progress)?;
    let bounds = Bounds::cube(family.parameters().len(), lower, upper)?;
    let search = Search { reduced: &reduced, bounds: &bounds, mode, context };
    let runs = search.runs(name);
    context.progress.end();
    let (runs, evaluations) = runs?;
    if context.progress.cancelled() {
        return Err(MethodError::Interrupted);
    }
    let evaluated = [reduced.engine(), reduced.arithmetic()];
    SearchOutcome::of(energy, evaluated, runs).ok_or(MethodError::NothingFound { evaluations })
}

/// Whether the reason of a descent is the one that its budget and its residual give.
fn ends_as_it_says(polished: &Polished) -> bool {
    // Of two points whose values only rounding tells apart the calmer one is reported.
    const BLURRED: f64 = 1e-6;
    let Polish { tolerance, evaluations } = Polish::default();
    let limit = tolerance * polished.value.abs();
    let counted = polished.iterations < polished.evaluations && polished.evaluations <= evaluations;
    let reason = if polished.residual <= limit * (1.0 + BLURRED) {
        PolishReason::Stationary
    } else if polished.evaluations == evaluations && polished.reason != PolishReason::Flat {
        PolishReason::Budget
    } else {
        PolishReason::Flat
    };
    counted && polished.reason == reason
}

fn from_swarm(run: &optim::Run) -> Option<SearchRun> {
    let swarm = Swarm {
        reason: run.reason,
        evaluations: run.evaluations,
        nan_evaluations: run.nan_evaluations,
        history: run.history.clone(),
    };
    Some(SearchRun::of_swarm((run.seed, run.run), swarm, run.best.clone()?))
}

/// Passes the iterations of a swarm on to whoever watches.
struct Watch<'a>(&'a Context<'a>);

impl Observer for Watch<'_> {
    fn observe(&self, _: &optim::Progress<'_>) -> ControlFlow<()> {
        self.0.progress.step();
        self.0.keeper.tick();
        if self.0.progress.cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
