use thiserror::Error;

use crate::{Degeneracy, Warning};

/// What a reader must know about results as a whole; shown as one sentence.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Remark {
    /// About the boundary, or about the only curve.
    #[error(transparent)]
    Whole(#[from] Warning),
    /// About one of several curves.
    #[error("{curve}: {warning}")]
    Curve {
        /// Its basis in words.
        curve: String,
        /// What is to be known of it.
        warning: Warning,
    },
    /// Curves were asked for in formats of surfaces.
    #[error("a curve has no mesh: nothing is written as {}", formats.join(", "))]
    NoMesh {
        /// The names of the formats.
        formats: Vec<&'static str>,
    },
    /// A sentence that was kept with surfaces, of results that were written earlier.
    #[error("{0}")]
    Kept(String),
}

impl From<Degeneracy> for Remark {
    fn from(degeneracy: Degeneracy) -> Self {
        Self::Whole(Warning::Degenerate(degeneracy))
    }
}
