//! What cannot be a method.

use std::ops::RangeInclusive;

use thiserror::Error;

use super::interior::MAX_METRIC_STEPS;
use crate::MAX_DEGREE;

/// The relative decreases of an area that may count as none.
pub const TOLERANCES: RangeInclusive<f64> = 1e-12..=1e-2;

/// Why functions and an interior make no method.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MethodFault {
    /// A row of the table needs a name.
    #[error("the name of a method is empty: its row of the table is labelled by it")]
    NoName,
    /// The tolerance of a least area.
    #[error(
        "the tolerance {found:?} of a least area is not in [{}, {}]", TOLERANCES.start(), TOLERANCES.end()
    )]
    Tolerance {
        /// The number given.
        found: f64,
    },
    /// The number of metric corrections.
    #[error("{0} steps of the metric correction: from 1 to {MAX_METRIC_STEPS} are possible")]
    MetricSteps(usize),
    /// The corner weight of a mask.
    #[error("the corner weight {0} of a mask is not finite")]
    MaskWeight(f64),
    /// A lower bound of a family that has none.
    #[error(
        "lower bounds are proved only for least areas in the Bernstein basis, and this method uses another"
    )]
    Bound,
    /// Layers of patches in a family whose functions do not make several.
    #[error("layers of smaller patches are made only in the Bernstein basis, and this method uses another")]
    Layers,
    /// The separable solver where nothing separates.
    #[error(
        "the separable solver serves Dirichlet extremals of one product of families: this system does not separate"
    )]
    NotSeparable,
    /// A harmonic net in a blend.
    #[error(
        "a harmonic net is a tensor net of Bernstein polynomials, which may be read in another basis, not in a blend"
    )]
    HarmonicBlend,
    /// A harmonic net that is raised.
    #[error("the degrees of a harmonic net are those of its boundary: it is not raised")]
    HarmonicRaised,
    /// A degree that is not offered.
    #[error("raised by {0}: degrees end at {MAX_DEGREE}")]
    Raised(usize),
}
