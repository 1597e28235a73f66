//! What is said of a result in words and tables.

pub(crate) mod cells;
pub(crate) mod curve_table;
pub(crate) mod figure;
pub(crate) mod grid;
pub(crate) mod standing;
mod table;

pub use table::table;
