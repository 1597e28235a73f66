//! The file as a whole: its subject, and what is written of it.

use std::path::Path;

use exchange::StepForm;
use serde_spanned::Spanned;

use super::boundary::{Sides, boundary, is_mixed};
use super::curve::curve;
use super::curves::curves;
use super::faces::faces;
use super::film;
use super::helicoid::{helicoid, trapezium};
use super::loops::{loops, polygon, sides};
use super::memory::fits;
use super::method::{Named, methods as net_methods, named};
use super::net::net;
use super::search::search;
use super::{Experiment, FilmExperiment, Output, PatchExperiment, Plan, Rim, Wanted};
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::boundary::{LOOPS, POLYGON, SIDES};
use crate::keys::output::{FORMATS, MESH, PICTURES, STEP_TOLERANCE, STEP_UNIT};
use crate::keys::{
    BOUNDARY, CURVE, EXPECT, FACE, HELICOID, METHOD, NET, OUTPUT, SEARCH, SEED, SWEEP, TITLE, TRAPEZIUM,
    VERTEX,
};
use crate::text::{Given, Table, Tables};

const KINDS: &str = "an experiment holds one of [boundary] or [[face]] with [[method]] tables, [helicoid], [trapezium-helicoid], [net], [curve]";

/// The plan that a file describes; its faults are reported.
pub(super) fn plan(root: &Table<'_>, file: &str) -> Option<Plan> {
    if let Some(span) = root.place(&[SWEEP.name()]) {
        let message = "this file is a sweep: many experiments, not one";
        let help = "`plateau run` runs all of its cells; take [sweep] out to have one experiment";
        root.faults().clash((span, "makes many of one"), message, help);
        return None;
    }
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
    let (tolerance, unit) = (table.take_or_default(&STEP_TOLERANCE), table.take(&STEP_UNIT).known());
    let mut formats = Vec::new();
    for format in named?.into_iter().map(Spanned::into_inner) {
        if !formats.contains(&format) {
            formats.push(format);
        }
    }
    Some(Output {
        mesh: mesh?,
        formats,
        pictures: pictures?,
        step: StepForm { tolerance: tolerance?, unit: unit?.map(Spanned::into_inner) },
    })
}

/// The tables of a boundary and of what fills it, read but not judged.
struct Parts<'t> {
    boundary: Given<Table<'t>>,
    curves: Given<Vec<Table<'t>>>,
    faces: Given<Vec<Table<'t>>>,
    vertices: Given<Vec<Table<'t>>>,
    methods: Given<Vec<Table<'t>>>,
    search: Option<Table<'t>>,
    expect: Given<Table<'t>>,
}

fn experiment(root: &Table<'_>) -> Option<(Experiment, Vec<Wanted>)> {
    let [helicoid_table, trapezium_table, net_table] =
        [&HELICOID, &TRAPEZIUM, &NET].map(|key| root.inner(key));
    let (curve_table, curves) = match root.one_or_several(&CURVE) {
        Given::Absent => (Given::Absent, Given::Absent),
        Given::Faulty => (Given::Faulty, Given::Faulty),
        Given::Sound(tables) => {
            let span = tables.span();
            match tables.into_inner() {
                Tables::One(table) => (Given::Sound(Spanned::new(span, table)), Given::Absent),
                Tables::Several(tables) => (Given::Absent, Given::Sound(Spanned::new(span, tables))),
            }
        }
    };
    let parts = Parts {
        boundary: root.inner(&BOUNDARY),
        curves,
        faces: root.several(&FACE),
        vertices: root.several(&VERTEX),
        methods: root.several(&METHOD),
        search: root.inner_or_empty(&SEARCH),
        expect: root.inner(&EXPECT),
    };
    if !has_one_subject(root, &parts) {
        return None;
    }
    let expect = parts.expect;
    if let Given::Sound(table) = helicoid_table {
        let found = helicoid(table.get_ref(), expect);
        return found.map(|(it, wanted)| (Experiment::Helicoid(it), vec![wanted]));
    }
    if let Given::Sound(table) = trapezium_table {
        let found = trapezium(table.get_ref(), expect);
        return found.map(|((it, construction), wanted)| {
            (Experiment::TrapeziumHelicoid(it, construction), vec![wanted])
        });
    }
    if let Given::Sound(table) = net_table {
        return net(table.get_ref(), expect).map(|(it, wanted)| (Experiment::Net(it), vec![wanted]));
    }
    if let Given::Sound(table) = curve_table {
        return curve(table.get_ref(), expect).map(|(it, wanted)| (Experiment::Curve(it), vec![wanted]));
    }
    let alone = [&helicoid_table, &trapezium_table, &net_table, &curve_table];
    if alone.into_iter().any(Given::is_faulty) {
        return None;
    }
    filled(root, Parts { expect, ..parts })
}

