//! Control points near the border.
//!
//! Of the parametrisations of nearly one surface the steps in all coordinates find some whose control points lie far away: a
//! ripple of degree n that hardly shows has control points 2ⁿ times as large. The area alone does not mind. Such a net is pulled
//! towards that of the Coons patch by a share of the squares of all displacements of its control points, the least of a ladder
//! of shares that brings them near, and is then moved along the normals once more.

use std::rc::Rc;

use bases::Matrix;
use energy::Cell;
use solve::SolveError;
use surfaces::Point;

use super::assembly::Assembly;
use super::descent::{Descent, LEAST_SHIFT, LOOSE, ROUNDING, Reached, TRIES, defined, less};
use super::outcome::ValleyEnd;
use super::rules::{Known, Rules};
use super::space::{Space, Topology};
use super::steps::{EVENNESS, Model};
use super::tensor::times;
use crate::MethodError;

/// Nodes of a cell up to which its control points are asked to be near: degree 12. Beyond, ripples that hardly show are worth the last
/// digits for which such degrees are taken, and control points follow from the nodes with rounding.
const MOST_NODES: usize = 13 * 13;

/// The shares by which nets are pulled: the largest, and what the next is of one.
const LARGEST_PULL: f64 = 1e-3;
const SLACKER: f64 = 0.25;
const PULLS: usize = 14;

/// Steps at each at most, and the share of the area that one must promise for another to follow.
const PULLED_STEPS: usize = 8;
const PULLED_GAIN: f64 = 1e-10;

/// The share of the area that is given up at most.
const GIVEN_UP: f64 = 5e-4;

/// How far control points may lie from the border, and how uneven a parametrisation may be.
struct Reach {
    /// From the nodes of a cell to its control points.
    control: Matrix,
    /// The sum of the squares of the control points as a form of the free nodes, for every cell, once it is needed.
    squares: Vec<Vec<f64>>,
    /// The nodes of the border.
    border: Vec<Point>,
    /// A length that the longest edge of no box around the border falls short of.
    size: f64,
    /// Sizes from the border within which all control points are to lie.
    sizes: f64,
    /// Points of the rule by which evenness is judged.
    rule: usize,
    /// The least evenness inside and at the nodes.
    floor: [f64; 2],
}

impl Reach {
    /// That of surfaces over one border, of which `x` is one.
    fn new<S: Space>(space: &S, x: &[Point]) -> Result<Self, MethodError> {
        let topology = space.topology();
        // The nodes of the border lie on it, as its control points need not.
        let fixed = x.iter().zip(&topology.fixed).filter(|(_, fixed)| **fixed);
        let border: Vec<Point> = fixed.map(|(&x, _)| x).collect();
        let across = border.iter().flat_map(|a| border.iter().map(|b| a.distance(*b))).fold(0.0, f64::max);
        let control = space.control()?;
        Ok(Self {
            control,
            squares: Vec::new(),
            border,
            // A box with a diagonal of at least `across` has an edge of at least a √3-th of it.
            size: across / 3f64.sqrt(),
            sizes: 1.0,
            rule: 0,
            floor: [0.0; 2],
        })
    }

    /// The sizes by which the furthest control point lies from the border, 1 if none lies further.
    fn sizes(&self, topology: &Topology, x: &[Point]) -> f64 {
        let of_point = |p: Point| match self.border.iter().any(|b| b.distance(p) <= self.size) {
            true => 1.0,
            false => self.border.iter().map(|b| b.distance(p)).fold(f64::INFINITY, f64::min) / self.size,
        };
        let of_cell = |k| times(&self.control, &topology.of_cell(k, x)).into_iter().map(of_point);
        (0..topology.cells.len()).flat_map(of_cell).fold(1.0, f64::max)
    }

