//! Nets of least area, with the time each takes: `cargo run --release --example least_area`.
//!
//! The frame of the saddle z = x² − y² over [−1, 1]², whose least area is 7.383505602602, and GT Example 5.1, by degree.
#![allow(clippy::print_stdout)]

use std::time::Instant;

use plateau::{Options, Plan, Quantity, run};

const SADDLE: &str = r#"
u0 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]]
u1 = [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]]
v1 = [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
"#;

const BICUBIC: &str = r#"
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (name, boundary, degree) in [("saddle frame", SADDLE, 2), ("GT Example 5.1", BICUBIC, 3)] {
        for raise in [0, 1, 3, 5, 6, 10] {
            let text = format!(
                "title = \"{name}\"\n[boundary]\n{boundary}\n[[method]]\nname = \"area\"\nbasis = \"bernstein\"\n\
                 energy = \"area\"\nraise = {raise}\n"
            );
            let plan = Plan::parse("least-area.toml", &text)?;
            let begin = Instant::now();
            let finished = run(&plan, Options::default(), &())?;
            let seconds = begin.elapsed().as_secs_f64();
            let area = finished.methods[0].figure(Quantity::Area).unwrap_or(f64::NAN);
            println!("{name}, degree {:2}: {area:.12} in {:.1} ms", degree + raise, 1e3 * seconds);
        }
    }
    Ok(())
}
