//! The reduced energy J(α): alone, in a batch, with its gradient, on both paths; and from samples at high degree.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput};
use plateau_benches::{FixtureError, example_5_1, gt_dirichlet, separable_parametric, shapes, wave};
use solve::Path;

/// Particles of a swarm, evaluated in one call.
const BATCH: usize = 50;

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    parametric(&mut criterion)?;
    separable(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

/// From Gram polynomials: the bicubic net of GT Example 5.1, then larger ones.
fn parametric(criterion: &mut Criterion) -> Result<(), FixtureError> {
    let points = shapes(BATCH);
    let single = [1.1, 0.9, 1.3, 2.0];
    for path in [Path::Portable, Path::Fma] {
        let mut group = criterion.benchmark_group(format!("parametric_{path}"));
        for degree in [3, 5, 8] {
            let net = if degree == 3 { example_5_1()? } else { wave(degree)? };
            let Ok(reduced) = gt_dirichlet(&net)?.with_path(path) else { continue };
            let parametric = reduced.system();
            let mut out = [0.0; BATCH];
            group.throughput(Throughput::Elements(BATCH as u64));
            group.bench_function(BenchmarkId::new("batch_of_50", degree), |bencher| {
                bencher.iter(|| parametric.values(black_box(&points), black_box(&mut out)));
            });
            group.throughput(Throughput::Elements(1));
            group.bench_function(BenchmarkId::new("single", degree), |bencher| {
                bencher.iter(|| parametric.value(black_box(&single)));
            });
            let mut gradient = [0.0; 4];
            group.bench_function(BenchmarkId::new("gradient", degree), |bencher| {
                bencher.iter(|| parametric.value_and_gradient(black_box(&single), black_box(&mut gradient)));
            });
        }
        group.finish();
    }
    Ok(())
}

/// From samples, which also serve where Gram matrices have lost their digits.
fn separable(criterion: &mut Criterion) -> Result<(), FixtureError> {
    let single = [1.1, 0.9, 1.3, 2.0];
    let mut group = criterion.benchmark_group("separable_parametric");
    for degree in [5, 8, 10, 20, 30] {
        let system = separable_parametric(&wave(degree)?)?;
        group.bench_function(BenchmarkId::new("single", degree), |bencher| {
            bencher.iter(|| system.value(black_box(&single)));
        });
        let mut gradient = [0.0; 4];
        group.bench_function(BenchmarkId::new("gradient", degree), |bencher| {
            bencher.iter(|| system.value_and_gradient(black_box(&single), black_box(&mut gradient)));
        });
    }
    group.finish();
    Ok(())
}
