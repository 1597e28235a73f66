//! The table of an experiment on the terminal.

use std::fmt::Write;

use super::cells::cells;
use super::curve_table::{samples, summary};
use super::figure::Place;
use super::grid::grid;
use crate::Printable;
use plateau::{MethodResult, Results};

/// Most samples of a curve that are listed.
const LISTED: usize = 12;

/// The table as text: the title, one row a method, then the warnings of each method.
pub fn table(results: &Results) -> String {
    let mut text = format!("{}\n\n", Printable(&results.title));
    match &results.curve {
        Some(curve) => {
            text += &grid(&summary(curve));
            if curve.t.len() <= LISTED {
                text.push('\n');
                text += &grid(&samples(curve, LISTED));
            }
        }
        None => text += &grid(&cells(results, Place::Everywhere, usize::MAX)),
    }
    for method in &results.methods {
        notes(&mut text, method);
    }
    for warning in &results.warnings {
        let _ = writeln!(text, "note: {}", Printable(warning));
    }
    text
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