/// Whether there is not more than one subject, and nothing that does not belong to it.
fn has_one_subject(root: &Table<'_>, parts: &Parts<'_>) -> bool {
    let rim = root.place(&["boundary"]).map(|span| ("[boundary]", span));
    let rim = rim.or(root.place(&["face"]).map(|span| ("[[face]]", span)));
    let alone = [
        ("[helicoid]", "helicoid"),
        ("[trapezium-helicoid]", "trapezium-helicoid"),
        ("[net]", "net"),
        ("[curve]", "curve"),
    ];
    let alone =
        alone.into_iter().filter(|(_, key)| *key != "curve" || !matches!(parts.curves, Given::Sound(_)));
    let alone = alone.filter_map(|(header, key)| Some((header, root.place(&[key])?)));
    let has_rim = rim.is_some();
    let subjects: Vec<_> = rim.into_iter().chain(alone).collect();
    if let [(first, first_span), (second, second_span), ..] = subjects.as_slice() {
        root.faults().conflict(
            (second_span.clone(), "a second subject"),
            (first_span.clone(), "the first subject"),
            format!("one experiment holds both {first} and {second}"),
            format!("put them into two files; {KINDS}"),
        );
        return false;
    }
    let Some((subject, at)) = subjects.first().filter(|_| !has_rim) else { return true };
    for (stray, key) in [("[[method]]", "method"), ("[search]", "search"), ("[[vertex]]", "vertex")] {
        let Some(span) = root.place(&[key]) else { continue };
        root.faults().conflict(
            (span, "only beside [boundary]"),
            (at.clone(), "the subject of this experiment"),
            format!("{stray} does not belong to a {subject} experiment"),
            format!("take {stray} out: {subject} says everything by itself"),
        );
    }
    true
}

/// A boundary with the methods that fill it.
fn filled(root: &Table<'_>, parts: Parts<'_>) -> Option<(Experiment, Vec<Wanted>)> {
    if let Given::Sound(table) = &parts.expect {
        root.faults().clash(
            (table.span(), "expected by which method?"),
            "[expect] stands beside methods",
            "write [method.expect] below the [[method]] it belongs to",
        );
    }
    let search = parts.search.as_ref().and_then(search);
    let methods = named_methods(root, &parts);
    let has = |key: &str| root.place(&["boundary", key]).is_some();
    let is_film = !parts.faces.is_absent() || has("polygon") || has("sides") || has("loops");
    let mixed = parts.boundary.value().is_some_and(is_mixed);
    if is_film {
        let rim = rim(root, &parts, mixed);
        let header = parts.boundary.span().or(parts.faces.span()).unwrap_or(root.span());
        let (methods, wanted) = film::methods(methods?, rim.as_ref(), &header)?.into_iter().unzip();
        return Some((Experiment::Film(FilmExperiment { rim: rim?, methods }), wanted));
    }
    only_beside(root, "curve", "[[curve]] belongs to `loops` or [[face]] tables");
    only_beside(root, "vertex", "[[vertex]] belongs to [[face]] tables");
    let sides = match &parts.boundary {
        Given::Sound(table) if !mixed => boundary(table.get_ref()),
        Given::Sound(_) | Given::Absent | Given::Faulty => Sides { kind: None, header: 0..0, boundary: None },
    };
    let methods = methods.and_then(|named| net_methods(named, &sides));
    let (boundary, search) = (sides.boundary?, search?);
    let (methods, wanted) = methods?.into_iter().unzip();
    Some((Experiment::Patch(PatchExperiment { boundary, methods, search }), wanted))
}

