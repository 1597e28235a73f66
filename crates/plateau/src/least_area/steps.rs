//! Newton steps in all coordinates, bounded: the way along the valley of surfaces that differ by their parametrisation.

use std::rc::Rc;

use energy::Cell;
use solve::{Condensed, SolveError};
use surfaces::Point;

use super::assembly::{Assembly, Tangents, Unknowns};
use super::descent::{
    Descent, LEAST_SHIFT, LOOSE, ROUNDING, Reached, Step, TRIES, TRUSTED_SHIFT, defined, less,
};
use super::outcome::ValleyEnd;
use super::rules::{Fine, Known, Rules};
use super::space::Space;
use crate::MethodError;

/// Steps running that gain less than the tolerance after which it is reached; one more for every digit below 1e-9.
const IDLE: usize = 2;

/// Steps with one factorisation at most, beyond the first.
const CORRECTED: usize = 10;

/// Share of what a step has gained so far that another with its factorisation must gain for one more to follow.
const CORRECTED_GAIN: f64 = 0.1;

/// Steps taken once nothing beyond rounding is to be gained: what has a curvature is then exact to rounding; and the share of
/// the Dirichlet product in them, which leaves what has none where it is.
const LAST_STEPS: usize = 2;
const LAST_SHIFT: f64 = 1e-7;

/// Share of the start's evenness (least over mean of the area densities) below which steps do not lead, from a tolerance of
/// [`LOOSE`] on; four digits less for every digit below it, where the area counts for more than the parametrisation.
pub(super) const EVENNESS: f64 = 0.1;
const LESS_EVEN: f64 = 4.0;

/// By what the floor of the steps is above that, so that the steps along the normals that follow do not lead below.
const MARGIN: f64 = 1.25;

/// Times the floor from which on a surface is even by whatever rule it is looked at.
const COMFORTABLE: f64 = 1.25;

/// Steps that lead to surfaces that no rule integrates, after which no other is tried.
const UNRESOLVED: usize = 4;

/// What a step is made of beside the gradient: the metric of the surface by a rule, with the Hessians that the descent keeps.
pub(super) struct Model {
    cell: Rc<dyn Cell>,
    tangents: Tangents,
    pub(super) metrics: Vec<Vec<f64>>,
}

/// Where a step may lead.
struct Trial {
    x: Vec<Point>,
    fine: Fine,
}

/// The floor of evenness, and how far the steps have come.
struct Bounds<'x> {
    /// The surfaces from whose evenness it counts.
    from: [&'x [Point]; 2],
    /// The floor by the first rule, and by a rule of so many points once it is needed.
    first_floor: f64,
    floor: Option<(usize, f64)>,
    idle: usize,
    last: usize,
    unresolved: usize,
}

impl<S: Space> Descent<'_, '_, S> {
    /// The share of the lesser evenness of two surfaces below which steps do not lead.
    fn floor_share(&self) -> f64 {
        let digits = (LOOSE / self.tolerance).log10().max(0.0);
        MARGIN * EVENNESS * 10f64.powf(-LESS_EVEN * digits)
    }

    /// Whether a surface of a rule is no less even than the floor. Near the floor a rule decides that is the same for rules which are
    /// nearly as fine, so that it plays no part by which of them the surface was integrated.
    fn is_even(
        &mut self,
        points: usize,
        trial: &Trial,
        bounds: &mut Bounds<'_>,
    ) -> Result<bool, MethodError> {
        if trial.fine.evenness >= COMFORTABLE * bounds.first_floor {
            return Ok(true);
        }
        let points = Rules::<S>::of_evenness(points);
        let floor = match bounds.floor {
            Some((of, floor)) if of == points => floor,
            Some(_) | None => {
                let [first, second] = bounds.from;
                let least = self.rules.evenness(points, first)?.min(self.rules.evenness(points, second)?);
                bounds.floor.insert((points, self.floor_share() * least)).1
            }
        };
        Ok(self.rules.evenness(points, &trial.x)? >= floor)
    }

