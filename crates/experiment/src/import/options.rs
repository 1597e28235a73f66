use exchange::{Assembly, AssemblyOptions, Sentence, Setting};
use plateau::MAX_DEGREE;

use super::ImportError;

/// What a file of curves leaves open.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ImportOptions {
    /// The points of polylines are samples: each side is the curve of this degree nearest to them.
    pub degree: Option<usize>,
    /// The points of polylines are control points of Bézier curves, however many.
    pub control_points: bool,
    /// How far the curve of a side of many samples may pass from them; by default [`Self::TOLERANCE`] of the size.
    pub tolerance: Option<f64>,
    /// Welding and corners.
    pub assembly: AssemblyOptions,
}

impl ImportOptions {
    /// Share of the size (the diagonal of the box around all curves) by which curves may pass from samples.
    pub const TOLERANCE: f64 = 1e-4;

    /// How far curves may pass from the samples of a boundary, a length.
    pub(super) fn rim_tolerance(&self, assembly: &Assembly) -> f64 {
        self.tolerance.unwrap_or(Self::TOLERANCE * assembly.size)
    }

    /// Whether something is said of the points of polylines.
    pub(super) fn says_what_points_are(&self) -> bool {
        self.degree.is_some() || self.control_points
    }

    /// Whether the numbers are ones that may be given.
    ///
    /// # Errors
    /// [`ImportError::Option`].
    pub fn check(&self) -> Result<(), ImportError> {
        if let Some(degree) = self.degree.filter(|degree| !(1..=MAX_DEGREE).contains(degree)) {
            let why = format!("degree {degree} is not offered; 1 to {MAX_DEGREE} are");
            return Err(ImportError::Option(why.into()));
        }
        match self.tolerance.filter(|tolerance| !(*tolerance > 0.0 && tolerance.is_finite())) {
            Some(tolerance) => {
                let given = Sentence::default().value(Setting::Tolerance, tolerance.to_string());
                Err(ImportError::Option(given.text(": it is a length above 0")))
            }
            None => Ok(()),
        }
    }
}
