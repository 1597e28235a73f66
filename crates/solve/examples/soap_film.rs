//! A Bernstein patch over the boundary of (x, y, eˣ cos y), which is harmonic: the extremal finds the surface.
//!
//! `cargo run --release -p plateau-solve --example soap_film`
#![allow(clippy::print_stdout)]

#[path = "../tests/families/mod.rs"]
mod families;

use families::{bernstein_patch, bernstein_samples, exponential_net, interior};
use solve::{Separable, SolveError};

fn main() -> Result<(), SolveError> {
    println!("{:>6} {:>18} {:>10} {:>10}", "degree", "Dirichlet energy", "sup error", "residual");
    for degree in [4, 8, 12, 16, 20, 30] {
        let samples = bernstein_samples(degree);
        let free = interior(degree);
        let film = Separable::new(&samples, &samples, &free, &free)?.solve(&exponential_net(degree))?;
        let error = (0..=50 * 50)
            .map(|k| (f64::from(k % 51) / 50.0, f64::from(k / 51) / 50.0))
            .map(|(s, t)| (bernstein_patch(degree, &film.x, s, t)[2] - s.exp() * t.cos()).abs())
            .fold(0.0, f64::max);
        println!("{degree:>6} {:>18.14} {error:>10.1e} {:>10.2}", film.energy, film.residual);
    }
    Ok(())
}
