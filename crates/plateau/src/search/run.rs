//! One run of a search.

use optim::{Best, PolishReason, Polished, Reason};

/// One run of a search: a swarm, a descent, or a swarm and then a descent from the best that it found.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchRun {
    seed: u64,
    index: usize,
    end: End,
}

/// What the swarm of a run did.
#[derive(Debug, Clone, PartialEq)]
pub struct Swarm {
    /// Why it ended.
    pub reason: Reason,
    /// Evaluations of the reduced energy.
    pub evaluations: u64,
    /// How many of them failed.
    pub nan_evaluations: u64,
    /// The best energy after its initialisation and after each iteration.
    pub history: Vec<f64>,
}

/// What a run ended with.
#[derive(Debug, Clone, PartialEq)]
enum End {
    Swarm { swarm: Swarm, best: Best },
    Descent { swarm: Option<Swarm>, polished: Polished },
}

impl SearchRun {
    /// The run of a number under a seed that ended with the best of a swarm.
    #[must_use]
    pub fn of_swarm((seed, index): (u64, usize), swarm: Swarm, best: Best) -> Self {
        Self { seed, index, end: End::Swarm { swarm, best } }
    }

    /// The run of a number under a seed that ended with a descent, from the best of a swarm if there was one.
    #[must_use]
    pub fn of_descent((seed, index): (u64, usize), swarm: Option<Swarm>, polished: Polished) -> Self {
        Self { seed, index, end: End::Descent { swarm, polished } }
    }

    /// The run where its swarm is followed by a descent.
    pub(crate) fn followed_by(self, polished: Polished) -> Self {
        let swarm = match self.end {
            End::Swarm { swarm, .. } => Some(swarm),
            End::Descent { swarm, .. } => swarm,
        };
        Self::of_descent((self.seed, self.index), swarm, polished)
    }

    /// The seed of the experiment.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Index of the run; seed and index determine it.
    #[must_use]
    pub fn index(&self) -> usize {
        self.index
    }

    /// The least energy it found, after the descent if there was one.
    #[must_use]
    pub fn value(&self) -> f64 {
        match &self.end {
            End::Swarm { best, .. } => best.value,
            End::Descent { polished, .. } => polished.value,
        }
    }

    /// Where.
    #[must_use]
    pub fn shape(&self) -> &[f64] {
        match &self.end {
            End::Swarm { best, .. } => &best.point,
            End::Descent { polished, .. } => &polished.point,
        }
    }

    /// What its swarm did, if it had one.
    #[must_use]
    pub fn swarm(&self) -> Option<&Swarm> {
        match &self.end {
            End::Swarm { swarm, .. } => Some(swarm),
            End::Descent { swarm, .. } => swarm.as_ref(),
        }
    }

    /// The descent from the swarm's best point or from a start, if it had one.
    #[must_use]
    pub fn polish(&self) -> Option<&Polished> {
        match &self.end {
            End::Swarm { .. } => None,
            End::Descent { polished, .. } => Some(polished),
        }
    }

    /// Why its swarm ended; where it had none, why its descent did.
    #[must_use]
    pub fn reason(&self) -> String {
        match &self.end {
            End::Swarm { swarm, .. } | End::Descent { swarm: Some(swarm), .. } => swarm.reason.to_string(),
            End::Descent { swarm: None, polished } => polished.reason.to_string(),
        }
    }

    /// Evaluations of the reduced energy.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        let by_descent = self.polish().map_or(0, |polished| polished.evaluations as u64);
        self.swarm().map_or(0, |swarm| swarm.evaluations) + by_descent
    }

    /// How many of them failed.
    #[must_use]
    pub fn nan_evaluations(&self) -> u64 {
        self.swarm().map_or(0, |swarm| swarm.nan_evaluations)
    }

    /// The best energy of the swarm after its initialisation and after each iteration; empty of a descent alone.
    #[must_use]
    pub fn history(&self) -> &[f64] {
        self.swarm().map_or(&[], |swarm| &swarm.history)
    }

    /// Whether it ended because its budget was spent, with nothing known of convergence.
    #[must_use]
    pub fn on_budget(&self) -> bool {
        match &self.end {
            End::Swarm { swarm, .. } => swarm.reason == Reason::Budget,
            End::Descent { polished, .. } => polished.reason == PolishReason::Budget,
        }
    }

    /// Whether a polish showed the run's end to be a stationary point of the box, or as near as rounding allows.
    #[must_use]
    pub fn is_stationary(&self) -> bool {
        self.polish().is_some_and(|p| matches!(p.reason, PolishReason::Stationary | PolishReason::Flat))
    }
}
