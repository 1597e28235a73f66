//! The stages of a minimisation: metric corrections, Newton steps in all coordinates, Newton steps along the normals.

use std::rc::Rc;

use energy::{EnergyError, Freedom};
use solve::{Condensed, SolveError};
use surfaces::Point;

use super::assembly::{Assembly, Tangents, Unknowns, solve_vectors};
use super::outcome::{AreaEnd, Stage, ValleyEnd};
use super::rules::{Fine, Known, Rules};
use super::space::Space;
use crate::MethodError;
use crate::Progress;

/// Metric corrections at most, and the share of the area one must gain for another to follow.
const CORRECTIONS: usize = 24;
const CORRECTION_GAIN: f64 = 1e-4;

/// The tolerance from which on the parametrisation is to be determined: below it the area counts for more.
pub(super) const LOOSE: f64 = 1e-10;

/// Newton steps in all coordinates at most, from [`LOOSE`] on, and how many more for every digit below it.
const STEPS: usize = 24;
const MORE_STEPS: f64 = 80.0;

/// Steps running that gain less than the tolerance after which it is reached; one more for every digit below 1e-9.
const IDLE: usize = 2;

/// Share of the Dirichlet product in the first of them, and the least. Where the Hessian with less than some share is
/// indefinite, rounding grows from step to step along what has negative curvature, the faster the less is added: from a
/// tolerance of [`LOOSE`] on, no later step has less than the share that made it definite, so that the parametrisation is
/// determined.
const FIRST_SHIFT: f64 = 1e-2;
const LEAST_SHIFT: f64 = 1e-9;

/// Steps with at most this share are those of Newton's method, but for the flattest directions.
const TRUSTED_SHIFT: f64 = 3e-4;

/// Factorisations and evaluations tried for one step.
const TRIES: usize = 14;

/// Steps with one factorisation at most, beyond the first.
const CORRECTED: usize = 10;

/// Share of what a step has gained so far that another with its factorisation must gain for one more to follow.
const CORRECTED_GAIN: f64 = 0.1;

/// Newton steps along the normals end once one is predicted to gain no more than this share of the tolerance, or rounding.
const NORMAL_GAIN: f64 = 1e-6;

/// Newton steps along the normals at most.
const NORMAL_STEPS: usize = 20;

/// A predicted decrease below this share of the area is rounding.
const ROUNDING: f64 = 1e-14;

/// Steps taken once nothing beyond rounding is to be gained: what has a curvature is then exact to rounding; and the share of
/// the Dirichlet product in them, which leaves what has none where it is.
const LAST_STEPS: usize = 2;
const LAST_SHIFT: f64 = 1e-7;

/// Share of the start's evenness (least over mean of the area densities) below which steps do not lead, from a tolerance of
/// [`LOOSE`] on; four digits less for every digit below it, where the area counts for more than the parametrisation.
const EVENNESS: f64 = 0.1;
const LESS_EVEN: f64 = 4.0;

/// A surface on its way down.
pub(super) struct Descent<'a, 'p, S: Space> {
    pub(super) rules: Rules<'a, S>,
    pub(super) progress: &'p dyn Progress,
    pub(super) tolerance: f64,
    scalar: Unknowns,
    all: Rc<Unknowns>,
    pub(super) iterations: usize,
    pub(super) evaluations: usize,
    /// The least share of the Dirichlet product in steps from here on.
    least_shift: f64,
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
}

/// A step.
struct Step {
    x: Vec<Point>,
    fine: Fine,
    /// The decrease of the area predicted, and what of it came true.
    predicted: f64,
    quality: f64,
}

impl<'a, 'p, S: Space> Descent<'a, 'p, S> {
    pub(super) fn new(space: &'a S, tolerance: f64, progress: &'p dyn Progress) -> Result<Self, MethodError> {
        let topology = space.topology();
        Ok(Self {
            rules: Rules::new(space, tolerance),
            progress,
            tolerance,
            scalar: Unknowns::scalar(topology)?,
            all: Rc::new(Unknowns::all(topology)?),
            iterations: 0,
            evaluations: 0,
            least_shift: LEAST_SHIFT,
        })
    }

    pub(super) fn scalar(&self) -> &Unknowns {
        &self.scalar
    }

