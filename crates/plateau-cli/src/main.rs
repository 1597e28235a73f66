//! The `plateau` command.
fn main() {}
