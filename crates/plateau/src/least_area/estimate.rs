//! How far a surface of least area lies above the least area of its border: from those of the next degrees.

use surfaces::{Complex, Net, TensorPatch, TriangleNet, TrianglePatch};
use thiserror::Error;

use super::complex::Glued;
use super::descent::Descent;
use super::space::Space;
use super::tensor::Separated;
use super::triangle::Triangular;
use super::{AreaEnd, AreaExtremal};
use crate::{MethodError, Progress};

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
}

/// Newton steps in all coordinates at a raised degree: the surface below is near.
const STEPS: usize = 2;

/// What a gain may be beside the one before it for a series to be continued: at each degree, and at every second one.
const FALLING: f64 = 0.4;
const FALLING_TWO: f64 = 0.8;

/// Share of the area below which a gain is rounding.
const ROUNDING: f64 = 1e-14;

/// What the area of a complex of least area is above the least area of its rim. The complexes of the next degrees are reached from
/// this one, which they hold; what they gain is continued as a geometric series (Aitken's Δ²).
///
/// # Errors
/// As [`least_area_complex`](super::least_area_complex).
pub fn estimate_complex(
    complex: &Complex,
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<AreaEstimate, MethodError> {
    sequence(complex.clone(), found, |lower| {
        let raised = lower.with_degree(lower.degree() + 1)?;
        improved(&Glued::new(&raised)?, &raised, progress)
    })
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
    sequence(TensorPatch::bernstein(net.clone())?, found, |lower| {
        let raised = TensorPatch::bernstein(lower.net().raised(1))?;
        improved(&Separated::new(&raised, &raised.products()[0])?, &raised, progress)
    })
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
    sequence(TrianglePatch::new(net.clone())?, found, |lower| {
        let raised = TrianglePatch::new(lower.net().raised(1)?)?;
        improved(&Triangular::new(raised.net())?, &raised, progress)
    })
}

/// A surface of a degree, with its area and the error of that.
type Improved<P> = (P, f64, f64);

/// A surface near `lower`, of less area if there is one.
fn improved<S: Space>(
    space: &S,
    lower: &S::Surface,
    progress: &dyn Progress,
) -> Result<Improved<S::Surface>, MethodError> {
    let mut descent = Descent::new(space, 1e-12, progress)?;
    let reached = descent.refined(space.nodes(lower)?, STEPS)?;
    let square = space.frame().unit().powi(2);
    let (area, error) = (reached.surface.area() * square, reached.surface.error * square);
    Ok((space.surface(&reached.surface.x)?, area, error))
}

/// The estimate from the areas of one degree after the other.
fn sequence<P>(
    surface: P,
    found: &AreaExtremal,
    mut next: impl FnMut(&P) -> Result<Improved<P>, MethodError>,
) -> Result<AreaEstimate, MethodError> {
    if found.end != AreaEnd::Stationary || !found.area.settled {
        return Ok(Err(NoEstimate::NotReached));
    }
    let area = found.area.value;
    let (one, first, first_error) = next(&surface)?;
    let (two, second, second_error) = next(&one)?;
    let mut error = found.area.error.max(first_error).max(second_error).max(ROUNDING * area);
    let (mut gained, mut then) = (area - first, first - second);
    if gained + then <= error {
        return Ok(Ok(error));
    }
    if then > FALLING * gained {
        // What is symmetric gains at every second degree only, and what falls off slowly is continued from further on.
        let (three, ..) = next(&two)?;
        let (_, fourth, fourth_error) = next(&three)?;
        error = error.max(fourth_error);
        (gained, then) = (area - second, second - fourth);
    }
    if then > FALLING_TWO * gained {
        return Ok(Err(NoEstimate::Slow { first: gained, second: then }));
    }
    if gained + then <= 4.0 * error {
        return Ok(Err(NoEstimate::Unresolved { gained: gained + then, error }));
    }
    Ok(Ok(gained / (1.0 - then.max(0.0) / gained)))
}