    /// Levenberg–Marquardt steps `(H + λK) d = −∇A` in all coordinates, K the Dirichlet product over the surface, until two
    /// running gain less than the tolerance. A step is judged by the finer rule, so that none exploits what the rule misses.
    pub(super) fn steps(
        &mut self,
        reached: &mut Reached,
        reference: &[Point],
        mut shift: f64,
        most: usize,
    ) -> Result<(), MethodError> {
        let first = reached.surface.x.clone();
        let from = [reference, first.as_slice()];
        let points = self.rules.first();
        let least =
            self.rules.fine(points, reference)?.evenness.min(self.rules.fine(points, &first)?.evenness);
        let first_floor = self.floor_share() * least;
        let mut bounds = Bounds { from, first_floor, floor: None, idle: 0, last: 0, unresolved: 0 };
        reached.valley = ValleyEnd::Budget;
        self.least_shift = LEAST_SHIFT;
        for _ in 0..most {
            self.watch(reached)?;
            let end = match self.step(&reached.surface, &mut shift, &mut bounds)? {
                Ok(step) => self.take(reached, step, &mut shift, &mut bounds)?,
                Err(end) => Some(end),
            };
            if let Some(end) = end {
                reached.valley = end;
                break;
            }
        }
        Ok(())
    }

    /// Goes a step, and learns from it how long the next may be; why none is to follow.
    fn take(
        &mut self,
        reached: &mut Reached,
        step: Step,
        shift: &mut f64,
        bounds: &mut Bounds<'_>,
    ) -> Result<Option<ValleyEnd>, MethodError> {
        let Step { x, fine, predicted, quality } = step;
        let (points, before, used) = (reached.surface.points, reached.surface.area(), *shift);
        let rounding = predicted <= ROUNDING * before;
        let next = self.rules.known(points, x, fine)?;
        // A step of rounding moves nothing that a finer rule could see; any other may lead to where one is needed.
        let next = if rounding { next } else { self.rules.settle(next)? };
        if next.points != points {
            // What the coarser rules promised is no gain if the finer ones do not see it.
            self.move_rule(reached, next.points)?;
            if reached.surface.area() <= next.area() {
                *shift *= 4.0;
                return Ok(None);
            }
        }
        // Nor is it one where not even the largest rule integrates the surface that it leads to.
        if self.resolves(&reached.surface) && !self.resolves(&next) {
            *shift = shift.max(1e-8) * 4.0;
            bounds.unresolved += 1;
            return Ok((bounds.unresolved == UNRESOLVED).then_some(ValleyEnd::Ratio));
        }
        let gained = reached.surface.area() - next.area();
        reached.steps.steps += 1;
        reached.steps.gained += gained;
        reached.surface = next;
        if rounding {
            bounds.last += 1;
            return Ok((bounds.last == LAST_STEPS).then_some(ValleyEnd::Rounding));
        }
        // The quotient of gain and promise says how far the parabola holds: less shift, or more.
        if quality > 0.75 {
            *shift = (0.3 * *shift).max(self.least_shift);
        } else if quality < 0.25 {
            *shift *= 4.0;
        }
        bounds.idle = match gained > self.tolerance * before {
            true => 0,
            // A step that was held back by the shift says nothing of what is left.
            false => bounds.idle + usize::from(used <= TRUSTED_SHIFT),
        };
        // Below 1e-9 gains along the valley fall off slowly: one small gain is not yet the end.
        let patience = IDLE + (1e-9 / self.tolerance).log10().max(0.0).round() as usize;
        Ok((bounds.idle >= patience).then_some(ValleyEnd::Tolerance))
    }

