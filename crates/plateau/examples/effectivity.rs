//! What areas are estimated to lie above the least, beside what they do: `cargo run --release -p plateau-patches --example effectivity`.
//!
//! The true excess is that over the area at a degree six higher over the same rim, within two layers of smaller patches around corners.
#![allow(clippy::print_stdout, reason = "the figures are the point")]

#[path = "../tests/estimates/mod.rs"]
mod estimates;

use estimates::{Told, frames};

fn main() {
    println!("{:<26}{:>3}  {:>12}  {:>9}  {:>9}  effectivity", "frame", "p", "area", "above", "estimate");
    let (mut inside, mut converged, mut refused, mut outside) = (0, 0, 0, 0);
    for frame in frames() {
        let told = frame.told();
        let Told { area, above, ref estimate, .. } = told;
        let start = format!("{:<26}{:>3}  {area:>12.8}  {above:>9.2e}", frame.name, frame.degree);
        match estimate {
            Err(why) => {
                refused += 1;
                println!("{start}  {:>9}  refused: {why}", "");
            }
            Ok(estimate) if told.is_converged() => {
                converged += 1;
                println!("{start}  {estimate:>9.2e}  converged");
            }
            Ok(estimate) => {
                let effectivity = estimate / above;
                let is_inside = (0.7..=1.5).contains(&effectivity);
                *(if is_inside { &mut inside } else { &mut outside }) += 1;
                println!(
                    "{start}  {estimate:>9.2e}  {effectivity:.3}{}",
                    if is_inside { "" } else { "  OUTSIDE" }
                );
            }
        }
    }
    println!(
        "\n{inside} between 0.7 and 1.5, {converged} converged to rounding, {refused} refused, {outside} outside"
    );
}
