//! The table of an experiment on the terminal.

use std::fmt::Write;

use crate::run::{Done, Finished, MethodResult};

const COLUMNS: usize = 9;
const HEADINGS: [&str; COLUMNS] = [
    "method",
    "Dirichlet D",
    "bound of D",
    "area A",
    "± of A",
    "(D−A)/A",
    "max |H|",
    "boundary",
    "shape parameters",
];
const UNITS: [&str; COLUMNS] =
    ["", "length²", "length²", "length²", "length²", "", "1/length", "moved by", "α1 α2 β1 β2"];

/// The table as text: the title, one row a method, then the warnings of each method.
///
/// The columns of the papers' tables, with the Dirichlet energy and the area apart, and beside them what keeps a comparison
/// honest: the least Dirichlet energy that the patch's own boundary curves admit, the area's quadrature error, the
/// conformality gap, and how far the boundary curves lie from the Bernstein curves of the net.
pub fn table(finished: &Finished) -> String {
    let rows: Vec<[String; COLUMNS]> = finished.methods.iter().map(row).collect();
    let mut widths = [0; COLUMNS];
    for cells in rows.iter().map(|r| r.each_ref().map(|s| s.as_str())).chain([HEADINGS, UNITS]) {
        for (width, cell) in widths.iter_mut().zip(cells) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut text = format!("{}\n\n", finished.title);
    let mut line = |cells: [&str; COLUMNS]| {
        let mut out = String::new();
        for (k, (cell, width)) in cells.into_iter().zip(widths).enumerate() {
            let pad = " ".repeat(width - cell.chars().count());
            // Names and the list of shapes are read from the left, numbers from the right.
            let cell =
                if k == 0 || k == COLUMNS - 1 { format!("{cell}{pad}") } else { format!("{pad}{cell}") };
            out.push_str(&cell);
            out.push_str("   ");
        }
        text.push_str(out.trim_end());
        text.push('\n');
    };
    line(HEADINGS);
    line(UNITS);
    let rules = widths.map(|w| "─".repeat(w));
    line(rules.each_ref().map(String::as_str));
    for row in &rows {
        line(row.each_ref().map(String::as_str));
    }
    for method in &finished.methods {
        notes(&mut text, method);
    }
    for warning in &finished.warnings {
        let _ = writeln!(text, "note: {warning}");
    }
    text
}

fn notes(text: &mut String, method: &MethodResult) {
    match &method.outcome {
        Ok(done) => {
            for warning in &done.warnings {
                let _ = writeln!(text, "note: {}: {warning}", method.name);
            }
        }
        Err(error) => {
            let _ = writeln!(text, "failed: {}: {error}", method.name);
        }
    }
}

fn row(method: &MethodResult) -> [String; COLUMNS] {
    let Ok(done) = &method.outcome else {
        let mut cells = [const { String::new() }; COLUMNS];
        cells[0].clone_from(&method.name);
        cells[1] = "failed".into();
        return cells;
    };
    let f = &done.figures;
    let boundary = done.boundary.as_ref();
    [
        method.name.clone(),
        format!("{:.7}", f.dirichlet.value),
        boundary.map_or(String::new(), |b| format!("{:.5}", b.harmonic_bound)),
        format!("{:.7}", f.area.value),
        format!("{:.1e}", f.area.error),
        f.conformality_gap.map_or(String::new(), |gap| format!("{:.4} %", 100.0 * gap)),
        f.mean_curvature_max.map_or("singular".into(), |h| format!("{h:.5}")),
        boundary.map_or(String::new(), |b| moved(b.deviation)),
        shape(done),
    ]
}

/// How far boundary curves moved; what is only rounding is written 0.
fn moved(deviation: f64) -> String {
    if deviation < 1e-12 { "0".into() } else { format!("{deviation:.4}") }
}

fn shape(done: &Done) -> String {
    let Some(shape) = done.solved.shape else { return "–".into() };
    if shape.iter().all(|x| (x - shape[0]).abs() < 5e-6) {
        return format!("{:.5} (all four)", shape[0]);
    }
    shape.map(|x| format!("{x:.5}")).join(" ")
}

/// The bounds a polish ended at, as `result.json` lists them.
pub(crate) fn active_bounds(polished: &optim::Polished) -> Vec<&'static str> {
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
