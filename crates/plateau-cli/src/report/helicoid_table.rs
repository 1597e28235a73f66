//! The table of a helicoid experiment.

use super::grid::{Column, figure, grid};
use plateau::MethodResult;
use plateau::Results;

/// One row a surface, with its distance from the closed form.
pub(crate) fn helicoid_table(results: &Results) -> String {
    let number = |heading, unit| Column { heading, unit, is_words: false };
    let columns = [
        Column { heading: "surface", unit: "", is_words: true },
        number("Dirichlet D", "length²"),
        number("area A", "length²"),
        number("± of A", "length²"),
        number("(D−A)/A", ""),
        number("max |H|", "1/length"),
        number("deviation", "length"),
        Column { heading: "weights", unit: "a b", is_words: true },
    ];
    let mut rows: Vec<Vec<String>> = results.methods.iter().map(row).collect();
    let has_weights = rows.iter().any(|row| !row[7].is_empty());
    let columns = if has_weights { &columns[..] } else { &columns[..7] };
    rows.iter_mut().for_each(|row| row.truncate(columns.len()));
    grid(columns, &rows)
}

fn row(method: &MethodResult) -> Vec<String> {
    let Ok(done) = &method.outcome else {
        let mut cells = vec![String::new(); 8];
        cells[0].clone_from(&method.name);
        cells[1] = "failed".into();
        return cells;
    };
    let f = &done.figures;
    // These are zero but for rounding: the exponent is what there is to read.
    let small = |value: Option<f64>| match value {
        Some(0.0) => "0".into(),
        Some(value) => format!("{value:.1e}"),
        None => "–".into(),
    };
    let gap = match f.conformality_gap {
        Some(gap) if (1e-6..1e4).contains(&gap.abs()) => format!("{:.4} %", 100.0 * gap),
        gap => small(gap),
    };
    let weights = done.closed_form.and_then(|form| form.weights);
    vec![
        method.name.clone(),
        figure(f.dirichlet.value),
        figure(f.area.value),
        format!("{:.1e}", f.area.error),
        gap,
        small(f.mean_curvature_max),
        small(done.closed_form.map(|form| form.deviation)),
        weights.map_or(String::new(), |[a, b]| format!("{} {}", figure(a), figure(b))),
    ]
}