    /// One step that lowers the area and leaves the surface no less even than the floor, or promises no more than rounding; why
    /// there is none.
    fn step(
        &mut self,
        here: &Known,
        shift: &mut f64,
        bounds: &mut Bounds<'_>,
    ) -> Result<Result<Step, ValleyEnd>, MethodError> {
        let (topology, all) = (self.rules.space.topology(), self.all.clone());
        let cell = self.rules.fine_cell(here.points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let mut end = ValleyEnd::Rounding;
        let Some(slopes) = defined(assembly.gradient(&here.fine.tangents))? else {
            return Ok(Err(ValleyEnd::Singular));
        };
        let Some(model) = self.model(here)? else { return Ok(Err(ValleyEnd::Singular)) };
        let of_model = Assembly { topology, cell: model.cell.as_ref() };
        let gradient = all.gather(&slopes);
        self.iterations += 1;
        for _ in 0..TRIES {
            let Some(factor) = self.factored(&all, &model, shift)? else { continue };
            let mut d = gradient.clone();
            factor.solve(1, &mut d)?;
            let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
            let change = all.scatter(&d);
            let square = of_model.metric_square(&model.tangents, &change)?;
            // −gᵀd − ½ dᵀHd with Hd = −g − λKd.
            let predicted = 0.5 * (slope + *shift * square);
            let small = predicted <= ROUNDING * here.area();
            // Nothing beyond rounding is promised: the last steps are made with the share that holds the valley still.
            if small && *shift != LAST_SHIFT {
                *shift = LAST_SHIFT;
                continue;
            }
            let mut trial = self.trial(here.points, less(&here.x, &change))?;
            if !small {
                trial = self.corrected(&assembly, &factor, here, trial, bounds)?;
            }
            let quality = (here.area() - trial.fine.area) / predicted;
            // The quotient of two roundings says nothing: a small step must only not climb.
            let lower = quality > 1e-4 || small && trial.fine.area <= here.area() * (1.0 + ROUNDING);
            if lower && (small || self.is_even(here.points, &trial, bounds)?) {
                let Trial { x, fine } = trial;
                return Ok(Ok(Step { x, fine, predicted, quality }));
            }
            // Only the evenness was against it: that is the reason if no shorter step does better.
            if lower {
                end = ValleyEnd::Ratio;
            }
            *shift = shift.max(1e-8) * 5.0;
        }
        Ok(Err(end))
    }

    /// The Hessians and the metric of a surface; none where it is singular.
    pub(super) fn model(&mut self, here: &Known) -> Result<Option<Model>, MethodError> {
        let (cell, tangents) = self.rough(here)?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let all = self.all.clone();
        if defined(all.hessians(&assembly, &tangents, &mut self.hessians))?.is_none() {
            return Ok(None);
        }
        let Some(metrics) = defined(assembly.metrics(&tangents))? else { return Ok(None) };
        Ok(Some(Model { cell, tangents, metrics }))
    }

    /// `H + λK`, factored; none if it is not positive definite: then the share λ is larger for the next try.
    fn factored<'u>(
        &mut self,
        all: &'u Unknowns,
        model: &Model,
        shift: &mut f64,
    ) -> Result<Option<Condensed<'u>>, MethodError> {
        all.shifted(self.rules.space.topology(), &self.hessians, (*shift, &model.metrics), &mut self.shifted);
        match all.condensation().factor(&self.shifted) {
            Ok(factor) => Ok(Some(factor)),
            Err(SolveError::NotPositiveDefinite { .. }) => {
                *shift = shift.max(1e-8) * 6.0;
                if self.tolerance >= LOOSE {
                    self.least_shift = self.least_shift.max(*shift);
                }
                Ok(None)
            }
            Err(error) => Err(error.into()),
        }
    }

    /// A surface by the finer rule.
    fn trial(&mut self, points: usize, x: Vec<Point>) -> Result<Trial, MethodError> {
        self.evaluations += 1;
        let fine = self.rules.fine(points, &x)?;
        Ok(Trial { x, fine })
    }

    /// A step along the curved valley leaves its floor; the same system leads back, and on, as long as the surface stays as
    /// even as the floor.
    fn corrected(
        &mut self,
        assembly: &Assembly<'_>,
        factor: &Condensed<'_>,
        here: &Known,
        mut trial: Trial,
        bounds: &mut Bounds<'_>,
    ) -> Result<Trial, MethodError> {
        for _ in 0..CORRECTED {
            // A simplified Newton step: the gradient is new, the factorisation is not.
            let Some(slopes) = defined(assembly.gradient(&trial.fine.tangents))? else { break };
            let mut d = self.all.gather(&slopes);
            factor.solve(1, &mut d)?;
            let next = self.trial(here.points, less(&trial.x, &self.all.scatter(&d)))?;
            let gained = trial.fine.area - next.fine.area;
            if gained.is_nan()
                || gained <= ROUNDING * trial.fine.area
                || !self.is_even(here.points, &next, bounds)?
            {
                break;
            }
            let so_far = here.area() - trial.fine.area;
            trial = next;
            if gained < CORRECTED_GAIN * so_far {
                break;
            }
        }
        Ok(trial)
    }
}
