//! Nanoseconds for one reduced energy on both paths: `cargo run --release -p plateau-solve --example solver_timing`.
#![allow(clippy::print_stdout)]

#[path = "../tests/families/mod.rs"]
mod families;

use families::{
    Random, add_kronecker, bernstein_samples, example_5_1, gram, gt_dirichlet, gt_samples, interior,
    smooth_net,
};
use solve::{Parametric, Partition, Path, Separable, SeparableParametric, Triplet};
use std::hint::black_box;
use std::time::Instant;

/// The least of several timings of `work`, in nanoseconds.
fn nanoseconds(repeats: usize, mut work: impl FnMut()) -> f64 {
    work();
    (0..15)
        .map(|_| {
            let start = Instant::now();
            (0..repeats).for_each(|_| work());
            start.elapsed().as_nanos() as f64 / repeats as f64
        })
        .fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), solve::SolveError> {
    let mut random = Random(1);
    let mut point = || [0.0; 4].map(|_: f64| 2.0 + 1.4 * random.signed());
    let points: Vec<f64> = (0..64).flat_map(|_| point()).collect();
    println!(
        "{:>6} {:>9} {:>12} {:>12} {:>12}",
        "degree", "path", "ns/J batch", "ns/J single", "ns gradient"
    );
    for degree in [3usize, 4, 5, 8, 10] {
        let net = if degree == 3 { example_5_1() } else { smooth_net(&mut Random(2), [degree, degree]) };
        let parametric = Parametric::new(&gt_dirichlet([degree, degree], net))?;
        for path in [Path::Portable, Path::Fma] {
            let Ok(parametric) = parametric.clone().with_path(path) else { continue };
            let repeats = 40_000 / degree.pow(4) + 1;
            let mut out = vec![0.0; 64];
            let batch = nanoseconds(repeats, || {
                let _ = parametric.values(black_box(&points), black_box(&mut out));
            }) / 64.0;
            let start = [1.1, 0.9, 1.3, 2.0];
            let single = nanoseconds(16 * repeats, || {
                black_box(parametric.value(black_box(&start)));
            });
            let mut gradient = [0.0; 4];
            let with_gradient = nanoseconds(16 * repeats, || {
                black_box(parametric.value_and_gradient(black_box(&start), &mut gradient));
            });
            println!("{degree:>6} {path:>9} {batch:>12.1} {single:>12.1} {with_gradient:>12.1}");
        }
    }

    println!("\n{:>6} {:>16} {:>16} {:>14}", "degree", "us/J separable", "us gradient", "us solve");
    for degree in [3, 5, 8, 10, 12, 20, 30] {
        let free = interior(degree);
        let net = smooth_net(&mut Random(2), [degree, degree]);
        let system = SeparableParametric::new(gt_samples(degree), gt_samples(degree), &free, &free, &net)?;
        let start = [1.1, 0.9, 1.3, 2.0];
        let value = nanoseconds(10, || {
            black_box(system.value(black_box(&start)));
        });
        let mut gradient = [0.0; 4];
        let with_gradient = nanoseconds(10, || {
            black_box(system.value_and_gradient(black_box(&start), &mut gradient));
        });
        let solve = nanoseconds(10, || {
            let _ = black_box(system.solve(black_box(&start)));
        });
        println!("{degree:>6} {:>16.1} {:>16.1} {:>14.1}", value / 1e3, with_gradient / 1e3, solve / 1e3);
    }

    println!("\n{:>6} {:>14} {:>14} {:>8}", "degree", "us dense", "us separable", "ratio");
    for degree in [3, 5, 8, 10, 12, 20, 30] {
        let samples = bernstein_samples(degree);
        let (free, n) = (interior(degree), degree + 1);
        let net = smooth_net(&mut Random(2), [degree, degree]);
        let partition = Partition::of_net(n, n, &free, &free)?;
        let repeats = 1 + 20_000 / degree.pow(4);
        let dense = nanoseconds(repeats, || {
            let (k, m) =
                (gram(&samples.weights, n, &samples.derivatives), gram(&samples.weights, n, &samples.values));
            let mut matrix = vec![0.0; n.pow(4)];
            add_kronecker(&mut matrix, 0.5, &k, n, &m, n);
            add_kronecker(&mut matrix, 0.5, &m, n, &k, n);
            let _ = black_box(solve::solve_partitioned(n * n, &matrix, &partition, 3, &net));
        });
        let separable = nanoseconds(10, || {
            let _ = black_box(Separable::new(&samples, &samples, &free, &free).and_then(|s| s.solve(&net)));
        });
        println!("{degree:>6} {:>14.1} {:>14.1} {:>8.1}", dense / 1e3, separable / 1e3, dense / separable);
    }

    // The Dirichlet mask of a triangular net of degree 60, 7 entries a row.
    let inner: Vec<[i32; 3]> = (1..60).flat_map(|i| (1..60 - i).map(move |j| [i, j, 60 - i - j])).collect();
    let mut triplets = Vec::new();
    for (row, at) in inner.iter().enumerate() {
        triplets.push(Triplet { row, column: row, value: -4.0 });
        for (shift, value) in [
            ([-1, -1, 2], 2.0),
            ([-1, 1, 0], -1.0),
            ([1, -1, 0], -1.0),
            ([-1, 2, -1], 1.0),
            ([0, 1, -1], 1.0),
            ([1, 0, -1], 1.0),
            ([2, -1, -1], 1.0),
        ] {
            if let Ok(column) = inner.binary_search(&[at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]]) {
                triplets.push(Triplet { row, column, value });
            }
        }
    }
    let rhs = Random(3).vector(3 * inner.len());
    let sparse = nanoseconds(1, || {
        let _ = black_box(solve::solve_sparse(inner.len(), &triplets, 3, &rhs));
    });
    println!("\nsparse LU, {} unknowns: {:.1} ms", inner.len(), sparse / 1e6);

    println!("\n{:>6} {:>12} {:>12}", "order", "us Cholesky", "us LU");
    for n in [1, 2, 4, 8, 12, 16, 17, 36, 100, 400] {
        let (matrix, rhs) = (Random(4).spd(n), Random(5).vector(3 * n));
        let repeats = 1 + 100_000 / (n * n * n + 50);
        let cholesky = nanoseconds(repeats, || {
            let _ = black_box(solve::solve_spd(n, &matrix, 3, &rhs));
        });
        let lu = nanoseconds(repeats, || {
            let _ = black_box(solve::solve_general(n, &matrix, 3, &rhs));
        });
        println!("{n:>6} {:>12.2} {:>12.2}", cholesky / 1e3, lu / 1e3);
    }
    Ok(())
}
