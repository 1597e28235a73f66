//! The table on a terminal.

use plateau::{Notation, Quantity};
use std::collections::BTreeMap;

use show::{Printable, width_of_names};

use crate::figures::{failure, name, value};
use crate::merged::Merged;

/// Most rows that are shown; all are in the files.
const MOST: usize = 100;

/// The figures beside the compared one, where there is room.
const BESIDE: [&str; 3] = [Quantity::Area.key(), "area_error", Quantity::AreaEstimate.key()];

/// A column: its heading, and whether its cells are words.
struct Column {
    heading: String,
    is_words: bool,
    cells: Vec<String>,
    width: usize,
}

/// One row a method of every cell: the values of the axes, the method, the compared figure, and which is the least of those that are compared.
pub(crate) fn table(merged: &Merged, room: usize) -> String {
    let mut columns = columns(merged);
    let wide = |columns: &[Column]| {
        columns.iter().map(|column| column.width).sum::<usize>() + 3 * (columns.len() - 1)
    };
    // The first figure stays, whatever the room.
    while wide(&columns) > room
        && columns.last().is_some_and(|column| BESIDE.contains(&column.heading.as_str()))
    {
        columns.pop();
    }
    let mut text = format!("{}\n\n", Printable(&merged.outline.title).cut(Printable::TITLE));
    let mut line = |cell: &dyn Fn(&Column) -> String| {
        let fitted = columns.iter().map(|column| column.fitted(&cell(column)));
        text += fitted.collect::<Vec<_>>().join("   ").trim_end();
        text.push('\n');
    };
    line(&|column| column.heading.clone());
    line(&|column| "─".repeat(column.width));
    let rows = columns.first().map_or(0, |column| column.cells.len());
    for row in 0..rows.min(MOST) {
        line(&|column| column.cells[row].clone());
    }
    if rows > MOST {
        text += &format!("… and {} more rows in merged.csv\n", rows - MOST);
    }
    text
}

fn columns(merged: &Merged) -> Vec<Column> {
    let outline = &merged.outline;
    let axis = |axis: usize| {
        let entry = &outline.axes[axis];
        let labels = merged.rows().map(|(kept, _)| outline.value(merged.cell(kept), axis).label.clone());
        let is_words = entry.values.iter().any(|setting| setting.number.is_none());
        Column::new(&entry.name, is_words, labels.collect())
    };
    let mut columns: Vec<Column> = (0..outline.axes.len()).map(axis).collect();
    columns.push(Column::new(
        "method",
        true,
        merged.rows().map(|(_, method)| name(method).to_owned()).collect(),
    ));
    let key = merged.key();
    let mut figures = vec![key];
    figures.extend(BESIDE.into_iter().filter(|figure| *figure != key));
    for figure in figures {
        let form = if figure == key || figure == "area" { Notation::Decimals(9) } else { Notation::Order };
        let cell = |method| match (value(method, figure), failure(method)) {
            (Some(value), _) => form.of(value),
            (None, Some(_)) if figure == key => "failed".to_owned(),
            (None, _) => String::new(),
        };
        let cells: Vec<String> = merged.rows().map(|(_, method)| cell(method)).collect();
        if figure == key || cells.iter().any(|cell| !cell.is_empty()) {
            columns.push(Column::new(figure, false, cells));
        }
    }
    let place = columns.iter().position(|column| column.heading == key).map_or(columns.len(), |k| k + 1);
    columns.insert(place, Column::new("", true, marks(merged)));
    columns
}

/// "least" beside the least value of several rows that are compared.
fn marks(merged: &Merged) -> Vec<String> {
    let (least, mut rows) = (merged.least(), BTreeMap::new());
    for (kept, _) in merged.rows() {
        *rows.entry(merged.comparable(kept)).or_insert(0) += 1;
    }
    let mark = |(kept, method)| {
        let panel = merged.comparable(kept);
        let found = value(method, merged.key());
        let is_least = found.is_some() && found == least.get(&panel).copied() && rows.get(&panel) > Some(&1);
        if is_least { "least".to_owned() } else { String::new() }
    };
    merged.rows().map(mark).collect()
}

impl Column {
    fn new(heading: &str, is_words: bool, cells: Vec<String>) -> Self {
        let shown = cells.iter().take(MOST).map(String::as_str);
        let width = width_of_names(shown.chain([heading]));
        Self { heading: heading.to_owned(), is_words, cells, width }
    }

    fn fitted(&self, cell: &str) -> String {
        let shown = Printable(cell).fitted(self.width);
        if self.is_words { shown } else { format!("{:>1$}", shown.trim_end(), self.width) }
    }
}
