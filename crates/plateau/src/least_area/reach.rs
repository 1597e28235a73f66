//! Control points near the border.
//!
//! Of the parametrisations of nearly one surface the steps in all coordinates find some whose control points lie far away: a
//! ripple of degree n that hardly shows has control points 2ⁿ times as large. The area alone does not mind. Such a net is pulled
//! towards that of the Coons patch by a share of the squares of all displacements of its control points, the least of a ladder
//! of shares that brings them near, and is then moved along the normals once more. Where nets are tame a few leaps lead down
//! that ladder.

use std::rc::Rc;

use bases::Matrix;
use energy::Cell;
use surfaces::Point;

use super::assembly::Assembly;
use super::descent::{Descent, LEAST_SHIFT, LOOSE, Reached};
use super::outcome::ValleyEnd;
use super::pulled_steps::{Pulled, Squares};
use super::rules::{Known, Rules};
use super::space::{Space, Topology};
use super::steps::EVENNESS;
use super::tensor::times;
use crate::MethodError;

/// Nodes of a cell up to which its control points are asked to be near: degree 12. Beyond, ripples that hardly show are worth the last
/// digits for which such degrees are taken, and control points follow from the nodes with rounding.
const MOST_NODES: usize = 13 * 13;

/// The shares by which nets are pulled: the largest, and what the next is of one.
const LARGEST_PULL: f64 = 1e-3;
const SLACKER: f64 = 0.25;
const PULLS: usize = 14;

/// Steps at each share at most.
const PULLED_STEPS: usize = 8;

/// Share of the evenness asked for below which no weaker pull mends where the strongest led, and any other.
const HOPELESS: [f64; 2] = [1e-2, 0.5];

/// The shares that are leapt to, the last of them the least, with the steps at each and those with each factorisation at most.
const LEAPS: [i32; 4] = [3, 6, 9, PULLS as i32 - 1];
const LEAP_STEPS: usize = 2;
const REUSED: usize = 10;

/// The share of the area that is given up at most.
const GIVEN_UP: f64 = 5e-4;

/// How far control points may lie from the border, and how uneven a parametrisation may be.
struct Reach {
    /// From the nodes of a cell to its control points.
    control: Matrix,
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
    /// That of surfaces over one border, of which `x` is one; none where nothing is asked of control points.
    fn new<S: Space>(space: &S, x: &[Point]) -> Result<Option<Self>, MethodError> {
        let Some(control) = space.control()? else { return Ok(None) };
        let topology = space.topology();
        // The nodes of the border lie on it, as its control points need not.
        let fixed = x.iter().zip(&topology.fixed).filter(|(_, fixed)| **fixed);
        let border: Vec<Point> = fixed.map(|(&x, _)| x).collect();
        let across = border.iter().flat_map(|a| border.iter().map(|b| a.distance(*b))).fold(0.0, f64::max);
        Ok(Some(Self {
            control,
            border,
            // A box with a diagonal of at least `across` has an edge of at least a √3-th of it.
            size: across / 3f64.sqrt(),
            sizes: 1.0,
            rule: 0,
            floor: [0.0; 2],
        }))
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
}

/// How a surface meets what is asked of it.
struct Fit {
    /// Its evenness over the least that is asked.
    evenness: f64,
    /// Whether its control points are near.
    is_near: bool,
}

impl Fit {
    fn is_good(&self) -> bool {
        self.evenness >= 1.0 && self.is_near
    }
}

impl<S: Space> Descent<'_, '_, S> {
    /// Pulls a surface towards `reference` if its control points lie further from the border than its size, or if it is less even
    /// than a tenth of `reference`, until neither holds. Where no pull does that, it stays. It is never left above `first`. Below
    /// the tolerance [`LOOSE`] the area counts for more.
    pub(super) fn within_reach(
        &mut self,
        reached: &mut Reached,
        reference: &[Point],
        [first, corrected]: [Known; 2],
    ) -> Result<(), MethodError> {
        let topology = self.rules.space.topology();
        if self.tolerance < LOOSE || topology.cells.iter().any(|cell| cell.len() > MOST_NODES) {
            return Ok(());
        }
        let Some(mut reach) = Reach::new(self.rules.space, reference)? else { return Ok(()) };
        // No more is asked of a surface than the reference has: its own control points may lie further away.
        reach.sizes = reach.sizes(topology, reference);
        // One and the same for all surfaces, whatever they are integrated by.
        reach.rule = Rules::<S>::of_evenness(reached.surface.points);
        reach.floor = self.evenness(reach.rule, reference)?.map(|even| EVENNESS * even);
        if self.fits(&reach, &reached.surface)? {
            return Ok(());
        }
        let squares = Squares::new(topology, &reach.control);
        let unpulled = reached.surface.area();
        // From the first surface with the strongest pull, not from the end of the valley, which the last digits decide.
        let start = Pulled {
            squares: &squares,
            towards: reference,
            share: LARGEST_PULL,
            shift: LEAST_SHIFT,
            most: PULLED_STEPS,
            reused: 0,
        };
        reached.valley = ValleyEnd::Far;
        let near = match self.leapt(&reach, Reached { surface: corrected, ..reached.clone() }, &start)? {
            Some(near) => Some(near),
            None => self.slackened(&reach, Reached { surface: first.clone(), ..reached.clone() }, start)?,
        };
        if let Some(near) = near
            && near.surface.area() <= unpulled * (1.0 + GIVEN_UP)
        {
            let beyond = near.surface.area() - unpulled;
            *reached = Reached { valley: ValleyEnd::Reach, beyond, ..near };
        }
        // Where that ends above the first surface, this one is moved along its normals alone.
        if reached.surface.area() > first.area() {
            *reached = Reached::new(first);
            self.normal_steps(reached)?;
            (reached.valley, reached.beyond) = match self.fits(&reach, &reached.surface)? {
                true => (ValleyEnd::Reach, reached.surface.area() - unpulled),
                false => (ValleyEnd::Far, 0.0),
            };
        }
        Ok(())
    }

