//! What came of methods.

use crate::{CurveResult, Done, MethodError, Quantity, Remark};

/// What came of an experiment: surfaces, one a method, or sampled curves.
#[derive(Debug)]
pub struct Results {
    title: String,
    found: Found,
    remarks: Vec<Remark>,
}

/// What an experiment is of.
#[derive(Debug)]
enum Found {
    Surfaces(Vec<MethodResult>),
    Curves(Vec<CurveResult>),
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
    /// The surfaces of methods, with a title.
    pub fn of_methods(title: impl Into<String>, methods: Vec<MethodResult>) -> Self {
        Self { title: title.into(), found: Found::Surfaces(methods), remarks: Vec::new() }
    }

    /// Sampled curves, one or one for each of several shapes, with a title.
    pub fn of_curves(title: impl Into<String>, curves: Vec<CurveResult>) -> Self {
        Self { title: title.into(), found: Found::Curves(curves), remarks: Vec::new() }
    }

    /// With what a reader must know about the whole.
    #[must_use]
    pub fn with_remarks(self, remarks: Vec<Remark>) -> Self {
        Self { remarks, ..self }
    }

    /// The title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// One entry per method; none of curves.
    pub fn methods(&self) -> &[MethodResult] {
        match &self.found {
            Found::Surfaces(methods) => methods,
            Found::Curves(_) => &[],
        }
    }

    /// The entries of the methods by themselves.
    pub fn into_methods(self) -> Vec<MethodResult> {
        match self.found {
            Found::Surfaces(methods) => methods,
            Found::Curves(_) => Vec::new(),
        }
    }

    /// The sampled curves; none of surfaces.
    pub fn curves(&self) -> &[CurveResult] {
        match &self.found {
            Found::Surfaces(_) => &[],
            Found::Curves(curves) => curves,
        }
    }

    /// What a reader must know about the whole.
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Whether the caller's wish to end left something undone.
    pub fn was_interrupted(&self) -> bool {
        self.failures().any(|(_, error)| matches!(error, MethodError::Interrupted))
    }

    /// One figure of the curves, whose samples are counted on from each to the next; curves have nothing but curvatures.
    pub fn figure_of_curves(&self, quantity: Quantity) -> Option<f64> {
        let Quantity::Curvature(mut k) = quantity else { return None };
        for curve in self.curves() {
            match k.checked_sub(curve.samples().len()) {
                Some(rest) => k = rest,
                None => return curve.samples()[k].curvature,
            }
        }
        None
    }

    /// The methods that failed, with their errors.
    pub fn failures(&self) -> impl Iterator<Item = (&str, &MethodError)> {
        self.methods().iter().filter_map(|m| m.outcome.as_ref().err().map(|error| (m.name.as_str(), error)))
    }
}

impl MethodResult {
    /// One figure of the result; none if the method failed or has no such figure.
    pub fn figure(&self, quantity: Quantity) -> Option<f64> {
        self.outcome.as_ref().ok().and_then(|done| quantity.of(done)).map(|measured| measured.value)
    }
}
