//! The table of an experiment on the terminal.

use std::fmt::Write;

use crate::run::{Done, Finished, MethodResult};

const HEADINGS: [&str; 7] =
    ["method", "Dirichlet D", "area A", "± of A", "(D−A)/A", "max |H|", "shape parameters"];
const UNITS: [&str; 7] = ["", "length²", "length²", "length²", "", "1/length", "α1 α2 β1 β2"];

/// The table as text: the title, one row a method, then the warnings of each method.
///
/// The columns of the papers' tables, with the Dirichlet energy and the area apart, the area's quadrature error and the
/// conformality gap beside them.
pub fn table(finished: &Finished) -> String {
    let rows: Vec<[String; 7]> = finished.methods.iter().map(row).collect();
    let mut widths = [0; 7];
    for cells in rows.iter().map(|r| r.each_ref().map(|s| s.as_str())).chain([HEADINGS, UNITS]) {
        for (width, cell) in widths.iter_mut().zip(cells) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut text = format!("{}\n\n", finished.title);
    let mut line = |cells: [&str; 7]| {
        let mut out = String::new();
        for (k, (cell, width)) in cells.into_iter().zip(widths).enumerate() {
            let pad = " ".repeat(width - cell.chars().count());
            // Names and the list of shapes are read from the left, numbers from the right.
            let cell = if k == 0 || k == 6 { format!("{cell}{pad}") } else { format!("{pad}{cell}") };
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

fn row(method: &MethodResult) -> [String; 7] {
    let Ok(done) = &method.outcome else {
        return [method.name.clone(), "failed".into()]
            .into_iter()
            .chain(std::iter::repeat_n(String::new(), 5))
            .collect::<Vec<_>>()
            .try_into()
            .unwrap_or_default();
    };
    let f = &done.figures;
    [
        method.name.clone(),
        format!("{:.7}", f.dirichlet.value),
        format!("{:.7}", f.area.value),
        format!("{:.1e}", f.area.error),
        f.conformality_gap.map_or(String::new(), |gap| format!("{:.4} %", 100.0 * gap)),
        f.mean_curvature_max.map_or("singular".into(), |h| format!("{h:.5}")),
        shape(done),
    ]
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
