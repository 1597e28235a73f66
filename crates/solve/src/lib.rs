//! Linear systems with some unknowns fixed.
//!
//! An energy of a coefficient array `X` (`N × 3`: the columns are x, y, z) is `Σ_d X_dᵀ Q X_d` with `Q` symmetric. With
//! some unknowns fixed its extremal and its minimum are
//!
//! ```text
//! Q_ff p = −Q_fb P_b,      J = c − Σ_d b_dᵀ Q_ff⁻¹ b_d,      b = Q_fb P_b,      c = Σ_d P_bᵀ Q_bb P_b.
//! ```
//!
//! | for | take | cost, n × n net |
//! |---|---|---|
//! | any matrix, all entries | [`solve_spd`], [`solve_general`], [`solve_partitioned`]; [`Cholesky`], [`Lu`] keep the factor | O(n⁶) |
//! | few entries a row (masks) | [`solve_sparse`], [`solve_sparse_spd`]; [`SparseLu`], [`SparseCholesky`] | milliseconds |
//! | `½ (K⊗M + M⊗K)`, the Dirichlet energy of a tensor net | [`Separable`] | O(n³) |
//! | a sum of Kronecker products: bending, TB–Coons patches, any energy of a large net | [`ProductSystem`] | O(n³), ten steps |
//! | `Q` polynomial in shape parameters, at many of them | [`Parametric`] to about ten points a side, above it [`SeparableParametric`] | 40 ns (bicubic), 40 µs (degree 10), 0.15 ms (20) |
//! | too few, too many or conflicting conditions | [`solve_rank`] | |
//! | is a matrix positive definite beyond doubt? | [`proves_positive_definite`] | O(n³) |
//! | is a critical point a minimum? | [`smallest_eigenvalue`], [`smallest_relative_eigenvalue`], [`smallest_eigenpair`], [`eigen_symmetric`] | |
//! | a sum of matrices of cells that share unknowns on their rims | [`Condensation`] | |
//! | functions made orthonormal from samples | [`orthonormalise`] | |
//!
//! Every answer carries its residual, scaled as LAPACK's tests do (above 30 it is an error), and a condition number. What
//! should be positive definite is factored as such or is an error that says why; nothing is shifted, nothing falls
//! back, lack of memory is never called singular, and bad input never panics. Arrays are row-major slices of
//! `f64`. All arithmetic runs on the calling thread, in an order that does not depend on anything but the input.
//!
//! ```
//! use solve::{Partition, Samples, Separable};
//!
//! // The plane z = x + y as a 3 × 3 Bernstein net whose middle point is free; two Gauss points suffice for it.
//! let t = [0.5 - 0.75f64.sqrt() / 3.0, 0.5 + 0.75f64.sqrt() / 3.0];
//! let values = t.iter().flat_map(|t| [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t]).collect();
//! let derivatives = t.iter().flat_map(|t| [2.0 * t - 2.0, 2.0 - 4.0 * t, 2.0 * t]).collect();
//! let samples = Samples { points: 2, functions: 3, weights: vec![0.5; 2], values, derivatives };
//! let mut net: Vec<f64> = (0..9).flat_map(|k| [(k / 3) as f64, (k % 3) as f64, (k / 3 + k % 3) as f64]).collect();
//! net[12..15].fill(f64::NAN); // the free point (1, 1): not read
//!
//! let solution = Separable::new(&samples, &samples, &[1], &[1])?.solve(&net)?;
//! assert!((solution.x[14] - 2.0).abs() < 1e-14 && solution.residual < 30.0);
//! assert_eq!(Partition::of_net(3, 3, &[1], &[1])?.free(), [4]);
//! # Ok::<(), solve::SolveError>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | what is fixed and what free | [`Partition`] |
//! | solutions | [`Solution`], [`SeparableSolution`], [`ProductSolution`], [`ParametricSolution`], [`RankSolution`] |
//! | a separable system | [`Samples`], [`AffineSamples`], [`SampledFunctions`], [`ProductTerm`] |
//! | a system with parameters | [`ParametricProblem`], [`PolynomialMatrix`], [`Term`], [`Path`] of the arithmetic |
//! | a sparse one | [`Triplet`] |
//! | condensed interiors | [`Condensation`], [`Condensed`] |
//! | eigenvalues | [`Eigenpair`], [`SymmetricEigen`] |
//! | errors | [`SolveError`], [`Place`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod certificate;
mod check;
mod condensed;
mod condition;
mod dense;
mod eigen;
mod error;
mod lanczos;
mod memory;
mod orthonormal;
mod parametric;
mod partition;
mod rank;
mod scale;
mod separable;
mod sparse;
mod system;

pub use certificate::proves_positive_definite;
pub use condensed::{Condensation, Condensed};
pub use dense::{Cholesky, Lu, solve_general, solve_partitioned, solve_spd};
pub use eigen::{SymmetricEigen, eigen_symmetric, smallest_eigenvalue, smallest_relative_eigenvalue};
pub use error::{Place, SolveError};
pub use lanczos::{Eigenpair, smallest_eigenpair};
pub use orthonormal::orthonormalise;
pub use parametric::{Parametric, ParametricProblem, ParametricSolution, Path, PolynomialMatrix, Term};
pub use partition::Partition;
pub use rank::{RankSolution, solve_rank};
pub use separable::{
    AffineSamples, ProductSolution, ProductSystem, ProductTerm, SampledFunctions, Samples, Separable,
    SeparableParametric, SeparableSolution,
};
pub use sparse::{SparseCholesky, SparseLu, Triplet, solve_sparse, solve_sparse_spd};
pub use system::Solution;
