//! The table of an experiment as columns and cells: what the terminal aligns and the page lays out.

use super::column::Column;
use super::figure::{FIGURES, Figure, Place};
use super::standing::{Standing, standings};
use crate::number::Form;
use plateau::{Done, MethodResult, Results};

/// A table. Every row has one cell per column, the first of which is its name.
pub struct Cells {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: Vec<Row>,
}

/// A row of a table.
pub(crate) struct Row {
    pub(crate) cells: Vec<String>,
    pub(crate) standing: Standing,
    /// Why there are no figures.
    pub(crate) failure: Option<String>,
}

/// What a column shows of a patch that is not one number.
type Words = (&'static str, &'static str, fn(&Done) -> String);

const WORDS: [Words; 2] = [("weights", "a b", weights), ("shape parameters", "α1 α2 β1 β2", shape)];

/// One row a method, at most `most`; columns that no row fills are left out.
///
/// The columns of the papers' tables, with the Dirichlet energy and the area apart, and beside them what keeps a comparison
/// honest: the least Dirichlet energy that the patch's own boundary curves admit, the area's quadrature error, the
/// conformality gap, and how far the boundary curves lie from the Bernstein curves of the net.
pub(crate) fn cells(results: &Results, place: Place, most: usize) -> Cells {
    let is_exact = results.methods.iter().any(has_closed_form);
    let mut shown: Vec<&Figure> =
        FIGURES.iter().filter(|figure| figure.place == Place::Everywhere || place == Place::Page).collect();
    if place == Place::Page {
        // A narrow page shows what it has room for: the area first.
        shown.sort_by_key(|figure| !figure.key.starts_with("area"));
    }
    let mut columns = vec![Column::words(if is_exact { "surface" } else { "method" }, "")];
    columns.extend(shown.iter().map(|figure| figure.column()));
    columns.extend(WORDS.map(|(heading, beneath, _)| Column::words(heading, beneath)));
    let done: Vec<Option<&Done>> = results.methods.iter().map(|m| m.outcome.as_deref().ok()).collect();
    let row = |(method, standing): (&MethodResult, Standing)| {
        let mut cells = vec![method.name.clone()];
        match &method.outcome {
            Ok(done) => {
                cells.extend(shown.iter().map(|figure| figure.cell(done, is_exact)));
                cells.extend(WORDS.map(|(_, _, words)| words(done)));
            }
            Err(_) => {
                cells.push("failed".into());
                cells.resize(columns.len(), String::new());
            }
        }
        Row { cells, standing, failure: method.outcome.as_ref().err().map(ToString::to_string) }
    };
    let rows = results.methods.iter().zip(standings(&done)).take(most).map(row).collect();
    Cells { columns, rows }.without_empty_columns()
}

fn has_closed_form(method: &MethodResult) -> bool {
    method.outcome.as_ref().is_ok_and(|done| done.closed_form.is_some())
}

impl Cells {
    /// A table none of whose rows failed.
    pub fn new(columns: Vec<Column>, rows: Vec<Vec<String>>) -> Self {
        Self {
            columns,
            rows: rows
                .into_iter()
                .map(|cells| Row { cells, standing: Standing::Alone, failure: None })
                .collect(),
        }
    }

    fn without_empty_columns(mut self) -> Self {
        let is_filled: Vec<bool> =
            (0..self.columns.len()).map(|k| self.rows.iter().any(|row| !row.cells[k].is_empty())).collect();
        let mut filled = is_filled.iter();
        self.columns.retain(|_| filled.next() == Some(&true));
        for row in &mut self.rows {
            let mut filled = is_filled.iter();
            row.cells.retain(|_| filled.next() == Some(&true));
        }
        self
    }
}

fn weights(done: &Done) -> String {
    let weights = done.closed_form.and_then(|form| form.weights);
    weights.map_or(String::new(), |weights| weights.map(|w| Form::Decimals(7).of(w)).join(" "))
}

fn shape(done: &Done) -> String {
    let Some(shape) = done.solved.shape else { return String::new() };
    if shape.iter().all(|x| (x - shape[0]).abs() < 5e-6) {
        return format!("{:.5} (all four)", shape[0]);
    }
    shape.map(|x| format!("{x:.5}")).join(" ")
}
