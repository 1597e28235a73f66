//! What came of methods.

use crate::{CurveResult, Done, MethodError, Quantity};

/// What came of an experiment: surfaces, one a method, or a sampled curve.
#[derive(Debug)]
pub struct Results {
    /// A title.
    pub title: String,
    /// One entry per method.
    pub methods: Vec<MethodResult>,
    /// The sampled curve, of experiments with a curve; they have no methods.
    pub curve: Option<CurveResult>,
    /// What a reader must know about the whole, one sentence each.
    pub warnings: Vec<String>,
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
