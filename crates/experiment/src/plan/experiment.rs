//! The file as a whole: its subject, and what is written of it.

use std::path::Path;

use serde_spanned::Spanned;

use super::boundary::{Sides, boundary};
use super::curve::curve;
use super::helicoid::{helicoid, trapezium};
use super::memory::fits;
use super::method::methods;
use super::search::search;
use super::{Experiment, Output, PatchExperiment, Plan, Wanted};
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::output::{FORMATS, MESH, PICTURES, STEP_TOLERANCE};
use crate::keys::{BOUNDARY, CURVE, EXPECT, HELICOID, METHOD, OUTPUT, SEARCH, SEED, TITLE, TRAPEZIUM};
use crate::text::{Given, Table};

const KINDS: &str =
    "an experiment holds one of [boundary] with [[method]] tables, [helicoid], [trapezium-helicoid], [curve]";

/// The plan that a file describes; its faults are reported.
pub(super) fn plan(root: &Table<'_>, file: &str) -> Option<Plan> {
    let title = root.require(&TITLE);
    let seed = root.take_or_default(&SEED);
    let output = root.inner_or_empty(&OUTPUT).and_then(|table| output(&table));
    let experiment = experiment(root);
    if let (Some((experiment, _)), Some(output)) = (&experiment, &output) {
        fits(root, experiment, output.mesh);
    }
    let (experiment, wanted) = experiment?;
    Some(Plan {
        title: title?.into_inner(),
        seed: seed?,
        stem: stem(file),
        file: file.to_owned(),
        experiment,
        wanted,
        output: output?,
        text: root.faults().text().to_owned(),
    })
}

/// The file name without its folders and its last extension; never empty, and no name of a folder above (`...toml`).
pub fn stem(file: &str) -> String {
    Path::new(file)
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned())
        .filter(|stem| !matches!(stem.as_str(), "" | "." | ".."))
        .unwrap_or_else(|| "experiment".to_owned())
}

fn output(table: &Table<'_>) -> Option<Output> {
    let mesh = table.take_or_default(&MESH);
    let named = table.take_or_default(&FORMATS);
    let pictures = table.take_or_default(&PICTURES);
    let step_tolerance = table.take_or_default(&STEP_TOLERANCE);
    let mut formats = Vec::new();
    for format in named?.into_iter().map(Spanned::into_inner) {
        if !formats.contains(&format) {
            formats.push(format);
        }
    }
    Some(Output { mesh: mesh?, formats, pictures: pictures?, step_tolerance: step_tolerance? })
}

fn experiment(root: &Table<'_>) -> Option<(Experiment, Vec<Wanted>)> {
    let subjects: Vec<_> = ["boundary", "helicoid", "trapezium-helicoid", "curve"]
        .into_iter()
        .filter_map(|key| Some((key, root.place(&[key])?)))
        .collect();
    let [boundary_table, helicoid_table, trapezium_table, curve_table] =
        [&BOUNDARY, &HELICOID, &TRAPEZIUM, &CURVE].map(|key| root.inner(key));
    let (methods, search, expect) =
        (root.several(&METHOD), root.inner_or_empty(&SEARCH), root.inner(&EXPECT));
    if let [(first, first_span), (second, second_span), ..] = subjects.as_slice() {
        root.faults().conflict(
            (second_span.clone(), "a second subject"),
            (first_span.clone(), "the first subject"),
            format!("one experiment holds both [{first}] and [{second}]"),
            format!("put them into two files; {KINDS}"),
        );
        return None;
    }
    if let Some((subject, at)) = subjects.first().filter(|(subject, _)| *subject != "boundary") {
        for (stray, key) in [("[[method]]", "method"), ("[search]", "search")] {
            let Some(span) = root.place(&[key]) else { continue };
            root.faults().conflict(
                (span, "only beside [boundary]"),
                (at.clone(), "the subject of this experiment"),
                format!("{stray} does not belong to a [{subject}] experiment"),
                format!("take {stray} out: [{subject}] says everything by itself"),
            );
        }
    }
    if let Given::Sound(table) = helicoid_table {
        let found = helicoid(table.get_ref(), expect);
        return found.map(|(it, wanted)| (Experiment::Helicoid(it), vec![wanted]));
    }
    if let Given::Sound(table) = trapezium_table {
        let found = trapezium(table.get_ref(), expect);
        return found.map(|(it, wanted)| (Experiment::TrapeziumHelicoid(it), vec![wanted]));
    }
    if let Given::Sound(table) = curve_table {
        return curve(table.get_ref(), expect).map(|(it, wanted)| (Experiment::Curve(it), vec![wanted]));
    }
    if subjects.iter().any(|(subject, _)| *subject != "boundary") {
        return None;
    }
    let found = patches(root, boundary_table, methods, search, expect);
    found.map(|(it, wanted)| (Experiment::Patch(it), wanted))
}

fn patches(
    root: &Table<'_>,
    boundary_table: Given<Table<'_>>,
    method_tables: Given<Vec<Table<'_>>>,
    search_table: Option<Table<'_>>,
    expect: Given<Table<'_>>,
) -> Option<(PatchExperiment, Vec<Wanted>)> {
    if let Given::Sound(table) = &expect {
        root.faults().clash(
            (table.span(), "expected by which method?"),
            "[expect] stands beside methods",
            "write [method.expect] below the [[method]] it belongs to",
        );
    }
    let search = search_table.and_then(|table| search(&table));
    if boundary_table.is_absent() && method_tables.is_absent() {
        nothing(root);
    }
    if boundary_table.is_absent() && !method_tables.is_absent() {
        let help = "the methods need a boundary: give u0, u1, v0, v1, or ab, bc, ca";
        root.missing("[boundary]", help);
    }
    let header = boundary_table.span();
    let sides = match &boundary_table {
        Given::Sound(table) => boundary(table.get_ref()),
        Given::Absent | Given::Faulty => Sides { kind: None, header: 0..0, boundary: None },
    };
    let example =
        "add a table [[method]] with name = \"…\", basis = \"bernstein\" and energy = \"dirichlet\"";
    let methods = match method_tables {
        Given::Sound(tables) if tables.get_ref().is_empty() => {
            root.faults().inadmissible(tables.span(), "the list of methods is empty", "no method", example);
            None
        }
        Given::Sound(tables) => methods(tables.into_inner(), &sides),
        Given::Faulty => None,
        Given::Absent => {
            if let Some(header) = header {
                let message = "the experiment lacks `[[method]]`";
                let label = "`[[method]]` is needed here";
                root.faults().report(Diagnostic::at(Fault::Missing, header, message, label).help(example));
            }
            None
        }
    };
    let (boundary, search) = (sides.boundary?, search?);
    let (methods, wanted) = methods?.into_iter().unzip();
    Some((PatchExperiment { boundary, methods, search }, wanted))
}

fn nothing(root: &Table<'_>) {
    let label = "the experiment has no subject";
    root.faults().report(
        Diagnostic::at(Fault::Missing, root.span(), "there is nothing to compute", label).help(KINDS),
    );
}
