//! The table of an experiment on the terminal.

use std::fmt::Write;

use super::cells::cells;
use super::curve_table::{samples, summary};
use super::figure::Place;
use super::grid::grid;
use super::how_far::{how_far, losses, unestimated};
use crate::Printable;
use crate::printable::columns;
use plateau::Results;

/// Most samples of a curve that are listed.
const LISTED: usize = 12;

/// Columns of a terminal where nothing is known of it: what is piped is read on one in the end.
pub const WIDTH: usize = 80;

/// The table as text: the title, one row a method, then the notes on them.
///
/// No line of the table is longer than `room` columns of a terminal: columns are left out in a fixed order, from the last of
/// these to the first: area, what was minimised, the excess over the least area, the error of the area, Dirichlet energy, D^g,
/// boundary, rim, kink, shape, (D − A)/A, max |H|, bound of D. A line says which.
pub fn table(results: &Results, room: usize) -> String {
    let mut text = format!("{}\n\n", Printable(results.title()).cut(Printable::TITLE));
    match results.curves() {
        [first, rest @ ..] => {
            text += &grid(&summary(results.curves()), room).0;
            if first.samples().len() <= LISTED && rest.is_empty() {
                text.push('\n');
                text += &grid(&samples(first, LISTED), room).0;
            }
        }
        [] => {
            let (table, left_out) = grid(&cells(results, Place::Everywhere, usize::MAX), room);
            text += &table;
            if !left_out.is_empty() {
                text += &listed("in result.json, too wide for here:", &left_out, room);
            }
        }
    }
    for note in notes(results) {
        let _ = writeln!(text, "{}", Printable(&note));
    }
    text
}

/// What is said of some names, in lines of at most `room` columns if each name fits one.
fn listed(said: &str, names: &[&str], room: usize) -> String {
    let mut lines = vec![said.to_owned()];
    for (k, name) in names.iter().enumerate() {
        let word = format!(" {name}{}", if k + 1 < names.len() { "," } else { "" });
        let last = lines.len() - 1;
        if columns(&lines[last]) + columns(&word) <= room {
            lines[last] += &word;
        } else {
            lines.push(format!(" {word}"));
        }
    }
    lines.join("\n") + "\n"
}

/// What a reader must know, and what may be done about it: numbered where a row bears the number.
pub(crate) fn notes(results: &Results) -> Vec<String> {
    let mut notes = Vec::new();
    let mut number = 0;
    for method in results.methods() {
        let name = Printable(&method.name).cut(Printable::NAME);
        match &method.outcome {
            Ok(done) => {
                notes.extend(done.warnings.iter().map(|warning| {
                    number += 1;
                    let remedy = warning.remedy().map_or(String::new(), |remedy| format!("; {remedy}"));
                    format!("note {number}: {name}: {warning}{remedy}")
                }));
                notes.extend(how_far(done).map(|far| format!("note: {name}: {far}")));
            }
            Err(error) => notes.push(format!("failed: {name}: {error}")),
        }
    }
    notes.extend(losses(results).map(|losses| format!("note: {losses}")));
    notes.extend(unestimated(results).map(|names| format!("note: {names}")));
    notes.extend(results.remarks().iter().map(|remark| format!("note: {remark}")));
    notes
}
