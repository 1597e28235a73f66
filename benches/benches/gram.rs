//! Gram matrices: of values and of derivatives of one family, its quadrature included; and those of all shapes at once.

use std::hint::black_box;

use bases::{Gt, Samples};
use criterion::BenchmarkId;
use energy::{Functional, ShapeForm};
use plateau_benches::FixtureError;
use surfaces::ShapedFamily;

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("gram");
    for degree in [3, 8, 20] {
        let basis = Gt::new(degree, [0.87, 1.2])?;
        group.bench_function(BenchmarkId::new("gt", degree), |bencher| {
            bencher.iter(|| {
                let samples = Samples::new(black_box(&basis), Samples::points_for(degree + 1), 1);
                samples.map(|samples| [samples.gram(0, &samples, 0), samples.gram(1, &samples, 1)])
            });
        });
    }
    for degree in [3, 8] {
        for (name, patch) in
            [("shape_form_gt", ShapedFamily::Gt), ("shape_form_tb_coons", ShapedFamily::TbCoons)]
        {
            group.bench_function(BenchmarkId::new(name, degree), |bencher| {
                bencher.iter(|| ShapeForm::of(Functional::Dirichlet, patch, black_box((degree, degree))));
            });
        }
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
