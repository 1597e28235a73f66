//! Surfaces of least area over a border that stays.
//!
//! A surface is known by its points at the nodes of its cells ([`space`]). From a Coons patch (of triangles the Dirichlet
//! extremal) metric corrections lead near, a bounded number of Newton steps in all coordinates nearer, and Newton steps along
//! the normals to a stationary surface ([`descent`]). The valley of surfaces that differ only by moving points along them has
//! no end; where in it the surface stays is what the corrections and the bounded steps give, which depends continuously on the
//! border and neither on its place nor on its unit. All is judged by rules as fine as the surface asks ([`rules`]).

mod assembly;
mod complex;
mod corrections;
mod descent;
mod displaced;
mod displacement;
mod estimate;
mod family;
mod high_degree;
mod minimisation;
mod mode;
mod normal_steps;
mod outcome;
mod pulled_steps;
mod raised;
mod reach;
mod rules;
mod space;
mod stability;
mod steps;
mod tensor;
#[cfg(test)]
mod tests;
mod triangle;

use surfaces::{Complex, TensorPatch, TrianglePatch};

pub use displacement::{Displacement, DisplacementEnd};
pub(crate) use estimate::costs_less;
pub use estimate::{
    AreaEstimate, NoEstimate, estimate_complex, estimate_net, estimate_triangle, excess_of_complex,
    excess_of_net, excess_of_triangle,
};
pub use mode::Mode;
pub use outcome::{AreaEnd, AreaExtremal, Stage, Start, ValleyEnd};
pub use raised::{least_area_raised, least_area_triangle_raised};

use crate::{MethodError, Progress};
use complex::Glued;
use descent::Descent;
use high_degree::{is_of_high_degree, least_of_displaced};
use minimisation::minimise;
use space::Space;
use tensor::{Separated, Sums};
use triangle::Triangular;

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
        _ if is_of_high_degree(patch)? => least_of_displaced(patch, None, starts, tolerance, progress),
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
