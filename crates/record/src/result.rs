//! `result.json`, the record of an experiment for other programs.

use serde::Serialize;
use surfaces::{Net, TriangleNet};

use crate::Manifest;
use exchange::SurfaceForm;
use experiment::{Finished, Missed, Plan};
use plateau::MethodResult;
use plateau::{SearchOutcome, SearchRun, Surface};

mod curve;
mod pieces;

use curve::CurveEntry;
use pieces::{DomainEntry, PieceEntry, piece_entries, single_net};

/// The version of the layout; the number after the slash changes only if a program reading it would break.
pub const SCHEMA: &str = "plateau-result/1";

/// The whole file. Numbers are written with all their digits; keys without a meaning are left out, and no number
/// that is not finite ever appears.
#[derive(Debug, Clone, Serialize)]
pub struct ResultFile {
    schema: &'static str,
    title: String,
    seed: u64,
    methods: Vec<MethodEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<CurveEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
    /// The numbers of the file that were not met.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    missed: Vec<MissedEntry>,
    /// Files beside the record that belong to no method.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    files: Vec<FileEntry>,
    /// Files that were asked for and are not there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unwritten: Vec<String>,
    manifest: Manifest,
}

#[derive(Debug, Clone, Serialize)]
struct MissedEntry {
    method: String,
    quantity: String,
    expected: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    found: Option<f64>,
}

#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
enum MethodEntry {
    Failed { name: String, error: String },
    Done(Box<DoneEntry>),
}

