use thiserror::Error;

use crate::{Sentence, Setting};

/// Why curves make no boundary.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// A number of the options.
    #[error("{name} = {value:?}: {expected}")]
    Option {
        /// The option.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What may be given.
        expected: &'static str,
    },
    /// All points of all curves are one point.
    #[error("the curves have no size: all their points are the same")]
    NoSize,
    /// The box around all curves is too small.
    #[error(
        "the curves have no size: their points are too near each other, {extent:e} apart, and below {:e} areas leave the range of double \
         precision: choose a smaller unit of length",
        plateau::MIN_SIZE
    )]
    TooNear {
        /// The longest side of the box (a length).
        extent: f64,
    },
    /// The box around all curves is too large.
    #[error(
        "the points of the curves are too far from each other, {extent:e}, and areas of that leave the range of double precision: \
         choose a larger unit of length"
    )]
    TooFarApart {
        /// The longest side of the box (a length).
        extent: f64,
    },
    /// Points so far from the origin that their coordinates cannot tell them apart.
    #[error(
        "the curves lie {distance:.3e} from the origin, where neighbouring numbers of double precision are {step:.3e} apart: their points \
         have been rounded onto one another or onto one straight line; move them near the origin before they are written"
    )]
    Far {
        /// The distance of the first of them from the origin (a length).
        distance: f64,
        /// How far apart neighbouring numbers are there (a length).
        step: f64,
    },
    /// All points on one line.
    #[error(
        "all points of the curves lie on one straight line, and a surface needs an area: is a side missing, or a coordinate?"
    )]
    Line,
    /// Ends of curves that meet nothing.
    #[error("{0}")]
    Gap(Sentence),
    /// More than can be understood without being told.
    #[error("{0}")]
    Ambiguous(String),
    /// Too much work.
    #[error("{0}")]
    TooMany(Sentence),
}

impl AssemblyError {
    /// What is wrong, with settings spelled like this.
    #[must_use]
    pub fn told(&self, spelled: &dyn Fn(Setting, Option<&str>) -> String) -> String {
        match self {
            Self::Gap(sentence) | Self::TooMany(sentence) => sentence.told(spelled),
            Self::Option { .. }
            | Self::NoSize
            | Self::TooNear { .. }
            | Self::TooFarApart { .. }
            | Self::Far { .. }
            | Self::Line
            | Self::Ambiguous(_) => self.to_string(),
        }
    }
}
