//! Nets whose free points are fixed combinations of their neighbours: sparse systems.

use solve::{Partition, Triplet, solve_sparse};
use surfaces::MaskSystem;

use crate::{MethodError, SolveFigures};

/// The coordinates of a net with the free ones solved for: `A_f P_f = −A_b P_b`.
pub(super) fn solve(
    system: &MaskSystem,
    fixed: &[bool],
    coordinates: &[f64],
) -> Result<(Vec<f64>, SolveFigures), MethodError> {
    let partition = Partition::new(fixed);
    let mut column_of = vec![usize::MAX; fixed.len()];
    for (column, &point) in partition.free().iter().enumerate() {
        column_of[point] = column;
    }
    let mut triplets = Vec::with_capacity(system.triplets.len());
    let mut rhs = vec![0.0; 3 * system.rows];
    for &(row, point, value) in &system.triplets {
        if fixed[point] {
            for d in 0..3 {
                rhs[3 * row + d] -= value * coordinates[3 * point + d];
            }
        } else {
            triplets.push(Triplet { row, column: column_of[point], value });
        }
    }
    let solution = solve_sparse(system.rows, &triplets, 3, &rhs)?;
    let mut solved = coordinates.to_vec();
    partition.scatter_free(3, &solution.x, &mut solved)?;
    let figures = SolveFigures {
        solver: "sparse",
        residual: solution.residual,
        condition: solution.condition,
        basis_condition: None,
        certified: None,
        left_out: None,
        metric: None,
    };
    Ok((solved, figures))
}