    /// Half the sum of the squares of the control points of a displacement, and its derivative by every node.
    fn pull(&self, topology: &Topology, d: &[Point]) -> (f64, Vec<Point>) {
        let (mut half, mut slopes) = (0.0, vec![Point::ZERO; d.len()]);
        for (nodes, square) in topology.cells.iter().zip(&self.squares) {
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

/// `Σ_c control_ck control_cl` over the nodes k, l wanted: symmetric, positive definite.
fn squares(control: &Matrix, wanted: &[bool]) -> Vec<f64> {
    let column = |k: usize| (0..control.rows()).map(|c| control[(c, k)]).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..control.cols()).filter(|&k| wanted[k]).map(column).collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    columns.iter().flat_map(|a| columns.iter().map(|b| product(a, b))).collect()
}

/// A step towards the least of the area with a share of the squares: from what it began, with its system.
struct Pulled<'x> {
    reach: &'x Reach,
    towards: &'x [Point],
    share: f64,
    shift: f64,
}

impl<S: Space> Descent<'_, '_, S> {
    /// Pulls a surface towards `reference` if its control points lie further from the border than its size, or if it is less even
    /// than a tenth of `reference`, until neither holds. Where no pull does that, it stays. It is never left above `first`. Below
    /// the tolerance [`LOOSE`] the area counts for more.
    pub(super) fn within_reach(
        &mut self,
        reached: &mut Reached,
        reference: &[Point],
        first: Known,
    ) -> Result<(), MethodError> {
        let topology = self.rules.space.topology();
        if self.tolerance < LOOSE || topology.cells.iter().any(|cell| cell.len() > MOST_NODES) {
            return Ok(());
        }
        let mut reach = Reach::new(self.rules.space, reference)?;
        // No more is asked of a surface than the reference has: its own control points may lie further away.
        reach.sizes = reach.sizes(topology, reference);
        // One and the same for all surfaces, whatever they are integrated by.
        reach.rule = Rules::<S>::of_evenness(reached.surface.points);
        reach.floor = self.evenness(reach.rule, reference)?.map(|even| EVENNESS * even);
        if self.fits(&reach, &reached.surface)? {
            return Ok(());
        }
        reach.squares =
            (0..topology.cells.len()).map(|k| squares(&reach.control, &topology.free(k))).collect();
        let unpulled = reached.surface.area();
        // From the first surface with the strongest pull, not from the end of the valley, which the last digits decide.
        let start = Pulled { reach: &reach, towards: reference, share: LARGEST_PULL, shift: LEAST_SHIFT };
        reached.valley = ValleyEnd::Far;
        if let Some(near) = self.slackened(Reached { surface: first.clone(), ..reached.clone() }, start)?
            && near.surface.area() <= unpulled * (1.0 + GIVEN_UP)
        {
            let beyond = near.surface.area() - unpulled;
            *reached = Reached { valley: ValleyEnd::Reach, beyond, ..near };
        }
        // Where that ends above the first surface, this one is moved along its normals alone.
        if reached.surface.area() > first.area() {
            let start = Reached::new(first);
            *reached = Reached { valley: reached.valley, beyond: start.surface.area() - unpulled, ..start };
            self.normal_steps(reached)?;
        }
        Ok(())
    }

    /// The surface within reach that the weakest pull leads to. From the strongest on each goes on from where the one before led:
    /// that is determined by the start, and so are all that follow.
    fn slackened(
        &mut self,
        mut pulled: Reached,
        mut step: Pulled<'_>,
    ) -> Result<Option<Reached>, MethodError> {
        let mut fitting = Vec::new();
        for _ in 0..PULLS {
            self.pulled_steps(&mut pulled, &mut step)?;
            match self.fits(step.reach, &pulled.surface)? {
                true => fitting.push(pulled.clone()),
                // Weaker pulls lead further away: once one does not fit after others did, none does.
                false if !fitting.is_empty() => break,
                false => {}
            }
            step.share *= SLACKER;
        }
        // The weakest first. The steps along the normals may lead out of reach once more.
        while let Some(mut last) = fitting.pop() {
            self.normal_steps(&mut last)?;
            if self.fits(step.reach, &last.surface)? {
                return Ok(Some(last));
            }
        }
        Ok(None)
    }

