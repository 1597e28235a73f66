//! What `result.json` says of a method.

use plateau::MethodResult;
use serde::{Deserialize, Serialize};

use super::extremal::AreaEntry;
use super::figures::{EVEN, EXACT, Figures, LEAST, OTHERS, RIM, SHAPE, SYSTEM};
use super::file::FileEntry;
use super::head::Head;
use super::number::finite;
use super::proof::ProofEntry;
use super::search::SearchEntry;
use super::surface::SurfaceEntry;

#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct MethodEntry {
    #[serde(flatten)]
    pub(super) head: Head,
    #[serde(flatten)]
    shape: Figures<SHAPE>,
    #[serde(flatten)]
    pub(super) surface: SurfaceEntry,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<[f64; 2]>,
    #[serde(flatten)]
    exact: Figures<EXACT>,
    #[serde(skip_serializing_if = "Option::is_none")]
    solver: Option<String>,
    #[serde(flatten)]
    system: Figures<SYSTEM>,
    #[serde(skip_serializing_if = "Option::is_none")]
    condition: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    basis_condition: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    certified: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area_extremal: Option<AreaEntry>,
    #[serde(flatten)]
    rim: Figures<RIM>,
    /// Angles between the tangent planes along the inner edges of a complex, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) kink: Option<Kink>,
    #[serde(flatten)]
    even: Figures<EVEN>,
    #[serde(flatten)]
    least: Figures<LEAST>,
    /// What proves the lower bound.
    #[serde(skip_serializing_if = "Option::is_none")]
    lower_bound_proof: Option<ProofEntry>,
    #[serde(flatten)]
    others: Figures<OTHERS>,
    #[serde(skip_serializing_if = "Option::is_none")]
    search: Option<SearchEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) files: Vec<FileEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Kink {
    max: f64,
    rms: f64,
}

impl MethodEntry {
    /// Of a method that failed, its head alone.
    pub(super) fn of(result: &MethodResult) -> Self {
        let head = Head::of(result);
        let Ok(done) = &result.outcome else { return Self { head, ..Self::default() } };
        let (solve, film) = (done.solved.solve(), done.film.as_ref());
        Self {
            head,
            shape: Figures::of(done),
            surface: SurfaceEntry::of(done),
            weights: done.closed_form.and_then(|form| form.weights),
            exact: Figures::of(done),
            solver: solve.map(|solve| solve.solver.to_owned()),
            system: Figures::of(done),
            condition: solve.and_then(|solve| finite(solve.condition)),
            basis_condition: solve.and_then(|solve| solve.basis_condition).and_then(finite),
            certified: solve.and_then(|solve| solve.certified),
            area_extremal: done.solved.area().map(|found| AreaEntry::new(found, done.solved.surface())),
            rim: Figures::of(done),
            kink: film.and_then(|film| film.seams().kink).map(|kink| Kink { max: kink.max, rms: kink.rms }),
            even: Figures::of(done),
            least: Figures::of(done),
            lower_bound_proof: done.bound.as_ref().map(ProofEntry::new),
            others: Figures::of(done),
            search: done.solved.search().map(SearchEntry::of),
            files: Vec::new(),
            warnings: done.warnings.iter().map(ToString::to_string).collect(),
        }
    }
}
