//! Running a plan: all methods of an experiment, their figures, what the file expected of them.

use crate::curve;
use crate::degeneracy::degeneracies;
use crate::helicoid::{helicoids, trapezium};
use crate::method::{self, Context};
use crate::{
    Arithmetic, BoundaryFigures, Checkpoint, ClosedForm, CurveResult, Expected, Experiment, Figures,
    Manifest, Method, MethodError, Plan, Progress, Published, Quantity, Solved, Surface,
};

/// Choices that are not part of the experiment.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Options {
    /// Replaces the seed of the file.
    pub seed: Option<u64>,
    /// Which arithmetic evaluates the energy in searches.
    pub arithmetic: Arithmetic,
}

/// An experiment that was run.
#[derive(Debug)]
#[non_exhaustive]
pub struct Finished {
    /// The title of the file.
    pub title: String,
    /// The seed used.
    pub seed: u64,
    /// What the numbers depend on.
    pub manifest: Manifest,
    /// One entry per method, in the order of the file.
    pub methods: Vec<MethodResult>,
    /// The sampled curve, of curve experiments; they have no methods.
    pub curve: Option<CurveResult>,
    /// What a reader must know about the whole experiment.
    pub warnings: Vec<String>,
}

/// What became of one method.
#[derive(Debug)]
#[non_exhaustive]
pub struct MethodResult {
    /// The name of the row.
    pub name: String,
    /// The patch and its figures, or why there is none.
    pub outcome: Result<Box<Done>, MethodError>,
    /// The numbers the file expects of this method.
    pub expect: Vec<Expected>,
    /// The numbers printed elsewhere for this method.
    pub published: Vec<Published>,
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
    pub warnings: Vec<String>,
}

/// An expected number that was not met.
#[derive(Debug, Clone, PartialEq)]
pub struct Missed {
    /// The method.
    pub method: String,
    /// The number of the file.
    pub expected: Expected,
    /// Ours; none if the method has no such figure.
    pub ours: Option<f64>,
}

/// Runs every method of a plan. A method that fails takes none of the others with it.
///
/// # Errors
/// As for a method, of the one curve of a curve experiment.
pub fn run(plan: &Plan, options: Options, progress: &dyn Progress) -> Result<Finished, MethodError> {
    run_kept(plan, options, progress, None)
}

/// As [`run()`], with the runs of searches that `checkpoint` holds taken from there, and those that end kept there. The
/// result is the same bit for bit, whatever the checkpoint held, if its manifest is that of `plan` and `options`.
///
/// # Errors
/// As [`run()`].
pub fn run_kept(
    plan: &Plan,
    options: Options,
    progress: &dyn Progress,
    checkpoint: Option<&Checkpoint>,
) -> Result<Finished, MethodError> {
    let (title, seed) = (plan.title.clone(), options.seed.unwrap_or(plan.seed));
    let manifest = Manifest::new(plan, options);
    let mut finished =
        Finished { title, seed, manifest, methods: Vec::new(), curve: None, warnings: Vec::new() };
    let mesh = plan.output.mesh;
    match &plan.experiment {
        Experiment::Patch(experiment) => {
            let arithmetic = options.arithmetic;
            let context = Context { experiment, index: 0, checkpoint, seed, arithmetic, progress };
            finished.warnings = degeneracies(&experiment.boundary);
            finished.methods = patches(&context, mesh);
        }
        Experiment::Helicoid(helicoid) => finished.methods = helicoids(helicoid, mesh, progress),
        Experiment::TrapeziumHelicoid(helicoid) => finished.methods = vec![trapezium(helicoid, mesh)],
        Experiment::Curve(curve) => {
            let sampled = curve::sample(curve)?;
            finished.warnings = sampled.warnings(curve, &plan.output);
            finished.curve = Some(sampled);
        }
    }
    Ok(finished)
}

fn patches(context: &Context<'_>, mesh: usize) -> Vec<MethodResult> {
    let result = |(index, method): (usize, &Method)| MethodResult {
        name: method.name.clone(),
        outcome: run_method(method, &Context { index, ..*context }, mesh).map(Box::new),
        expect: method.expect.clone(),
        published: method.published.clone(),
    };
    context.experiment.methods.iter().enumerate().map(result).collect()
}

fn run_method(method: &Method, context: &Context<'_>, mesh: usize) -> Result<Done, MethodError> {
    if context.progress.cancelled() {
        return Err(MethodError::Interrupted);
    }
    let solved = method::solve(method, context)?;
    let cancellation = solved.surface.cancellation();
    if cancellation > method::WORST_CANCELLATION {
        return Err(MethodError::Cancellation { degrees: solved.surface.degrees(), share: cancellation });
    }
    context.progress.begin(&format!("figures of {}", method.name), None);
    let mesh = solved.surface.mesh(mesh);
    let figures = Figures::of(solved.surface.patch(), &mesh);
    context.progress.end();
    let figures = figures?;
    let boundary = match &solved.surface {
        Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
        Surface::Triangle(_) | Surface::Pieces(_) => None,
    };
    let warnings = crate::report::warnings(&solved, &figures, &context.experiment.search);
    Ok(Done { solved, mesh, figures, boundary, closed_form: None, warnings })
}

impl Finished {
    /// The expected numbers that were not met; a method that failed meets none.
    pub fn missed(&self) -> Vec<Missed> {
        self.comparisons()
            .filter(|(_, expected, ours)| !ours.is_some_and(|ours| expected.is_met_by(ours)))
            .map(|(name, expected, ours)| Missed { method: name.into(), expected: expected.clone(), ours })
            .collect()
    }

    /// How many numbers the file expects.
    pub fn expected(&self) -> usize {
        self.comparisons().count()
    }

    /// Every expected number with its method and ours.
    pub(crate) fn comparisons(&self) -> impl Iterator<Item = (&str, &Expected, Option<f64>)> {
        let of_methods = self.methods.iter().flat_map(|method| {
            method.expect.iter().map(|e| (method.name.as_str(), e, method.figure(e.quantity)))
        });
        let of_curve = self
            .curve
            .iter()
            .flat_map(|curve| curve.expect.iter().map(|e| ("curve", e, curve.figure(e.quantity))));
        of_methods.chain(of_curve)
    }

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
