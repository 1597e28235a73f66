//! Degrees that rise until the area is near the least.

use super::fill::{Fill, Solution};
use crate::{AreaEstimate, MethodError, Progress, Seams, estimate_complex, least_area_complex};

/// Degrees that are added at once, and the highest that is reached.
const MORE: usize = 2;
const HIGHEST: usize = 14;

impl Fill {
    /// The surface in patches of the least degree, by twos from that of `solution`, whose area is estimated to lie less than this share
    /// above the least; of degree 14 where none is known to. With its estimate.
    pub(super) fn accurate(
        &self,
        accuracy: f64,
        mut solution: Solution,
        progress: &dyn Progress,
    ) -> Result<(Solution, Option<AreaEstimate>), MethodError> {
        loop {
            let Some(found) = solution.extremal else { return Ok((solution, None)) };
            let estimate = estimate_complex(&solution.complex, &found, progress)?;
            let is_reached = estimate.is_ok_and(|estimate| estimate <= accuracy * found.area.value);
            let degree = solution.complex.degree() + MORE;
            if is_reached || degree > HIGHEST {
                return Ok((solution, Some(estimate)));
            }
            let raised = solution.complex.with_degree(degree)?;
            let (complex, found) = least_area_complex(&raised, &[], self.tolerance, progress)?;
            solution.seams = Seams::of(&complex)?;
            (solution.complex, solution.extremal) = (complex, Some(found));
        }
    }
}
