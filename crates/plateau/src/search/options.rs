//! How shape parameters are searched.

use surfaces::ShapedFamily;
use thiserror::Error;

/// Largest `particles × iterations × runs` of a search.
pub const MAX_SEARCH_BUDGET: u64 = 1_000_000_000;

/// How shape parameters are searched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchMode {
    /// Particle swarm only, as in the paper.
    Pso,
    /// Descent with the gradient only, from `runs` starts.
    Polish,
    /// Particle swarm, then descent from each run's best point.
    PsoPolish,
}

/// The search for shape parameters: a particle swarm in a box (GT §5).
///
/// ```
/// use plateau::Search;
/// let search = Search::default().with_swarm(20, 50, 4)?.with_box(0.0, 4.0)?;
/// assert_eq!((search.particles(), search.bounds()), (20, [0.0, 4.0]));
/// assert!(search.with_box(2.0, 1.0).is_err());
/// # Ok::<(), plateau::SearchFault>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    variant: Variant,
    particles: usize,
    iterations: usize,
    runs: usize,
    weights: [f64; 3],
    bounds: [f64; 2],
}

impl Default for Search {
    /// The values of GT §5: a global swarm of 50, 100 iterations, 10 runs, w = 0.7, c1 = c2 = 1.5,
    /// box [0.5, 3.5].
    fn default() -> Self {
        Self {
            variant: Variant::Global,
            particles: 50,
            iterations: 100,
            runs: 10,
            weights: [0.7, 1.5, 1.5],
            bounds: [0.5, 3.5],
        }
    }
}

/// What no search has.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SearchFault {
    /// A count that is not offered.
    #[error("{name} = {count} is not offered by searches: 1 to {most} are")]
    Count {
        /// What is counted.
        name: &'static str,
        /// How many were asked for.
        count: usize,
        /// The most there may be.
        most: usize,
    },
    /// More evaluations than a search makes.
    #[error("{0} evaluations are more than the {MAX_SEARCH_BUDGET} that a search may make")]
    Budget(u64),
    /// A weight that is not offered.
    #[error("{name} = {value} is not offered by searches: it lies between 0 and {most}")]
    Weight {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Its greatest value.
        most: f64,
    },
    /// A box that holds no shape.
    #[error(
        "the box of a search lies within [{least}, {most}], its lower end below its upper: [{0}, {1}] does not",
        least = ShapedFamily::WIDEST_RANGE.0,
        most = ShapedFamily::WIDEST_RANGE.1
    )]
    Box(f64, f64),
}

impl Search {
    /// Most iterations of a run.
    pub const MOST_ITERATIONS: usize = 1_000_000;

    /// Most runs of a search.
    pub const MOST_RUNS: usize = 10_000;

    /// So many particles, iterations of a run, and independent runs, or starts of a polish.
    ///
    /// # Errors
    /// [`SearchFault::Count`] unless there are 1 to [`optim::MAX_PARTICLES`], [`Self::MOST_ITERATIONS`] and [`Self::MOST_RUNS`] of them,
    /// [`SearchFault::Budget`] if their product exceeds [`MAX_SEARCH_BUDGET`].
    pub fn with_swarm(self, particles: usize, iterations: usize, runs: usize) -> Result<Self, SearchFault> {
        let counts = [
            ("particles", particles, optim::MAX_PARTICLES),
            ("iterations", iterations, Self::MOST_ITERATIONS),
            ("runs", runs, Self::MOST_RUNS),
        ];
        if let Some((name, count, most)) =
            counts.into_iter().find(|(_, count, most)| !(1..=*most).contains(count))
        {
            return Err(SearchFault::Count { name, count, most });
        }
        let found = Self { particles, iterations, runs, ..self };
        match found.budget() {
            budget if budget > MAX_SEARCH_BUDGET => Err(SearchFault::Budget(budget)),
            _ => Ok(found),
        }
    }

    /// Particles are moved by their inertia w, in [0, 1], the social coefficient c1 and the cognitive c2, both in [0, 10].
    ///
    /// # Errors
    /// [`SearchFault::Weight`].
    pub fn with_weights(self, inertia: f64, social: f64, cognitive: f64) -> Result<Self, SearchFault> {
        let weights = [("inertia", inertia, 1.0), ("social", social, 10.0), ("cognitive", cognitive, 10.0)];
        match weights.into_iter().find(|(_, value, most)| !(0.0..=*most).contains(value)) {
            Some((name, value, most)) => Err(SearchFault::Weight { name, value, most }),
            None => Ok(Self { weights: [inertia, social, cognitive], ..self }),
        }
    }

    /// Every parameter lies between `lower` and `upper`.
    ///
    /// # Errors
    /// [`SearchFault::Box`] unless `lower` < `upper`, both within [`ShapedFamily::WIDEST_RANGE`].
    pub fn with_box(self, lower: f64, upper: f64) -> Result<Self, SearchFault> {
        let (least, most) = ShapedFamily::WIDEST_RANGE;
        if !(least <= lower && lower < upper && upper <= most) {
            return Err(SearchFault::Box(lower, upper));
        }
        Ok(Self { bounds: [lower, upper], ..self })
    }

    /// Particles are informed by these.
    ///
    /// # Errors
    /// [`SearchFault::Count`] for no neighbours.
    pub fn with_variant(self, variant: Variant) -> Result<Self, SearchFault> {
        if variant == (Variant::Local { neighbours: 0 }) {
            return Err(SearchFault::Count { name: "neighbours", count: 0, most: optim::MAX_PARTICLES });
        }
        Ok(Self { variant, ..self })
    }

    /// Who informs a particle.
    #[must_use]
    pub fn variant(&self) -> Variant {
        self.variant
    }

    /// Particles of a swarm.
    #[must_use]
    pub fn particles(&self) -> usize {
        self.particles
    }

    /// Iterations of a run.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// Independent runs, or starts of a polish.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs
    }

    /// Inertia, social and cognitive coefficient.
    #[must_use]
    pub fn weights(&self) -> [f64; 3] {
        self.weights
    }

    /// The ends of the box in every parameter.
    #[must_use]
    pub fn bounds(&self) -> [f64; 2] {
        self.bounds
    }

    /// Evaluations of a swarm in all runs.
    fn budget(&self) -> u64 {
        [self.particles, self.iterations, self.runs]
            .iter()
            .fold(1u64, |product, &count| product.saturating_mul(count as u64))
    }
}

/// Who informs a particle of a swarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// Every particle.
    Global,
    /// The ring neighbours.
    Local {
        /// Neighbours on each side, ≥ 1.
        neighbours: usize,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_search_has_is_refused() {
        let search = Search::default();
        assert!(matches!(search.with_swarm(0, 1, 1), Err(SearchFault::Count { name: "particles", .. })));
        assert!(matches!(search.with_swarm(10_000, 1_000_000, 10_000), Err(SearchFault::Budget(_))));
        assert!(matches!(
            search.with_weights(0.7, 11.0, 1.5),
            Err(SearchFault::Weight { name: "social", .. })
        ));
        assert!(search.with_weights(f64::NAN, 1.0, 1.0).is_err());
        assert!(search.with_box(0.0, 4.1).is_err() && search.with_box(f64::NAN, 1.0).is_err());
        assert!(search.with_variant(Variant::Local { neighbours: 0 }).is_err());
    }
}
