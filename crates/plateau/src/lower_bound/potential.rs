//! The potential that makes the bound largest.

use bases::Matrix;
use energy::Calibration;
use solve::{SolveError, solve_spd};

use super::NoBound;

/// Newton steps at most, and halvings of one: convergence is quadratic once near.
const STEPS: usize = 40;
const HALVINGS: i32 = 20;

/// Share of the diagonal that is added to a matrix which is singular to working precision: it slows the steps, and harms no bound.
const REGULAR: f64 = 1e-12;

/// The best potential of a calibration.
pub(super) fn potential(calibration: &Calibration) -> Result<Vec<f64>, NoBound> {
    let (matrix, rhs) = calibration.fit();
    let mut psi = solved(&matrix, &rhs)?;
    let mut value = calibration.value(&psi);
    // The fit may be too steep at some points; ψ = 0 is not, so shrinking comes to an end.
    while value.is_none() {
        psi.iter_mut().for_each(|c| *c *= 0.95);
        value = calibration.value(&psi);
    }
    let Some(mut value) = value else { return Ok(psi) };
    for _ in 0..STEPS {
        let (gradient, hessian) = calibration.derivatives(&psi);
        // Newton for a concave function: `derivatives` gives the negative Hessian, so the step goes up.
        let step = solved(&hessian, &gradient)?;
        // Outside of |∇ψ| < 1 there is no value: such lengths are halved like those that do not rise.
        let risen = (0..HALVINGS).map(|k| 0.5f64.powi(k)).find_map(|length| {
            let next: Vec<f64> = psi.iter().zip(&step).map(|(c, s)| c + length * s).collect();
            calibration.value(&next).filter(|&reached| reached > value).map(|reached| (next, reached))
        });
        let Some((next, reached)) = risen else { break };
        let gained = reached - value;
        (psi, value) = (next, reached);
        if gained <= 1e-15 * value {
            break;
        }
    }
    Ok(psi)
}

/// The solution whose first coefficient is 0: constants are the kernel of both matrices.
fn solved(matrix: &Matrix, rhs: &[f64]) -> Result<Vec<f64>, SolveError> {
    // Without its first row and column the matrix is definite: the constant is held.
    let n = rhs.len() - 1;
    let mut reduced: Vec<f64> = (1..=n).flat_map(|i| matrix.row(i)[1..].to_vec()).collect();
    let solution = match solve_spd(n, &reduced, 1, &rhs[1..]) {
        Err(SolveError::NotPositiveDefinite { .. }) => {
            reduced.iter_mut().step_by(n + 1).for_each(|d| *d *= 1.0 + REGULAR);
            solve_spd(n, &reduced, 1, &rhs[1..])?
        }
        solution => solution?,
    };
    Ok(std::iter::once(0.0).chain(solution.x).collect())
}
