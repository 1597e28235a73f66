//! Seconds for the search of GT Example 5.1 in process, one `name value` a line for other programs to read:
//! `cargo run --release -p plateau-benches --example search_time`.
//!
//! Medians (and the least) of many repeats of ten runs of the swarm (50 particles, 100 iterations) and of ten descents
//! from random starts, on one thread and on all of them; the minimum that each found.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use std::hint::black_box;
use std::time::Instant;

use optim::{Polish, Pso};
use plateau_benches::{FixtureError, example_5_1, gt_dirichlet, search_box};
use rayon::ThreadPoolBuilder;

const RUNS: usize = 10;

/// Median and least wall time of `repeats` calls, in seconds.
fn seconds(repeats: usize, mut call: impl FnMut()) -> [f64; 2] {
    call();
    let mut times: Vec<f64> = (0..repeats)
        .map(|_| {
            let start = Instant::now();
            call();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_unstable_by(f64::total_cmp);
    [times[repeats / 2], times[0]]
}

fn main() -> Result<(), FixtureError> {
    let (reduced, bounds) = (gt_dirichlet(&example_5_1()?)?, search_box()?);
    let (pso, polish) = (Pso::new(7), Polish::default());
    println!("path {}", reduced.path());
    for (threads, label) in [(1, "one-thread"), (0, "all-threads")] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        println!("threads-{label} {}", pool.current_num_threads());
        let [median, least] = pool.install(|| {
            seconds(51, || {
                let _ = black_box(pso.search(black_box(&reduced), &bounds, RUNS, &()));
            })
        });
        println!("search-{label} {median:e}\nsearch-{label}-least {least:e}");
        let [median, least] = pool.install(|| {
            seconds(501, || {
                let _ = black_box(polish.run_starts(black_box(&reduced), &bounds, RUNS, 7));
            })
        });
        println!("ten-starts-{label} {median:e}\nten-starts-{label}-least {least:e}");
    }
    let search = pso.search(&reduced, &bounds, RUNS, &())?;
    let best = search.best().ok_or("the swarm found nothing")?;
    println!("search-evaluations {}\nsearch-minimum {:.13}", search.evaluations(), best.value());
    let descents = polish.run_starts(&reduced, &bounds, RUNS, 7)?;
    let evaluations: usize = descents.iter().map(|descent| descent.evaluations).sum();
    let least = descents.iter().map(|descent| descent.value).fold(f64::INFINITY, f64::min);
    println!("ten-starts-evaluations {evaluations}\nten-starts-minimum {least:.13}");
    Ok(())
}