/// The methods by their names; none if there is none, which is reported, as is what else is missing.
fn named_methods<'t>(root: &Table<'t>, parts: &Parts<'t>) -> Option<Vec<Named<'t>>> {
    let example =
        "add a table [[method]] with name = \"…\", basis = \"bernstein\" and energy = \"dirichlet\"";
    let has_boundary = !(parts.boundary.is_absent() && parts.faces.is_absent());
    match &parts.methods {
        Given::Absent if !has_boundary => {
            let label = "the experiment has no subject";
            root.faults().report(
                Diagnostic::at(Fault::Missing, root.span(), "there is nothing to compute", label).help(KINDS),
            );
        }
        Given::Absent => {
            let header = parts.boundary.span().or(parts.faces.span()).unwrap_or(root.span());
            let (message, label) = ("the experiment lacks `[[method]]`", "`[[method]]` is needed here");
            root.faults().report(Diagnostic::at(Fault::Missing, header, message, label).help(example));
        }
        Given::Faulty => {}
        Given::Sound(tables) if tables.get_ref().is_empty() => {
            root.faults().inadmissible(tables.span(), "the list of methods is empty", "no method", example);
        }
        Given::Sound(_) => {
            if !has_boundary {
                let help = "the methods need a boundary: give u0, u1, v0, v1, or ab, bc, ca, a polygon, sides or loops, or \
                            [[face]] tables";
                root.missing("[boundary]", help);
            }
        }
    }
    Some(named(parts.methods.value()?.iter())).filter(|methods| !methods.is_empty())
}

/// Loops or faces.
fn rim(root: &Table<'_>, parts: &Parts<'_>, is_mixed: bool) -> Option<Rim> {
    let of_curves = || match &parts.curves {
        Given::Absent => Some(Vec::new()),
        Given::Faulty => None,
        Given::Sound(tables) => curves(tables.get_ref()),
    };
    if let Some(face) = root.place(&["face"]) {
        let holds = parts.boundary.value().and_then(|table| table.present().next());
        if let Some((key, span)) = holds {
            root.faults().conflict(
                (face, "a surface of faces"),
                (span, "another boundary"),
                format!("one experiment holds [[face]] tables and `{}` in [boundary]", key.name),
                "keep one of the two: faces lie between [[curve]]s and need no [boundary]",
            );
            return None;
        }
        let (Given::Sound(face_tables), Some(vertex_tables)) = (&parts.faces, several(&parts.vertices))
        else {
            return None;
        };
        return faces(root.faults(), face_tables, vertex_tables, &of_curves()?).map(Rim::Faces);
    }
    only_beside(root, "vertex", "[[vertex]] belongs to [[face]] tables");
    let table = parts.boundary.value().filter(|_| !is_mixed)?;
    match table.take(&LOOPS) {
        Given::Absent => {}
        Given::Faulty => return None,
        Given::Sound(lists) => return loops(table, lists.get_ref(), &of_curves()?).map(Rim::Loops),
    }
    only_beside(root, "curve", "[[curve]] belongs to `loops` or [[face]] tables");
    let around = match (table.take(&POLYGON), table.take(&SIDES)) {
        (Given::Sound(corners), _) => polygon(table, &corners),
        (_, Given::Sound(lists)) => sides(table, &lists),
        (Given::Absent | Given::Faulty, Given::Absent | Given::Faulty) => None,
    };
    around.map(|around| Rim::Loops(vec![around]))
}

/// The tables, if they are known; none where there are none.
fn several<'p, 't>(given: &'p Given<Vec<Table<'t>>>) -> Option<&'p [Table<'t>]> {
    match given {
        Given::Absent => Some(&[]),
        Given::Faulty => None,
        Given::Sound(tables) => Some(tables.get_ref()),
    }
}

/// Reports a table that has nothing to belong to.
fn only_beside(root: &Table<'_>, key: &str, message: &str) {
    if let Some(span) = root.place(&[key]) {
        let help = "write `loops` in [boundary], or [[face]] tables, or take it out";
        root.faults().clash((span, "nothing here names it"), message, help);
    }
}
