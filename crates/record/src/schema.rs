//! The layout of `result.json`.

/// The version of the layout; the number after the slash changes only if a program reading it would break.
pub const SCHEMA: &str = "plateau-result/1";
