//! The table for other programs: comma-separated values.

use crate::figures::{columns, failure, name, value};
use crate::merged::Merged;

/// A heading and one row a method of every cell.
pub(crate) fn csv(merged: &Merged) -> String {
    let figures = columns(merged.rows().map(|(_, method)| method));
    let axes = merged.outline.axes.iter().map(|axis| axis.name.as_str());
    let heading = ["cell"].into_iter().chain(axes).chain(["method"]).map(quoted);
    let mut text =
        line(heading.chain(figures.iter().map(|figure| quoted(figure))).chain(["error".to_owned()]));
    for (kept, method) in merged.rows() {
        let cell = merged.cell(kept);
        let values = (0..cell.at.len()).map(|axis| {
            let setting = merged.outline.value(cell, axis);
            setting.number.map_or_else(|| quoted(&setting.label), number)
        });
        let figures = figures.iter().map(|figure| value(method, figure).map_or(String::new(), number));
        let names = [quoted(&cell.name)].into_iter().chain(values).chain([quoted(name(method))]);
        text += &line(names.chain(figures).chain([quoted(failure(method).unwrap_or_default())]));
    }
    text
}

/// A number with all its digits.
fn number(x: f64) -> String {
    serde_json::Value::from(x).to_string()
}

fn line(fields: impl Iterator<Item = String>) -> String {
    fields.collect::<Vec<_>>().join(",") + "\n"
}

/// A text as a field: in quotes where it must be.
fn quoted(text: &str) -> String {
    if text.contains(['"', ',', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
