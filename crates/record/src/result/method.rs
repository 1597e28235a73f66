//! What `result.json` says of a method.

use plateau::{Done, MethodResult, Quantity};
use serde::{Deserialize, Serialize};

use super::extremal::AreaEntry;
use super::file::FileEntry;
use super::head::Head;
use super::minimised::Minimised;
use super::number::finite;
use super::proof::ProofEntry;
use super::search::SearchEntry;
use super::surface::SurfaceEntry;

#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct MethodEntry {
    #[serde(flatten)]
    pub(super) head: Head,
    #[serde(skip_serializing_if = "Option::is_none")]
    dirichlet: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dirichlet_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    laplacian_defect: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    laplacian_defect_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bending: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bending_error: Option<f64>,
    /// Energies that were minimised, beside those of every surface.
    #[serde(flatten)]
    minimised: Minimised,
    #[serde(skip_serializing_if = "Option::is_none")]
    metric_dirichlet: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    metric_dirichlet_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    conformality_gap: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_curvature: Option<MeanCurvature>,
    #[serde(flatten)]
    pub(super) surface: SurfaceEntry,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    solver: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    residual: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    condition: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    basis_condition: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    certified: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area_extremal: Option<AreaEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    boundary_deviation: Option<f64>,
    /// How far the rim of a complex lies from the curves that were given.
    #[serde(skip_serializing_if = "Option::is_none")]
    rim_deviation: Option<f64>,
    /// Angles between the tangent planes along the inner edges of a complex, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) kink: Option<Kink>,
    #[serde(skip_serializing_if = "Option::is_none")]
    jacobian_ratio: Option<f64>,
    /// What the area is above the least one, judged from a sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    area_estimate: Option<f64>,
    /// What the least area is proved not to be below.
    #[serde(skip_serializing_if = "Option::is_none")]
    lower_bound: Option<f64>,
    /// What proves it.
    #[serde(skip_serializing_if = "Option::is_none")]
    lower_bound_proof: Option<ProofEntry>,
    /// The area of the loops when each is spanned by itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    spanned_one_by_one: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic_bound: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic_bound_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    search: Option<SearchEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) files: Vec<FileEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct MeanCurvature {
    #[serde(skip_serializing_if = "Option::is_none")]
    max_abs: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rms: Option<f64>,
}

impl MeanCurvature {
    /// None if neither is known.
    fn of(max_abs: Option<f64>, rms: Option<f64>) -> Option<Self> {
        max_abs.or(rms).is_some().then_some(Self { max_abs, rms })
    }
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Kink {
    max: f64,
    rms: f64,
}

/// The value of a figure, if it has one that JSON has.
fn value(done: &Done, quantity: Quantity) -> Option<f64> {
    quantity.of(done).and_then(|figure| finite(figure.value))
}

/// Its error, likewise.
fn error(done: &Done, quantity: Quantity) -> Option<f64> {
    quantity.of(done).and_then(|figure| figure.error).and_then(finite)
}

impl MethodEntry {
    /// Of a method that failed, its head alone.
    pub(super) fn of(result: &MethodResult) -> Self {
        let head = Head::of(result);
        let Ok(done) = &result.outcome else { return Self { head, ..Self::default() } };
        let mut entry = Self {
            head,
            surface: SurfaceEntry::of(done),
            weights: done.closed_form.and_then(|form| form.weights),
            search: done.solved.search.as_ref().map(SearchEntry::of),
            warnings: done.warnings.iter().map(ToString::to_string).collect(),
            ..Self::default()
        };
        entry.add_energies(done);
        entry.add_way(done);
        entry.add_comparisons(done);
        entry
    }

    /// Energies, area and curvature.
    fn add_energies(&mut self, done: &Done) {
        self.dirichlet = value(done, Quantity::Dirichlet);
        self.dirichlet_error = error(done, Quantity::Dirichlet);
        self.area = value(done, Quantity::Area);
        self.area_error = error(done, Quantity::Area);
        self.laplacian_defect = value(done, Quantity::LaplacianDefect);
        self.laplacian_defect_error = error(done, Quantity::LaplacianDefect);
        self.bending = value(done, Quantity::Bending);
        self.bending_error = error(done, Quantity::Bending);
        self.minimised = Minimised::of(done);
        self.metric_dirichlet = value(done, Quantity::MetricDirichlet);
        self.metric_dirichlet_error = error(done, Quantity::MetricDirichlet);
        self.conformality_gap = value(done, Quantity::ConformalityGap);
        self.mean_curvature = MeanCurvature::of(
            value(done, Quantity::MeanCurvatureMax),
            value(done, Quantity::MeanCurvatureRms),
        );
    }

    /// How it was solved for.
    fn add_way(&mut self, done: &Done) {
        let solve = done.solved.solve.as_ref();
        self.solver = solve.map(|s| s.solver.to_owned());
        self.residual = value(done, Quantity::Residual);
        self.condition = solve.and_then(|s| finite(s.condition));
        self.basis_condition = solve.and_then(|s| s.basis_condition).and_then(finite);
        self.certified = solve.and_then(|s| s.certified);
        self.area_extremal =
            done.solved.area.as_ref().map(|found| AreaEntry::new(found, &done.solved.surface));
    }

    /// What keeps a comparison with other surfaces honest: borders, rims, folds, what lies below the area.
    fn add_comparisons(&mut self, done: &Done) {
        let film = done.film.as_ref();
        self.boundary_deviation = value(done, Quantity::BoundaryDeviation);
        self.rim_deviation = value(done, Quantity::RimDeviation);
        self.kink = film.and_then(|film| film.seams.kink).map(|kink| Kink { max: kink.max, rms: kink.rms });
        self.jacobian_ratio = value(done, Quantity::JacobianRatio);
        self.area_estimate = done.estimate.and_then(finite);
        self.lower_bound = done.bound.as_ref().map(|bound| bound.value);
        self.lower_bound_proof = done.bound.as_ref().map(ProofEntry::new);
        self.spanned_one_by_one = value(done, Quantity::SpannedOneByOne);
        self.harmonic_bound = value(done, Quantity::HarmonicBound);
        self.harmonic_bound_error = error(done, Quantity::HarmonicBound);
        self.deviation = value(done, Quantity::Deviation);
    }
}
