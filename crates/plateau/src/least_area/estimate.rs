//! How far a surface of least area lies above the least area of its border: from those of the next degrees.

use bases::Matrix;
use energy::EnergyError;
use solve::SolveError;
use surfaces::{Complex, Net, TensorPatch, TriangleNet, TrianglePatch};
use thiserror::Error;

use super::assembly::{Assembly, Unknowns};
use super::complex::Glued;
use super::descent::Descent;
use super::displaced::Displaced;
use super::high_degree::is_of_high_degree;
use super::space::Space;
use super::tensor::Separated;
use super::triangle::Triangular;
use super::{AreaEnd, AreaExtremal};
use crate::corners::graded;
use crate::{MethodError, Progress, odd_corners};

/// What the area of a surface is above the least area of its border, as far as that can be told.
pub type AreaEstimate = Result<f64, NoEstimate>;

/// Why it is not told.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum NoEstimate {
    /// The gains of degree after degree do not fall off.
    #[error("raising the degree gains {first:.1e}, and then {second:.1e}: no end is in sight")]
    Slow {
        /// What one raising gains.
        first: f64,
        /// What the next one does.
        second: f64,
    },
    /// The gains are no more than the error of the quadrature.
    #[error("raising the degree gains {gained:.1e}, which the quadrature (± {error:.1e}) does not resolve")]
    Unresolved {
        /// What raising gains.
        gained: f64,
        /// The error of the areas.
        error: f64,
    },
    /// The surface is none of least area.
    #[error("the least area was not reached")]
    NotReached,
    /// There is no memory for surfaces of the next degrees.
    #[error("surfaces of the next degrees would take about {:.0} MB, which cannot be allocated", *bytes as f64 / 1e6)]
    OutOfMemory {
        /// What they take.
        bytes: usize,
    },
}

/// Newton steps in all coordinates at a raised degree: the surface below is near.
const STEPS: usize = 2;

/// What a gain may be beside the one before it for a series to be continued: at each degree, and at every second one.
const FALLING: f64 = 0.4;
const FALLING_TWO: f64 = 0.8;

/// Share of the area below which a gain is rounding, and that up to which an error of areas is called so.
const ROUNDING: f64 = 1e-14;
const CONVERGED: f64 = 1e-12;

/// Gains are resolved from so many times the error of the areas on.
const RESOLVED: f64 = 10.0;

