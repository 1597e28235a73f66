//! How shape parameters are searched.

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Who informs a particle.
    pub variant: Variant,
    /// Particles of a swarm, in 1..=[`optim::MAX_PARTICLES`].
    pub particles: usize,
    /// Iterations of a run, in 1..=1 000 000.
    pub iterations: usize,
    /// Independent runs, or starts of a polish, in 1..=10 000;
    /// `particles × iterations × runs` ≤ [`MAX_SEARCH_BUDGET`].
    pub runs: usize,
    /// Inertia w, in [0, 1].
    pub inertia: f64,
    /// Social coefficient c1, in [0, 10].
    pub social: f64,
    /// Cognitive coefficient c2, in [0, 10].
    pub cognitive: f64,
    /// Lower end of the box in every parameter, ≥ 0.
    pub lower: f64,
    /// Upper end of the box in every parameter, > lower and ≤ 4.
    pub upper: f64,
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
            inertia: 0.7,
            social: 1.5,
            cognitive: 1.5,
            lower: 0.5,
            upper: 3.5,
        }
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
