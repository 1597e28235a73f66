use thiserror::Error;

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
    Gap(String),
    /// More than can be understood without being told.
    #[error("{0}")]
    Ambiguous(String),
    /// Too much work.
    #[error("{0}")]
    TooMany(String),
}
