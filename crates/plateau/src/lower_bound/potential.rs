//! The potential that makes the bound largest.

use bases::Matrix;
use energy::Calibration;
use solve::{SolveError, solve_spd};

use super::NoBound;

/// Newton steps at most, and halvings of one: convergence is quadratic once near.
const STEPS: usize = 40;
const HALVINGS: i32 = 20;

/// Shares of the diagonal that are added, one after the other, to a matrix which is singular to working precision: they slow the steps, and
/// harm no bound.
const REGULAR: [f64; 5] = [0.0, 1e-12, 1e-10, 1e-8, 1e-6];

/// The best potential of a calibration; none if its first system is singular to working precision.
pub(super) fn potential(calibration: &Calibration) -> Result<Option<Vec<f64>>, NoBound> {
    let (matrix, rhs) = calibration.fit();
    let Some(mut psi) = solved(&matrix, &rhs)? else { return Ok(None) };
    let mut value = calibration.value(&psi);
    // The fit may be too steep at some points; ψ = 0 is not, so shrinking comes to an end.
    while value.is_none() {
        psi.iter_mut().for_each(|c| *c *= 0.95);
        value = calibration.value(&psi);
    }
    let Some(mut value) = value else { return Ok(Some(psi)) };
    for _ in 0..STEPS {
        let (gradient, hessian) = calibration.derivatives(&psi);
        // Newton for a concave function: `derivatives` gives the negative Hessian, so the step goes up.
        // Where ψ rises by nearly 1 somewhere the second derivatives are beyond all bounds there: it is good as it is.
        let Some(step) = solved(&hessian, &gradient)? else { break };
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
    Ok(Some(psi))
}

/// The solution whose first coefficient is 0: constants are the kernel of both matrices. None if the matrix is singular to working precision.
fn solved(matrix: &Matrix, rhs: &[f64]) -> Result<Option<Vec<f64>>, SolveError> {
    // Without its first row and column the matrix is definite: the constant is held.
    let n = rhs.len() - 1;
    let mut reduced: Vec<f64> = (1..=n).flat_map(|i| matrix.row(i)[1..].to_vec()).collect();
    for share in REGULAR {
        reduced.iter_mut().step_by(n + 1).for_each(|d| *d *= 1.0 + share);
        match solve_spd(n, &reduced, 1, &rhs[1..]) {
            Ok(solution) => return Ok(Some(std::iter::once(0.0).chain(solution.x).collect())),
            Err(SolveError::NotPositiveDefinite { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}
