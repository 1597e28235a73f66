//! Surfaces of least area over a border that stays.
//!
//! A surface is known by its points at the nodes of its cells ([`space`]). From a Coons patch (of triangles the Dirichlet
//! extremal) metric corrections lead near, a bounded number of Newton steps in all coordinates nearer, and Newton steps along
//! the normals to a stationary surface ([`descent`]). The valley of surfaces that differ only by moving points along them has
//! no end; where in it the surface stays is what the corrections and the bounded steps give, which depends continuously on the
//! border and neither on its place nor on its unit. All is judged by rules as fine as the surface asks ([`rules`]).

mod assembly;
mod complex;
mod descent;
mod estimate;
mod family;
mod outcome;
mod raised;
mod rules;
mod space;
mod stability;
mod tensor;
#[cfg(test)]
mod tests;
mod triangle;

use energy::Integral;
use surfaces::{Complex, Point, TensorPatch, TrianglePatch};

pub(crate) use estimate::costs_less;
pub use estimate::{
    AreaEstimate, NoEstimate, estimate_complex, estimate_net, estimate_triangle, excess_of_complex,
    excess_of_net, excess_of_triangle,
};
pub use outcome::{AreaEnd, AreaExtremal, Stage, Start, ValleyEnd};
pub use raised::{least_area_raised, least_area_triangle_raised};

use crate::{MethodError, Progress};
use assembly::Assembly;
use complex::Glued;
use descent::{Descent, LOOSE, Reached};
use space::Space;
use stability::Variation;
use tensor::{Separated, Sums};
use triangle::Triangular;

/// A second variation below minus this is negative.
const UNSTABLE: f64 = 1e-6;

/// Saddles left one after the other.
const SADDLES: usize = 3;

/// Share of the root of the area by which a saddle is left at first, and how often that is halved.
const LEAVE: f64 = 0.1;
const HALVINGS: usize = 6;

/// Relative change of the area by a finer rule below which the rule is said to resolve it; a tenth of the tolerance where that
/// is more.
const RESOLVED: f64 = 1e-9;

/// The form of the Dirichlet energy over the unit square.
const SQUARES: [f64; 3] = [1.0, 0.0, 1.0];

/// An area below this share of the Dirichlet energy is rounding.
const NO_AREA: f64 = 1e-12;

/// Share of the area by which another surface must have less to count as lower.
const LOWER: f64 = 1e-12;

/// The patch of least area on the border of `patch`, among the nets of its families. The free points of `patch` play no part.
/// `tolerance` is the relative decrease of the area that counts as none while points may still move along the surface.
/// `progress` hears of every step.
///
/// # Errors
/// [`MethodError::Energy`] with [`energy::EnergyError::Singular`] if the start has parallel tangents at a point of
/// the rule, [`MethodError::Solve`] if the functions depend on each other to working precision,
/// [`MethodError::Interrupted`] if `progress` cancels.
pub fn least_area(
    patch: &TensorPatch,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    least_area_from(patch, &[], tolerance, progress)
}