    /// All three stages from `x`; evenness counts from that of `reference`. A surface that is `near` begins with steps that are
    /// nearly Newton's.
    pub(super) fn run(
        &mut self,
        x: Vec<Point>,
        reference: &[Point],
        near: bool,
    ) -> Result<Reached, MethodError> {
        let mut reached = self.at(x)?;
        if self.scalar.count() == 0 {
            return Ok(reached);
        }
        self.corrections(&mut reached)?;
        let digits = (LOOSE / self.tolerance).log10().max(0.0);
        let most = STEPS + (MORE_STEPS * digits) as usize;
        self.steps(&mut reached, reference, if near { TRUSTED_SHIFT } else { FIRST_SHIFT }, most)?;
        self.normal_steps(&mut reached)?;
        Ok(reached)
    }

    /// From `x`, which is near, in at most `most` steps in all coordinates and steps along the normals.
    pub(super) fn refined(&mut self, x: Vec<Point>, most: usize) -> Result<Reached, MethodError> {
        let mut reached = self.at(x.clone())?;
        if self.scalar.count() > 0 {
            self.steps(&mut reached, &x, TRUSTED_SHIFT, most)?;
            self.normal_steps(&mut reached)?;
        }
        Ok(reached)
    }

    /// A surface from which nothing was done yet.
    fn at(&mut self, x: Vec<Point>) -> Result<Reached, MethodError> {
        Ok(Reached {
            surface: self.rules.settled(x)?,
            corrections: Stage::default(),
            steps: Stage::default(),
            normal_steps: Stage::default(),
            end: AreaEnd::Stationary,
            valley: ValleyEnd::Rounding,
        })
    }

    /// The extremal of the Dirichlet energy of the form (a, b, c), from any surface with the border.
    pub(super) fn dirichlet(&mut self, x: &[Point], form: [f64; 3]) -> Result<Vec<Point>, MethodError> {
        if self.scalar.count() == 0 {
            return Ok(x.to_vec());
        }
        let cell = self.rules.cell(self.rules.first())?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let pull = assembly.pull(&assembly.tangents(x), form);
        let change = solve_vectors(&self.scalar, &assembly.stiffnesses(form), &pull)?;
        Ok(x.iter().zip(change).map(|(&x, d)| x - d).collect())
    }

