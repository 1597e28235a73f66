//! Sweeps: one file that says many experiments, its cells, one for each combination of the values of its axes.

mod address;
mod axis;
mod base;
mod cell;
mod frame;
mod range;
mod read;
mod segment;
mod source;
mod stretch;

pub use axis::{Axis, Setting};
pub use cell::{Cell, Sweep};
pub use source::Source;
