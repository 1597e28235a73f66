//! What came of methods.

use crate::{CurveResult, Done, MethodError, Quantity, Remark};

/// What came of an experiment: surfaces, one a method, or sampled curves.
#[derive(Debug)]
pub struct Results {
    /// A title.
    pub title: String,
    /// One entry per method.
    pub methods: Vec<MethodResult>,
    /// The sampled curves, of experiments with a curve: one, or one for each of several shapes. They have no methods.
    pub curves: Vec<CurveResult>,
    /// What a reader must know about the whole.
    pub warnings: Vec<Remark>,
}

/// What became of one method.
#[derive(Debug)]
pub struct MethodResult {
    /// The name of the row.
    pub name: String,
    /// The patch and its figures, or why there is none.
    pub outcome: Result<Box<Done>, MethodError>,
}

impl Results {
    /// Whether the caller's wish to end left something undone.
    pub fn was_interrupted(&self) -> bool {
        self.failures().any(|(_, error)| matches!(error, MethodError::Interrupted))
    }

    /// One figure of the curves, whose samples are counted on from each to the next; curves have nothing but curvatures.
    pub fn figure_of_curves(&self, quantity: Quantity) -> Option<f64> {
        let Quantity::Curvature(mut k) = quantity else { return None };
        for curve in &self.curves {
            match k.checked_sub(curve.t.len()) {
                Some(rest) => k = rest,
                None => return curve.curvature[k],
            }
        }
        None
    }

    /// The methods that failed, with their errors.
    pub fn failures(&self) -> impl Iterator<Item = (&str, &MethodError)> {
        self.methods.iter().filter_map(|m| m.outcome.as_ref().err().map(|error| (m.name.as_str(), error)))
    }
}

impl MethodResult {
    /// One figure of the result; none if the method failed or has no such figure.
    pub fn figure(&self, quantity: Quantity) -> Option<f64> {
        self.outcome.as_ref().ok().and_then(|done| quantity.of(done)).map(|measured| measured.value)
    }
}