#[derive(Debug, Clone, Default, Serialize)]
struct DoneEntry {
    name: String,
    patch: &'static str,
    basis: &'static str,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    conformality_gap: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_curvature: Option<MeanCurvature>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<[f64; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    net: Option<NetEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    domain: Option<DomainEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pieces: Option<Vec<PieceEntry>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    solver: Option<&'static str>,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic_bound: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic_bound_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    search: Option<SearchEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    files: Vec<FileEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

/// A file written beside the record.
#[derive(Debug, Clone, Serialize)]
struct FileEntry {
    file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    description: Option<String>,
}

/// `net[i][j]` for rectangular nets, a list of points with their indices for triangular ones.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
enum NetEntry {
    Rows(Vec<Vec<[f64; 3]>>),
    Triangle(Vec<IndexedPoint>),
}

#[derive(Debug, Clone, Serialize)]
struct IndexedPoint {
    index: [usize; 3],
    point: [f64; 3],
}

#[derive(Debug, Clone, Serialize)]
struct MeanCurvature {
    #[serde(skip_serializing_if = "Option::is_none")]
    max_abs: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rms: Option<f64>,
}

/// The way to the least area: where it began, how it ended, whether it is stable.
#[derive(Debug, Clone, Serialize)]
struct AreaEntry {
    start_area: f64,
    gradient: f64,
    iterations: usize,
    evaluations: usize,
    reason: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    second_variation: Option<f64>,
}

#[derive(Debug, Clone, Serialize)]
struct SearchEntry {
    evaluations: u64,
    nan_evaluations: u64,
    engine: &'static str,
    arithmetic: &'static str,
    minimum: f64,
    runs: Vec<RunEntry>,
}

#[derive(Debug, Clone, Serialize)]
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

#[derive(Debug, Clone, Serialize)]
struct PolishEntry {
    value: f64,
    kkt_residual: f64,
    active_bounds: Vec<&'static str>,
    evaluations: usize,
    reason: String,
}

impl ResultFile {
    /// The record of an experiment: the plan and what came of it.
    pub fn new(plan: &Plan, finished: &Finished) -> Self {
        let results = &finished.results;
        let methods = results.methods.iter().map(method_entry).collect();
        Self {
            schema: SCHEMA,
            title: results.title.clone(),
            seed: finished.seed,
            methods,
            curve: results.curve.as_ref().map(CurveEntry::new),
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
    let f = &done.figures;
    let solve = done.solved.solve.as_ref();
    let (patch, basis) = done.solved.family.names();
    MethodEntry::Done(Box::new(DoneEntry {
        name: result.name.clone(),
        patch,
        basis,
        dirichlet: finite(f.dirichlet.value),
        dirichlet_error: finite(f.dirichlet.error),
        area: finite(f.area.value),
        area_error: finite(f.area.error),
        laplacian_defect: finite(f.laplacian_defect.value),
        laplacian_defect_error: finite(f.laplacian_defect.error),
        bending: finite(f.bending.value),
        bending_error: finite(f.bending.error),
        conformality_gap: f.conformality_gap.and_then(finite),
        mean_curvature: (f.mean_curvature_max.or(f.mean_curvature_rms).is_some())
            .then_some(MeanCurvature { max_abs: f.mean_curvature_max, rms: f.mean_curvature_rms }),
        shape: done.solved.shape,
        net: match &done.solved.surface {
            Surface::Tensor(patch) => Some(NetEntry::Rows(rows(patch.net()))),
            Surface::Triangle(patch) => Some(NetEntry::Triangle(indexed(patch.net()))),
            Surface::Pieces(pieces) => single_net(pieces).map(NetEntry::Rows),
        },
        domain: match &done.solved.surface {
            Surface::Pieces(pieces) => Some(DomainEntry::new(pieces)),
            Surface::Tensor(_) | Surface::Triangle(_) => None,
        },
        pieces: match &done.solved.surface {
            Surface::Pieces(pieces) => piece_entries(pieces),
            Surface::Tensor(_) | Surface::Triangle(_) => None,
        },
        weights: done.closed_form.and_then(|form| form.weights),
        deviation: done.closed_form.map(|form| form.deviation).and_then(finite),
        solver: solve.map(|s| s.solver),
        residual: solve.and_then(|s| finite(s.residual)),
        condition: solve.and_then(|s| finite(s.condition)),
        basis_condition: solve.and_then(|s| s.basis_condition).and_then(finite),
        certified: solve.and_then(|s| s.certified),
        area_extremal: done.solved.area.map(|found| AreaEntry {
            start_area: found.start,
            gradient: found.gradient,
            iterations: found.iterations,
            evaluations: found.evaluations,
            reason: found.reason().to_owned(),
            second_variation: found.second_variation.and_then(finite),
        }),
        boundary_deviation: done.boundary.map(|b| b.deviation).and_then(finite),
        harmonic_bound: done.boundary.map(|b| b.harmonic_bound).and_then(finite),
        harmonic_bound_error: done.boundary.map(|b| b.harmonic_bound_error).and_then(finite),
        search: done.solved.search.as_ref().map(search_entry),
        files: Vec::new(),
        warnings: done.warnings.iter().map(ToString::to_string).collect(),
    }))
}

fn rows(net: &Net) -> Vec<Vec<[f64; 3]>> {
    net.points()
        .chunks_exact(net.cols())
        .map(|row| row.iter().copied().map(<[f64; 3]>::from).collect())
        .collect()
}

fn indexed(net: &TriangleNet) -> Vec<IndexedPoint> {
    net.indices().zip(net.points()).map(|(index, &p)| IndexedPoint { index, point: p.into() }).collect()
}

fn search_entry(outcome: &SearchOutcome) -> SearchEntry {
    SearchEntry {
        evaluations: outcome.evaluations,
        nan_evaluations: outcome.nan_evaluations,
        engine: outcome.engine,
        arithmetic: outcome.arithmetic,
        minimum: outcome.minimum,
        runs: outcome.runs.iter().map(run_entry).collect(),
    }
}

fn run_entry(run: &SearchRun) -> RunEntry {
    RunEntry {
        seed: run.seed,
        run: run.index,
        best: run.value,
        shape: run.shape.to_vec(),
        reason: run.reason.clone(),
        evaluations: run.evaluations,
        history: run.history.iter().copied().filter(|v| v.is_finite()).collect(),
        polish: run.polish.as_ref().map(|p| PolishEntry {
            value: p.value,
            kkt_residual: p.residual,
            active_bounds: active_bounds(p),
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
