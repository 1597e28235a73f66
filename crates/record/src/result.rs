//! `result.json`, the record of an experiment for other programs.

use serde::{Deserialize, Serialize};
use surfaces::{Complex, Face, TriangleNet};

use crate::{Manifest, SCHEMA};
use exchange::SurfaceForm;
use experiment::{Finished, Missed, Plan};
use plateau::{MethodResult, Quantity};
use plateau::{SearchOutcome, SearchRun, Surface};

mod curve;
mod minimised;
mod net;
mod pieces;
mod proof;

use curve::CurveEntry;
use minimised::Minimised;
use net::rows;
use pieces::{DomainEntry, PieceEntry, piece_entries, single_net};
use proof::ProofEntry;

/// The whole file. Numbers are written with all their digits; keys without a meaning are left out, and no number
/// that is not finite ever appears.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ResultFile {
    schema: String,
    title: String,
    seed: u64,
    methods: Vec<MethodEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<CurveEntry>,
    /// Of several shapes, instead of `curve`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    curves: Vec<CurveEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
    /// The numbers of the file that were not met.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    missed: Vec<MissedEntry>,
    /// Files beside the record that belong to no method.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    files: Vec<FileEntry>,
    /// Files that were asked for and are not there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    unwritten: Vec<String>,
    manifest: Manifest,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct MissedEntry {
    method: String,
    quantity: String,
    expected: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    found: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
enum MethodEntry {
    Failed { name: String, error: String },
    Done(Box<DoneEntry>),
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
struct DoneEntry {
    name: String,
    patch: String,
    basis: String,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    net: Option<NetEntry>,
    /// The patches of a complex, instead of `net`.
    #[serde(skip_serializing_if = "Option::is_none")]
    faces: Option<Vec<FaceEntry>>,
    /// The names of the vertices of a complex, in the order of its control points and of its meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    domain: Option<DomainEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pieces: Option<Vec<PieceEntry>>,
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
    kink: Option<Kink>,
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
    files: Vec<FileEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

/// A file written beside the record.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct FileEntry {
    file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    description: Option<String>,
}

/// `net[i][j]` for rectangular nets, a list of points with their indices for triangular ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
enum NetEntry {
    Rows(Vec<Vec<[f64; 3]>>),
    Triangle(Vec<IndexedPoint>),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct IndexedPoint {
    index: [usize; 3],
    point: [f64; 3],
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

/// One patch of a complex: its vertices by name, in order round it, and its net.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct FaceEntry {
    vertices: Vec<String>,
    net: Vec<Vec<[f64; 3]>>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Kink {
    max: f64,
    rms: f64,
}

/// The way to the least area: where it began, how it ended, whether it is stable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct AreaEntry {
    start_area: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    gradient: Option<f64>,
    iterations: usize,
    evaluations: usize,
    reason: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    second_variation: Option<f64>,
    /// What surface it began with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    start: Option<String>,
    /// The gradient in all coordinates; `gradient` is that along the normals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    whole_gradient: Option<f64>,
    /// The last surface's stages.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stages: Option<Stages>,
    /// Whether a saddle was left on the way.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    left_saddle: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Stages {
    corrections: StageEntry,
    steps: StageEntry,
    normal_steps: StageEntry,
}

/// Steps of one kind and the area lost by them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct StageEntry {
    steps: usize,
    gained: f64,
}

impl From<plateau::Stage> for StageEntry {
    fn from(stage: plateau::Stage) -> Self {
        Self { steps: stage.steps, gained: stage.gained }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct SearchEntry {
    evaluations: u64,
    nan_evaluations: u64,
    engine: String,
    arithmetic: String,
    minimum: f64,
    runs: Vec<RunEntry>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct RunEntry {
    seed: u64,
    run: usize,
    best: f64,
    shape: Vec<f64>,
    reason: String,
    evaluations: u64,
    history: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polish: Option<PolishEntry>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct PolishEntry {
    value: f64,
    kkt_residual: f64,
    active_bounds: Vec<String>,
    evaluations: usize,
    reason: String,
}

impl ResultFile {
    /// The record of an experiment: the plan and what came of it.
    pub fn new(plan: &Plan, finished: &Finished) -> Self {
        let results = &finished.results;
        let methods = results.methods.iter().map(method_entry).collect();
        Self {
            schema: SCHEMA.to_owned(),
            title: results.title.clone(),
            seed: finished.seed,
            methods,
            curve: match results.curves.as_slice() {
                [curve] => Some(CurveEntry::new(curve)),
                _ => None,
            },
            curves: match results.curves.as_slice() {
                [_] => Vec::new(),
                curves => curves.iter().map(CurveEntry::new).collect(),
            },
            warnings: results.warnings.clone(),
            missed: finished.missed().into_iter().map(missed_entry).collect(),
            files: Vec::new(),
            unwritten: Vec::new(),
            manifest: Manifest::of(plan, finished),
        }
    }

    /// Records a file written for method `k`, or for the experiment as a whole.
    pub(crate) fn add_file(&mut self, k: Option<usize>, file: String, form: Option<SurfaceForm>) {
        let (deviation, description) = form.map_or((None, None), |f| (f.deviation, Some(f.description)));
        let entry = FileEntry { file, deviation, description };
        match k.map(|k| self.methods.get_mut(k)) {
            None => self.files.push(entry),
            Some(Some(MethodEntry::Done(method))) => method.files.push(entry),
            Some(_) => {}
        }
    }

    /// The files written beside the record.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        let of_methods = self.methods.iter().flat_map(|method| match method {
            MethodEntry::Done(method) => method.files.as_slice(),
            MethodEntry::Failed { .. } => &[],
        });
        of_methods.chain(&self.files).map(|entry| entry.file.as_str())
    }

    /// Files that were asked for and are not there.
    pub fn unwritten(&self) -> &[String] {
        &self.unwritten
    }

    /// Records a file that was asked for and could not be written.
    pub(crate) fn add_unwritten(&mut self, file: &str) {
        self.unwritten.push(file.to_owned());
    }

    /// The record in the bytes of a `result.json` of this program: what was written, value for value.
    ///
    /// # Errors
    /// [`ReadError`](crate::ReadError), if it is none.
    pub fn parse(bytes: &[u8]) -> Result<Self, crate::ReadError> {
        crate::result_reader::check_size(bytes)?;
        let record: Self = serde_json::from_slice(bytes)
            .map_err(|source| crate::ReadError::Json { place: String::new(), source })?;
        crate::result_reader::check_schema(Some(record.schema.clone()))?;
        Ok(record)
    }

    /// The text of the file: indented JSON with a final line break.
    ///
    /// # Errors
    /// Never in fact: every part of the record has a JSON form.
    pub fn to_json(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }
}

/// What `result.json` says of one method, as JSON.
///
/// # Errors
/// Never in fact: every part of a record has a JSON form.
pub fn method_record(result: &MethodResult) -> serde_json::Result<String> {
    serde_json::to_string(&method_entry(result))
}

fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}

fn missed_entry(missed: Missed) -> MissedEntry {
    MissedEntry {
        method: missed.method,
        quantity: missed.expected.quantity.to_string(),
        expected: missed.expected.text,
        found: missed.ours.and_then(finite),
    }
}

fn method_entry(result: &MethodResult) -> MethodEntry {
    let done = match &result.outcome {
        Ok(done) => done,
        Err(error) => return MethodEntry::Failed { name: result.name.clone(), error: error.to_string() },
    };
    let (solve, film) = (done.solved.solve.as_ref(), done.film.as_ref());
    let value = |quantity: Quantity| quantity.of(done).and_then(|figure| finite(figure.value));
    let error = |quantity: Quantity| quantity.of(done).and_then(|figure| figure.error).and_then(finite);
    let (patch, basis) = done.solved.family.names();
    MethodEntry::Done(Box::new(DoneEntry {
        name: result.name.clone(),
        patch: patch.to_owned(),
        basis: basis.to_owned(),
        dirichlet: value(Quantity::Dirichlet),
        dirichlet_error: error(Quantity::Dirichlet),
        area: value(Quantity::Area),
        area_error: error(Quantity::Area),
        laplacian_defect: value(Quantity::LaplacianDefect),
        laplacian_defect_error: error(Quantity::LaplacianDefect),
        bending: value(Quantity::Bending),
        bending_error: error(Quantity::Bending),
        minimised: Minimised::of(done),
        metric_dirichlet: value(Quantity::MetricDirichlet),
        metric_dirichlet_error: error(Quantity::MetricDirichlet),
        conformality_gap: value(Quantity::ConformalityGap),
        mean_curvature: MeanCurvature::of(
            value(Quantity::MeanCurvatureMax),
            value(Quantity::MeanCurvatureRms),
        ),
        shape: done.solved.shape.clone(),
        net: match &done.solved.surface {
            Surface::Tensor(patch) => Some(NetEntry::Rows(rows(patch.net()))),
            Surface::Triangle(patch) => Some(NetEntry::Triangle(indexed(patch.net()))),
            Surface::Pieces(pieces) => single_net(pieces).map(NetEntry::Rows),
            Surface::Complex(_) => None,
        },
        faces: match (&done.solved.surface, &done.film) {
            (Surface::Complex(complex), Some(film)) => Some(faces(complex, &film.names)),
            (Surface::Complex(_) | Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_), _) => None,
        },
        vertices: film.map(|film| film.names.clone()),
        domain: match &done.solved.surface {
            Surface::Pieces(pieces) => Some(DomainEntry::new(pieces)),
            Surface::Tensor(_) | Surface::Triangle(_) | Surface::Complex(_) => None,
        },
        pieces: match &done.solved.surface {
            Surface::Pieces(pieces) => piece_entries(pieces),
            Surface::Tensor(_) | Surface::Triangle(_) | Surface::Complex(_) => None,
        },
        weights: done.closed_form.and_then(|form| form.weights),
        deviation: value(Quantity::Deviation),
        solver: solve.map(|s| s.solver.to_owned()),
        residual: value(Quantity::Residual),
        condition: solve.and_then(|s| finite(s.condition)),
        basis_condition: solve.and_then(|s| s.basis_condition).and_then(finite),
        certified: solve.and_then(|s| s.certified),
        area_extremal: done.solved.area.map(|found| AreaEntry {
            start_area: found.start,
            gradient: finite(found.gradient),
            iterations: found.iterations,
            evaluations: found.evaluations,
            reason: found.reason(),
            second_variation: found.second_variation.and_then(finite),
            start: Some(found.from.to_string()),
            whole_gradient: finite(found.whole_gradient),
            stages: Some(Stages {
                corrections: found.corrections.into(),
                steps: found.steps.into(),
                normal_steps: found.normal_steps.into(),
            }),
            left_saddle: found.left_saddle,
        }),
        boundary_deviation: value(Quantity::BoundaryDeviation),
        rim_deviation: value(Quantity::RimDeviation),
        kink: film.and_then(|film| film.seams.kink).map(|kink| Kink { max: kink.max, rms: kink.rms }),
        jacobian_ratio: value(Quantity::JacobianRatio),
        area_estimate: done.estimate.and_then(finite),
        lower_bound: done.bound.as_ref().map(|bound| bound.value),
        lower_bound_proof: done.bound.as_ref().map(ProofEntry::new),
        spanned_one_by_one: value(Quantity::SpannedOneByOne),
        harmonic_bound: value(Quantity::HarmonicBound),
        harmonic_bound_error: error(Quantity::HarmonicBound),
        search: done.solved.search.as_ref().map(search_entry),
        files: Vec::new(),
        warnings: done.warnings.iter().map(ToString::to_string).collect(),
    }))
}

fn faces(complex: &Complex, names: &[String]) -> Vec<FaceEntry> {
    let count = complex.degree() + 1;
    let entry = |face: &Face| FaceEntry {
        vertices: face.vertices().map(|vertex| names[vertex].clone()).to_vec(),
        net: face
            .nodes()
            .chunks_exact(count)
            .map(|row| row.iter().map(|&k| complex.points()[k].into()).collect())
            .collect(),
    };
    complex.faces().iter().map(entry).collect()
}

fn indexed(net: &TriangleNet) -> Vec<IndexedPoint> {
    net.indices().zip(net.points()).map(|(index, &p)| IndexedPoint { index, point: p.into() }).collect()
}

fn search_entry(outcome: &SearchOutcome) -> SearchEntry {
    SearchEntry {
        evaluations: outcome.evaluations,
        nan_evaluations: outcome.nan_evaluations,
        engine: outcome.engine.to_owned(),
        arithmetic: outcome.arithmetic.to_owned(),
        minimum: outcome.minimum,
        runs: outcome.runs.iter().map(run_entry).collect(),
    }
}

fn run_entry(run: &SearchRun) -> RunEntry {
    RunEntry {
        seed: run.seed,
        run: run.index,
        best: run.value,
        shape: run.shape.clone(),
        reason: run.reason.clone(),
        evaluations: run.evaluations,
        history: run.history.iter().copied().filter(|v| v.is_finite()).collect(),
        polish: run.polish.as_ref().map(|p| PolishEntry {
            value: p.value,
            kkt_residual: p.residual,
            active_bounds: active_bounds(p).into_iter().map(str::to_owned).collect(),
            evaluations: p.evaluations,
            reason: p.reason.to_string(),
        }),
    }
}

/// The bounds a polish ended at, as `result.json` lists them.
fn active_bounds(polished: &optim::Polished) -> Vec<&'static str> {
    polished
        .active
        .iter()
        .map(|bound| match bound {
            optim::Bound::Lower => "lower",
            optim::Bound::Free => "free",
            optim::Bound::Upper => "upper",
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every key a method may have that no method of this version writes.
    #[test]
    fn keys_of_complexes_are_read_and_written() {
        let method = serde_json::json!({
            "name": "Least area", "patch": "complex", "basis": "bernstein", "area": 2.5, "coons_functional": 3.0,
            "metric_dirichlet": 2.6, "rim_deviation": 1e-9, "kink": { "max": 0.1, "rms": -0.0 }, "jacobian_ratio": 0.25,
            "area_estimate": 1e-4, "lower_bound": 2.4, "spanned_one_by_one": 5.0,
            "faces": [{ "vertices": ["a", "b", "c", "d"], "net": [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.1]], [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]] }],
        });
        let entry: MethodEntry = serde_json::from_value(method.clone()).unwrap();
        assert!(matches!(&entry, MethodEntry::Done(done) if done.faces.is_some() && done.kink.is_some()));
        assert_eq!(serde_json::to_value(&entry).unwrap(), method);
        let failed = serde_json::json!({ "name": "x", "error": "y" });
        let entry: MethodEntry = serde_json::from_value(failed.clone()).unwrap();
        assert!(matches!(&entry, MethodEntry::Failed { .. }));
        assert_eq!(serde_json::to_value(&entry).unwrap(), failed);
    }
}
