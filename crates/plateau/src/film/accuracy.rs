//! Degrees that rise, and layers around corners, until the area is near the least.

use super::options::Fill;
use super::solution::Solution;
use crate::{
    AreaEstimate, MethodError, Progress, Seams, Warning, estimate_complex, least_area_complex, memory,
};

/// Degrees that are added at once, and the highest that is reached.
const MORE: usize = 2;
const HIGHEST: usize = 14;

/// What a raising leaves of the estimate at most; more is a stall, which corners explain if there are odd ones.
const STALLED: f64 = 0.1;

/// What the rising led to.
pub(super) struct Accurate {
    pub(super) solution: Solution,
    pub(super) estimate: Option<AreaEstimate>,
    /// That a layer was set.
    pub(super) note: Option<Warning>,
}

impl Fill {
    /// The surface in patches of the least degree, by twos from that of `solution`, whose area is estimated to lie less than this share
    /// above the least; of degree 14 where none is known to. Where a raising gains little and there are odd corners, these get a layer of
    /// smaller patches first.
    pub(super) fn accurate(
        &self,
        accuracy: f64,
        mut solution: Solution,
        progress: &dyn Progress,
    ) -> Result<Accurate, MethodError> {
        let (mut before, mut may_layer, mut note) = (None, solution.layers == 0, None);
        loop {
            let Some(found) = &solution.extremal else {
                return Ok(Accurate { solution, estimate: None, note });
            };
            let estimate = estimate_complex(&solution.complex, found, progress)?;
            if estimate.is_ok_and(|estimate| estimate <= accuracy * found.area.value) {
                return Ok(Accurate { solution, estimate: Some(estimate), note });
            }
            let degree = solution.complex.degree() + MORE;
            let is_stalled = before.is_some_and(|before| match (before, estimate) {
                (Ok(before), Ok(estimate)) => estimate > STALLED * before,
                (Err(_), _) | (_, Err(_)) => true,
            });
            before = Some(estimate);
            if std::mem::take(&mut may_layer) {
                may_layer = !(is_stalled || degree > HIGHEST);
                if !may_layer {
                    solution = self.layered(solution, progress)?;
                    if solution.layers > 0 {
                        note = Some(Warning::LayerSet { degree: solution.complex.degree() });
                        before = None;
                        continue;
                    }
                }
            }
            if degree > HIGHEST {
                return Ok(Accurate { solution, estimate: Some(estimate), note });
            }
            let faces = solution.complex.faces().len();
            memory::holds(memory::of_faces(degree, faces))?;
            progress.tell(&format!("({faces} patches of degree {degree})"));
            let raised = solution.complex.with_degree(degree)?;
            let (complex, found) = least_area_complex(&raised, &[], self.tolerance, progress)?;
            solution.seams = Seams::of(&complex)?;
            (solution.complex, solution.extremal) = (complex, Some(found));
        }
    }
}
