//! Newton steps along the normals, to a surface that is stationary.

use energy::Freedom;
use solve::SolveError;
use surfaces::Point;

use super::assembly::{Assembly, Tangents, Unknowns, solve_vectors};
use super::descent::{Descent, ROUNDING, Reached, Step, TRIES, defined, less};
use super::outcome::AreaEnd;
use super::rules::Known;
use super::space::Space;
use crate::MethodError;

/// Newton steps along the normals end once one is predicted to gain no more than this share of the tolerance, or rounding.
const NORMAL_GAIN: f64 = 1e-6;

/// Newton steps along the normals at most.
const NORMAL_STEPS: usize = 20;

impl<S: Space> Descent<'_, '_, S> {
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
                // Where the tangents are parallel a cell has no normal to give.
                if cross.norm() > 16.0 * f64::EPSILON * x_u.norm() * x_v.norm() {
                    around[node].extend(cross.unit());
                }
            }
        }
        let freedom = |node: usize| match (topology.fixed[node], topology.joint[node]) {
            (true, _) => Freedom::Fixed,
            (false, true) => Freedom::Free,
            // Without any normal a node stays: there is no direction to move it along.
            (false, false) => common_direction(&around[node]).map_or(Freedom::Fixed, Freedom::Along),
        };
        Ok((0..x.len()).map(freedom).collect())
    }

    /// Newton steps along the normals, refreshed each time, to a gradient that is rounding.
    pub(super) fn normal_steps(&mut self, reached: &mut Reached) -> Result<(), MethodError> {
        let topology = self.rules.space.topology();
        // Below this the prediction itself is rounding: it falls with the square of the step.
        let enough = (NORMAL_GAIN * self.tolerance).max(1e-2 * ROUNDING);
        let mut shift = 0.0;
        reached.end = AreaEnd::Budget;
        for _ in 0..NORMAL_STEPS {
            self.watch(reached)?;
            // The normals of the surface as it is now: along those of the step before, part of the way would be tangential.
            let unknowns = Unknowns::new(topology, self.normals(&reached.surface.x)?)?;
            let Some(step) = self.normal_step(&reached.surface, &unknowns, &mut shift)? else {
                reached.end = AreaEnd::Rough;
                return Ok(());
            };
            let next = self.rules.known(reached.surface.points, step.x, step.fine)?;
            // The rule may prove too coarse for where the step led; the finer one then decides whether it was a gain.
            let next = self.rules.settle(next)?;
            self.move_rule(reached, next.points)?;
            let (before, after) = (reached.surface.area(), next.area());
            // By the finer rule it was none: the next step is made by that rule.
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
        let cell = self.rules.fine_cell(here.points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let Some(slopes) = defined(assembly.gradient(&here.fine.tangents))? else { return Ok(None) };
        let (rough, tangents) = self.rough(here)?;
        let rough = Assembly { topology, cell: rough.as_ref() };
        if defined(unknowns.hessians(&rough, &tangents, &mut self.hessians))?.is_none() {
            return Ok(None);
        }
        let gradient = unknowns.gather(&slopes);
        self.iterations += 1;
        let mut metrics = Vec::new();
        for _ in 0..TRIES {
            // Metrics cost much and are seldom needed.
            if *shift > 0.0 && metrics.is_empty() {
                metrics = Self::metrics_of(unknowns, &rough, &tangents)?;
            }
            unknowns.shifted(topology, &self.hessians, (*shift, &metrics), &mut self.shifted);
            let mut d = gradient.clone();
            match unknowns.condensation().factor(&self.shifted) {
                Ok(factor) => factor.solve(1, &mut d)?,
                Err(SolveError::NotPositiveDefinite { .. }) => {
                    *shift = (5.0 * *shift).max(1e-3);
                    continue;
                }
                Err(error) => return Err(error.into()),
            }
            // Half of gᵀH⁻¹g: what a parabola would gain.
            let predicted = 0.5 * d.iter().zip(&gradient).map(|(d, g)| d * g).sum::<f64>();
            let x = less(&here.x, &unknowns.scatter(&d));
            let fine = self.rules.fine(here.points, &x)?;
            self.evaluations += 1;
            if fine.area <= here.area() * (1.0 + ROUNDING) {
                // The shift is let go fast: with it convergence is not quadratic.
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
    /// norm over the surface.
    pub(super) fn gradients(&mut self, here: &Known) -> Result<[f64; 2], MethodError> {
        if self.scalar.count() == 0 {
            return Ok([0.0; 2]);
        }
        let cell = self.rules.fine_cell(here.points)?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let gradient = assembly.gradient(&here.fine.tangents)?;
        let normal = Unknowns::new(assembly.topology, self.normals(&here.x)?)?;
        // To the normals and back: the tangential part is gone.
        let along = normal.scatter(&normal.gather(&gradient));
        let (rough, tangents) = self.rough(here)?;
        let rough = Assembly { topology: assembly.topology, cell: rough.as_ref() };
        let metrics = rough.metrics(&tangents)?;
        let area = here.area();
        let mut norms = [0.0; 2];
        // The dual norm gᵀK⁻¹g; K is the same for x, y and z, so one scalar system serves.
        for (norm, part) in norms.iter_mut().zip([&along, &gradient]) {
            let dual = match solve_vectors(&self.scalar, &metrics, part) {
                Ok(dual) => dual,
                Err(MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => return Ok([f64::NAN; 2]),
                Err(error) => return Err(error),
            };
            // Rounding may leave a square of nearly 0 below it.
            let square: f64 = dual.iter().zip(part).map(|(d, g)| d.dot(*g)).sum();
            *norm = (square / area).max(0.0).sqrt();
        }
        Ok(norms)
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
        // Normals at one node are near each other: a few powers are enough.
        for _ in 0..8 {
            direction = normals.iter().fold(Point::ZERO, |sum, n| sum + *n * n.dot(direction)).unit()?;
        }
    }
    Some(direction)
}
