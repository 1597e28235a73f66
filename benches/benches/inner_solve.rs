//! The extremal of the Dirichlet energy of one GT patch, from the patch to its control points: assembled and factored,
//! or with both directions diagonalised.
//!
//! From degree 18 or so the assembled matrix is not positive definite in doubles, and the dense solver says so. What it
//! would cost is still worth knowing: `dense_shifted` solves the same system with 1e-9 of its largest entry added to the
//! diagonal, whose solution is *wrong*; `dense_refused` is the time until the error.

use std::hint::black_box;
use std::time::Duration;

use bases::Matrix;
use criterion::BenchmarkId;
use energy::{Functional, QuadraticForm};
use plateau_benches::{FixtureError, gt_samples, interior, wave};
use solve::{Partition, Separable, Solution, SolveError, solve_partitioned};
use surfaces::TensorPatch;

const SHAPE: [f64; 4] = [0.87, 1.2, 0.95, 1.5];

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("inner_solve");
    for degree in [3, 5, 8, 12, 20, 30] {
        if degree >= 20 {
            group.sample_size(10).measurement_time(Duration::from_millis(if degree > 20 {
                3000
            } else {
                1000
            }));
        }
        let patch = TensorPatch::gt(wave(degree)?, SHAPE)?;
        let works = assembled(&patch, 0.0)?.is_ok();
        let name = if works { "dense" } else { "dense_refused" };
        group.bench_function(BenchmarkId::new(name, degree), |bencher| {
            bencher.iter(|| assembled(black_box(&patch), 0.0));
        });
        if !works {
            group.bench_function(BenchmarkId::new("dense_shifted", degree), |bencher| {
                bencher.iter(|| assembled(black_box(&patch), 1e-9));
            });
            assert!(assembled(&patch, 1e-9)?.is_ok(), "the shift is meant to make the system definite");
        }
        group.bench_function(BenchmarkId::new("separable", degree), |bencher| {
            bencher.iter(|| separable(black_box(&patch), degree));
        });
        let samples = both_samples(degree)?;
        group.bench_function(BenchmarkId::new("separable_from_samples", degree), |bencher| {
            bencher.iter(|| separable_from(black_box(&samples), &patch, degree));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

/// All entries of Q, then Cholesky of the free block.
fn assembled(patch: &TensorPatch, shift: f64) -> Result<Result<Solution, SolveError>, FixtureError> {
    let mut matrix: Matrix = QuadraticForm::of(Functional::Dirichlet, patch)?.matrix();
    if shift > 0.0 {
        let shift = shift * matrix.max_abs();
        for i in 0..matrix.rows() {
            matrix[(i, i)] += shift;
        }
    }
    let net = patch.net();
    let partition = Partition::new(net.fixed());
    Ok(solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &net.coordinates()))
}

fn both_samples(degree: usize) -> Result<[solve::Samples; 2], FixtureError> {
    Ok([gt_samples(degree, [SHAPE[0], SHAPE[1]])?, gt_samples(degree, [SHAPE[2], SHAPE[3]])?])
}

fn separable(patch: &TensorPatch, degree: usize) -> Result<Vec<f64>, FixtureError> {
    separable_from(&both_samples(degree)?, patch, degree)
}

fn separable_from(
    [u, v]: &[solve::Samples; 2],
    patch: &TensorPatch,
    degree: usize,
) -> Result<Vec<f64>, FixtureError> {
    let free = interior(degree);
    Ok(Separable::new(u, v, &free, &free)?.solve(&patch.net().coordinates())?.x)
}
