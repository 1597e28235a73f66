//! A whole experiment in process: the file of GT Example 5.1 read, checked and run, all four methods.

use std::hint::black_box;

use experiment::{Options, Plan, run};
use plateau_benches::FixtureError;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/gt-5.1.toml");

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let mut group = criterion.benchmark_group("experiment");
    group.bench_function("read", |bencher| bencher.iter(|| Plan::read(black_box(FILE))));
    let plan = Plan::read(FILE).map_err(|refusal| refusal.to_string())?;
    group.bench_function("read_and_run", |bencher| {
        bencher.iter(|| Plan::read(black_box(FILE)).map(|plan| run(&plan, Options::default(), &())));
    });
    let finished = run(&plan, Options::default(), &())?;
    assert!(finished.missed().is_empty(), "what was timed is not the experiment");
    group.finish();
    criterion.final_summary();
    Ok(())
}
