//! Running a plan: its surfaces or its curve, and what the file wants of them.

use plateau::{
    Arithmetic, Context, Curve, CurveResult, Done, Energy, Fill, Helicoid, Keeper, MethodError, MethodResult,
    Progress, Quantity, Remark, Results, Solved, counted, degeneracies, helicoids, of_net, sample, solve,
    trapezium,
};

use crate::advice::advised;
use crate::{Expected, Experiment, FilmExperiment, FilmMethod, Output, PatchExperiment, Plan, Rim, Wanted};

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
    /// What was computed.
    pub results: Results,
    /// The seed used.
    pub seed: u64,
    /// The arithmetic asked for.
    pub arithmetic: Arithmetic,
    /// What the file wants of every row of the results, or of the curve.
    pub wanted: Vec<Wanted>,
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
    run_kept(plan, options, progress, &())
}

/// As [`run()`], with the runs of searches that `keeper` holds taken from there, and those that end kept there. The
/// result is the same bit for bit, whatever was kept, if it was kept of the same plan and options by the same program.
///
/// # Errors
/// As [`run()`].
pub fn run_kept(
    plan: &Plan,
    options: Options,
    progress: &dyn Progress,
    keeper: &dyn Keeper,
) -> Result<Finished, MethodError> {
    let (seed, arithmetic) = (options.seed.unwrap_or(plan.seed), options.arithmetic);
    let mut wanted = plan.wanted.clone();
    let mesh = plan.output.mesh;
    let of_methods = |methods| Results::of_methods(plan.title.as_str(), methods);
    let results = match &plan.experiment {
        Experiment::Patch(experiment) => {
            let mut context = Context::new(seed);
            (context.search, context.arithmetic, context.mesh) = (experiment.search, arithmetic, mesh);
            (context.keeper, context.progress) = (keeper, progress);
            let degenerate = degeneracies(&experiment.boundary).into_iter().map(Remark::from);
            let welded = experiment.boundary.welding().map(Remark::from);
            of_methods(patches(experiment, &context)).with_remarks(degenerate.chain(welded).collect())
        }
        Experiment::Film(experiment) => of_methods(films(experiment, mesh, progress)),
        Experiment::Helicoid(helicoid) => {
            wanted = wanted_of_frames(helicoid, wanted);
            of_methods(helicoids(helicoid, mesh, progress))
        }
        Experiment::TrapeziumHelicoid(helicoid, construction) => {
            of_methods(vec![trapezium(helicoid, *construction, mesh)])
        }
        Experiment::Net(net) => of_methods(vec![of_net(net, mesh)]),
        Experiment::Curve(curves) => sampled(plan, curves)?,
    };
    Ok(Finished { results, seed, arithmetic, wanted })
}

/// Curves with what is to be known of each.
fn sampled(plan: &Plan, curves: &[Curve]) -> Result<Results, MethodError> {
    let sampled = curves.iter().map(sample).collect::<Result<Vec<_>, _>>()?;
    let of_curve = |of: &CurveResult| -> Vec<Remark> {
        let remark = |warning| match curves.len() {
            1 => Remark::Whole(warning),
            _ => Remark::Curve { curve: of.name().to_owned(), warning },
        };
        of.warnings().into_iter().map(remark).collect()
    };
    let remarks = without_mesh(&plan.output).into_iter().chain(sampled.iter().flat_map(of_curve)).collect();
    Ok(Results::of_curves(plan.title.as_str(), sampled).with_remarks(remarks))
}

fn patches(experiment: &PatchExperiment, context: &Context<'_>) -> Vec<MethodResult> {
    // Least areas last, the lower degrees first: none of them ends above what the others found.
    let methods = &experiment.methods;
    let is_area = |k: usize| methods[k].minimised() == Some(Energy::Area);
    let mut order: Vec<usize> = (0..methods.len()).collect();
    order.sort_by_key(|&k| (is_area(k), if is_area(k) { methods[k].raise() } else { 0 }));
    let mut results: Vec<Option<MethodResult>> = methods.iter().map(|_| None).collect();
    for index in order {
        let at_hand: Vec<&Solved> =
            results.iter().flatten().filter_map(|r| Some(&r.outcome.as_ref().ok()?.solved)).collect();
        let mut context = *context;
        (context.index, context.at_hand) = (index, &at_hand);
        let outcome = solve(&experiment.boundary, &methods[index], &context).map(Box::new).map_err(advised);
        results[index] = Some(MethodResult { name: methods[index].name().to_owned(), outcome });
    }
    results.into_iter().flatten().collect()
}

