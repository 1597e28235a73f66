//! The table of an experiment as columns and cells: what the terminal aligns and the page lays out.

use super::column::Column;
use super::figure::{FIGURES, Figure, Place};
use super::standing::{Standing, standings};
use plateau::{Done, MethodResult, Notation, Results};

/// A table. Every row has one cell per column, the first of which is its name.
pub struct Cells {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: Vec<Row>,
}

/// A row of a table.
pub(crate) struct Row {
    pub(crate) cells: Vec<String>,
    /// Its place in the file.
    pub(crate) index: usize,
    /// The numbers of the notes on it, `1,2`.
    pub(crate) marks: String,
    pub(crate) standing: Standing,
    /// Why there are no figures.
    pub(crate) failure: Option<String>,
}

/// What a column shows of a patch that is not one number.
struct Words {
    heading: &'static str,
    /// What its numbers are called, where that is the same in all rows.
    names: fn(&Done) -> &'static [&'static str],
    of: fn(&Done) -> String,
}

const WORDS: [Words; 2] = [
    Words { heading: "weights", names: |_| &["a", "b"], of: weights },
    Words { heading: "shape", names: |done| done.solved.family().parameters(), of: shape },
];

/// Most notes whose numbers stand beside a name.
const MARKS: usize = 3;

/// One row a method, at most `most`; columns that no row fills are left out, rows over other boundary curves stand last.
///
/// The columns: the area with its error and its excess over the least, what was minimised, and what keeps a comparison
/// honest: how far the boundary curves lie from the Bernstein curves of the net, the conformality gap, the mean curvature, the
/// least Dirichlet energy that the patch's own boundary curves admit.
pub(crate) fn cells(results: &Results, place: Place, most: usize) -> Cells {
    let done: Vec<Option<&Done>> = results.methods().iter().map(|m| m.outcome.as_deref().ok()).collect();
    let is_exact = done.iter().flatten().any(|done| done.closed_form.is_some());
    let shown = shown(&done, place);
    let mut columns = vec![Column::words(if is_exact { "surface" } else { "method" }, "")];
    columns.extend(shown.iter().map(|figure| figure.column_among(&done)));
    columns.insert(AREA.len() + 1, Column { rank: 2, ..Column::number("excess", "of area") });
    columns.extend(WORDS.map(|words| words.column_among(&done)));
    let mut first = 1;
    let row = |(index, (method, standing)): (usize, (&MethodResult, Standing))| {
        let notes = method.outcome.as_ref().map_or(0, |done| done.warnings.len());
        let marks = marks(first, notes);
        first += notes;
        let mut cells = vec![method.name.clone()];
        match &method.outcome {
            Ok(done) => {
                cells.extend(shown.iter().map(|figure| figure.cell(done, is_exact)));
                cells.insert(AREA.len() + 1, standing.in_words());
                cells.extend(WORDS.map(|words| (words.of)(done)));
            }
            Err(_) => {
                cells.push("failed".into());
                cells.resize(columns.len(), String::new());
            }
        }
        Row { cells, index, marks, standing, failure: method.outcome.as_ref().err().map(ToString::to_string) }
    };
    let mut rows: Vec<Row> =
        results.methods().iter().zip(standings(&done)).enumerate().take(most).map(row).collect();
    if rows.iter().any(|row| matches!(row.standing, Standing::Best | Standing::Above(_))) {
        rows.sort_by_key(|row| row.standing == Standing::Apart);
    }
    Cells { columns, rows }.without_empty_columns()
}

impl Words {
    fn column_among(&self, done: &[Option<&Done>]) -> Column {
        let mut names =
            done.iter().flatten().filter(|done| !(self.of)(done).is_empty()).map(|done| (self.names)(done));
        let first = names.next().unwrap_or_default();
        let beneath = if names.all(|other| other == first) { first.join(" ") } else { String::new() };
        Column { rank: 6, ..Column::words(self.heading, beneath) }
    }
}

/// The figures that begin every table.
const AREA: [&str; 2] = ["area", "area_error"];

/// The figures of a place: those that are always there, and the energies that a method minimised.
fn shown(done: &[Option<&Done>], place: Place) -> Vec<&'static Figure> {
    let is_shown = |figure: &&Figure| match figure.place {
        Place::Everywhere => true,
        Place::Page => place == Place::Page || figure.is_minimised_by(done),
        Place::Minimised => figure.is_minimised_by(done),
    };
    FIGURES.iter().filter(is_shown).collect()
}

/// The numbers of so many notes from the first on.
fn marks(first: usize, notes: usize) -> String {
    let numbers: Vec<String> = (first..first + notes.min(MARKS)).map(|k| k.to_string()).collect();
    numbers.join(",") + if notes > MARKS { ",…" } else { "" }
}

impl Cells {
    /// A table none of whose rows failed.
    pub fn new(columns: Vec<Column>, rows: Vec<Vec<String>>) -> Self {
        let plain = |(index, cells)| Row {
            cells,
            index,
            marks: String::new(),
            standing: Standing::Alone,
            failure: None,
        };
        Self { columns, rows: rows.into_iter().enumerate().map(plain).collect() }
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
    weights.map_or(String::new(), |weights| weights.map(|w| Notation::Decimals(7).of(w)).join(" "))
}

fn shape(done: &Done) -> String {
    let Some(shape) = done.solved.shape() else { return String::new() };
    if shape.iter().all(|x| (x - shape[0]).abs() < 5e-6) {
        let all = if shape.len() == 4 { "all four".to_owned() } else { format!("all {}", shape.len()) };
        return format!("{:.5} ({all})", shape[0]);
    }
    shape.iter().map(|x| format!("{x:.5}")).collect::<Vec<_>>().join(" ")
}
