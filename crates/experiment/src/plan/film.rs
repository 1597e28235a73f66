//! `[[method]]` over loops and faces.

use std::ops::Range;

use plateau::{CurveGraph, Energy, FillEnergy, Loop};

use super::Wanted;
use super::expected::check::{Subject, wanted_of};
use super::method::{Named, has_only_keys_over};
use crate::keys::method::{ACCURACY, BOUND, DEGREE, ENERGY, LAYERS, LOOPS, RIM_TOLERANCE, TOLERANCE};
use crate::text::{Given, Table};

/// Surfaces over loops or faces: one row of the table per method.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmExperiment {
    /// What they span.
    pub rim: Rim,
    /// At least one; names are unique.
    pub methods: Vec<FilmMethod>,
}

/// What a surface of several patches spans.
#[derive(Clone, Debug, PartialEq)]
pub enum Rim {
    /// One loop, spanned by a disc, or two, spanned by an annulus.
    Loops(Vec<Loop>),
    /// The faces of a graph of curves.
    Faces(CurveGraph),
}

/// One way to fill loops or faces.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmMethod {
    /// Name of the row; not empty, unique in the experiment.
    pub name: String,
    /// What is minimised.
    pub energy: FillEnergy,
    /// The degree of every patch, if the file gives one.
    pub degree: Option<usize>,
    /// Layers of smaller patches around corners, 0 or 1; only for [`FillEnergy::Area`].
    pub layers: usize,
    /// For [`FillEnergy::Area`]: the relative decrease of the area that counts as none, in [1e-12, 1e-2].
    pub tolerance: f64,
    /// How far the rim may pass from curves that cannot be met exactly, a length, if the file says so.
    pub rim_tolerance: Option<f64>,
    /// For [`FillEnergy::Area`]: the share of the least area that the area may lie above it, in [1e-12, 1e-2]; the degree rises for it.
    pub accuracy: Option<f64>,
    /// Whether a lower bound is to be proved; only for [`FillEnergy::Area`].
    pub bound: bool,
}

impl Rim {
    /// How many loops there are to span.
    fn loops(&self) -> usize {
        match self {
            Self::Loops(loops) => loops.len(),
            Self::Faces(_) => 0,
        }
    }
}

/// Checks every method over loops or faces, whose heading is at `header`.
pub(super) fn methods(
    named: Vec<Named<'_>>,
    rim: Option<&Rim>,
    header: &Range<usize>,
) -> Option<Vec<(FilmMethod, Wanted)>> {
    let checked: Vec<Option<(FilmMethod, Wanted)>> = named
        .into_iter()
        .map(|(name, table)| {
            let fits = has_only_keys_over(&table, (LOOPS, "a boundary of loops or faces"), header);
            method(&table, rim, name).filter(|_| fits)
        })
        .collect();
    checked.into_iter().collect()
}

fn method(table: &Table<'_>, rim: Option<&Rim>, name: Option<String>) -> Option<(FilmMethod, Wanted)> {
    let degree = table.take(&DEGREE).known();
    let layers_given = table.take(&LAYERS);
    let layers = table.or_default(&LAYERS, &layers_given);
    let tolerance_given = table.take(&TOLERANCE);
    let energy = energy(table, &table.take(&ENERGY));
    let tolerance = table.or_default(&TOLERANCE, &tolerance_given);
    let rim_tolerance = table.take(&RIM_TOLERANCE).known();
    let accuracy_given = table.take(&ACCURACY);
    let bound_given = table.take(&BOUND);
    let bound = table.or_default(&BOUND, &bound_given);
    let only_of_areas = |key: &str, span: Option<Range<usize>>| match (span, energy) {
        (Some(span), Some(FillEnergy::Dirichlet)) => {
            table.faults().clash(
                (span, "needs energy = \"area\""),
                format!("{} has a `{key}`, but does not minimise the area", table.name()),
                "leave it out, or write energy = \"area\"",
            );
            false
        }
        (Some(_) | None, _) => true,
    };
    let fits = only_of_areas("tolerance", tolerance_given.span())
        & only_of_areas("layers", layers_given.span().filter(|_| layers.is_some_and(|layers| layers > 0)))
        & only_of_areas("accuracy", accuracy_given.span())
        & only_of_areas("bound", bound_given.span().filter(|_| bound == Some(true)));
    let wanted = wanted_of(
        table,
        Some(Subject::Film {
            least: energy.map(|energy| energy == FillEnergy::Area),
            bound,
            loops: rim.map(Rim::loops),
        }),
    );
    let method = FilmMethod {
        name: name?,
        energy: energy?,
        degree: degree?.map(|degree| degree.into_inner()),
        layers: layers?,
        tolerance: tolerance?,
        rim_tolerance: rim_tolerance?.map(|tolerance| tolerance.into_inner()),
        accuracy: accuracy_given.known()?.map(|accuracy| accuracy.into_inner()),
        bound: bound?,
    };
    fits.then_some((method, wanted?))
}

fn energy(table: &Table<'_>, given: &Given<Energy>) -> Option<FillEnergy> {
    const HELP: &str = "write energy = \"area\" for the least area, or energy = \"dirichlet\"";
    match given {
        Given::Absent => {
            table.missing("energy", HELP);
            None
        }
        Given::Faulty => None,
        Given::Sound(energy) => match *energy.get_ref() {
            Energy::Area => Some(FillEnergy::Area),
            Energy::DIRICHLET => Some(FillEnergy::Dirichlet),
            Energy::Quadratic(_) => {
                table.faults().clash(
                    (energy.span(), "not over loops and faces"),
                    format!(
                        "{} minimises an energy of single patches over a boundary of several",
                        table.name()
                    ),
                    HELP,
                );
                None
            }
        },
    }
}
