//! How interior control points are found.

use energy::{Functional, ReferenceTriangle};
use surfaces::TriangleMask;

use super::Energy;

/// How the interior of a tensor net is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TensorInterior {
    /// The extremal of a quadratic energy.
    Extremal {
        /// The energy that is minimised.
        energy: Functional,
        /// The linear solver.
        solver: SolverChoice,
    },
    /// Steps of the metric correction after the Dirichlet extremal (TRI §7).
    MetricCorrections {
        /// How many, in 1 … [`MAX_METRIC_STEPS`].
        steps: usize,
        /// The linear solver of the Dirichlet extremal.
        solver: SolverChoice,
    },
    /// The least area.
    LeastArea {
        /// The relative decrease of the area that counts as none, in [`TOLERANCES`](super::TOLERANCES).
        tolerance: f64,
        /// Whether a lower bound is to be proved, for Bernstein polynomials.
        bound: bool,
        /// Layers of smaller patches around corners, for Bernstein polynomials: with any the surface is a complex, as over loops, see
        /// [`Fill::with_layers`](crate::Fill::with_layers).
        layers: usize,
    },
    /// Each interior point a fixed combination of its eight neighbours: corner weight α, edge weight β with 4α + 4β = 1. The Coons mask is
    /// α = −1/4.
    Mask {
        /// The corner weight.
        alpha: f64,
    },
    /// The discrete Coons patch.
    DiscreteCoons,
    /// The net of a harmonic Bézier surface (GT §6, corrected), in no blend and without raising it.
    ///
    /// With [`Boundary::Opposite`](crate::Boundary::Opposite) the two sides determine it; with
    /// [`Boundary::Tensor`](crate::Boundary::Tensor) all four sides are data, which may be in conflict.
    Harmonic,
}

/// How the interior of a triangular net is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriangleInterior {
    /// The extremal of a quadratic energy.
    Extremal {
        /// The energy that is minimised.
        energy: Functional,
        /// The plane triangle over which it is taken.
        domain: ReferenceTriangle,
    },
    /// Steps of the metric correction after the Dirichlet extremal (TRI §7).
    MetricCorrections {
        /// How many, in 1 … [`MAX_METRIC_STEPS`].
        steps: usize,
        /// The plane triangle of the Dirichlet extremal.
        domain: ReferenceTriangle,
    },
    /// The least area.
    LeastArea {
        /// The relative decrease of the area that counts as none, in [`TOLERANCES`](super::TOLERANCES).
        tolerance: f64,
    },
    /// Each interior point a fixed combination of its neighbours.
    Mask(TriangleMask),
    /// The discrete Coons patch; it raises the degree by one (COONS (3)).
    DiscreteCoons,
}

/// Most steps of the metric correction.
pub const MAX_METRIC_STEPS: usize = 1000;

/// A solver of the linear system of an extremal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolverChoice {
    /// Whatever suits the system best.
    #[default]
    Auto,
    /// Dense factorization.
    Dense,
    /// Two small generalized eigenproblems, for Dirichlet extremals of one product of families.
    Separable,
}

impl TensorInterior {
    /// The energy whose extremal the interior is; none for constructions.
    #[must_use]
    pub fn minimised(self) -> Option<Energy> {
        match self {
            Self::Extremal { energy, .. } => Some(Energy::Quadratic(energy)),
            Self::MetricCorrections { .. } => Some(Energy::DIRICHLET),
            Self::LeastArea { .. } => Some(Energy::Area),
            Self::Mask { .. } | Self::DiscreteCoons | Self::Harmonic => None,
        }
    }

    /// The linear solver, where one can be chosen.
    pub(crate) fn solver(self) -> SolverChoice {
        match self {
            Self::Extremal { solver, .. } | Self::MetricCorrections { solver, .. } => solver,
            Self::LeastArea { .. } | Self::Mask { .. } | Self::DiscreteCoons | Self::Harmonic => {
                SolverChoice::Auto
            }
        }
    }
}

impl TriangleInterior {
    /// The energy whose extremal the interior is; none for constructions.
    #[must_use]
    pub fn minimised(self) -> Option<Energy> {
        match self {
            Self::Extremal { energy, .. } => Some(Energy::Quadratic(energy)),
            Self::MetricCorrections { .. } => Some(Energy::DIRICHLET),
            Self::LeastArea { .. } => Some(Energy::Area),
            Self::Mask(_) | Self::DiscreteCoons => None,
        }
    }
}
