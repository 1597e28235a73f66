use energy::{EnergyError, Unproved};
use solve::SolveError;
use surfaces::{ComplexError, SurfaceError};
use thiserror::Error;

/// Why no bound was proved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NoBound {
    /// Three faces meet at an edge.
    #[error("three and more faces meet at an edge: such films are no graph over a plane")]
    FilmsMeet,
    /// The surface is no graph.
    #[error("the surface is no graph over any plane that was tried")]
    NoGraph,
    /// More coefficients than are solved for.
    #[error("the bound needs {unknowns} coefficients, more than {max}; lower the degree")]
    TooLarge {
        /// Coefficients needed.
        unknowns: usize,
        /// Most that are offered.
        max: usize,
    },
    /// A potential was found, but the signs that make it a proof could not be shown.
    #[error("a bound was found but not proved: {0}; another degree may have one")]
    Unproved(#[from] Unproved),
    /// The integrals could not be made.
    #[error(transparent)]
    Energy(#[from] EnergyError),
    /// The system of the potential is singular to working precision.
    #[error(
        "its potential of degree {degree} cannot be told to working precision: take a lower degree, or no layers"
    )]
    Singular {
        /// The degree of the potential.
        degree: usize,
    },
    /// The systems could not be solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// A net that is no face of a complex.
    #[error(transparent)]
    Net(#[from] SurfaceError),
}

impl From<ComplexError> for NoBound {
    fn from(error: ComplexError) -> Self {
        Self::Energy(error.into())
    }
}
