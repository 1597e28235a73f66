use faer::dyn_stack::mem::AllocError;
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::evd::EvdError;
use faer::linalg::svd::SvdError;
use faer::sparse::linalg::LuError;
use faer::sparse::{CreationError, FaerError};
use thiserror::Error;

/// The array of a linear system in which a number was found that is neither finite nor usable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The matrix of the system, or a table or sample it is made of.
    Matrix,
    /// The right-hand side, or the fixed values it is made of.
    RightHandSide,
    /// The answer: the data are finite, the solution overflows.
    Solution,
    /// The parameters at which a parametric system was evaluated.
    Parameters,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Matrix => "matrix",
            Self::RightHandSide => "right-hand side",
            Self::Solution => "solution",
            Self::Parameters => "parameters",
        })
    }
}

/// Why a linear system has no answer that could be trusted.
///
/// Indices count from 0. Lack of memory is never reported as a property of the matrix.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SolveError {
    /// A Cholesky factorisation met a pivot that is not positive, or succeeded with a condition beyond
    /// 1/(n ε), where its success proves nothing.
    #[error(
        "the matrix of order {order} is not positive definite to working precision ({}): \
         fix more unknowns, check that no function of the basis depends on the others, lower the degree, or use the separable solver where it is offered",
        Cause { pivot: *.pivot, condition: *.condition }
    )]
    NotPositiveDefinite {
        /// Order of the matrix.
        order: usize,
        /// Index of the pivot that was not positive; `None` if the factorisation went through.
        pivot: Option<usize>,
        /// Estimate of the condition number, where one is known.
        condition: Option<f64>,
    },
    /// The matrix has no inverse to working precision.
    #[error(
        "the matrix of order {order} is singular to working precision (reciprocal condition {reciprocal_condition:.2e}): \
         the conditions depend on each other, so add or change some of them"
    )]
    Singular {
        /// Order of the matrix.
        order: usize,
        /// Estimate of 1/(‖A‖₁‖A⁻¹‖₁); exactly 0 if a pivot vanished.
        reciprocal_condition: f64,
    },
    /// A matrix promised to be symmetric is not.
    #[error(
        "the matrix is not symmetric: entries ({row}, {column}) and ({column}, {row}) differ by {difference:e}"
    )]
    NotSymmetric {
        /// Row of the entry with the largest difference.
        row: usize,
        /// Column of that entry.
        column: usize,
        /// The difference of the two entries.
        difference: f64,
    },
    /// A number is NaN or infinite.
    #[error("the {place} holds a number that is not finite in row {row}, column {column}")]
    NotFinite {
        /// Where it stands.
        place: Place,
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// An array has the wrong length, or an index does not fit.
    #[error("{what}: expected {expected}, found {found}")]
    WrongShape {
        /// What was measured.
        what: &'static str,
        /// What it should have been.
        expected: usize,
        /// What it was.
        found: usize,
    },
    /// An index points outside of its array, or comes twice, or out of order.
    #[error("{what}: index {index} must be below {bound} and above its predecessor")]
    WrongIndex {
        /// Which list of indices.
        what: &'static str,
        /// The offending index.
        index: usize,
        /// The bound it has to stay below.
        bound: usize,
    },
    /// A system was factored, but its solution does not satisfy it: the ratio that LAPACK's tests call a failure.
    #[error(
        "the solution of the linear system of order {order} misses it by a scaled residual of {ratio:.3e}, above 30 \
         (LAPACK's threshold of failure): rounding grew in the factorisation, so the numbers would be wrong; lower the \
         degree or choose another solver"
    )]
    Residual {
        /// Order of the matrix.
        order: usize,
        /// `‖b − A x‖ / (‖A‖ ‖x‖ n ε)`; not finite where the solution is zero and should not be.
        ratio: f64,
    },
    /// A weight of a quadrature rule is not positive.
    #[error(
        "weight {index} of the quadrature rule is not positive; take a rule with positive weights (Gauss)"
    )]
    NotPositiveWeight {
        /// Its index.
        index: usize,
    },
    /// The memory for the system could not be had.
    #[error("out of memory: {bytes} bytes could not be allocated; solve a smaller system or free memory")]
    OutOfMemory {
        /// Size of the request, at least.
        bytes: usize,
    },
    /// The system is larger than this crate is willing to try.
    #[error("{what} is {found}, the limit is {limit}")]
    TooLarge {
        /// What is too large.
        what: &'static str,
        /// Its value.
        found: usize,
        /// The largest value accepted.
        limit: usize,
    },
    /// The processor cannot take the arithmetic path that was asked for.
    #[error("this processor has no {path} path; use Path::detect()")]
    PathUnavailable {
        /// The path.
        path: crate::Path,
    },
    /// An iteration for singular values or eigenvalues did not converge.
    #[error("the iteration for the {what} of a matrix of order {order} did not converge")]
    NoConvergence {
        /// Singular values or eigenvalues.
        what: &'static str,
        /// Order of the matrix.
        order: usize,
    },
}

