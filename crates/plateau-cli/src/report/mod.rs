//! What is said of a result in words and tables.

mod curve_table;
pub(crate) mod grid;
mod helicoid_table;
mod table;
mod warnings;

pub(crate) use table::active_bounds;
pub use table::table;
pub(crate) use warnings::{newton_end, warnings};
