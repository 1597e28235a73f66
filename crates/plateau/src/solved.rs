//! What a method found, and how.

use crate::{AreaExtremal, Energy, Family, SearchOutcome, Surface};

/// The patch a method found, with what is known of the way to it.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The patch.
    pub surface: Surface,
    /// The functions it is made of.
    pub family: Family,
    /// The energy whose extremal the interior is; none for constructions and closed forms.
    pub minimised: Option<Energy>,
    /// The shape parameters, for families that have them: those in u before those in v.
    pub shape: Option<Vec<f64>>,
    /// How the interior was solved for, if it was.
    pub solve: Option<SolveFigures>,
    /// How the least area was reached, if it was asked for.
    pub area: Option<AreaExtremal>,
    /// The search for shape parameters, if there was one.
    pub search: Option<SearchOutcome>,
}

/// What is known of a linear solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveFigures {
    /// Which solver.
    pub solver: &'static str,
    /// Residual as LAPACK's tests scale it: about 1 is rounding, above 30 a failure.
    pub residual: f64,
    /// Estimate of the condition number of the system that was solved.
    pub condition: f64,
    /// For the separable solver: what the control points may lose besides, the surface not (the condition of the two
    /// families of functions).
    pub basis_condition: Option<f64>,
    /// For the dense solver: whether the matrix is proved positive definite
    /// ([`proves_positive_definite`](solve::proves_positive_definite)), so that the net is the only extremal and a minimum.
    pub certified: Option<bool>,
    /// For conjugate gradients: how far, at most, the parts of the extremal reach that no control net in doubles holds and that
    /// were left out; share of the size of the boundary.
    pub left_out: Option<f64>,
    /// For metric corrections: the energy D^g of the last, whose extremal the net is.
    pub metric: Option<energy::Integral>,
}

impl SolveFigures {
    /// Of nets given by a formula: nothing was solved.
    pub(crate) const EXPLICIT: Self = Self {
        solver: "explicit",
        residual: 0.0,
        condition: 1.0,
        basis_condition: None,
        certified: None,
        left_out: None,
        metric: None,
    };

    /// Of the extremal of a form with some points fixed, by a dense factorisation.
    pub(crate) fn dense(
        matrix: &bases::Matrix,
        partition: &solve::Partition,
        solution: &solve::Solution,
    ) -> Result<Self, solve::SolveError> {
        let block = partition.free_block(matrix.as_slice())?;
        Ok(Self {
            solver: "dense",
            residual: solution.residual,
            condition: solution.condition,
            basis_condition: None,
            left_out: None,
            metric: None,
            certified: Some(solve::proves_positive_definite(partition.free().len(), &block)?),
        })
    }
}
