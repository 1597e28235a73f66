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
    /// All points of all curves are one point, or their box is too large for a number.
    #[error("the curves have no size: all their points are the same, or too far apart")]
    NoSize,
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
            Self::Option { .. } | Self::NoSize | Self::Line | Self::Ambiguous(_) => self.to_string(),
        }
    }
}
