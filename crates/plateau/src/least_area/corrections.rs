//! Metric corrections.

use solve::SolveError;

use super::assembly::{Assembly, solve_vectors};
use super::descent::{Descent, ROUNDING, Reached, defined, less};
use super::space::Space;
use crate::MethodError;

/// Metric corrections at most, and the share of the area one must gain for another to follow.
const CORRECTIONS: usize = 24;
const CORRECTION_GAIN: f64 = 1e-4;

impl<S: Space> Descent<'_, '_, S> {
    /// `x ← argmin D^g`, g the metric of x: as K(x) x is the gradient of the area, x − K⁻¹ ∇A. Never enlarges the area.
    pub(super) fn corrections(&mut self, reached: &mut Reached) -> Result<(), MethodError> {
        while reached.corrections.steps < CORRECTIONS {
            self.watch(reached)?;
            let here = &reached.surface;
            let cell = self.rules.fine_cell(here.points)?;
            let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
            let Some(gradient) = defined(assembly.gradient(&here.fine.tangents))? else { break };
            let (rough, tangents) = self.rough(here)?;
            let rough = Assembly { topology: assembly.topology, cell: rough.as_ref() };
            let Some(metrics) = defined(rough.metrics(&tangents))? else { break };
            self.iterations += 1;
            let change = match solve_vectors(&self.scalar, &metrics, &gradient) {
                Ok(change) => change,
                // A metric that is singular to working precision leads nowhere.
                Err(MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => break,
                Err(error) => return Err(error),
            };
            let x = less(&here.x, &change);
            let next = self.rules.at(here.points, x)?;
            let next = self.rules.settle(next)?;
            self.evaluations += 1;
            self.move_rule(reached, next.points)?;
            let before = reached.surface.area();
            let gained = before - next.area();
            // A gain within the error of the rule is none.
            if gained.is_nan() || gained <= next.error.max(ROUNDING * before) {
                break;
            }
            reached.corrections.steps += 1;
            reached.corrections.gained += gained;
            reached.surface = next;
            if gained < CORRECTION_GAIN * before {
                break;
            }
        }
        Ok(())
    }
}
