//! The figures of merged methods: which there are, and where they stand in a record.

use plateau::Quantity;
use serde_json::{Map, Value};

/// Most numbers of a figure that has several.
const MOST: usize = 4;

/// The column of a figure: its place in a record, with dots.
pub(crate) type Figure = String;

/// Every figure there may be, in the order of columns, each followed by its error.
fn all() -> Vec<Figure> {
    let of = |quantity: &Quantity| {
        let key = quantity.key();
        let several = (0..MOST).map(move |k| format!("{key}.{k}"));
        [key.to_owned(), format!("{key}_error")].into_iter().chain(several)
    };
    Quantity::ALL.iter().flat_map(of).collect()
}

/// The figures that some of the methods have.
pub(crate) fn columns<'a>(methods: impl Iterator<Item = &'a Map<String, Value>> + Clone) -> Vec<Figure> {
    let mut all = all();
    all.retain(|figure| methods.clone().any(|method| value(method, figure).is_some()));
    all
}

/// The figure of a method.
pub(crate) fn value(method: &Map<String, Value>, figure: &str) -> Option<f64> {
    let mut steps = figure.split('.');
    let first = method.get(steps.next()?)?;
    let value = steps.try_fold(first, |value, step| match value {
        Value::Object(table) => table.get(step),
        Value::Array(list) => list.get(step.parse::<usize>().ok()?),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => None,
    });
    value?.as_f64()
}

/// The name of a method.
pub(crate) fn name(method: &Map<String, Value>) -> &str {
    method.get("name").and_then(Value::as_str).unwrap_or_default()
}

/// Why a method failed, if it did.
pub(crate) fn failure(method: &Map<String, Value>) -> Option<&str> {
    method.get("error").and_then(Value::as_str)
}
