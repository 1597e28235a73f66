//! The numbers of a boundary that an axis multiplies.

use std::ops::Range;

use thiserror::Error;
use toml::de::{DeTable, DeValue};

use crate::keys::sweep::Stretch;
use crate::text::{Value, finite};

/// The keys of boundaries, curves and vertices that hold points.
const POINTS: [&str; 14] = [
    "u0", "u1", "v0", "v1", "ab", "bc", "ca", "polygon", "sides", "points", "polyline", "point", "center",
    "from",
];

/// The tables that hold points further down.
const INNER: [&str; 3] = ["spline", "through", "circle"];

/// A number with its place.
type Number = (Range<usize>, f64);

/// Why a boundary cannot be stretched.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub(super) enum Unstretched {
    /// One coordinate of a circle.
    #[error("a circle with one coordinate multiplied is no circle")]
    Circle,
    /// Nothing to be stretched.
    #[error("the file has no points that bound a surface")]
    NoPoints,
}

/// The numbers of the boundary that a stretch multiplies, with their places.
///
/// # Errors
/// A boundary that cannot be stretched so, or none.
pub(super) fn stretched(document: &DeTable<'_>, stretch: Stretch) -> Result<Vec<Number>, Unstretched> {
    let mut numbers = Vec::new();
    for table in ["boundary", "curve", "vertex", "net"].iter().filter_map(|table| document.get(*table)) {
        match table.get_ref() {
            DeValue::Table(table) => of_table(table, stretch, &mut numbers)?,
            DeValue::Array(tables) => {
                for table in tables.iter().filter_map(|table| table.get_ref().as_table()) {
                    of_table(table, stretch, &mut numbers)?;
                }
            }
            DeValue::String(_)
            | DeValue::Integer(_)
            | DeValue::Float(_)
            | DeValue::Boolean(_)
            | DeValue::Datetime(_) => {}
        }
    }
    if numbers.is_empty() { Err(Unstretched::NoPoints) } else { Ok(numbers) }
}

fn of_table(table: &DeTable<'_>, stretch: Stretch, numbers: &mut Vec<Number>) -> Result<(), Unstretched> {
    for (key, value) in table {
        let key: &str = key.get_ref();
        if POINTS.contains(&key) {
            of_points(value, stretch, numbers);
        } else if let Some(inner) = value.get_ref().as_table().filter(|_| INNER.contains(&key)) {
            if key == "circle" {
                match stretch {
                    Stretch::Coordinate(_) => return Err(Unstretched::Circle),
                    Stretch::Size => {
                        let radius = inner.get("radius");
                        numbers.extend(
                            radius.and_then(|radius| Some((radius.span(), finite(radius.get_ref())?))),
                        );
                    }
                }
            }
            of_table(inner, stretch, numbers)?;
        }
    }
    Ok(())
}

/// Of a point the coordinates that are multiplied; of a list of points those of all.
fn of_points(value: &Value<'_>, stretch: Stretch, numbers: &mut Vec<Number>) {
    let Some(list) = value.get_ref().as_array() else { return };
    let coordinates: Option<Vec<f64>> = list.iter().map(|element| finite(element.get_ref())).collect();
    match coordinates {
        Some(coordinates) => {
            for (k, (element, number)) in list.iter().zip(coordinates).enumerate() {
                let is_meant = match stretch {
                    Stretch::Coordinate(coordinate) => k == coordinate,
                    Stretch::Size => true,
                };
                if is_meant {
                    numbers.push((element.span(), number));
                }
            }
        }
        None => list.iter().for_each(|element| of_points(element, stretch, numbers)),
    }
}