    /// The surface that the weakest pull leads to from one that is near, by leaps over most of the ladder: none if one of them does not
    /// come to its end, or if the last ends out of reach. So it is where nets are tame, and costs a fraction of the ladder.
    fn leapt(
        &mut self,
        reach: &Reach,
        mut pulled: Reached,
        step: &Pulled<'_>,
    ) -> Result<Option<Reached>, MethodError> {
        for rung in LEAPS {
            let share = LARGEST_PULL * SLACKER.powi(rung);
            let mut step = Pulled { share, most: LEAP_STEPS, reused: REUSED, ..*step };
            if !self.pulled_steps(&mut pulled, &mut step)? || !self.fits(reach, &pulled.surface)? {
                return Ok(None);
            }
        }
        self.normal_steps(&mut pulled)?;
        Ok(self.fits(reach, &pulled.surface)?.then_some(pulled))
    }

    /// The surface within reach that the weakest pull leads to. From the strongest on each goes on from where the one before led:
    /// that is determined by the start, and so are all that follow.
    fn slackened(
        &mut self,
        reach: &Reach,
        mut pulled: Reached,
        mut step: Pulled<'_>,
    ) -> Result<Option<Reached>, MethodError> {
        let mut fitting = Vec::new();
        for pull in 0..PULLS {
            // A pull before may have asked for a finer rule.
            self.rough = self.rules.first();
            pulled.surface = self.rules.settled(pulled.surface.x)?;
            self.pulled_steps(&mut pulled, &mut step)?;
            let fit = self.fit(reach, &pulled.surface)?;
            match fit.is_good() {
                true => fitting.push(pulled.clone()),
                // Weaker pulls lead further away: once one does not fit after others did, none does.
                false if !fitting.is_empty() || fit.evenness < HOPELESS[pull.min(1)] => break,
                false => {}
            }
            step.share *= SLACKER;
        }
        // The weakest first. The steps along the normals may lead out of reach once more.
        while let Some(mut last) = fitting.pop() {
            self.normal_steps(&mut last)?;
            if self.fits(reach, &last.surface)? {
                return Ok(Some(last));
            }
        }
        Ok(None)
    }

    fn fits(&mut self, reach: &Reach, surface: &Known) -> Result<bool, MethodError> {
        Ok(self.fit(reach, surface)?.is_good())
    }

    fn fit(&mut self, reach: &Reach, surface: &Known) -> Result<Fit, MethodError> {
        let even = self.evenness(reach.rule, &surface.x)?;
        let evenness =
            even.iter().zip(reach.floor).map(|(even, floor)| even / floor).fold(f64::INFINITY, f64::min);
        let is_near = reach.sizes(self.rules.space.topology(), &surface.x) <= reach.sizes;
        Ok(Fit { evenness, is_near })
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
}
