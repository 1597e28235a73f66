//! Seconds for least areas whose value is known, in process, from the Coons start to the surface: one line `frame degree area
//! seconds` each, for `benches/peer/films.py` to set beside other programs.
//! `cargo run --release -p plateau-benches --example film_time`.
//!
//! The least of several repeats on one thread, without reading or writing files.
#![allow(clippy::print_stdout)] // an example talks to other programs

use std::hint::black_box;
use std::time::Instant;

use plateau::{MethodError, least_area, least_area_complex};
use plateau_benches::{FixtureError, catenoid, cube, hexagon, saddle};
use surfaces::Complex;

/// Seconds in which a frame is repeated, and repeats at least.
const PATIENCE: f64 = 0.5;
const REPEATS: usize = 3;

/// A frame by its degree.
type Frame = fn(usize) -> Result<Complex, FixtureError>;

/// The name of a frame, and the degrees at which it is solved, with the tolerance that suits each.
type Runs<'a> = (&'a str, Frame, &'a [(usize, f64)]);

fn print(name: &str, degree: usize, solve: impl Fn() -> Result<f64, MethodError>) -> Result<(), MethodError> {
    let (begin, mut least, mut repeats) = (Instant::now(), f64::INFINITY, 0);
    let mut area = 0.0;
    while repeats < REPEATS || begin.elapsed().as_secs_f64() < PATIENCE {
        let start = Instant::now();
        area = black_box(solve()?);
        least = least.min(start.elapsed().as_secs_f64());
        repeats += 1;
    }
    println!("{name} {degree} {area:.15} {least:e}");
    Ok(())
}

fn main() -> Result<(), FixtureError> {
    for (degree, tolerance) in
        [(4, 1e-6), (5, 1e-6), (6, 1e-7), (8, 1e-8), (10, 1e-9), (12, 1e-10), (14, 3e-10)]
    {
        let patch = saddle(degree)?;
        print("saddle", degree, || Ok(least_area(&patch, tolerance, &())?.1.area.value))?;
    }
    let films: [Runs<'_>; 3] = [
        ("hexagon", hexagon, &[(3, 1e-9), (4, 1e-11), (6, 1e-13), (8, 1e-13)]),
        ("catenoid", catenoid, &[(4, 1e-9), (6, 1e-11), (8, 1e-13)]),
        ("cube film", cube, &[(3, 1e-9), (4, 1e-10)]),
    ];
    for (name, frame, runs) in films {
        for &(degree, tolerance) in runs {
            let complex = frame(degree)?;
            print(name, degree, || Ok(least_area_complex(&complex, &[], tolerance, &())?.1.area.value))?;
        }
    }
    Ok(())
}
