//! The extremal of a quadratic energy with the boundary net fixed.

use energy::QuadraticForm;
use solve::{Partition, solve_partitioned};
use surfaces::TensorPatch;

use super::{MethodError, SolveFigures, extremal_energy, functional};
use crate::Method;

/// `patch` with its free control points at the extremal of the method's energy: `Q_ff p = −Q_fb P_b` for x, y, z.
pub(super) fn solve(
    patch: &TensorPatch,
    method: &Method,
) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let energy = extremal_energy(method).ok_or(MethodError::Unavailable { what: "this construction" })?;
    let functional = functional(energy).ok_or(MethodError::Unavailable { what: "energy = \"area\"" })?;
    let net = patch.net();
    let matrix = QuadraticForm::of(functional, patch)?.matrix();
    let partition = Partition::new(net.fixed());
    let solution = solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &net.coordinates())?;
    let figures =
        SolveFigures { solver: "dense", residual: solution.residual, condition: solution.condition };
    Ok((patch.with_net(net.with_coordinates(&solution.x)?)?, figures))
}
