//! What a search found.

use super::SearchRun;
use crate::SearchEnergy;

/// What a search found: its runs, of which one is the best.
#[derive(Debug, Clone)]
pub struct SearchOutcome {
    energy: SearchEnergy,
    engine: &'static str,
    arithmetic: &'static str,
    runs: Vec<SearchRun>,
    /// The first of the least value.
    best: usize,
}

impl SearchOutcome {
    /// The outcome of `runs`, in order; none if no run found a finite value.
    pub(crate) fn of(
        energy: SearchEnergy,
        [engine, arithmetic]: [&'static str; 2],
        runs: Vec<SearchRun>,
    ) -> Option<Self> {
        let less = |best: usize, k: usize| if runs[k].value() < runs[best].value() { k } else { best };
        let best = (0..runs.len()).reduce(less)?;
        runs[best].value().is_finite().then_some(Self { energy, engine, arithmetic, runs, best })
    }

    /// What was minimised.
    #[must_use]
    pub fn energy(&self) -> SearchEnergy {
        self.energy
    }

    /// The best shape of all runs.
    #[must_use]
    pub fn shape(&self) -> &[f64] {
        self.runs[self.best].shape()
    }

    /// Its value there.
    #[must_use]
    pub fn minimum(&self) -> f64 {
        self.runs[self.best].value()
    }

    /// Evaluations of the reduced energy, those of the polish included.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.runs.iter().map(SearchRun::evaluations).sum()
    }

    /// How many of them failed.
    #[must_use]
    pub fn nan_evaluations(&self) -> u64 {
        self.runs.iter().map(SearchRun::nan_evaluations).sum()
    }

    /// How it was evaluated: `parametric` from polynomials of the shape, `separable` from samples.
    #[must_use]
    pub fn engine(&self) -> &'static str {
        self.engine
    }

    /// Which arithmetic evaluated it: results repeat bit for bit on the same one only.
    #[must_use]
    pub fn arithmetic(&self) -> &'static str {
        self.arithmetic
    }

    /// Every run, in order.
    #[must_use]
    pub fn runs(&self) -> &[SearchRun] {
        &self.runs
    }

    /// The difference between the worst and the best run.
    #[must_use]
    pub fn spread(&self) -> f64 {
        self.runs.iter().map(|run| run.value() - self.minimum()).fold(0.0, f64::max)
    }
}
