//! What is said of a result in words and tables.

pub(crate) mod cells;
mod column;
pub(crate) mod curve_table;
pub(crate) mod figure;
mod grid;
mod how_far;
mod patch_table;
pub(crate) mod standing;

pub use cells::Cells;
pub use column::Column;
pub use grid::grid;
pub(crate) use how_far::{NOT_ESTIMATED, is_too_costly};
pub(crate) use patch_table::notes;
pub use patch_table::{WIDTH, table};