struct Cause {
    pivot: Option<usize>,
    condition: Option<f64>,
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.pivot, self.condition) {
            (Some(pivot), Some(condition)) => {
                write!(f, "pivot {pivot} is not positive, condition about {condition:.1e}")
            }
            (Some(pivot), None) => write!(f, "pivot {pivot} is not positive"),
            (None, Some(condition)) => write!(f, "condition about {condition:.1e}"),
            (None, None) => write!(f, "no condition estimate"),
        }
    }
}

// faer's errors do not know the order of the matrix or the size of the request; the caller does.

pub(crate) fn from_llt(error: LltError, order: usize) -> SolveError {
    match error {
        LltError::NonPositivePivot { index } => {
            SolveError::NotPositiveDefinite { order, pivot: Some(index), condition: None }
        }
    }
}

pub(crate) fn from_svd(error: SvdError, order: usize) -> SolveError {
    match error {
        SvdError::NoConvergence => SolveError::NoConvergence { what: "singular values", order },
    }
}

pub(crate) fn from_evd(error: EvdError, order: usize) -> SolveError {
    match error {
        EvdError::NoConvergence => SolveError::NoConvergence { what: "eigenvalues", order },
    }
}

#[expect(clippy::wildcard_enum_match_arm, reason = "faer's enum is non-exhaustive")]
pub(crate) fn from_faer(error: FaerError, bytes: usize) -> SolveError {
    match error {
        FaerError::IndexOverflow => SolveError::TooLarge {
            what: "number of entries of the factor",
            found: usize::MAX,
            limit: isize::MAX as usize,
        },
        // Today its only other member is OutOfMemory.
        _ => SolveError::OutOfMemory { bytes },
    }
}

pub(crate) fn from_creation(error: CreationError, order: usize, bytes: usize) -> SolveError {
    match error {
        CreationError::Generic(error) => from_faer(error, bytes),
        CreationError::OutOfBounds { row, col } => {
            SolveError::WrongIndex { what: "entry of the sparse matrix", index: row.max(col), bound: order }
        }
    }
}

pub(crate) fn from_sparse_lu(error: LuError, order: usize, bytes: usize) -> SolveError {
    match error {
        LuError::SymbolicSingular { .. } => SolveError::Singular { order, reciprocal_condition: 0.0 },
        LuError::Generic(error) => from_faer(error, bytes),
    }
}

pub(crate) fn from_alloc(_: AllocError, bytes: usize) -> SolveError {
    SolveError::OutOfMemory { bytes }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lack_of_memory_is_never_a_property_of_the_matrix() {
        let memory = SolveError::OutOfMemory { bytes: 640 };
        assert_eq!(from_faer(FaerError::OutOfMemory, 640), memory);
        assert_eq!(from_creation(CreationError::Generic(FaerError::OutOfMemory), 8, 640), memory);
        assert_eq!(from_sparse_lu(LuError::Generic(FaerError::OutOfMemory), 8, 640), memory);
        assert_eq!(from_alloc(AllocError, 640), memory);
        assert!(memory.to_string().starts_with("out of memory: 640 bytes"));
    }

    #[test]
    fn a_singular_matrix_is_never_lack_of_memory() {
        assert_eq!(
            from_sparse_lu(LuError::SymbolicSingular { index: 3 }, 8, 640),
            SolveError::Singular { order: 8, reciprocal_condition: 0.0 }
        );
        let pivot = from_llt(LltError::NonPositivePivot { index: 3 }, 8);
        assert_eq!(pivot, SolveError::NotPositiveDefinite { order: 8, pivot: Some(3), condition: None });
        assert!(matches!(from_faer(FaerError::IndexOverflow, 640), SolveError::TooLarge { .. }));
        let outside = from_creation(CreationError::OutOfBounds { row: 9, col: 2 }, 8, 640);
        assert!(matches!(outside, SolveError::WrongIndex { index: 9, bound: 8, .. }));
        assert!(
            from_svd(SvdError::NoConvergence, 8)
                .to_string()
                .contains("singular values of a matrix of order 8")
        );
        assert!(from_evd(EvdError::NoConvergence, 8).to_string().contains("eigenvalues"));
    }

    #[test]
    fn indefinite_matrices_are_told_with_all_that_is_known() {
        for (pivot, condition, said) in [
            (Some(4), Some(2e17), "pivot 4 is not positive, condition about 2.0e17"),
            (Some(4), None, "pivot 4 is not positive)"),
            (None, Some(2e17), "(condition about 2.0e17)"),
            (None, None, "no condition estimate"),
        ] {
            let text = SolveError::NotPositiveDefinite { order: 9, pivot, condition }.to_string();
            assert!(text.contains(said) && text.contains("order 9"), "{text}");
        }
    }

    #[test]
    fn places_are_named() {
        let text = |place| SolveError::NotFinite { place, row: 1, column: 2 }.to_string();
        let named = [Place::Matrix, Place::RightHandSide, Place::Solution, Place::Parameters].map(text);
        for (text, name) in named.iter().zip(["matrix", "right-hand side", "solution", "parameters"]) {
            assert_eq!(text, &format!("the {name} holds a number that is not finite in row 1, column 2"));
        }
    }
}
