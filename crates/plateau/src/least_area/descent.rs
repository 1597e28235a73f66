//! The stages of a minimisation: metric corrections, Newton steps in all coordinates, Newton steps along the normals.

use energy::{EnergyError, Freedom};
use solve::SolveError;
use surfaces::Point;

use super::assembly::{Assembly, Tangents, Unknowns, solve_vectors};
use super::outcome::{AreaEnd, Stage, ValleyEnd};
use super::rules::{Rules, Settled};
use super::space::Space;
use crate::MethodError;
use crate::Progress;

/// Metric corrections at most, and the share of the area one must gain for another to follow.
const CORRECTIONS: usize = 24;
const CORRECTION_GAIN: f64 = 1e-4;

/// Newton steps in all coordinates at most, from this tolerance on; twice as many more for every digit below it.
const STEPS: usize = 40;
const LOOSE: f64 = 1e-10;

/// Steps running that gain less than the tolerance after which it is reached; more for every digit below [`LOOSE`].
const IDLE: usize = 2;

/// Share of the Dirichlet product in the first of them, and the least.
const FIRST_SHIFT: f64 = 1e-2;
const LEAST_SHIFT: f64 = 1e-9;

/// Steps with at most this share are those of Newton's method, but for the flattest directions.
const TRUSTED_SHIFT: f64 = 3e-4;

/// Factorisations and evaluations tried for one step.
const TRIES: usize = 14;

/// Steps with one factorisation at most, beyond the first.
const CORRECTED: usize = 10;

/// Newton steps along the normals at most.
const NORMAL_STEPS: usize = 20;

/// A predicted decrease below this share of the area is rounding.
const ROUNDING: f64 = 1e-14;

/// Steps taken once nothing beyond rounding is to be gained: what has a curvature is then exact to rounding; and the share of
/// the Dirichlet product in them, which leaves what has none where it is.
const LAST_STEPS: usize = 2;
const LAST_SHIFT: f64 = 1e-7;

/// Share of the start's evenness (least over mean of the area densities) below which steps do not lead, from a tolerance of
/// [`LOOSE`] on; a digit less for every digit below it.
const EVENNESS: f64 = 0.1;

/// A surface on its way down.
pub(super) struct Descent<'a, 'p, S: Space> {
    pub(super) rules: Rules<'a, S>,
    pub(super) progress: &'p dyn Progress,
    pub(super) tolerance: f64,
    scalar: Unknowns,
    all: Unknowns,
    pub(super) iterations: usize,
    pub(super) evaluations: usize,
}

/// Where a descent ended.
#[derive(Debug, Clone)]
pub(super) struct Reached {
    pub(super) x: Vec<Point>,
    pub(super) settled: Settled,
    pub(super) corrections: Stage,
    pub(super) steps: Stage,
    pub(super) normal_steps: Stage,
    pub(super) end: AreaEnd,
    pub(super) valley: ValleyEnd,
}

/// A step in all coordinates.
struct Step {
    x: Vec<Point>,
    area: f64,
    /// The decrease predicted, and what of it came true.
    predicted: f64,
    quality: f64,
}

/// A surface with what a step needs of it.
struct Here {
    tangents: Tangents,
    gradient: Vec<Point>,
}

impl<'a, 'p, S: Space> Descent<'a, 'p, S> {
    pub(super) fn new(space: &'a S, tolerance: f64, progress: &'p dyn Progress) -> Result<Self, MethodError> {
        let topology = space.topology();
        Ok(Self {
            rules: Rules::new(space),
            progress,
            tolerance,
            scalar: Unknowns::scalar(topology)?,
            all: Unknowns::all(topology)?,
            iterations: 0,
            evaluations: 0,
        })
    }

    pub(super) fn scalar(&self) -> &Unknowns {
        &self.scalar
    }

