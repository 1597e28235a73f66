//! How often the swarm finds the known minimum within 1e-5: 100 seeds of each function and dimension.
#![allow(clippy::print_stdout)] // an example talks to the terminal

#[path = "../tests/functions/mod.rs"]
mod functions;

use functions::{PROBLEMS, cube};
use optim::{FnObjective, Pso, Topology};

const SEEDS: u64 = 100;

/// Seeds with which 50 particles come within 1e-5 of the minimum, 0, in 500 iterations.
fn successes(function: fn(&[f64]) -> f64, dimension: usize, sides: [f64; 2], topology: Topology) -> usize {
    let objective = FnObjective::new(dimension, function);
    let found = |&seed: &u64| {
        let pso = Pso { iterations: 500, topology, ..Pso::new(seed) };
        let run = pso.run(&objective, &cube(dimension, sides), 0, &()).expect("valid parameters");
        // Nothing lies below a known minimum, and what was found is there.
        let best = run.best.as_ref().expect("finite values");
        assert!(best.value >= -1e-14 && function(&best.point).to_bits() == best.value.to_bits());
        assert!(run.history.windows(2).all(|pair| pair[1] <= pair[0]));
        best.value < 1e-5
    };
    (0..SEEDS).filter(found).count()
}

fn main() {
    println!("successes of {SEEDS} seeds, 50 particles, 500 iterations, w = 0.7, c₁ = c₂ = 1.5\n");
    println!("function     dimension   global   ring of 2");
    for (name, function, sides) in PROBLEMS {
        for dimension in 2..=4 {
            let [global, ring] = [Topology::Global, Topology::Ring { neighbours: 2 }]
                .map(|topology| successes(function, dimension, sides, topology));
            println!("{name:<10}   {dimension:>9}   {global:>6}   {ring:>9}");
        }
    }
}
