//! The table for other programs, as JSON.

use serde::Serialize;
use serde_json::{Map, Value};

use crate::merged::{Kept, Merged};
use crate::outline::{AxisEntry, Outline};
use crate::stored::Stored;

/// The version of the layout of `merged.json`.
pub const MERGED_SCHEMA: &str = "plateau-merged/1";

#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    title: &'a str,
    figure: &'a str,
    axes: &'a [AxisEntry],
    cells: Vec<Cell<'a>>,
    /// Cells that are not there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    missing: Vec<&'a str>,
}

#[derive(Serialize)]
struct Cell<'a> {
    name: &'a str,
    /// For every axis its number or, if it is none, its label.
    values: Map<String, Value>,
    methods: &'a [Map<String, Value>],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    missed: &'a [Value],
}

/// The whole table: indented, with a final line break.
pub(crate) fn document(merged: &Merged) -> serde_json::Result<String> {
    let Outline { title, figure, axes, .. } = &merged.outline;
    let cells = merged.kept.iter().map(|kept| cell_of(merged, kept)).collect();
    let missing = merged.missing.iter().map(|lack| lack.name.as_str()).collect();
    let document = Document { schema: MERGED_SCHEMA, title, figure, axes, cells, missing };
    let mut text = serde_json::to_string_pretty(&document)?;
    text.push('\n');
    Ok(text)
}

fn cell_of<'a>(merged: &'a Merged, kept: &'a Kept) -> Cell<'a> {
    let cell = merged.cell(kept);
    let axes = merged.outline.axes.iter().enumerate();
    let values = axes.map(|(k, axis)| {
        let setting = merged.outline.value(cell, k);
        let value = setting.number.map_or_else(|| Value::from(setting.label.as_str()), Value::from);
        (axis.name.clone(), value)
    });
    let Stored { methods, missed, .. } = &kept.stored;
    Cell { name: &cell.name, values: values.collect(), methods, missed }
}
