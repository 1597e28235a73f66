//! Particle swarm search in a box: parameters, stopping, the loop over iterations.

use rayon::prelude::*;
use thiserror::Error;

use crate::bounds::Bounds;
use crate::objective::Objective;
use crate::observer::{Observer, Progress};
use crate::report::{Best, Reason, Run, Search};
use crate::swarm::Swarm;
use crate::topology::Topology;

/// The parameters of a particle swarm search (GT §3, Algorithm 1, with the corrections below).
///
/// Iterations are synchronous: every particle of iteration t uses the bests of t − 1,
/// `v ← w v + c₁ r₁∘(informant − x) + c₂ r₂∘(own best − x)`, `x ← x + v`, with `r₁`, `r₂` fresh and
/// uniform per component. A position that leaves the box is put on its wall and that component of
/// its velocity set to zero, without which particles stick there. The best point is the arg min
/// over all own bests, ties to the smaller index.
///
/// Particle `i` of run `r` draws from ChaCha8 stream `i` under the key (seed, r): first its
/// position, then its velocity, then in each iteration `r₁` and `r₂` of every component in turn. So a run's report depends on
/// the parameters, the objective, the box and `r` alone: not on threads, batches or other runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Pso {
    /// Number of particles, 1 to [`MAX_PARTICLES`].
    pub particles: usize,
    /// Iterations after the initialisation; `particles × (iterations + 1)` is at most
    /// [`MAX_EVALUATIONS`].
    pub iterations: usize,
    /// Weight `w` of the old velocity, in `[0, 1000]`.
    pub inertia: f64,
    /// Weight `c₁` of the pull to the informant, in `[0, 1000]`.
    pub social: f64,
    /// Weight `c₂` of the pull to the particle's own best, in `[0, 1000]`.
    pub cognitive: f64,
    /// Largest initial velocity relative to the width of the box, in `[0, 1000]`.
    pub initial_velocity: f64,
    /// Who informs whom.
    pub topology: Topology,
    /// The experiment's seed.
    pub seed: u64,
    /// Particles per call of the objective; smaller than the swarm, calls run in parallel.
    /// `None`: the whole swarm in one call on the calling thread.
    pub batch: Option<usize>,
    /// End a run whose best value stopped improving.
    pub stagnation: Option<Stagnation>,
    /// End a run whose diameter, relative to the box, is at most this number in `[0, 1]`.
    pub collapse: Option<f64>,
}

/// No improvement above `tolerance × |best value|` over the last `iterations` iterations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stagnation {
    /// Length of the window, at least 1.
    pub iterations: usize,
    /// Relative improvement that counts, finite and not negative.
    pub tolerance: f64,
}

/// The largest number of particles.
pub const MAX_PARTICLES: usize = 100_000;
/// The largest number of coordinates of a swarm, particles × dimension.
pub const MAX_COORDINATES: usize = 4_000_000;
/// The largest number of evaluations of a run, particles × (iterations + 1).
pub const MAX_EVALUATIONS: usize = 1_000_000_000;
/// The largest number of iterations of all runs of a search, runs × (iterations + 1).
pub const MAX_HISTORY: usize = 50_000_000;

/// Why a search cannot begin.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PsoError {
    /// A count is zero or too large.
    #[error("{name} is {value}; it must lie between 1 and {limit}")]
    Count {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: usize,
        /// The largest value allowed.
        limit: usize,
    },
    /// A product of counts is too large.
    #[error("{product} exceeds {limit} with {first} and {second}; lower one of the two")]
    Budget {
        /// The product in words.
        product: &'static str,
        /// Its first factor.
        first: usize,
        /// Its second factor.
        second: usize,
        /// The largest product allowed.
        limit: usize,
    },
    /// A coefficient is NaN or outside its range.
    #[error("{name} is {value:?}; it must lie in [0, {limit:?}]")]
    Coefficient {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The largest value allowed.
        limit: f64,
    },
    /// Objective and box disagree.
    #[error(
        "the objective has dimension {objective}, the box {bounds}; give one pair of bounds per component"
    )]
    Dimension {
        /// The dimension of the objective.
        objective: usize,
        /// The dimension of the box.
        bounds: usize,
    },
}

