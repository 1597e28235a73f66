//! What is said of a result in words and tables.

mod curve_table;
pub(crate) mod grid;
mod helicoid_table;
mod table;

pub use table::table;
