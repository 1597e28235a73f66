//! The stages of a minimisation: metric corrections, Newton steps in all coordinates, Newton steps along the normals.

use std::rc::Rc;

use bases::Matrix;
use energy::{Cell, EnergyError};
use surfaces::Point;

use super::assembly::{Assembly, Tangents, Unknowns, solve_vectors};
use super::outcome::{AreaEnd, Stage, ValleyEnd};
use super::rules::{Fine, Known, Rules};
use super::space::Space;
use crate::{MethodError, Progress};

/// The tolerance from which on the parametrisation is to be determined: below it the area counts for more.
pub(super) const LOOSE: f64 = 1e-10;

/// Newton steps in all coordinates at most, from [`LOOSE`] on, and how many more for every digit below it.
const STEPS: usize = 24;
const MORE_STEPS: f64 = 80.0;

/// Share of the Dirichlet product in the first steps in all coordinates, and the least. Where the Hessian with less than some share is
/// indefinite, rounding grows from step to step along what has negative curvature, the faster the less is added: from a
/// tolerance of [`LOOSE`] on, no later step has less than the share that made it definite, so that the parametrisation is
/// determined.
const FIRST_SHIFT: f64 = 1e-2;
pub(super) const LEAST_SHIFT: f64 = 1e-9;

/// Steps with at most this share are those of Newton's method, but for the flattest directions.
pub(super) const TRUSTED_SHIFT: f64 = 3e-4;

/// Factorisations and evaluations tried for one step.
pub(super) const TRIES: usize = 14;

/// A predicted decrease below this share of the area is rounding.
pub(super) const ROUNDING: f64 = 1e-14;

/// Relative error of the area by the rule of Hessians and metrics, as a share of the tolerance, and the least.
const ROUGH: f64 = 0.1;
const LEAST_ROUGH: f64 = 1e-11;

/// Relative change of the area by a finer rule below which the rule is said to resolve it; a tenth of the tolerance where that
/// is more.
const RESOLVED: f64 = 1e-9;

/// A surface on its way down.
pub(super) struct Descent<'a, 'p, S: Space> {
    pub(super) rules: Rules<'a, S>,
    pub(super) progress: &'p dyn Progress,
    pub(super) tolerance: f64,
    pub(super) scalar: Unknowns,
    pub(super) all: Rc<Unknowns>,
    pub(super) iterations: usize,
    pub(super) evaluations: usize,
    /// The least share of the Dirichlet product in steps from here on.
    pub(super) least_shift: f64,
    /// Points of the rule that Hessians and metrics bear.
    pub(super) rough: usize,
    /// The last Hessians, a cell each, and with their share of the Dirichlet product: kept for their memory.
    pub(super) hessians: Vec<Matrix>,
    pub(super) shifted: Vec<Vec<f64>>,
}

/// Where a descent ended.
#[derive(Debug, Clone)]
pub(super) struct Reached {
    pub(super) surface: Known,
    pub(super) corrections: Stage,
    pub(super) steps: Stage,
    pub(super) normal_steps: Stage,
    pub(super) end: AreaEnd,
    pub(super) valley: ValleyEnd,
    /// What control points far from the border had less area.
    pub(super) beyond: f64,
}

impl Reached {
    /// A surface from which nothing was done yet.
    pub(super) fn new(surface: Known) -> Self {
        Self {
            surface,
            corrections: Stage::default(),
            steps: Stage::default(),
            normal_steps: Stage::default(),
            end: AreaEnd::Stationary,
            valley: ValleyEnd::Rounding,
            beyond: 0.0,
        }
    }
}

/// A step.
pub(super) struct Step {
    pub(super) x: Vec<Point>,
    pub(super) fine: Fine,
    /// The decrease of the area predicted, and what of it came true.
    pub(super) predicted: f64,
    pub(super) quality: f64,
}

impl<'a, 'p, S: Space> Descent<'a, 'p, S> {
    pub(super) fn new(space: &'a S, tolerance: f64, progress: &'p dyn Progress) -> Result<Self, MethodError> {
        let topology = space.topology();
        let rules = Rules::new(space, tolerance);
        Ok(Self {
            rough: rules.first(),
            hessians: Vec::new(),
            shifted: Vec::new(),
            rules,
            progress,
            tolerance,
            scalar: Unknowns::scalar(topology)?,
            all: Rc::new(Unknowns::all(topology)?),
            iterations: 0,
            evaluations: 0,
            least_shift: LEAST_SHIFT,
        })
    }

