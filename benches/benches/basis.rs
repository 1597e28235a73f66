//! One call that gives all functions of a family with their first and second derivatives; and the Gauss rules that
//! such calls are made at.

use std::hint::black_box;

use bases::{Basis, Bernstein, GaussLegendre, Gt};
use criterion::BenchmarkId;
use plateau_benches::FixtureError;

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("basis");
    for degree in [3, 20] {
        let bernstein = Bernstein::new(degree)?;
        let gt = Gt::new(degree, [0.87, 1.2])?;
        let families: [(&str, &dyn Basis); 2] = [("bernstein", &bernstein), ("gt", &gt)];
        for (name, basis) in families {
            let mut out = vec![0.0; 3 * basis.count()];
            group.bench_function(BenchmarkId::new(name, degree), |bencher| {
                bencher.iter(|| basis.evaluate_into(black_box(0.3), 2, black_box(&mut out)));
            });
        }
    }
    for points in [20, 64] {
        group.bench_function(BenchmarkId::new("gauss_legendre", points), |bencher| {
            bencher.iter(|| GaussLegendre::new(black_box(points)));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