const MAX_COEFFICIENT: f64 = 1000.0;

impl Pso {
    /// The parameters of GT §3: 50 particles, 100 iterations, `w = 0.7`, `c₁ = c₂ = 1.5`, everyone
    /// informs everyone, no stopping before the budget is spent.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            particles: 50,
            iterations: 100,
            inertia: 0.7,
            social: 1.5,
            cognitive: 1.5,
            initial_velocity: 0.1,
            topology: Topology::Global,
            seed,
            batch: None,
            stagnation: None,
            collapse: None,
        }
    }

    /// One run of the swarm: run `run` of a search, whose report it equals bit for bit.
    ///
    /// # Errors
    /// Parameters outside their ranges, or an objective of another dimension than the box.
    /// An objective without finite values is not an error but a [`Reason::NothingFinite`].
    pub fn run(
        &self,
        objective: &(impl Objective + ?Sized),
        bounds: &Bounds,
        run: usize,
        observer: &(impl Observer + ?Sized),
    ) -> Result<Run, PsoError> {
        self.validate(objective.dimension(), bounds)?;
        Ok(self.fly(objective, bounds, run, observer))
    }

    /// Runs `0 … runs − 1`, in parallel, reported by index.
    ///
    /// # Errors
    /// As [`Pso::run`], and for `runs` 0 or `runs × (iterations + 1)` above [`MAX_HISTORY`].
    pub fn search(
        &self,
        objective: &(impl Objective + ?Sized),
        bounds: &Bounds,
        runs: usize,
        observer: &(impl Observer + ?Sized),
    ) -> Result<Search, PsoError> {
        self.validate_search(objective.dimension(), bounds, runs)?;
        let fly = |run| self.fly(objective, bounds, run, observer);
        let runs = (0..runs).into_par_iter().map(fly).collect();
        Ok(Search { runs })
    }

    /// As [`Pso::validate`], for a search of several runs.
    ///
    /// # Errors
    /// The first parameter at fault.
    pub fn validate_search(&self, dimension: usize, bounds: &Bounds, runs: usize) -> Result<(), PsoError> {
        self.validate(dimension, bounds)?;
        count("runs", runs, MAX_HISTORY)?;
        budget("runs × (iterations + 1)", runs, self.iterations + 1, MAX_HISTORY)
    }

    /// Whether the parameters lie in their ranges and suit the box, without running anything.
    ///
    /// # Errors
    /// The first parameter at fault; `dimension` is the objective's.
    pub fn validate(&self, dimension: usize, bounds: &Bounds) -> Result<(), PsoError> {
        if dimension != bounds.dimension() {
            return Err(PsoError::Dimension { objective: dimension, bounds: bounds.dimension() });
        }
        count("particles", self.particles, MAX_PARTICLES)?;
        budget("particles × dimension", self.particles, dimension, MAX_COORDINATES)?;
        let evaluations = "particles × (iterations + 1)";
        let iterations = self.iterations.saturating_add(1);
        budget(evaluations, self.particles, iterations, MAX_EVALUATIONS)?;
        budget("runs × (iterations + 1)", 1, iterations, MAX_HISTORY)?;
        if let Topology::Ring { neighbours } = self.topology {
            count("neighbours", neighbours, usize::MAX)?;
        }
        if let Some(batch) = self.batch {
            count("batch", batch, usize::MAX)?;
        }
        coefficient("inertia", self.inertia, MAX_COEFFICIENT)?;
        coefficient("social", self.social, MAX_COEFFICIENT)?;
        coefficient("cognitive", self.cognitive, MAX_COEFFICIENT)?;
        coefficient("initial velocity", self.initial_velocity, MAX_COEFFICIENT)?;
        if let Some(Stagnation { iterations, tolerance }) = self.stagnation {
            count("stagnation iterations", iterations, usize::MAX)?;
            coefficient("stagnation tolerance", tolerance, f64::MAX)?;
        }
        if let Some(diameter) = self.collapse {
            coefficient("collapse", diameter, 1.0)?;
        }
        Ok(())
    }

    fn fly(
        &self,
        objective: &(impl Objective + ?Sized),
        bounds: &Bounds,
        run: usize,
        observer: &(impl Observer + ?Sized),
    ) -> Run {
        let batch = self.batch.unwrap_or(self.particles);
        let mut swarm = Swarm::scatter(self, bounds, run);
        let mut history = Vec::with_capacity(self.iterations + 1);
        let mut last_improvement = 0;
        let reason = loop {
            swarm.evaluate(objective, batch);
            swarm.remember();
            // The initialisation is iteration 0.
            let iteration = history.len();
            if history.last().is_some_and(|&before| swarm.best_value() < before) {
                last_improvement = iteration;
            }
            history.push(swarm.best_value());
            let progress = Progress {
                run,
                iteration,
                iterations: self.iterations,
                best_value: swarm.best_value(),
                best_point: swarm.best_point(),
                evaluations: (self.particles * history.len()) as u64,
                nan_evaluations: swarm.nan_evaluations,
            };
            // Before the reasons to stop, so that the last iteration is shown, too.
            if observer.observe(&progress).is_break() {
                break Reason::Observer;
            }
            if let Some(reason) = self.stop(&swarm, &history) {
                break reason;
            }
            swarm.advance(self);
        };
        Run {
            seed: self.seed,
            run,
            best: swarm.best_point().map(|point| Best { value: swarm.best_value(), point: point.to_vec() }),
            evaluations: (self.particles * history.len()) as u64,
            nan_evaluations: swarm.nan_evaluations,
            history,
            reason,
            diameter: swarm.diameter(),
            last_improvement,
        }
    }

    /// Why a run ends here, if it does.
    fn stop(&self, swarm: &Swarm<'_>, history: &[f64]) -> Option<Reason> {
        let iteration = history.len() - 1;
        // In the order of what they tell: the budget, which tells nothing, last.
        let reason = if swarm.best_value() == f64::NEG_INFINITY {
            Reason::Unbounded
        } else if self.stagnation.is_some_and(|s| s.holds(history)) {
            Reason::Stagnation
        } else if self.collapse.is_some_and(|limit| swarm.diameter() <= limit) {
            Reason::Collapse
        } else if iteration == self.iterations {
            Reason::Budget
        } else {
            return None;
        };
        let found = swarm.best_point().is_some();
        Some(if found { reason } else { Reason::NothingFinite })
    }
}

impl Stagnation {
    fn holds(&self, history: &[f64]) -> bool {
        let now = history.len() - 1;
        let Some(then) = now.checked_sub(self.iterations) else {
            return false;
        };
        let (before, after) = (history[then], history[now]);
        // From +∞ to a number every improvement counts.
        before == after || (before.is_finite() && before - after <= self.tolerance * before.abs())
    }
}

fn count(name: &'static str, value: usize, limit: usize) -> Result<(), PsoError> {
    if (1..=limit).contains(&value) { Ok(()) } else { Err(PsoError::Count { name, value, limit }) }
}

fn budget(product: &'static str, first: usize, second: usize, limit: usize) -> Result<(), PsoError> {
    match first.checked_mul(second) {
        Some(value) if value <= limit => Ok(()),
        _ => Err(PsoError::Budget { product, first, second, limit }),
    }
}

fn coefficient(name: &'static str, value: f64, limit: f64) -> Result<(), PsoError> {
    if (0.0..=limit).contains(&value) { Ok(()) } else { Err(PsoError::Coefficient { name, value, limit }) }
}
