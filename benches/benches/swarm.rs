//! The search of GT Example 5.1: ten runs of a swarm of 50 over 100 iterations, and ten descents from random starts.

use std::hint::black_box;

use criterion::Throughput;
use optim::{Polish, Pso, Topology};
use plateau_benches::{FixtureError, example_5_1, gt_dirichlet, search_box};
use rayon::ThreadPoolBuilder;

const RUNS: usize = 10;

fn main() -> Result<(), FixtureError> {
    let mut criterion = plateau_benches::criterion();
    let (reduced, bounds) = (gt_dirichlet(&example_5_1()?)?, search_box()?);
    let polish = Polish::default();
    let mut group = criterion.benchmark_group("search");
    for (threads, label) in [(1, "one_thread"), (0, "all_threads")] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        for (name, topology) in [("global", Topology::Global), ("ring", Topology::Ring { neighbours: 2 })] {
            let pso = Pso { topology, ..Pso::new(7) };
            group.throughput(Throughput::Elements((RUNS * pso.particles * (pso.iterations + 1)) as u64));
            group.bench_function(format!("{name}/{label}"), |bencher| {
                pool.install(|| bencher.iter(|| pso.search(black_box(&reduced), &bounds, RUNS, &())));
            });
        }
        let descents = polish.run_starts(&reduced, &bounds, RUNS, 7)?;
        group.throughput(Throughput::Elements(descents.iter().map(|p| p.evaluations as u64).sum()));
        group.bench_function(format!("ten_starts/{label}"), |bencher| {
            pool.install(|| bencher.iter(|| polish.run_starts(black_box(&reduced), &bounds, RUNS, 7)));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