/// The surfaces over loops or faces.
fn films(experiment: &FilmExperiment, mesh: usize, progress: &dyn Progress) -> Vec<MethodResult> {
    let filled = |method: &FilmMethod| -> Result<Done, MethodError> {
        if progress.cancelled() {
            return Err(MethodError::Interrupted);
        }
        let fill = Fill::default()
            .with_energy(method.energy)
            .with_tolerance(method.tolerance)
            .with_rim_tolerance(method.rim_tolerance)
            .with_layers(method.layers)
            .with_accuracy(method.accuracy)
            .with_bound(method.bound)
            .with_mesh_in_all(mesh);
        let fill = method.degree.map_or(fill, |degree| fill.with_degree(degree));
        progress.begin(&format!("surface of {}", method.name), None);
        let film = match &experiment.rim {
            Rim::Loops(loops) => fill.loops(loops, progress),
            Rim::Faces(graph) => fill.graph(graph, progress),
        };
        progress.end();
        Ok(film?.into_done())
    };
    let result = |method: &FilmMethod| MethodResult {
        name: method.name.clone(),
        outcome: filled(method).map(Box::new),
    };
    experiment.methods.iter().map(result).collect()
}

/// What is wanted of a helicoid and of the frames of its deformation: of every frame what is the same for all.
fn wanted_of_frames(helicoid: &Helicoid, mut wanted: Vec<Wanted>) -> Vec<Wanted> {
    let shared: Vec<Expected> =
        wanted.iter().flat_map(|w| &w.expect).filter(|e| is_shared(e.quantity)).cloned().collect();
    wanted.extend((0..helicoid.frames()).map(|_| Wanted { expect: shared.clone(), published: Vec::new() }));
    wanted
}

/// Whether a figure is the same for all surfaces of a deformation: then it is expected of every frame.
fn is_shared(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::Deviation
            | Quantity::ConformalityGap
            | Quantity::MeanCurvatureMax
            | Quantity::MeanCurvatureRms
    )
}

/// What is said where a curve is asked for in formats of surfaces.
fn without_mesh(output: &Output) -> Option<Remark> {
    let formats: Vec<_> = output.formats.iter().map(|format| format.name()).collect();
    (!formats.is_empty()).then_some(Remark::NoMesh { formats })
}

/// That expected numbers were missed or methods failed, in words; none if none were.
pub fn shortfall(missed: usize, failed: usize) -> Option<String> {
    let told =
        || format!("{} missed, {} failed", counted(missed, "expected number"), counted(failed, "method"));
    (missed + failed > 0).then(told)
}

impl Finished {
    /// The expected numbers that were not met; a method that failed meets none.
    pub fn missed(&self) -> Vec<Missed> {
        self.comparisons()
            .filter(|(_, expected, ours)| !ours.is_some_and(|ours| expected.is_met_by(ours)))
            .map(|(name, expected, ours)| Missed { method: name.into(), expected: expected.clone(), ours })
            .collect()
    }

    /// What is not as the file wants it, in words; none if all is.
    pub fn shortfall(&self) -> Option<String> {
        shortfall(self.missed().len(), self.results.failures().count())
    }

    /// How many numbers the file expects.
    pub fn expected(&self) -> usize {
        self.comparisons().count()
    }

    /// Every expected number with its method and ours.
    pub fn comparisons(&self) -> impl Iterator<Item = (&str, &Expected, Option<f64>)> {
        let of_methods = self.results.methods().iter().zip(&self.wanted).flat_map(|(method, wanted)| {
            wanted.expect.iter().map(|e| (method.name.as_str(), e, method.figure(e.quantity)))
        });
        let of_curves =
            self.results.curves().first().into_iter().zip(&self.wanted).flat_map(|(_, wanted)| {
                wanted.expect.iter().map(|e| ("curve", e, self.results.figure_of_curves(e.quantity)))
            });
        of_methods.chain(of_curves)
    }
}
