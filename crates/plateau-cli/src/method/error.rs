use thiserror::Error;

/// Why a method found no patch.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MethodError {
    /// The linear system of the interior.
    #[error("the interior control points cannot be solved for: {0}")]
    Solve(#[from] solve::SolveError),
    /// The control net or the families on it.
    #[error(transparent)]
    Surface(#[from] surfaces::SurfaceError),
    /// The energy.
    #[error(transparent)]
    Energy(#[from] energy::EnergyError),
    /// A basis.
    #[error(transparent)]
    Basis(#[from] bases::BasisError),
    /// The parameters of the swarm.
    #[error("the search cannot begin: {0}")]
    Swarm(#[from] optim::PsoError),
    /// The parameters of the polish.
    #[error("the polish cannot begin: {0}")]
    Polish(#[from] optim::PolishError),
    /// The search box.
    #[error("the search box is not sound: {0}")]
    Bounds(#[from] optim::BoundsError),
    /// No shape in the box has a finite energy.
    #[error("no shape in the search box gives a finite energy: {evaluations} evaluations all failed")]
    NothingFound {
        /// Evaluations made.
        evaluations: u64,
    },
    /// The user ended the work before this method had a result.
    #[error("interrupted before it had a result")]
    Interrupted,
    /// Not offered by this version.
    #[error("{what} is not available in this version")]
    Unavailable {
        /// What was asked for.
        what: &'static str,
    },
}
