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
    /// The Coons mask determines no net at even degrees from 6.
    #[error(
        "the Coons mask is exactly singular at every even degree from 6, and this net has degree {degree}: some nets that \
         vanish on the border satisfy it too. Use an odd degree (raise = 1), construction = \"discrete-coons\", or \
         energy = \"coons\""
    )]
    SingularMask {
        /// Degree of the net.
        degree: usize,
    },
    /// Harmonic nets are offered up to a degree only.
    #[error("a harmonic net of degree {degree} is beyond the largest offered, {max}")]
    HarmonicDegree {
        /// The larger of the two degrees.
        degree: usize,
        /// The largest offered.
        max: usize,
    },
    /// The sides given do not determine the harmonic net.
    #[error(
        "the sides given leave {missing} degrees of freedom of a harmonic net of degree ({m}, {n}): give the other two \
         sides as well, or choose equal odd degrees"
    )]
    HarmonicMissing {
        /// Degree in u.
        m: usize,
        /// Degree in v.
        n: usize,
        /// Dimension of the harmonic nets that fit, for each coordinate.
        missing: usize,
    },
    /// No harmonic net has the sides given.
    #[error(
        "no harmonic net of degree ({m}, {n}) has the sides given: the relations impose {conditions} conditions on them \
         and they fail by {misfit:.1e}; give two opposite sides only, of equal odd degrees, or sides taken from a \
         harmonic surface"
    )]
    HarmonicConflict {
        /// Degree in u.
        m: usize,
        /// Degree in v.
        n: usize,
        /// How many linear conditions the sides must satisfy, for each coordinate.
        conditions: usize,
        /// The largest relative misfit.
        misfit: f64,
    },
    /// Derivatives of a curve are not finite.
    #[error(
        "the derivatives of the curve near t = {t} are beyond double precision: scale its points or its span"
    )]
    Overflow {
        /// The parameter.
        t: f64,
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