/// As [`least_area`], not above any of `starts`: patches of the same families over the same border that are at hand.
///
/// # Errors
/// As [`least_area`].
pub fn least_area_from(
    patch: &TensorPatch,
    starts: &[TensorPatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    match patch.products() {
        [product] => minimise(&Separated::new(patch, product)?, None, starts, tolerance, progress),
        _ => minimise(&Sums::new(patch)?, None, starts, tolerance, progress),
    }
}

/// The triangular patch of least area on the border of `patch`: as [`least_area`].
///
/// # Errors
/// As [`least_area`].
pub fn least_area_triangle(
    patch: &TrianglePatch,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TrianglePatch, AreaExtremal), MethodError> {
    least_area_triangle_from(patch, &[], tolerance, progress)
}

/// As [`least_area_triangle`], not above any of `starts`.
///
/// # Errors
/// As [`least_area`].
pub fn least_area_triangle_from(
    patch: &TrianglePatch,
    starts: &[TrianglePatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TrianglePatch, AreaExtremal), MethodError> {
    minimise(&Triangular::new(patch.net())?, None, starts, tolerance, progress)
}

/// The complex of least area with the faces, edges and fixed points of `complex`, which is the start: as [`least_area`]. Where
/// three and more faces meet along an edge, the edge moves to where their areas balance.
///
/// # Errors
/// As [`least_area`].
pub fn least_area_complex(
    complex: &Complex,
    starts: &[Complex],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(Complex, AreaExtremal), MethodError> {
    minimise(&Glued::new(complex)?, None, starts, tolerance, progress)
}

/// As [`least_area_complex`], from a complex that is near that of least area, such as a finer one on the surface of another.
///
/// # Errors
/// As [`least_area`].
pub fn least_area_complex_near(
    complex: &Complex,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(Complex, AreaExtremal), MethodError> {
    minimise(&Glued::new(complex)?, Some(complex), &[], tolerance, progress)
}

/// The complex with the faces, edges and fixed points of `complex` whose Dirichlet energy ½∫(E + G) is least, every face over
/// a unit square.
///
/// # Errors
/// [`MethodError::Solve`] if the functions depend on each other to working precision.
pub fn dirichlet_complex(complex: &Complex, progress: &dyn Progress) -> Result<Complex, MethodError> {
    let space = Glued::new(complex)?;
    let (start, _) = space.start();
    let extremal = Descent::new(&space, 1.0, progress)?.dirichlet(&start, [1.0, 0.0, 1.0])?;
    space.surface(&extremal)
}

/// The surface of least area of a space, from `lower` if there is one, else from the start of the space; not above `starts`.
fn minimise<S: Space>(
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
    let mut at_hand = starts.iter().map(|surface| space.nodes(surface)).collect::<Result<Vec<_>, _>>()?;
    if form.is_none() && lower.is_none() {
        at_hand.push(descent.dirichlet(&start, SQUARES)?);
    }
    if let Some(lower) = lower {
        (start, from) = (space.nodes(lower)?, Start::AtHand);
    }
    // Another surface is a better start if it has less area and its parametrisation is as even.
    let (mut least, evenness) = descent.judge(&start)?;
    for x in &at_hand {
        let (area, even) = descent.judge(x)?;
        if area < least && even >= evenness {
            (start, least, from) = (x.clone(), area, Start::AtHand);
        }
    }
    descent.check(&start)?;
    let mut best = descent.run(start.clone(), &reference, lower.is_some())?;
    // Below the tolerance at which one valley is as good as another, all are looked into. Of several cells the Dirichlet
    // extremal, every one over a unit square, is a bad start.
    let all = tolerance < LOOSE && lower.is_none() && space.topology().cells.len() == 1;
    if all {
        at_hand.push(reference.clone());
    }
    for x in at_hand.into_iter().filter(|x| *x != start) {
        let (area, _) = descent.judge(&x)?;
        if all || area < best.surface.area() * (1.0 - LOWER) {
            let other = descent.run(x, &reference, false)?;
            let enough = if all { tolerance.max(LOWER) } else { 0.0 };
            if other.surface.area() < best.surface.area() * (1.0 - enough) {
                (best, least, from) = (other, area, Start::AtHand);
            }
        }
    }
    descent.check_area(&best.surface.x)?;
    let mut variation = descent.variation(&best.surface.x, best.surface.points)?;
    let mut left_saddle = false;
    for _ in 0..SADDLES {
        let Some(negative) = variation.as_ref().filter(|v| v.smallest < -UNSTABLE) else { break };
        let Some(lower) = leave_saddle(&mut descent, &best, negative, &reference)? else { break };
        variation = descent.variation(&lower.surface.x, lower.surface.points)?;
        (best, left_saddle) = (lower, true);
    }
    let gradients = descent.gradients(&best.surface.x, best.surface.points)?;
    let found = extremal(&descent, &best, least, gradients, variation.map(|v| v.smallest), left_saddle);
    let jacobian_ratio = best.surface.fine.evenness;
    Ok((space.surface(&best.surface.x)?, AreaExtremal { from, jacobian_ratio, ..found }))
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
    let free = (0..saddle.surface.x.len()).filter(|&node| !descent.rules.space.topology().fixed[node]);
    for (node, f) in free.zip(&variation.displacement) {
        if let [normal] = normals[node].directions() {
            directions[node] = *normal * *f;
        }
    }
    let largest = directions.iter().map(|d| d.norm()).fold(0.0, f64::max);
    let (area, points) = (saddle.surface.area(), saddle.surface.points);
    let mut lowest: Option<Reached> = None;
    for side in [1.0, -1.0] {
        let mut step = side * LEAVE * area.sqrt() / largest;
        for _ in 0..HALVINGS {
            let x: Vec<Point> =
                saddle.surface.x.iter().zip(&directions).map(|(&x, &d)| x + d * step).collect();
            if descent.rules.fine(points, &x)?.area < area {
                let reached = descent.run(x, reference, false)?;
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
    second_variation: Option<f64>,
    left_saddle: bool,
) -> AreaExtremal {
    let square = descent.rules.space.frame().unit().powi(2);
    let stage = |stage: Stage| Stage { gained: stage.gained * square, ..stage };
    let surface = &reached.surface;
    AreaExtremal {
        area: Integral {
            value: surface.area() * square,
            error: (surface.error + 64.0 * f64::EPSILON * surface.area()) * square,
            points: surface.points,
            settled: surface.error <= RESOLVED.max(0.1 * descent.tolerance) * surface.area(),
        },
        start: start * square,
        from: Start::Coons,
        corrections: stage(reached.corrections),
        steps: stage(reached.steps),
        normal_steps: stage(reached.normal_steps),
        gradient,
        whole_gradient,
        iterations: descent.iterations,
        evaluations: descent.evaluations,
        end: reached.end,
        valley: reached.valley,
        jacobian_ratio: 0.0,
        second_variation,
        left_saddle,
        cutting_gains: 0.0,
    }
}

impl<S: Space> Descent<'_, '_, S> {
    /// The area of a surface and the least over the mean of its density.
    fn judge(&mut self, x: &[Point]) -> Result<(f64, f64), MethodError> {
        let fine = self.rules.settled(x.to_vec())?.fine;
        Ok((fine.area, fine.evenness))
    }

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
