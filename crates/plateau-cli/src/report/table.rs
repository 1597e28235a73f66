//! The table of an experiment on the terminal.

use std::fmt::Write;

use super::curve_table::curve_table;
use super::grid::{Column, figure, grid};
use super::helicoid_table::helicoid_table;
use crate::Printable;
use plateau::{Done, MethodResult, Results};

const COLUMNS: [Column; 9] = [
    words("method", ""),
    number("Dirichlet D", "length²"),
    number("bound of D", "length²"),
    number("area A", "length²"),
    number("± of A", "length²"),
    number("(D−A)/A", ""),
    number("max |H|", "1/length"),
    number("boundary", "moved by"),
    words("shape parameters", "α1 α2 β1 β2"),
];

const fn words(heading: &'static str, unit: &'static str) -> Column {
    Column { heading, unit, is_words: true }
}

const fn number(heading: &'static str, unit: &'static str) -> Column {
    Column { heading, unit, is_words: false }
}

/// The table as text: the title, one row a method, then the warnings of each method.
///
/// The columns of the papers' tables, with the Dirichlet energy and the area apart, and beside them what keeps a comparison
/// honest: the least Dirichlet energy that the patch's own boundary curves admit, the area's quadrature error, the
/// conformality gap, and how far the boundary curves lie from the Bernstein curves of the net. Columns that no method
/// fills are left out.
pub fn table(results: &Results) -> String {
    let mut text = format!("{}\n\n", Printable(&results.title));
    text += &match &results.curve {
        Some(curve) => curve_table(curve),
        None if results.methods.iter().any(has_closed_form) => helicoid_table(results),
        None => patch_table(results),
    };
    for method in &results.methods {
        notes(&mut text, method);
    }
    for warning in &results.warnings {
        let _ = writeln!(text, "note: {}", Printable(warning));
    }
    text
}

fn has_closed_form(method: &MethodResult) -> bool {
    method.outcome.as_ref().is_ok_and(|done| done.closed_form.is_some())
}

fn patch_table(results: &Results) -> String {
    let rows: Vec<[String; 9]> = results.methods.iter().map(row).collect();
    let filled: Vec<usize> =
        (0..COLUMNS.len()).filter(|&k| rows.iter().any(|row| !row[k].is_empty())).collect();
    let columns: Vec<Column> = filled.iter().map(|&k| COLUMNS[k]).collect();
    let rows: Vec<Vec<String>> =
        rows.into_iter().map(|row| filled.iter().map(|&k| row[k].clone()).collect()).collect();
    grid(&columns, &rows)
}

fn notes(text: &mut String, method: &MethodResult) {
    let name = Printable(&method.name).cut(Printable::NAME);
    match &method.outcome {
        Ok(done) => {
            for warning in &done.warnings {
                let _ = writeln!(text, "note: {name}: {warning}");
            }
        }
        Err(error) => {
            let _ = writeln!(text, "failed: {name}: {}", Printable(&error.to_string()));
        }
    }
}

fn row(method: &MethodResult) -> [String; 9] {
    let Ok(done) = &method.outcome else {
        let mut cells = [const { String::new() }; 9];
        cells[0].clone_from(&method.name);
        cells[1] = "failed".into();
        return cells;
    };
    let f = &done.figures;
    let size = f.dirichlet.value.sqrt();
    let boundary = done.boundary.as_ref();
    [
        method.name.clone(),
        figure(f.dirichlet.value),
        boundary.map_or(String::new(), |b| figure(b.harmonic_bound)),
        figure(f.area.value),
        format!("{:.1e}", f.area.error),
        f.conformality_gap.map_or(String::new(), |gap| format!("{:.4} %", 100.0 * gap)),
        f.mean_curvature_max.map_or("singular".into(), |h| curvature(h, size)),
        boundary.map_or(String::new(), |b| moved(b.deviation, size)),
        shape(done),
    ]
}

/// How far boundary curves moved; what is only rounding, for a patch of this size, is written 0.
fn moved(deviation: f64, size: f64) -> String {
    match deviation {
        _ if deviation <= 1e-12 * size => "0".into(),
        1e-3..1e6 => format!("{deviation:.4}"),
        _ => format!("{deviation:.4e}"),
    }
}

/// A curvature with five decimals, or with an exponent where they would not show it. Beside the curvature of a sphere of
/// this size, one millionth is none.
fn curvature(h: f64, size: f64) -> String {
    match h {
        1e-3..1e6 => format!("{h:.5}"),
        _ if h < 1.0 && h * size < 1e-6 => format!("{h:.5}"),
        _ => format!("{h:.5e}"),
    }
}

fn shape(done: &Done) -> String {
    let Some(shape) = done.solved.shape else { return String::new() };
    if shape.iter().all(|x| (x - shape[0]).abs() < 5e-6) {
        return format!("{:.5} (all four)", shape[0]);
    }
    shape.map(|x| format!("{x:.5}")).join(" ")
}

#[cfg(test)]
mod tests {
    use super::{curvature, moved};

    #[test]
    fn lengths_are_readable_in_any_unit() {
        // A metre in kilometres, in metres and in nanometres.
        let said = |unit: f64| [moved(0.3616 * unit, unit), curvature(0.6121 / unit, unit)];
        assert_eq!(said(1.0), ["0.3616", "0.61210"]);
        assert_eq!(said(1e-9), ["3.6160e-10", "6.12100e8"]);
        assert_eq!(said(1e9), ["3.6160e8", "6.12100e-10"]);
        // Rounding is nothing in any unit.
        for unit in [1e-40, 1.0, 1e40] {
            assert_eq!(moved(1e-16 * unit, unit), "0");
        }
        assert_eq!(
            [moved(0.0, 0.0), curvature(1e-16, 1.0), curvature(0.0, 0.0)],
            ["0", "0.00000", "0.00000"]
        );
    }
}
