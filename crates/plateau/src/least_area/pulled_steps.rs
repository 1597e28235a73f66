//! Newton steps in all coordinates to the least of the area with a share of the squares of displacements of control points.

use bases::Matrix;
use solve::SolveError;
use surfaces::Point;

use super::assembly::Assembly;
use super::descent::{Descent, LEAST_SHIFT, ROUNDING, Reached, TRIES, defined, less};
use super::rules::{Fine, Known};
use super::space::{Space, Topology};
use super::steps::Model;
use crate::MethodError;

/// The share of the area that a step must promise for another to follow.
const PULLED_GAIN: f64 = 1e-10;

/// The sum of the squares of the control points, as a form of the free nodes of every cell.
pub(super) struct Squares {
    of_cells: Vec<Vec<f64>>,
}

impl Squares {
    /// Those of `control`, from the nodes of a cell to its control points: `Σ_c control_ck control_cl`, symmetric, positive definite.
    pub(super) fn new(topology: &Topology, control: &Matrix) -> Self {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let of_cell = |cell: usize| {
            let free = topology.free(cell);
            let column = |k: usize| (0..control.rows()).map(|c| control[(c, k)]).collect::<Vec<f64>>();
            let columns: Vec<Vec<f64>> = (0..control.cols()).filter(|&k| free[k]).map(column).collect();
            columns.iter().flat_map(|a| columns.iter().map(|b| product(a, b))).collect()
        };
        Self { of_cells: (0..topology.cells.len()).map(of_cell).collect() }
    }

    /// Half of it for a displacement, and its derivative by every node.
    fn half(&self, topology: &Topology, d: &[Point]) -> (f64, Vec<Point>) {
        let (mut half, mut slopes) = (0.0, vec![Point::ZERO; d.len()]);
        for (nodes, square) in topology.cells.iter().zip(&self.of_cells) {
            let free: Vec<usize> = nodes.iter().copied().filter(|&node| !topology.fixed[node]).collect();
            for (row, &node) in square.chunks_exact(free.len().max(1)).zip(&free) {
                let slope = row.iter().zip(&free).fold(Point::ZERO, |sum, (&c, &l)| sum + d[l] * c);
                half += 0.5 * d[node].dot(slope);
                slopes[node] += slope;
            }
        }
        (half, slopes)
    }
}

/// What such steps lead towards, with the share of the squares and that of the Dirichlet product, which the steps change.
#[derive(Clone, Copy)]
pub(super) struct Pulled<'x> {
    pub(super) squares: &'x Squares,
    /// The surface from which displacements count.
    pub(super) towards: &'x [Point],
    pub(super) share: f64,
    pub(super) shift: f64,
    /// Factorisations at most, and steps with each beyond the first.
    pub(super) most: usize,
    pub(super) reused: usize,
}

/// Where a step led.
struct Led {
    x: Vec<Point>,
    fine: Fine,
    /// The area with the share of the squares.
    sum: f64,
    /// The decrease of that which the step promised.
    promised: f64,
}

impl<S: Space> Descent<'_, '_, S> {
    /// Such steps from a surface; whether they end where none promises more.
    pub(super) fn pulled_steps(
        &mut self,
        reached: &mut Reached,
        step: &mut Pulled<'_>,
    ) -> Result<bool, MethodError> {
        for _ in 0..step.most {
            self.watch(reached)?;
            let points = reached.surface.points;
            let Some(model) = self.model(&reached.surface)? else { break };
            self.iterations += 1;
            let Some(led) = self.pulled_step(&reached.surface, &model, step)? else { break };
            let next = self.rules.known(points, led.x, led.fine)?;
            let next = self.rules.settle(next)?;
            reached.steps.steps += 1;
            reached.steps.gained += reached.surface.area() - next.area();
            reached.surface = next;
            step.shift = (0.1 * step.shift).max(LEAST_SHIFT);
            if led.promised <= PULLED_GAIN * reached.surface.area() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Where one such step leads, and others with its factorisation; none if no step does not enlarge the sum.
    fn pulled_step(
        &mut self,
        here: &Known,
        model: &Model,
        step: &mut Pulled<'_>,
    ) -> Result<Option<Led>, MethodError> {
        let (topology, all, points) = (self.rules.space.topology(), self.all.clone(), here.points);
        let Some(gradient) = self.pulled_gradient(points, &here.x, &here.fine, step)? else {
            return Ok(None);
        };
        let before = here.area() + step.share * self.pull(step, &here.x).0;
        for _ in 0..TRIES {
            all.shifted(topology, &self.hessians, (step.shift, &model.metrics), &mut self.shifted);
            // The squares are quadratic: their Hessian is the matrix itself.
            all.add_metrics(topology, step.share, &step.squares.of_cells, &mut self.shifted);
            let factor = match all.condensation().factor(&self.shifted) {
                Ok(factor) => factor,
                Err(SolveError::NotPositiveDefinite { .. }) => {
                    step.shift = step.shift.max(1e-8) * 6.0;
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            let mut d = gradient.clone();
            factor.solve(1, &mut d)?;
            let mut led = self.led(points, &here.x, (&d, &gradient), step)?;
            if led.sum > before * (1.0 + ROUNDING) {
                step.shift = step.shift.max(1e-8) * 5.0;
                continue;
            }
            for _ in 0..step.reused {
                if led.promised <= PULLED_GAIN * led.fine.area {
                    break;
                }
                let Some(mut d) = self.pulled_gradient(points, &led.x, &led.fine, step)? else { break };
                let gradient = d.clone();
                factor.solve(1, &mut d)?;
                let next = self.led(points, &led.x, (&d, &gradient), step)?;
                if next.sum.is_nan() || next.sum >= led.sum {
                    break;
                }
                led = next;
            }
            return Ok(Some(led));
        }
        Ok(None)
    }

    /// Where the step −d from a surface leads, given the gradient there.
    fn led(
        &mut self,
        points: usize,
        x: &[Point],
        (d, gradient): (&[f64], &[f64]),
        step: &Pulled<'_>,
    ) -> Result<Led, MethodError> {
        self.evaluations += 1;
        let x = less(x, &self.all.scatter(d));
        let fine = self.rules.fine(points, &x)?;
        let sum = fine.area + step.share * self.pull(step, &x).0;
        let promised = 0.5 * d.iter().zip(gradient).map(|(d, g)| d * g).sum::<f64>();
        Ok(Led { x, fine, sum, promised })
    }

    /// The gradient of the area with the share of the squares; none where the surface is singular.
    fn pulled_gradient(
        &mut self,
        points: usize,
        x: &[Point],
        fine: &Fine,
        step: &Pulled<'_>,
    ) -> Result<Option<Vec<f64>>, MethodError> {
        let cell = self.rules.fine_cell(points)?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let Some(slopes) = defined(assembly.gradient(&fine.tangents))? else { return Ok(None) };
        let (_, pulls) = self.pull(step, x);
        let sums: Vec<Point> = slopes.iter().zip(&pulls).map(|(&g, &pull)| g + pull * step.share).collect();
        Ok(Some(self.all.gather(&sums)))
    }

    /// Half the squares of a surface, and their derivative.
    fn pull(&self, step: &Pulled<'_>, x: &[Point]) -> (f64, Vec<Point>) {
        step.squares.half(self.rules.space.topology(), &less(x, step.towards))
    }
}
