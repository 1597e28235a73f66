use thiserror::Error;

/// Why no curves could be read from a file.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveFileError {
    /// Larger than what is read.
    #[error("is larger than {most} MiB, the most that is read")]
    TooLarge {
        /// The limit.
        most: usize,
    },
    /// A file of another kind.
    #[error("is {what}: {advice}")]
    OtherKind {
        /// What it is.
        what: String,
        /// What to do.
        advice: String,
    },
    /// A line that is not understood.
    #[error("line {line}: {why}")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What is wrong with it, what was expected.
        why: String,
    },
    /// The file as a whole.
    #[error("{0}")]
    File(String),
}

impl CurveFileError {
    pub(super) fn at(line: usize, why: impl Into<String>) -> Self {
        Self::Line { line, why: why.into() }
    }
}