    /// All three stages from `x`; evenness counts from that of `reference`.
    pub(super) fn run(&mut self, x: Vec<Point>, reference: &[Point]) -> Result<Reached, MethodError> {
        let settled = self.rules.settle(self.rules.first(), &x)?;
        let mut reached = Reached {
            x,
            settled,
            corrections: Stage::default(),
            steps: Stage::default(),
            normal_steps: Stage::default(),
            end: AreaEnd::Stationary,
            valley: ValleyEnd::Rounding,
        };
        if self.scalar.count() == 0 {
            return Ok(reached);
        }
        self.corrections(&mut reached)?;
        self.steps(&mut reached, reference)?;
        self.normal_steps(&mut reached)?;
        Ok(reached)
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
            let cell = self.rules.cell(reached.settled.points)?;
            let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
            let tangents = assembly.tangents(&reached.x);
            let Some(gradient) = defined(assembly.gradient(&tangents))? else { break };
            let metrics = assembly.metrics(&tangents)?;
            self.iterations += 1;
            let change = match solve_vectors(&self.scalar, &metrics, &gradient) {
                Ok(change) => change,
                // A metric that is singular to working precision leads nowhere.
                Err(MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => break,
                Err(error) => return Err(error),
            };
            let x: Vec<Point> = reached.x.iter().zip(change).map(|(&x, d)| x - d).collect();
            let settled = self.rules.settle(reached.settled.points, &x)?;
            self.evaluations += 1;
            let before = self.same_rule(reached, settled.points)?;
            let gained = before - settled.area;
            // A gain within the error of the rule is none.
            if gained.is_nan() || gained <= settled.error.max(ROUNDING * before) {
                break;
            }
            reached.corrections.steps += 1;
            reached.corrections.gained += gained;
            (reached.x, reached.settled) = (x, settled);
            if gained < CORRECTION_GAIN * before {
                break;
            }
        }
        Ok(())
    }

    /// The area of the surface reached by the rule of `points`, to which it is moved on.
    fn same_rule(&mut self, reached: &mut Reached, points: usize) -> Result<f64, MethodError> {
        if reached.settled.points != points {
            reached.settled = self.rules.compare(points, &reached.x)?;
        }
        Ok(reached.settled.area)
    }

    fn here(&mut self, reached: &Reached) -> Result<Option<Here>, MethodError> {
        let cell = self.rules.cell(reached.settled.points)?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let tangents = assembly.tangents(&reached.x);
        Ok(defined(assembly.gradient(&tangents))?.map(|gradient| Here { tangents, gradient }))
    }

    fn evenness(&mut self, points: usize, x: &[Point]) -> Result<f64, MethodError> {
        let cell = self.rules.cell(Rules::<S>::finer(points))?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        Ok(assembly.jacobian_ratio(&assembly.tangents(x)))
    }

    /// Levenberg–Marquardt steps `(H + λK) d = −∇A` in all coordinates, K the Dirichlet product over the surface, until two
    /// running gain less than the tolerance. A step is judged by the finer rule, so that none exploits what the rule misses.
    fn steps(&mut self, reached: &mut Reached, reference: &[Point]) -> Result<(), MethodError> {
        let (mut shift, mut idle, mut last) = (FIRST_SHIFT, 0, 0);
        let digits = (LOOSE / self.tolerance).log10().max(0.0);
        let share = EVENNESS * 10f64.powf(-digits);
        let mut floor = share * self.evenness(reached.settled.points, reference)?;
        reached.valley = ValleyEnd::Budget;
        for _ in 0..STEPS + (2.0 * STEPS as f64 * digits) as usize {
            self.watch(reached)?;
            let Some(here) = self.here(reached)? else { break };
            let Some(Step { x, area, predicted, quality }) = self.step(reached, &here, &mut shift)? else {
                reached.valley = ValleyEnd::Rounding;
                return Ok(());
            };
            let used = shift;
            if predicted <= ROUNDING * area {
                reached.x = x;
                last += 1;
                if last == LAST_STEPS {
                    reached.valley = ValleyEnd::Rounding;
                    return Ok(());
                }
                continue;
            }
            let gained = reached.settled.area - area;
            if self.evenness(reached.settled.points, &x)? < floor {
                reached.valley = ValleyEnd::Ratio;
                return Ok(());
            }
            let settled = self.rules.settle(reached.settled.points, &x)?;
            if settled.points != reached.settled.points {
                floor = share * self.evenness(settled.points, reference)?;
                // What the coarser rules promised is no gain if the finer ones do not see it.
                let before = self.same_rule(reached, settled.points)?;
                if before <= settled.area {
                    shift *= 4.0;
                    continue;
                }
            }
            reached.steps.steps += 1;
            reached.steps.gained += gained;
            (reached.x, reached.settled) = (x, settled);
            if quality > 0.75 {
                shift = (0.3 * shift).max(LEAST_SHIFT);
            } else if quality < 0.25 {
                shift *= 4.0;
            }
            idle = match gained > self.tolerance * area {
                true => 0,
                // A step that was held back by the shift says nothing of what is left.
                false => idle + usize::from(used <= TRUSTED_SHIFT),
            };
            if idle >= IDLE + (2.0 * digits) as usize {
                reached.valley = ValleyEnd::Tolerance;
                return Ok(());
            }
        }
        Ok(())
    }

