//! Nets of least area, with the time each takes: `cargo run --release -p plateau-patches --example least_area`.
//!
//! The frame of the saddle z = x² − y² over [−1, 1]², whose least area is 7.383505602602, and GT Example 5.1, by degree and
//! tolerance. Times are the least of several, from the boundary net to the net of least area.
#![allow(clippy::print_stdout, reason = "the times are the output")]

use std::error::Error;
use std::time::Instant;

use plateau::least_area;
use surfaces::{Net, Point, TensorPatch};

const SADDLE: [[[f64; 3]; 3]; 4] = [
    [[-1., -1., 0.], [-1., 0., 2.], [-1., 1., 0.]],
    [[1., -1., 0.], [1., 0., 2.], [1., 1., 0.]],
    [[-1., -1., 0.], [0., -1., -2.], [1., -1., 0.]],
    [[-1., 1., 0.], [0., 1., -2.], [1., 1., 0.]],
];

const EXAMPLE_5_1: [[[f64; 3]; 4]; 4] = [
    [[0., 0., 0.], [2., 0., 2.], [4., 0., -2.], [6., 0., 0.]],
    [[0., 6., 0.], [2., 6., 2.], [4., 6., -2.], [6., 6., 0.]],
    [[0., 0., 0.], [0., 2., 2.], [0., 4., -2.], [0., 6., 0.]],
    [[6., 0., 0.], [6., 2., 2.], [6., 4., -2.], [6., 6., 0.]],
];

fn net<const N: usize>(sides: [[[f64; 3]; N]; 4]) -> Result<Net, Box<dyn Error>> {
    let [u0, u1, v0, v1] = sides.map(|side| side.map(Point::from));
    Ok(Net::from_boundary(&u0, &u1, &v0, &v1)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let frames = [
        ("saddle frame", net(SADDLE)?, 7.383_505_602_602),
        ("GT Example 5.1", net(EXAMPLE_5_1)?, 37.999_848_863),
    ];
    for (name, net, least) in frames {
        let degree = net.degrees().0;
        for (to, tolerance) in [
            (3, 1e-11),
            (5, 1e-7),
            (5, 1e-6),
            (6, 1e-7),
            (6, 1e-6),
            (7, 1e-6),
            (8, 1e-9),
            (8, 1e-11),
            (12, 1e-11),
        ] {
            let mut best = f64::INFINITY;
            let mut found = None;
            for _ in 0..5 {
                let begin = Instant::now();
                let patch = TensorPatch::bernstein(net.raised(to - degree))?;
                found = Some(least_area(&patch, tolerance, &())?.1);
                best = best.min(begin.elapsed().as_secs_f64());
            }
            let Some(found) = found else { continue };
            println!(
                "{name}, degree {to:2}, tolerance {tolerance:.0e}: area {:.12}, {:+.1e} of the least, {} steps, {:.1} ms",
                found.area.value,
                found.area.value / least - 1.0,
                found.iterations,
                1e3 * best,
            );
        }
    }
    Ok(())
}
