//! Prints the chapter of the book that lists every key: `cargo run -p plateau-experiment --example key_list > docs/keys.md`.

#![allow(clippy::print_stdout)] // What it is for.

fn main() {
    print!("{}", experiment::key_list());
}
