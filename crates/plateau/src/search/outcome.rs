//! What a search found.

use optim::Polished;

use crate::SearchEnergy;

/// What a search found.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SearchOutcome {
    /// What was minimised.
    pub energy: SearchEnergy,
    /// The best shape of all runs.
    pub shape: Vec<f64>,
    /// Its value there.
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
pub struct SearchRun {
    /// The seed of the experiment.
    pub seed: u64,
    /// Index of the run; seed and index determine it.
    pub index: usize,
    /// The least energy it found, after the polish if there was one.
    pub value: f64,
    /// Where.
    pub shape: Vec<f64>,
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
    /// Whether it ended because its budget was spent, with nothing known of convergence.
    pub on_budget: bool,
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
