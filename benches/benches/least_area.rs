//! Least areas from the border to the surface: patches to a given error, at high degree, and films of several patches.

use std::hint::black_box;
use std::time::Duration;

use criterion::BenchmarkId;
use plateau::{least_area, least_area_complex, least_area_triangle};
use plateau_benches::{FixtureError, catenoid, cube, hexagon, ribbon, saddle, triangle};

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("least_area");
    // Degree and tolerance by which the saddle is within 1e-6, 1e-8 and 1e-10 of its area.
    for (to, degree, tolerance) in [("1e-6", 5, 1e-6), ("1e-8", 8, 1e-8), ("1e-10", 14, 3e-10)] {
        let patch = saddle(degree)?;
        group.bench_function(BenchmarkId::new("saddle", to), |bencher| {
            bencher.iter(|| least_area(black_box(&patch), tolerance, &()));
        });
    }
    let patch = ribbon(10)?;
    group.bench_function(BenchmarkId::new("ribbon", 10), |bencher| {
        bencher.iter(|| least_area(black_box(&patch), 1e-10, &()));
    });
    for (degree, tolerance) in [(4, 1e-11), (6, 1e-13)] {
        let complex = hexagon(degree)?;
        group.bench_function(BenchmarkId::new("hexagon", degree), |bencher| {
            bencher.iter(|| least_area_complex(black_box(&complex), &[], tolerance, &()));
        });
    }
    let complex = catenoid(8)?;
    group.bench_function(BenchmarkId::new("catenoid", 8), |bencher| {
        bencher.iter(|| least_area_complex(black_box(&complex), &[], 1e-13, &()));
    });
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    let complex = cube(4)?;
    group.bench_function(BenchmarkId::new("cube film", 4), |bencher| {
        bencher.iter(|| least_area_complex(black_box(&complex), &[], 1e-10, &()));
    });
    let patch = triangle(16)?;
    group.bench_function(BenchmarkId::new("triangle", 16), |bencher| {
        bencher.iter(|| least_area_triangle(black_box(&patch), 1e-10, &()));
    });
    for degree in [24, 64] {
        let patch = saddle(degree)?;
        group.bench_function(BenchmarkId::new("saddle of degree", degree), |bencher| {
            bencher.iter(|| least_area(black_box(&patch), 1e-10, &()));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
