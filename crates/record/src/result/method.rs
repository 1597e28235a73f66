//! What `result.json` says of a method.

use plateau::{Done, MethodResult, Quantity, Surface};
use serde::{Deserialize, Serialize};
use surfaces::{Complex, Face, TriangleNet};

use super::extremal::AreaEntry;
use super::file::FileEntry;
use super::minimised::Minimised;
use super::net::rows;
use super::number::finite;
use super::pieces::{DomainEntry, PieceEntry, piece_entries, single_net};
use super::proof::ProofEntry;
use super::search::SearchEntry;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(super) enum MethodEntry {
    Failed { name: String, error: String },
    Done(Box<DoneEntry>),
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct DoneEntry {
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
    pub(super) faces: Option<Vec<FaceEntry>>,
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
pub(super) struct FaceEntry {
    vertices: Vec<String>,
    net: Vec<Vec<[f64; 3]>>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Kink {
    max: f64,
    rms: f64,
}

impl MethodEntry {
    pub(super) fn of(result: &MethodResult) -> Self {
        match &result.outcome {
            Ok(done) => Self::Done(Box::new(DoneEntry::of(&result.name, done))),
            Err(error) => Self::Failed { name: result.name.clone(), error: error.to_string() },
        }
    }
}

/// The value of a figure, if it has one that JSON has.
fn value(done: &Done, quantity: Quantity) -> Option<f64> {
    quantity.of(done).and_then(|figure| finite(figure.value))
}

/// Its error, likewise.
fn error(done: &Done, quantity: Quantity) -> Option<f64> {
    quantity.of(done).and_then(|figure| figure.error).and_then(finite)
}

impl DoneEntry {
    fn of(name: &str, done: &Done) -> Self {
        let (patch, basis) = done.solved.family.names();
        let mut entry = Self {
            name: name.to_owned(),
            patch: patch.to_owned(),
            basis: basis.to_owned(),
            shape: done.solved.shape.clone(),
            weights: done.closed_form.and_then(|form| form.weights),
            search: done.solved.search.as_ref().map(SearchEntry::of),
            warnings: done.warnings.iter().map(ToString::to_string).collect(),
            ..Self::default()
        };
        entry.add_energies(done);
        entry.add_surface(done);
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

    /// What the surface is made of.
    fn add_surface(&mut self, done: &Done) {
        let film = done.film.as_ref();
        self.net = match &done.solved.surface {
            Surface::Tensor(patch) => Some(NetEntry::Rows(rows(patch.net()))),
            Surface::Triangle(patch) => Some(NetEntry::Triangle(indexed(patch.net()))),
            Surface::Pieces(pieces) => single_net(pieces).map(NetEntry::Rows),
            Surface::Complex(_) => None,
        };
        self.faces = match (&done.solved.surface, &done.film) {
            (Surface::Complex(complex), Some(film)) => Some(faces(complex, &film.names)),
            (Surface::Complex(_) | Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_), _) => None,
        };
        self.vertices = film.map(|film| film.names.clone());
        self.domain = match &done.solved.surface {
            Surface::Pieces(pieces) => Some(DomainEntry::new(pieces)),
            Surface::Tensor(_) | Surface::Triangle(_) | Surface::Complex(_) => None,
        };
        self.pieces = match &done.solved.surface {
            Surface::Pieces(pieces) => piece_entries(pieces),
            Surface::Tensor(_) | Surface::Triangle(_) | Surface::Complex(_) => None,
        };
    }

    /// How it was solved for.
    fn add_way(&mut self, done: &Done) {
        let solve = done.solved.solve.as_ref();
        self.solver = solve.map(|s| s.solver.to_owned());
        self.residual = value(done, Quantity::Residual);
        self.condition = solve.and_then(|s| finite(s.condition));
        self.basis_condition = solve.and_then(|s| s.basis_condition).and_then(finite);
        self.certified = solve.and_then(|s| s.certified);
        self.area_extremal = done.solved.area.map(AreaEntry::from);
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