    fn fits(&mut self, reach: &Reach, surface: &Known) -> Result<bool, MethodError> {
        let even = self.evenness(reach.rule, &surface.x)?;
        let is_even = even.iter().zip(reach.floor).all(|(even, floor)| *even >= floor);
        Ok(is_even && reach.sizes(self.rules.space.topology(), &surface.x) <= reach.sizes)
    }

    /// The least over the mean area density inside, by a rule, and at the nodes, which lie on the border, too.
    fn evenness(&mut self, points: usize, x: &[Point]) -> Result<[f64; 2], MethodError> {
        let topology = self.rules.space.topology();
        let cell = self.rules.cell(points)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let (area, inside) = assembly.measure(&assembly.tangents(x));
        let nodes = Assembly { topology, cell: self.at_nodes()?.as_ref() }.tangents(x);
        let densities = nodes.into_iter().flatten().map(|[x_u, x_v]| x_u.cross(x_v).norm());
        let extent: f64 = cell.weights().iter().sum();
        let mean = area / (extent * topology.cells.len() as f64);
        Ok([inside, densities.fold(f64::INFINITY, f64::min) / mean])
    }

    fn at_nodes(&self) -> Result<Rc<dyn Cell>, MethodError> {
        Ok(Rc::from(self.rules.space.at_nodes()?))
    }

    /// Newton steps in all coordinates to the least of the area with a share of the squares.
    fn pulled_steps(&mut self, reached: &mut Reached, step: &mut Pulled<'_>) -> Result<(), MethodError> {
        let topology = self.rules.space.topology();
        for _ in 0..PULLED_STEPS {
            self.watch(reached)?;
            let here = &reached.surface;
            let cell = self.rules.fine_cell(here.points)?;
            let assembly = Assembly { topology, cell: cell.as_ref() };
            let Some(slopes) = defined(assembly.gradient(&here.fine.tangents))? else { break };
            let Some(model) = self.model(here)? else { break };
            self.iterations += 1;
            let Some((x, promised)) = self.pulled_step(here, &slopes, &model, step)? else { break };
            let next = self.rules.at(here.points, x)?;
            let next = self.rules.settle(next)?;
            reached.steps.steps += 1;
            reached.steps.gained += reached.surface.area() - next.area();
            reached.surface = next;
            step.shift = (0.1 * step.shift).max(LEAST_SHIFT);
            if promised <= PULLED_GAIN * reached.surface.area() {
                break;
            }
        }
        Ok(())
    }

    /// Where one such step leads, and the decrease it promised; none if no step does not enlarge the sum.
    fn pulled_step(
        &mut self,
        here: &Known,
        slopes: &[Point],
        model: &Model,
        step: &mut Pulled<'_>,
    ) -> Result<Option<(Vec<Point>, f64)>, MethodError> {
        let (topology, all) = (self.rules.space.topology(), self.all.clone());
        let (half, pulls) = step.reach.pull(topology, &less(&here.x, step.towards));
        let before = here.area() + step.share * half;
        // The gradient of the area with the share of the squares, which is quadratic: its Hessian is the matrix itself.
        let slopes: Vec<Point> = slopes.iter().zip(&pulls).map(|(&g, &pull)| g + pull * step.share).collect();
        let gradient = all.gather(&slopes);
        for _ in 0..TRIES {
            all.shifted(topology, &self.hessians, (step.shift, &model.metrics), &mut self.shifted);
            all.add_metrics(topology, step.share, &step.reach.squares, &mut self.shifted);
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
            let x = less(&here.x, &all.scatter(&d));
            self.evaluations += 1;
            let fine = self.rules.fine(here.points, &x)?;
            let after = fine.area + step.share * step.reach.pull(topology, &less(&x, step.towards)).0;
            if after <= before * (1.0 + ROUNDING) {
                let promised = 0.5 * d.iter().zip(&gradient).map(|(d, g)| d * g).sum::<f64>();
                return Ok(Some((x, promised)));
            }
            step.shift = step.shift.max(1e-8) * 5.0;
        }
        Ok(None)
    }
}
