//! How near STEP files hold a surface, and the unit they declare.

use crate::LengthUnit;

/// Largest distance of a fitted surface from the patch where none is asked for, as a share of the size.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// How STEP holds a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepForm {
    /// Largest distance of a fitted surface from the patch, as a share of the size.
    pub tolerance: f64,
    /// What it says its numbers are; they are written unchanged.
    pub unit: LengthUnit,
}

impl Default for StepForm {
    fn default() -> Self {
        DEFAULT_TOLERANCE.into()
    }
}

impl From<f64> for StepForm {
    /// A fit within this share of the size, in millimetres.
    fn from(tolerance: f64) -> Self {
        Self { tolerance, unit: LengthUnit::default() }
    }
}