/// What the area of a complex of least area is above the least area of its rim. The complexes of the next degrees are reached from
/// this one, which they hold; what they gain is continued as a geometric series (Aitken's Δ²). Where polynomials converge slowly towards
/// corners ([`odd_corners`]), a second series has with every degree one more layer of smaller patches around these; that which
/// reaches the lower area is believed.
///
/// # Errors
/// As [`least_area_complex`](super::least_area_complex).
pub fn estimate_complex(
    complex: &Complex,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<AreaEstimate, MethodError> {
    let raised = |lower: &Complex| lower.with_degree(lower.degree() + 1);
    let by_degree = sequence(complex.clone(), found, |lower| {
        let raised = raised(lower)?;
        improved(&Glued::new(&raised)?, &raised, progress)
    })?;
    at_corners(by_degree, complex, found, progress)
}

/// What the area of the Bernstein–Bézier patch of least area on `net` is above the least area of its border: as [`estimate_complex`].
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn estimate_net(
    net: &Net,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<AreaEstimate, MethodError> {
    let patch = TensorPatch::bernstein(net.clone())?;
    if is_of_high_degree(&patch)? {
        return Ok(by_displacements(patch, found, progress)?.estimate);
    }
    let by_degree = sequence(patch, found, |lower| {
        let raised = TensorPatch::bernstein(lower.net().raised(1))?;
        improved(&Separated::new(&raised, &raised.products()[0])?, &raised, progress)
    })?;
    at_corners(by_degree, &Complex::of_net(net)?, found, progress)
}

/// The estimate from displacements of the next degrees, which the net is raised to where it is none of theirs.
fn by_displacements(
    patch: TensorPatch,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<Series, MethodError> {
    let mut degrees = found.displacement.map_or(patch.net().degrees(), |displacement| displacement.degrees);
    sequence(patch, found, |lower| {
        degrees = (degrees.0 + 1, degrees.1 + 1);
        let (m, n) = lower.net().degrees();
        let raise = degrees.0.saturating_sub(m).max(degrees.1.saturating_sub(n));
        let raised = TensorPatch::bernstein(lower.net().raised(raise))?;
        improved(&Displaced::new(&raised, degrees)?, &raised, progress)
    })
}

/// The estimate from degrees, unless the complex has corners where layers lead lower.
fn at_corners(
    by_degree: Series,
    complex: &Complex,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<AreaEstimate, MethodError> {
    let corners = odd_corners(complex);
    if corners.is_empty() || by_degree.lowest.is_nan() {
        return Ok(by_degree.estimate);
    }
    // Each layer comes with one degree more: layers alone would end at the error of the degree.
    let by_layers = sequence(complex.clone(), found, |lower| {
        let finer = graded(&lower.with_degree(lower.degree() + 1)?, &corners)?;
        improved(&Glued::new(&finer)?, &finer, progress)
    })?;
    Ok(if by_layers.lowest <= by_degree.lowest { by_layers.estimate } else { by_degree.estimate })
}

/// What the area of the triangular patch of least area on `net` is above the least area of its border: as [`estimate_complex`].
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn estimate_triangle(
    net: &TriangleNet,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<AreaEstimate, MethodError> {
    let by_degree = sequence(TrianglePatch::new(net.clone())?, found, |lower| {
        let raised = TrianglePatch::new(lower.net().raised(1)?)?;
        improved(&Triangular::new(raised.net())?, &raised, progress)
    })?;
    Ok(by_degree.estimate)
}

/// Newton steps that an estimate makes at each of two degrees, about.
const COUNTED: f64 = 4.0;

/// Nodes up to which an estimate takes no time to speak of, and with layers around corners, of which there are few.
const FEW: usize = 400;
const FEW_AT_CORNERS: usize = 1700;

/// What an estimate may cost where all steps to the surface, those at lower degrees among them, are counted: about a second.
const SHORT: f64 = 2e9;

/// Whether an estimate costs less than the surface did, of so many faces, `at_corners` of them at corners where layers are tried: a step
/// is counted with the sixth power of the degree, as its factorisations are.
pub(crate) fn costs_less(degree: usize, faces: usize, at_corners: usize, found: &AreaExtremal) -> bool {
    let step = |degree: usize| (degree as f64 + 1.0).powi(6);
    // A layer makes three faces of each at a corner.
    let [one, two] = [1, 2].map(|layers| faces + 2 * layers * at_corners);
    let few = if at_corners == 0 { FEW } else { FEW_AT_CORNERS };
    let is_small = two * (degree + 3).pow(2) <= few;
    let steps = one as f64 * step(degree + 1) + two as f64 * step(degree + 2);
    let spent = |iterations: usize| (iterations * faces) as f64 * step(degree);
    let most = spent(found.last_iterations).max(spent(found.iterations).min(SHORT));
    is_small || COUNTED * steps <= most
}

/// Degrees that a surface is raised by to see what it lacks.
const RICHER: usize = 2;

/// A decrement of a larger share of the area says nothing: the area is no parabola as far as that.
const NEAR: f64 = 0.25;

/// What the area of any Bernstein–Bézier patch is above the least area of its border, about: half of `gᵀH⁻¹g`, with the gradient g and the
/// Hessian H of the area in displacements along the normals of two degrees more. None where the surface is singular, H not positive
/// definite, or the least area too far. For surfaces of least area of their degree it is too small.
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn excess_of_net(net: &Net) -> Result<Option<f64>, MethodError> {
    let raised = TensorPatch::bernstein(net.raised(RICHER))?;
    excess(&Separated::new(&raised, &raised.products()[0])?, &raised)
}

/// As [`excess_of_net`], of a triangular patch.
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn excess_of_triangle(net: &TriangleNet) -> Result<Option<f64>, MethodError> {
    let raised = TrianglePatch::new(net.raised(RICHER)?)?;
    excess(&Triangular::new(raised.net())?, &raised)
}

/// As [`excess_of_net`], of a complex.
///
/// # Errors
/// As [`least_area_complex`](super::least_area_complex).
pub fn excess_of_complex(complex: &Complex) -> Result<Option<f64>, MethodError> {
    let raised = complex.with_degree(complex.degree() + RICHER)?;
    excess(&Glued::new(&raised)?, &raised)
}

fn excess<S: Space>(space: &S, surface: &S::Surface) -> Result<Option<f64>, MethodError> {
    // A loose tolerance: no step is made, and only the rule depends on it.
    let mut descent = Descent::new(space, 1e-6, &())?;
    let here = descent.rules.settled(space.nodes(surface)?)?;
    let (cell, topology) = (descent.rules.cell(here.points)?, space.topology());
    let assembly = Assembly { topology, cell: cell.as_ref() };
    let tangents = assembly.tangents(&here.x);
    let slopes = match assembly.gradient(&tangents) {
        Err(EnergyError::Singular { .. }) => return Ok(None),
        slopes => slopes?,
    };
    let unknowns = Unknowns::new(topology, descent.normals(&here.x)?)?;
    if unknowns.count() == 0 {
        return Ok(None);
    }
    let (gradient, mut hessians) = (unknowns.gather(&slopes), Vec::new());
    unknowns.hessians(&assembly, &tangents, &mut hessians)?;
    // No shift: where H is indefinite there is no minimum near, and half of gᵀH⁻¹g means nothing.
    let mut step = gradient.clone();
    match unknowns.condensation().factor(&hessians.iter().map(Matrix::as_slice).collect::<Vec<_>>()) {
        Ok(factor) => factor.solve(1, &mut step)?,
        Err(SolveError::NotPositiveDefinite { .. }) => return Ok(None),
        Err(error) => return Err(error.into()),
    }
    let decrement = 0.5 * step.iter().zip(&gradient).map(|(d, g)| d * g).sum::<f64>();
    let is_known = here.settled && decrement > ROUNDING * here.area() && decrement <= NEAR * here.area();
    Ok(is_known.then(|| decrement * space.frame().unit().powi(2)))
}

/// A surface of a degree, with its area and the error of that.
type Improved<P> = (P, f64, f64);

/// A surface near `lower`, of less area if there is one.
fn improved<S: Space>(
    space: &S,
    lower: &S::Surface,
    progress: &dyn Progress,
) -> Result<Improved<S::Surface>, MethodError> {
    // Gains are differences of areas: these must be known beyond what degrees still gain.
    let mut descent = Descent::new(space, 1e-12, progress)?;
    let reached = descent.refined(space.nodes(lower)?, STEPS)?;
    let square = space.frame().unit().powi(2);
    let (area, error) = (reached.surface.area() * square, reached.surface.error * square);
    Ok((space.surface(&reached.surface.x)?, area, error))
}

/// What areas that fall one after the other lead to.
struct Series {
    /// The lowest of them; not a number where none was looked for.
    lowest: f64,
    estimate: AreaEstimate,
}

/// The estimate from the areas of one surface after the other, each finer than that before.
fn sequence<P>(
    surface: P,
    found: &AreaExtremal,
    mut next: impl FnMut(&P) -> Result<Improved<P>, MethodError>,
) -> Result<Series, MethodError> {
    if found.end != AreaEnd::Stationary || !found.area.settled {
        return Ok(Series { lowest: f64::NAN, estimate: Err(NoEstimate::NotReached) });
    }
    let area = found.area.value;
    let (one, first, first_error) = next(&surface)?;
    let (two, second, second_error) = next(&one)?;
    let mut lowest = first.min(second);
    let error = found.area.error.max(first_error).max(second_error).max(ROUNDING * area);
    let (mut gained, mut then) = (area - first, first - second);
    if gained + then <= RESOLVED * error {
        let is_rounding = error <= CONVERGED * area;
        let gained = (gained + then).max(error);
        let estimate = if is_rounding { Ok(gained) } else { Err(NoEstimate::Unresolved { gained, error }) };
        return Ok(Series { lowest, estimate });
    }
    if then > FALLING * gained {
        // What is symmetric gains at every second degree only, and what falls off slowly is continued from further on.
        let (three, ..) = next(&two)?;
        let (_, fourth, _) = next(&three)?;
        // Areas at every second degree: p, p + 2, p + 4.
        (gained, then) = (area - second, second - fourth);
        lowest = lowest.min(fourth);
    }
    // The sum of a geometric series with these first two terms; a second gain below 0 is rounding.
    let estimate = match then > FALLING_TWO * gained {
        true => Err(NoEstimate::Slow { first: gained, second: then }),
        false => Ok(gained / (1.0 - then.max(0.0) / gained)),
    };
    Ok(Series { lowest, estimate })
}