    /// One step that lowers the area, or promises no more than rounding. None if there is none.
    fn step(&mut self, reached: &Reached, here: &Here, shift: &mut f64) -> Result<Option<Step>, MethodError> {
        let (points, topology) = (reached.settled.points, self.rules.space.topology());
        let cell = self.rules.cell(points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let hessians = self.all.hessians(&assembly, &here.tangents)?;
        let metrics = assembly.metrics(&here.tangents)?;
        let gradient = self.all.gather(&here.gradient);
        self.iterations += 1;
        for _ in 0..TRIES {
            let mut matrices = hessians.clone();
            self.all.add_metrics(topology, *shift, &metrics, &mut matrices);
            let factor = match self.all.condensation().factor(&matrices) {
                Ok(factor) => factor,
                Err(SolveError::NotPositiveDefinite { .. }) => {
                    *shift = shift.max(1e-8) * 6.0;
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            let mut d = gradient.clone();
            factor.solve(1, &mut d)?;
            let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
            let change = self.all.scatter(&d);
            let square = assembly.metric_square(&here.tangents, &change)?;
            // −gᵀd − ½ dᵀHd with Hd = −g − λKd.
            let predicted = 0.5 * (slope + *shift * square);
            let small = predicted <= ROUNDING * reached.settled.area;
            if small && *shift != LAST_SHIFT {
                *shift = LAST_SHIFT;
                continue;
            }
            let mut x: Vec<Point> = reached.x.iter().zip(&change).map(|(&x, &d)| x - d).collect();
            let mut area = self.rules.fine_area(points, &x)?;
            self.evaluations += 1;
            // A step along the curved valley leaves its floor; the same system leads back, and on.
            for _ in 0..if small { 0 } else { CORRECTED } {
                let Some(slopes) = defined(assembly.gradient(&assembly.tangents(&x)))? else { break };
                let mut d = self.all.gather(&slopes);
                factor.solve(1, &mut d)?;
                let next: Vec<Point> = x.iter().zip(self.all.scatter(&d)).map(|(&x, d)| x - d).collect();
                let lower = self.rules.fine_area(points, &next)?;
                self.evaluations += 1;
                let gained = area - lower;
                if gained.is_nan() || gained <= ROUNDING * area {
                    break;
                }
                let so_far = reached.settled.area - area;
                (x, area) = (next, lower);
                if gained < 0.1 * so_far {
                    break;
                }
            }
            let quality = (reached.settled.area - area) / predicted;
            if quality > 1e-4 || small && area <= reached.settled.area * (1.0 + ROUNDING) {
                return Ok(Some(Step { x, area, predicted, quality }));
            }
            *shift = shift.max(1e-8) * 5.0;
        }
        Ok(None)
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
        let mut shift = 0.0;
        reached.end = AreaEnd::Budget;
        for _ in 0..NORMAL_STEPS {
            self.watch(reached)?;
            let Some(here) = self.here(reached)? else {
                reached.end = AreaEnd::Rough;
                return Ok(());
            };
            let unknowns = Unknowns::new(topology, self.normals(&reached.x)?)?;
            let Some((x, area, predicted)) = self.normal_step(reached, &here, &unknowns, &mut shift)? else {
                reached.end = AreaEnd::Rough;
                return Ok(());
            };
            let gained = reached.settled.area - area;
            let settled = self.rules.settle(reached.settled.points, &x)?;
            if settled.points != reached.settled.points
                && self.same_rule(reached, settled.points)? * (1.0 + ROUNDING) < settled.area
            {
                continue;
            }
            reached.normal_steps.steps += 1;
            reached.normal_steps.gained += gained;
            (reached.x, reached.settled) = (x, settled);
            // The next step would be the square of this one.
            if predicted <= 1e-2 * ROUNDING * reached.settled.area && shift == 0.0 {
                reached.end = AreaEnd::Stationary;
                return Ok(());
            }
        }
        Ok(())
    }

    /// One Newton step along the normals: where it leads, the area there, the decrease predicted. The Dirichlet product is
    /// added only if the Hessian is indefinite or the step enlarges the area.
    fn normal_step(
        &mut self,
        reached: &Reached,
        here: &Here,
        unknowns: &Unknowns,
        shift: &mut f64,
    ) -> Result<Option<(Vec<Point>, f64, f64)>, MethodError> {
        let (points, topology) = (reached.settled.points, self.rules.space.topology());
        let cell = self.rules.cell(points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let hessians = unknowns.hessians(&assembly, &here.tangents)?;
        let gradient = unknowns.gather(&here.gradient);
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
            let change = unknowns.scatter(&d);
            let x: Vec<Point> = reached.x.iter().zip(&change).map(|(&x, &d)| x - d).collect();
            let area = self.rules.fine_area(points, &x)?;
            self.evaluations += 1;
            if area <= reached.settled.area * (1.0 + ROUNDING) {
                *shift = if *shift > 1e-6 { 0.1 * *shift } else { 0.0 };
                return Ok(Some((x, area, predicted)));
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
            reached.settled.area * unit * unit
        ));
        Ok(())
    }
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
