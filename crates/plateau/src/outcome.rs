//! What came of methods.

use crate::{BoundaryFigures, ClosedForm, CurveResult, Figures, MethodError, Quantity, Solved, Warning};

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

/// A method that found its patch.
#[derive(Debug)]
#[non_exhaustive]
pub struct Done {
    /// The patch and the way to it.
    pub solved: Solved,
    /// The mesh the files and the largest curvature are taken from.
    pub mesh: surfaces::Mesh,
    /// Its figures.
    pub figures: Figures,
    /// What its boundary admits and how far it moved, for patches on the unit square.
    pub boundary: Option<BoundaryFigures>,
    /// How it compares with its closed form, for surfaces that have one.
    pub closed_form: Option<ClosedForm>,
    /// What a reader must know about this method.
    pub warnings: Vec<Warning>,
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
        let done = self.outcome.as_ref().ok()?;
        let (figures, solved) = (&done.figures, &done.solved);
        match quantity {
            Quantity::Dirichlet => Some(figures.dirichlet.value),
            Quantity::Area => Some(figures.area.value),
            Quantity::LaplacianDefect => Some(figures.laplacian_defect.value),
            Quantity::Bending => Some(figures.bending.value),
            Quantity::ConformalityGap => figures.conformality_gap,
            Quantity::MeanCurvatureMax => figures.mean_curvature_max,
            Quantity::MeanCurvatureRms => figures.mean_curvature_rms,
            Quantity::Residual => solved.solve.map(|s| s.residual),
            Quantity::Shape(k) => solved.shape.and_then(|shape| shape.get(k).copied()),
            Quantity::SearchMinimum => solved.search.as_ref().map(|s| s.minimum),
            Quantity::BoundaryDeviation => done.boundary.map(|b| b.deviation),
            Quantity::HarmonicBound => done.boundary.map(|b| b.harmonic_bound),
            Quantity::Deviation => done.closed_form.map(|form| form.deviation),
            Quantity::Curvature(_) => None,
        }
    }
}
