//! Ten runs on the sphere function: the report of the best, and the value of each.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use optim::{Bounds, FnObjective, Pso};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let sphere = FnObjective::new(4, |x: &[f64]| x.iter().map(|x| x * x).sum());
    let bounds = Bounds::cube(4, -5.0, 5.0)?;
    let search = Pso::new(7).search(&sphere, &bounds, 10, &())?;
    let best = search.best().ok_or("no run found a finite value")?;
    println!("{best}");
    for run in &search.runs {
        println!("run {}: {:.3e}, {}", run.run, run.value(), run.reason);
    }
    assert!(best.value() < 1e-9, "the minimum is 0");
    Ok(())
}
