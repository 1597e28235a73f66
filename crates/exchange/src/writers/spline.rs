//! The B-spline a CAD program is given for a surface.

use surfaces::{Domain, Patch, SplineFit, SplineFitError, SplineSurface, TensorPatch};
use thiserror::Error;

use plateau::{Family, Surface};

/// Largest degree OpenCASCADE, and with it FreeCAD, takes.
pub(super) const LARGEST_DEGREE: usize = 25;

/// Why a surface has no spline.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SplineError {
    /// Polynomials of high degree are refused by the programs that read the file.
    #[error(
        "the triangular patch has degree {degree}, and OpenCASCADE reads degrees up to {max}: run the method on a boundary \
         of lower degree, or export a mesh (glb, ply)",
        max = LARGEST_DEGREE
    )]
    Degree {
        /// Degree of the patch.
        degree: usize,
    },
    /// No fit was found.
    #[error(transparent)]
    Fit(#[from] SplineFitError),
    /// A surface of several faces is no single spline.
    #[error("the surface has several faces that share edges: no single B-spline holds it")]
    Faces,
}

/// How a [`spline()`] came about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// It is the patch, up to the rounding of its control points.
    Exact,
    /// It is a [`SplineFit`].
    Fitted {
        /// That of the fit.
        deviation: f64,
        /// That of the fit.
        size: f64,
    },
}

impl Accuracy {
    /// The largest distance between spline and surface that is stated; none if they are the same.
    pub(super) fn deviation(self) -> Option<f64> {
        match self {
            Self::Exact => None,
            Self::Fitted { deviation, .. } => Some(deviation),
        }
    }
}

/// The spline of a surface, exact if it can be, otherwise within `tolerance` times its size.
///
/// # Errors
/// [`SplineError`].
pub fn spline(
    surface: &Surface,
    family: Family,
    tolerance: f64,
) -> Result<(SplineSurface, Accuracy), SplineError> {
    match surface {
        Surface::Tensor(patch) if is_polynomial(patch, family) && is_read(patch) => {
            Ok((SplineSurface::bernstein(patch.net()), Accuracy::Exact))
        }
        Surface::Tensor(patch) => Ok(fitted(SplineFit::of_patch(patch, tolerance)?)),
        Surface::Pieces(pieces) => Ok(fitted(SplineFit::of_pieces(pieces, tolerance)?)),
        Surface::Triangle(patch) => match patch.net().degree() {
            degree if degree > LARGEST_DEGREE => Err(SplineError::Degree { degree }),
            _ => Ok((SplineSurface::triangle(patch.net()), Accuracy::Exact)),
        },
        Surface::Complex(_) => Err(SplineError::Faces),
    }
}

fn fitted(fit: SplineFit) -> (SplineSurface, Accuracy) {
    (fit.surface, Accuracy::Fitted { deviation: fit.deviation, size: fit.size })
}

/// Whether a patch is the polynomial that its net says, over the unit square.
pub(super) fn is_polynomial(patch: &TensorPatch, family: Family) -> bool {
    family == Family::Bernstein
        && matches!(patch.domain(), Domain::Rectangle { u: (0.0, 1.0), v: (0.0, 1.0) })
}

fn is_read(patch: &TensorPatch) -> bool {
    let (m, n) = patch.net().degrees();
    m.max(n) <= LARGEST_DEGREE
}

/// What a spline is, for people.
pub(super) fn described(spline: &SplineSurface, accuracy: Accuracy) -> String {
    let [u, v] = spline.knots();
    let degrees = format!("degree ({}, {})", u.degree(), v.degree());
    match accuracy {
        Accuracy::Exact => format!("exact: a polynomial surface of {degrees}"),
        Accuracy::Fitted { deviation, size } => format!(
            "a B-spline fit of {degrees} in {} x {} segments, twice continuously differentiable: no point farther than \
             {deviation:.2e} ({:.1e} of the size) from the patch, 1.25 times the largest distance measured",
            u.values().len() - 1,
            v.values().len() - 1,
            if size > 0.0 { deviation / size } else { 0.0 },
        ),
    }
}