    /// All three stages from `start`; evenness counts from that of `reference`. A surface that is `near` begins with steps that are
    /// nearly Newton's.
    pub(super) fn run(
        &mut self,
        start: Known,
        reference: &[Point],
        near: bool,
    ) -> Result<Reached, MethodError> {
        let mut reached = Reached::new(start);
        if self.scalar.count() == 0 {
            return Ok(reached);
        }
        // Another start may be tamer than where the last descent ended.
        self.rough = self.rules.first();
        // Kept, because what control points near the border cost must not lead above it.
        let first = reached.surface.clone();
        self.corrections(&mut reached)?;
        let corrected = reached.surface.clone();
        let digits = (LOOSE / self.tolerance).log10().max(0.0);
        let most = STEPS + (MORE_STEPS * digits) as usize;
        self.steps(&mut reached, reference, if near { TRUSTED_SHIFT } else { FIRST_SHIFT }, most)?;
        self.normal_steps(&mut reached)?;
        self.within_reach(&mut reached, reference, [first, corrected])?;
        Ok(reached)
    }

    /// Where the metric corrections lead from `start`.
    pub(super) fn after_corrections(&mut self, start: Known) -> Result<Known, MethodError> {
        let mut reached = Reached::new(start);
        if self.scalar.count() > 0 {
            self.rough = self.rules.first();
            self.corrections(&mut reached)?;
        }
        Ok(reached.surface)
    }

    /// From `x`, which is near, in at most `most` steps in all coordinates and steps along the normals.
    pub(super) fn refined(&mut self, x: Vec<Point>, most: usize) -> Result<Reached, MethodError> {
        let mut reached = Reached::new(self.rules.settled(x.clone())?);
        if self.scalar.count() > 0 {
            self.steps(&mut reached, &x, TRUSTED_SHIFT, most)?;
            self.normal_steps(&mut reached)?;
        }
        Ok(reached)
    }

    /// The extremal of the Dirichlet energy of the form (a, b, c), from any surface with the border.
    pub(super) fn dirichlet(&mut self, x: &[Point], form: [f64; 3]) -> Result<Vec<Point>, MethodError> {
        if self.scalar.count() == 0 {
            return Ok(x.to_vec());
        }
        let cell = self.rules.cell(self.rules.first())?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        // The energy is quadratic: one step from any surface with the border ends at its minimum.
        let pull = assembly.pull(&assembly.tangents(x), form);
        let change = solve_vectors(&self.scalar, &assembly.stiffnesses(form), &pull)?;
        Ok(x.iter().zip(change).map(|(&x, d)| x - d).collect())
    }

    /// The cell and the tangents by the first rule that gives the area of a surface nearly: where steps lead, gradients and areas say,
    /// and Hessians only how.
    pub(super) fn rough(&mut self, here: &Known) -> Result<(Rc<dyn Cell>, Tangents), MethodError> {
        loop {
            let points = self.rough.min(here.points);
            let cell = self.rules.cell(points)?;
            let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
            let tangents = assembly.tangents(&here.x);
            let error = (assembly.area_of(&tangents) - here.area()).abs();
            if points == here.points || error <= (ROUGH * self.tolerance).max(LEAST_ROUGH) * here.area() {
                return Ok((cell, tangents));
            }
            self.rough = Rules::<S>::next(self.rough);
        }
    }

    /// Whether the rule of a surface integrates it.
    pub(super) fn resolves(&self, surface: &Known) -> bool {
        surface.error <= RESOLVED.max(0.1 * self.tolerance) * surface.area()
    }

    /// The surface reached at the rule of `points`.
    pub(super) fn move_rule(&mut self, reached: &mut Reached, points: usize) -> Result<(), MethodError> {
        if reached.surface.points != points {
            reached.surface = self.rules.at(points, std::mem::take(&mut reached.surface.x))?;
        }
        Ok(())
    }

    pub(super) fn watch(&self, reached: &Reached) -> Result<(), MethodError> {
        if self.progress.cancelled() {
            return Err(MethodError::Interrupted);
        }
        self.progress.step();
        let unit = self.rules.space.frame().unit();
        self.progress.tell(&format!(
            "(step {}: area {:.9})",
            self.iterations,
            reached.surface.area() * unit * unit
        ));
        Ok(())
    }
}

/// `x − d`.
pub(super) fn less(x: &[Point], d: &[Point]) -> Vec<Point> {
    x.iter().zip(d).map(|(&x, &d)| x - d).collect()
}

/// None where the surface is singular at a point of the rule: it has no gradient there.
pub(super) fn defined<T>(found: Result<T, EnergyError>) -> Result<Option<T>, EnergyError> {
    match found {
        Ok(found) => Ok(Some(found)),
        Err(EnergyError::Singular { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}
