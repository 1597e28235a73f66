//! Linear systems with some unknowns fixed.
//!
//! An energy of a coefficient array `X` (`N × 3`: three right-hand columns x, y, z) is `Σ_d X_dᵀ Q X_d` with
//! `Q` symmetric. With some unknowns fixed its extremal is
//!
//! ```text
//! Q_ff p = −Q_fb P_b,      J = c − Σ_d b_dᵀ Q_ff⁻¹ b_d,      b = Q_fb P_b,   c = Σ_d P_bᵀ Q_bb P_b.
//! ```

mod check;
mod condition;
mod dense;
mod error;
mod memory;
mod parametric;
mod partition;
mod scale;
mod separable;
mod sparse;
mod system;

pub use dense::{
    Cholesky, Lu, RankSolution, SymmetricEigen, eigen_symmetric, smallest_eigenvalue, solve_general,
    solve_partitioned, solve_rank, solve_spd,
};
pub use error::{Place, SolveError};
pub use parametric::{Parametric, ParametricProblem, ParametricSolution, Path, PolynomialMatrix, Term};
pub use partition::Partition;
pub use separable::{AffineSamples, Samples, Separable, SeparableParametric, SeparableSolution};
pub use sparse::{SparseCholesky, SparseLu, Triplet, solve_sparse, solve_sparse_spd};
pub use system::Solution;