    /// `x ← argmin D^g`, g the metric of x: as K(x) x is the gradient of the area, x − K⁻¹ ∇A. Never enlarges the area.
    fn corrections(&mut self, reached: &mut Reached) -> Result<(), MethodError> {
        while reached.corrections.steps < CORRECTIONS {
            self.watch(reached)?;
            let here = &reached.surface;
            let cell = self.rules.cell(here.points)?;
            let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
            let Some(gradient) = defined(assembly.gradient(&here.tangents))? else { break };
            let metrics = assembly.metrics(&here.tangents)?;
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

    /// The surface reached at the rule of `points`.
    fn move_rule(&mut self, reached: &mut Reached, points: usize) -> Result<(), MethodError> {
        if reached.surface.points != points {
            reached.surface = self.rules.at(points, std::mem::take(&mut reached.surface.x))?;
        }
        Ok(())
    }

    /// The least evenness of surfaces.
    fn floor(&mut self, points: usize, surfaces: [&[Point]; 2]) -> Result<f64, MethodError> {
        let [first, second] = surfaces;
        Ok(self.rules.fine(points, first)?.evenness.min(self.rules.fine(points, second)?.evenness))
    }

    /// Levenberg–Marquardt steps `(H + λK) d = −∇A` in all coordinates, K the Dirichlet product over the surface, until two
    /// running gain less than the tolerance. A step is judged by the finer rule, so that none exploits what the rule misses.
    fn steps(
        &mut self,
        reached: &mut Reached,
        reference: &[Point],
        mut shift: f64,
        most: usize,
    ) -> Result<(), MethodError> {
        let (mut idle, mut last) = (0, 0);
        let digits = (LOOSE / self.tolerance).log10().max(0.0);
        let share = EVENNESS * 10f64.powf(-LESS_EVEN * digits);
        let patience = IDLE + (1e-9 / self.tolerance).log10().max(0.0).round() as usize;
        let first = reached.surface.x.clone();
        let mut floor = self.floor(reached.surface.points, [reference, &first])? * share;
        reached.valley = ValleyEnd::Budget;
        self.least_shift = LEAST_SHIFT;
        for _ in 0..most {
            self.watch(reached)?;
            let Step { x, fine, predicted, quality } = match self.step(&reached.surface, &mut shift, floor)? {
                Ok(step) => step,
                Err(end) => {
                    reached.valley = end;
                    return Ok(());
                }
            };
            let (points, before, used) = (reached.surface.points, reached.surface.area(), shift);
            let rounding = predicted <= ROUNDING * before;
            let next = self.rules.known(points, x, fine)?;
            let next = if rounding { next } else { self.rules.settle(next)? };
            if next.points != points {
                floor = self.floor(next.points, [reference, &first])? * share;
                // What the coarser rules promised is no gain if the finer ones do not see it.
                self.move_rule(reached, next.points)?;
                if reached.surface.area() <= next.area() {
                    shift *= 4.0;
                    continue;
                }
            }
            let gained = reached.surface.area() - next.area();
            reached.steps.steps += 1;
            reached.steps.gained += gained;
            reached.surface = next;
            if rounding {
                last += 1;
                if last == LAST_STEPS {
                    reached.valley = ValleyEnd::Rounding;
                    return Ok(());
                }
                continue;
            }
            if quality > 0.75 {
                shift = (0.3 * shift).max(self.least_shift);
            } else if quality < 0.25 {
                shift *= 4.0;
            }
            idle = match gained > self.tolerance * before {
                true => 0,
                // A step that was held back by the shift says nothing of what is left.
                false => idle + usize::from(used <= TRUSTED_SHIFT),
            };
            if idle >= patience {
                reached.valley = ValleyEnd::Tolerance;
                return Ok(());
            }
        }
        Ok(())
    }

    /// One step that lowers the area and leaves the surface no less even than `floor`, or promises no more than rounding; why
    /// there is none.
    fn step(
        &mut self,
        here: &Known,
        shift: &mut f64,
        floor: f64,
    ) -> Result<Result<Step, ValleyEnd>, MethodError> {
        let (topology, all) = (self.rules.space.topology(), self.all.clone());
        let cell = self.rules.cell(here.points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let mut end = ValleyEnd::Rounding;
        let Some(slopes) = defined(assembly.gradient(&here.tangents))? else { return Ok(Err(end)) };
        let hessians = all.hessians(&assembly, &here.tangents)?;
        let metrics = assembly.metrics(&here.tangents)?;
        let gradient = all.gather(&slopes);
        self.iterations += 1;
        for _ in 0..TRIES {
            let mut matrices = hessians.clone();
            all.add_metrics(topology, *shift, &metrics, &mut matrices);
            let factor = match all.condensation().factor(&matrices) {
                Ok(factor) => factor,
                Err(SolveError::NotPositiveDefinite { .. }) => {
                    *shift = shift.max(1e-8) * 6.0;
                    if self.tolerance >= LOOSE {
                        self.least_shift = self.least_shift.max(*shift);
                    }
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            let mut d = gradient.clone();
            factor.solve(1, &mut d)?;
            let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
            let change = all.scatter(&d);
            let square = assembly.metric_square(&here.tangents, &change)?;
            // −gᵀd − ½ dᵀHd with Hd = −g − λKd.
            let predicted = 0.5 * (slope + *shift * square);
            let small = predicted <= ROUNDING * here.area();
            if small && *shift != LAST_SHIFT {
                *shift = LAST_SHIFT;
                continue;
            }
            let mut x = less(&here.x, &change);
            let mut fine = self.rules.fine(here.points, &x)?;
            self.evaluations += 1;
            if !small {
                (x, fine) = self.corrected(&assembly, &factor, here, (x, fine), floor)?;
            }
            let quality = (here.area() - fine.area) / predicted;
            let lower = quality > 1e-4 || small && fine.area <= here.area() * (1.0 + ROUNDING);
            if lower && (small || fine.evenness >= floor) {
                return Ok(Ok(Step { x, fine, predicted, quality }));
            }
            if lower {
                end = ValleyEnd::Ratio;
            }
            *shift = shift.max(1e-8) * 5.0;
        }
        Ok(Err(end))
    }

    /// A step along the curved valley leaves its floor; the same system leads back, and on, as long as the surface stays as
    /// even as `floor`.
    fn corrected(
        &mut self,
        assembly: &Assembly<'_>,
        factor: &Condensed<'_>,
        here: &Known,
        (mut x, mut fine): (Vec<Point>, Fine),
        floor: f64,
    ) -> Result<(Vec<Point>, Fine), MethodError> {
        for _ in 0..CORRECTED {
            let Some(slopes) = defined(assembly.gradient(&assembly.tangents(&x)))? else { break };
            let mut d = self.all.gather(&slopes);
            factor.solve(1, &mut d)?;
            let next = less(&x, &self.all.scatter(&d));
            let lower = self.rules.fine(here.points, &next)?;
            self.evaluations += 1;
            let gained = fine.area - lower.area;
            if gained.is_nan() || gained <= ROUNDING * fine.area || lower.evenness < floor {
                break;
            }
            let so_far = here.area() - fine.area;
            (x, fine) = (next, lower);
            if gained < CORRECTED_GAIN * so_far {
                break;
            }
        }
        Ok((x, fine))
    }

    /// How the nodes move along the normals of the surface: where several cells meet along the direction closest to all of
    /// theirs, where three meet along a line anywhere.
    pub(super) fn normals(&self, x: &[Point]) -> Result<Vec<Freedom>, MethodError> {
        let space = self.rules.space;
        let topology = space.topology();
        let cell = space.at_nodes()?;
        let mut around: Vec<Vec<Point>> = vec![Vec::new(); x.len()];
        for (k, nodes) in topology.cells.iter().enumerate() {
            for (&node, [x_u, x_v]) in nodes.iter().zip(cell.tangents(&topology.of_cell(k, x))) {
                let cross = x_u.cross(x_v);
                if cross.norm() > 16.0 * f64::EPSILON * x_u.norm() * x_v.norm() {
                    around[node].extend(cross.unit());
                }
            }
        }
        let freedom = |node: usize| match (topology.fixed[node], topology.joint[node]) {
            (true, _) => Freedom::Fixed,
            (false, true) => Freedom::Free,
            (false, false) => common_direction(&around[node]).map_or(Freedom::Fixed, Freedom::Along),
        };
        Ok((0..x.len()).map(freedom).collect())
    }

    /// Newton steps along the normals, refreshed each time, to a gradient that is rounding.
    fn normal_steps(&mut self, reached: &mut Reached) -> Result<(), MethodError> {
        let topology = self.rules.space.topology();
        let enough = (NORMAL_GAIN * self.tolerance).max(1e-2 * ROUNDING);
        let mut shift = 0.0;
        reached.end = AreaEnd::Budget;
        for _ in 0..NORMAL_STEPS {
            self.watch(reached)?;
            let unknowns = Unknowns::new(topology, self.normals(&reached.surface.x)?)?;
            let Some(step) = self.normal_step(&reached.surface, &unknowns, &mut shift)? else {
                reached.end = AreaEnd::Rough;
                return Ok(());
            };
            let next = self.rules.known(reached.surface.points, step.x, step.fine)?;
            let next = self.rules.settle(next)?;
            self.move_rule(reached, next.points)?;
            let (before, after) = (reached.surface.area(), next.area());
            if after > before * (1.0 + ROUNDING) {
                continue;
            }
            reached.normal_steps.steps += 1;
            reached.normal_steps.gained += before - after;
            reached.surface = next;
            // The next step would be the square of this one.
            if step.predicted <= enough * after && shift == 0.0 {
                reached.end = AreaEnd::Stationary;
                return Ok(());
            }
        }
        Ok(())
    }

    /// One Newton step along the normals. The Dirichlet product is added only if the Hessian is indefinite or the step
    /// enlarges the area.
    fn normal_step(
        &mut self,
        here: &Known,
        unknowns: &Unknowns,
        shift: &mut f64,
    ) -> Result<Option<Step>, MethodError> {
        let topology = self.rules.space.topology();
        let cell = self.rules.cell(here.points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let Some(slopes) = defined(assembly.gradient(&here.tangents))? else { return Ok(None) };
        let hessians = unknowns.hessians(&assembly, &here.tangents)?;
        let gradient = unknowns.gather(&slopes);
        self.iterations += 1;
        let mut metrics = None;
        for _ in 0..TRIES {
            let mut matrices = hessians.clone();
            if *shift > 0.0 {
                let metrics = match &metrics {
                    Some(metrics) => metrics,
                    None => metrics.insert(self.metrics_of(unknowns, &assembly, &here.tangents)?),
                };
                unknowns.add_metrics(topology, *shift, metrics, &mut matrices);
            }
            let mut d = gradient.clone();
            match unknowns.condensation().factor(&matrices) {
                Ok(factor) => factor.solve(1, &mut d)?,
                Err(SolveError::NotPositiveDefinite { .. }) => {
                    *shift = (5.0 * *shift).max(1e-3);
                    continue;
                }
                Err(error) => return Err(error.into()),
            }
            let predicted = 0.5 * d.iter().zip(&gradient).map(|(d, g)| d * g).sum::<f64>();
            let x = less(&here.x, &unknowns.scatter(&d));
            let fine = self.rules.fine(here.points, &x)?;
            self.evaluations += 1;
            if fine.area <= here.area() * (1.0 + ROUNDING) {
                *shift = if *shift > 1e-6 { 0.1 * *shift } else { 0.0 };
                let quality = (here.area() - fine.area) / predicted;
                return Ok(Some(Step { x, fine, predicted, quality }));
            }
            *shift = (5.0 * *shift).max(1e-3);
        }
        Ok(None)
    }

    /// The Dirichlet products over the nodes that move.
    fn metrics_of(
        &self,
        unknowns: &Unknowns,
        assembly: &Assembly<'_>,
        tangents: &Tangents,
    ) -> Result<Vec<Vec<f64>>, MethodError> {
        let of = |(k, tangents): (usize, &Vec<[Point; 2]>)| {
            let freedoms = unknowns.of_cell(assembly.topology, k);
            let wanted: Vec<bool> = freedoms.iter().map(|f| *f != Freedom::Fixed).collect();
            Ok(assembly.cell.metric(&wanted, tangents)?.as_slice().to_vec())
        };
        tangents.iter().enumerate().map(of).collect()
    }

    /// The norm of the gradient over √area along the normals, and in all coordinates, against displacements of unit Dirichlet
    /// norm over the surface, by the rule of `points`.
    pub(super) fn gradients(&mut self, x: &[Point], points: usize) -> Result<[f64; 2], MethodError> {
        if self.scalar.count() == 0 {
            return Ok([0.0; 2]);
        }
        let cell = self.rules.cell(points)?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let tangents = assembly.tangents(x);
        let Some(gradient) = defined(assembly.gradient(&tangents))? else { return Ok([f64::NAN; 2]) };
        let normal = Unknowns::new(assembly.topology, self.normals(x)?)?;
        let along = normal.scatter(&normal.gather(&gradient));
        let metrics = assembly.metrics(&tangents)?;
        let area = assembly.area_of(&tangents);
        let mut norms = [0.0; 2];
        for (norm, part) in norms.iter_mut().zip([&along, &gradient]) {
            let dual = match solve_vectors(&self.scalar, &metrics, part) {
                Ok(dual) => dual,
                Err(MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => return Ok([f64::NAN; 2]),
                Err(error) => return Err(error),
            };
            let square: f64 = dual.iter().zip(part).map(|(d, g)| d.dot(*g)).sum();
            *norm = (square / area).max(0.0).sqrt();
        }
        Ok(norms)
    }

    fn watch(&self, reached: &Reached) -> Result<(), MethodError> {
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
fn less(x: &[Point], d: &[Point]) -> Vec<Point> {
    x.iter().zip(d).map(|(&x, &d)| x - d).collect()
}

/// None where the surface is singular at a point of the rule: it has no gradient there.
fn defined<T>(found: Result<T, EnergyError>) -> Result<Option<T>, EnergyError> {
    match found {
        Ok(found) => Ok(Some(found)),
        Err(EnergyError::Singular { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

/// The direction with the largest sum of squares along all of `normals`, whose signs play no part.
fn common_direction(normals: &[Point]) -> Option<Point> {
    let first = *normals.first()?;
    let mut direction = first;
    if normals.len() > 1 {
        // The sum of all turned alike, then the power method on Σ n nᵀ.
        let turned = |d: Point, n: &Point| if d.dot(*n) < 0.0 { -*n } else { *n };
        direction = normals.iter().fold(Point::ZERO, |sum, n| sum + turned(first, n)).unit()?;
        for _ in 0..8 {
            direction = normals.iter().fold(Point::ZERO, |sum, n| sum + *n * n.dot(direction)).unit()?;
        }
    }
    Some(direction)
}
