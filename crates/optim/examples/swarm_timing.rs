//! What search and polish cost beside their objectives.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use std::hint::black_box;
use std::time::Instant;

use optim::{Bounds, FnObjective, FnSmooth, Objective, Polish, Pso, Topology};

/// The least wall time of `repeats` calls, in seconds.
fn least(repeats: usize, mut call: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64()
    };
    (0..repeats).map(time).fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let bounds = Bounds::cube(4, 0.5, 3.5)?;
    let cheap = FnObjective::new(4, |x: &[f64]| x[0]);
    for topology in [Topology::Global, Topology::Ring { neighbours: 2 }] {
        let pso = Pso { topology, ..Pso::new(7) };
        let run = pso.run(&cheap, &bounds, 0, &())?;
        let seconds = least(200, || {
            black_box(pso.run(black_box(&cheap), &bounds, 0, &()).is_ok());
        });
        let each = seconds * 1e9 / run.evaluations as f64;
        println!("{topology:?}: {each:.1} ns of overhead per evaluation");
    }

    // About as dear as a reduced energy: 4-dimensional, some 60 ns.
    let dear = FnObjective::new(4, |x: &[f64]| {
        let mut sum = 37.4;
        for k in 1..26 {
            let t = x[0] * x[1] - x[2] + x[3] / f64::from(k);
            sum += (t * t + 1.0).sqrt();
        }
        sum
    });
    let points: Vec<f64> = (0..200).map(|i| 0.5 + 0.01 * f64::from(i)).collect();
    let mut values = vec![0.0; 50];
    let alone = least(200, || dear.evaluate(black_box(&points), black_box(&mut values)));
    println!("objective alone: {:.1} ns per evaluation", alone * 1e9 / 50.0);
    let pso = Pso::new(7);
    let seconds = least(100, || {
        black_box(pso.search(black_box(&dear), &bounds, 10, &()).is_ok());
    });
    println!("10 runs of 50 × 100: {:.2} ms", seconds * 1e3);

    // A chain of quartic springs.
    let smooth = FnSmooth::new(4, |x: &[f64], gradient: &mut [f64]| {
        let mut value = 10.0;
        for i in 0..4 {
            let s = x[i] - if i == 0 { 1.0 } else { 0.5 * x[i - 1] };
            value += s * s + 0.25 * s * s * s * s;
            let force = 2.0 * s + s * s * s;
            gradient[i] = force;
            if i > 0 {
                gradient[i - 1] -= 0.5 * force;
            }
        }
        value
    });
    let polish = Polish::default();
    let reports = polish.run_starts(&smooth, &bounds, 10, 7)?;
    let evaluations: usize = reports.iter().map(|report| report.evaluations).sum();
    let seconds = least(500, || {
        black_box(polish.run_starts(black_box(&smooth), &bounds, 10, 7).is_ok());
    });
    println!("10 polishes from random starts: {evaluations} evaluations, {:.1} µs", seconds * 1e6);
    let seconds = least(500, || {
        black_box(polish.run(black_box(&smooth), &bounds, &[3.0, 1.0, 2.0, 0.5]).is_ok());
    });
    let report = polish.run(&smooth, &bounds, &[3.0, 1.0, 2.0, 0.5])?;
    let each = seconds * 1e9 / report.evaluations as f64;
    println!("one polish: {each:.0} ns of overhead per evaluation");
    Ok(())
}
