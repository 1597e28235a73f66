//! 100 000 scattered points of a patch: what an evaluation asked for at parameters of one's own costs.

use std::hint::black_box;

use criterion::BenchmarkId;
use plateau_benches::{FixtureError, wave};
use surfaces::{Patch, Point, TensorPatch, TriangleNet, TrianglePatch};

const COUNT: usize = 100_000;

fn main() -> Result<(), FixtureError> {
    // Spread evenly over the triangle below the diagonal, which is part of the square too.
    let parameters: Vec<[f64; 2]> = (0..COUNT)
        .map(|k| [0.618_033_988_749_894_9, 0.754_877_666_246_692_8].map(|step| (k as f64 * step).fract()))
        .map(|[u, v]| if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] })
        .collect();
    let mut patches: Vec<(&str, usize, Box<dyn Patch>)> = Vec::new();
    for degree in [3, 8] {
        let net = wave(degree)?;
        patches.push(("bernstein", degree, Box::new(TensorPatch::bernstein(net.clone())?)));
        patches.push(("gt", degree, Box::new(TensorPatch::gt(net, [0.87, 1.2, 1.0, 2.0])?)));
        let points = (0..(degree + 1) * (degree + 2) / 2).map(|k| Point::new(k as f64, (k * k) as f64, 1.0));
        patches.push((
            "triangle",
            degree,
            Box::new(TrianglePatch::new(TriangleNet::new(degree, points.collect())?)?),
        ));
    }
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("scattered");
    group.sample_size(10);
    for (name, degree, patch) in &patches {
        group.bench_function(BenchmarkId::new(format!("points_{name}"), degree), |bencher| {
            bencher.iter(|| patch.points_at(black_box(&parameters)));
        });
        group.bench_function(BenchmarkId::new(format!("jets_{name}"), degree), |bencher| {
            bencher.iter(|| patch.jets_at(black_box(&parameters)));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
