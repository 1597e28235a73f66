//! How near files hold a surface that they have by a formula, and the unit of their numbers.

use crate::LengthUnit;

/// Largest distance of a fitted surface from the patch where none is asked for, as a share of the size.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// How STEP holds a surface, and what its numbers are, which GLB is scaled by, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepForm {
    /// Largest distance of a fitted surface from the patch, as a share of the size.
    pub tolerance: f64,
    /// What the numbers are, where that is known: STEP says so and millimetres where it is not, its numbers are written unchanged; GLB, which
    /// is in metres, is scaled by it.
    pub unit: Option<LengthUnit>,
}

impl Default for StepForm {
    fn default() -> Self {
        DEFAULT_TOLERANCE.into()
    }
}

impl From<f64> for StepForm {
    /// A fit within this share of the size, of numbers whose unit is not known.
    fn from(tolerance: f64) -> Self {
        Self { tolerance, unit: None }
    }
}
