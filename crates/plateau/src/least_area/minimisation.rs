//! From a start to the surface of least area: the lowest end of the descents, saddles left behind.

use energy::Integral;
use surfaces::Point;

use super::Mode;
use super::assembly::Assembly;
use super::descent::{Descent, LOOSE, Reached};
use super::outcome::{AreaExtremal, Stage, Start};
use super::rules::Known;
use super::space::Space;
use super::stability::Variation;
use crate::{MethodError, Progress};

/// A second variation below minus this is negative.
const UNSTABLE: f64 = 1e-6;

/// Saddles left one after the other.
const SADDLES: usize = 3;

/// Share of the root of the area by which a saddle is left at first, and how often that is halved.
const LEAVE: f64 = 0.1;
const HALVINGS: usize = 6;

/// The form of the Dirichlet energy over the unit square.
const SQUARES: [f64; 3] = [1.0, 0.0, 1.0];

/// An area below this share of the Dirichlet energy is rounding.
const NO_AREA: f64 = 1e-12;

/// Share of the area by which another surface must have less to count as lower.
const LOWER: f64 = 1e-12;

/// The surface of least area of a space, from `lower` if there is one, else from the start of the space; not above `starts`.
pub(super) fn minimise<S: Space>(
    space: &S,
    lower: Option<&S::Surface>,
    starts: &[S::Surface],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(S::Surface, AreaExtremal), MethodError> {
    let mut descent = Descent::new(space, tolerance, progress)?;
    let (mut start, form) = space.start();
    let mut from = Start::Coons;
    if let Some(form) = form {
        start = descent.dirichlet(&start, form)?;
        from = Start::Dirichlet;
    }
    let reference = start.clone();
    let mut at_hand: Vec<Vec<Point>> =
        starts.iter().map(|surface| space.nodes(surface)).collect::<Result<_, _>>()?;
    // Beside the Coons surface, whatever else is at hand: sometimes it is the better start.
    if form.is_none() && lower.is_none() {
        at_hand.push(descent.dirichlet(&start, SQUARES)?);
    }
    if let Some(lower) = lower {
        (start, from) = (space.nodes(lower)?, Start::AtHand);
    }
    let mut lowest = lowest(&mut descent, start, at_hand, (&reference, lower.is_some()))?;
    if lowest.is_at_hand {
        from = Start::AtHand;
    }
    let best = &mut lowest.reached;
    // After the descent, too: over a border that spans nothing it ends in a surface without area.
    descent.check_area(&best.surface.x)?;
    let mut variation = descent.variation(&best.surface)?;
    let mut left_saddle = false;
    for _ in 0..SADDLES {
        let Some(negative) = variation.as_ref().filter(|v| v.smallest < -UNSTABLE) else { break };
        let Some(lower) = leave_saddle(&mut descent, best, negative, &reference)? else { break };
        variation = descent.variation(&lower.surface)?;
        (*best, left_saddle) = (lower, true);
    }
    let gradients = descent.gradients(&best.surface)?;
    let found = extremal(&descent, best, lowest.start, gradients, left_saddle);
    let jacobian_ratio = best.surface.fine.evenness;
    let second_variation = variation.as_ref().map(|v| v.smallest);
    let mode = variation.map(|v| space.coefficients(&v.displacement)).transpose()?.and_then(Mode::new);
    let found = AreaExtremal { from, jacobian_ratio, second_variation, mode, ..found };
    Ok((space.surface(&best.surface.x)?, found))
}

/// The lowest end of descents, and the area of the surface it began from.
struct Lowest {
    reached: Reached,
    start: f64,
    /// Whether that was another surface than was meant.
    is_at_hand: bool,
}

/// Descends from `start`, or from a better surface `at_hand`, and once more from others that may lead lower. `reference` is the
/// surface from which evenness counts, with whether `start` is near.
fn lowest<S: Space>(
    descent: &mut Descent<'_, '_, S>,
    start: Vec<Point>,
    at_hand: Vec<Vec<Point>>,
    (reference, near): (&[Point], bool),
) -> Result<Lowest, MethodError> {
    // Another surface is a better start if it has less area and its parametrisation is as even.
    let (mut start, mut is_at_hand) = (descent.rules.settled(start)?, false);
    let evenness = start.fine.evenness;
    let mut at_hand =
        at_hand.into_iter().map(|x| descent.rules.settled(x)).collect::<Result<Vec<Known>, _>>()?;
    for other in &at_hand {
        if other.area() < start.area() * (1.0 - LOWER) && other.fine.evenness >= evenness {
            (start, is_at_hand) = (other.clone(), true);
        }
    }
    descent.check(&start.x)?;
    let (mut least, first) = (start.area(), start.x.clone());
    let mut best = descent.run(start, reference, near)?;
    // Below the tolerance at which one valley is as good as another, all are looked into. Of several cells the Dirichlet
    // extremal, every one over a unit square, is a bad start.
    let tolerance = descent.tolerance;
    let all = tolerance < LOOSE && !near && descent.rules.space.topology().cells.len() == 1;
    if all {
        at_hand.push(descent.rules.settled(reference.to_vec())?);
    }
    for other in at_hand.into_iter().filter(|other| other.x != first) {
        let area = other.area();
        let is_lower = area < best.surface.area() * (1.0 - LOWER);
        // Where corrections lead costs little to know, and may lie in another valley.
        let leads_lower = |descent: &mut Descent<'_, '_, S>| -> Result<bool, MethodError> {
            Ok(descent.after_corrections(other.clone())?.area() < best.surface.area() * (1.0 - LOWER))
        };
        if all || is_lower || leads_lower(descent)? {
            let other = descent.run(other, reference, false)?;
            // Of two ends of one valley rounding would choose.
            let enough = if is_lower && !all { 0.0 } else { tolerance.max(LOWER) };
            if other.surface.area() < best.surface.area() * (1.0 - enough) {
                (best, least, is_at_hand) = (other, area, true);
            }
        }
    }
    Ok(Lowest { reached: best, start: least, is_at_hand })
}

/// The lower of the two surfaces that a saddle leads to along its negative direction; none if neither is lower than it.
fn leave_saddle<S: Space>(
    descent: &mut Descent<'_, '_, S>,
    saddle: &Reached,
    variation: &Variation,
    reference: &[Point],
) -> Result<Option<Reached>, MethodError> {
    let normals = descent.normals(&saddle.surface.x)?;
    let mut directions = vec![Point::ZERO; saddle.surface.x.len()];
    let sides = descent.rules.space.topology().sides();
    // Displacements are along the normals: nodes on lines of three cells have none, and stay.
    for (node, f) in variation.displacement.iter().enumerate() {
        if let [normal] = normals[node].directions() {
            directions[node] = *normal * (*f * sides[node]);
        }
    }
    let largest = directions.iter().map(|d| d.norm()).fold(0.0, f64::max);
    let (area, points) = (saddle.surface.area(), saddle.surface.points);
    let mut lowest: Option<Reached> = None;
    // Both ways: the sign of an eigenvector means nothing, and the two may lead to different minima.
    for side in [1.0, -1.0] {
        // Far enough for rounding, near enough for the parabola: halved until the area falls.
        let mut step = side * LEAVE * area.sqrt() / largest;
        for _ in 0..HALVINGS {
            let x: Vec<Point> =
                saddle.surface.x.iter().zip(&directions).map(|(&x, &d)| x + d * step).collect();
            if descent.rules.fine(points, &x)?.area < area {
                let left = descent.rules.settled(x)?;
                let reached = descent.run(left, reference, false)?;
                let bound = lowest.as_ref().map_or(area * (1.0 - LOWER), |lowest| lowest.surface.area());
                if reached.surface.area() < bound {
                    lowest = Some(reached);
                }
                break;
            }
            step *= 0.5;
        }
    }
    Ok(lowest)
}

/// What is told of a surface, in the unit of its border.
fn extremal<S: Space>(
    descent: &Descent<'_, '_, S>,
    reached: &Reached,
    start: f64,
    [gradient, whole_gradient]: [f64; 2],
    left_saddle: bool,
) -> AreaExtremal {
    let square = descent.rules.space.frame().unit().powi(2);
    let stage = |stage: Stage| Stage { gained: stage.gained * square, ..stage };
    let surface = &reached.surface;
    AreaExtremal {
        area: Integral {
            value: surface.area() * square,
            // The rule's error, and the rounding of its sum.
            error: (surface.error + 64.0 * f64::EPSILON * surface.area()) * square,
            points: surface.points,
            settled: descent.resolves(surface),
        },
        start: start * square,
        from: Start::Coons,
        corrections: stage(reached.corrections),
        steps: stage(reached.steps),
        normal_steps: stage(reached.normal_steps),
        gradient,
        whole_gradient,
        iterations: descent.iterations,
        last_iterations: descent.iterations,
        evaluations: descent.evaluations,
        end: reached.end,
        valley: reached.valley,
        jacobian_ratio: 0.0,
        second_variation: None,
        mode: None,
        left_saddle,
        given_up: reached.beyond.max(0.0) * square,
        displacement: None,
    }
}

impl<S: Space> Descent<'_, '_, S> {
    /// That a surface has a normal at the points of the first rule.
    fn check(&mut self, x: &[Point]) -> Result<(), MethodError> {
        let cell = self.rules.cell(self.rules.first())?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        assembly.gradient(&assembly.tangents(x))?;
        self.check_area(x)
    }

    /// That a surface has an area beyond rounding.
    fn check_area(&mut self, x: &[Point]) -> Result<(), MethodError> {
        let cell = self.rules.cell(self.rules.first())?;
        let assembly = Assembly { topology: self.rules.space.topology(), cell: cell.as_ref() };
        let tangents = assembly.tangents(x);
        // The area is at most the Dirichlet energy: far below it the tangents are parallel nearly everywhere.
        let squares = |line: &[[Point; 2]]| {
            let of = |([u, v], w): (&[Point; 2], &f64)| 0.5 * w * (u.dot(*u) + v.dot(*v));
            line.iter().zip(cell.weights()).map(of).sum::<f64>()
        };
        let dirichlet: f64 = tangents.iter().map(|line| squares(line)).sum();
        match assembly.area_of(&tangents) <= NO_AREA * dirichlet {
            true => Err(cell.singular(0).into()),
            false => Ok(()),
        }
    }
}
