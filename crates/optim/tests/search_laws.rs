//! Laws of the swarm: what holds for every objective, box, seed and number of threads.

mod functions;

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};

use functions::{cube, rastrigin};
use optim::{
    Bounds, FnObjective, Objective, Progress, Pso, PsoError, Reason, Run, Search, Stagnation, Topology,
};
use proptest::prelude::*;

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

fn assert_same_bits(a: &Run, b: &Run) {
    assert_eq!(a, b);
    assert_eq!(bits(&a.history), bits(&b.history));
    if let (Some(a), Some(b)) = (&a.best, &b.best) {
        assert_eq!(bits(&a.point), bits(&b.point));
    }
}

fn assert_same_search(a: &Search, b: &Search) {
    assert_eq!(a.runs.len(), b.runs.len());
    for (a, b) in a.runs.iter().zip(&b.runs) {
        assert_same_bits(a, b);
    }
}

/// About a tenth of all points have no value, wherever the swarm goes.
fn patchy(x: &[f64]) -> f64 {
    let mixed = x.iter().fold(1_u64, |hash, x| (hash ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 7);
    if mixed.is_multiple_of(10) { f64::NAN } else { rastrigin(x) }
}

fn topologies() -> impl Strategy<Value = Topology> {
    prop_oneof![Just(Topology::Global), (1..6_usize).prop_map(|neighbours| Topology::Ring { neighbours }),]
}

prop_compose! {
    fn swarms()(
        particles in 1..24_usize,
        iterations in 0..30_usize,
        inertia in 0.0..1.5,
        social in 0.0..4.0,
        cognitive in 0.0..4.0,
        initial_velocity in 0.0..2.0,
        topology in topologies(),
        seed: u64,
    ) -> Pso {
        Pso { particles, iterations, inertia, social, cognitive, initial_velocity, topology,
            ..Pso::new(seed) }
    }
}

prop_compose! {
    fn boxes()(sides in prop::collection::vec((-50.0..50.0, 1e-3..100.0), 1..5)) -> Bounds {
        let (lower, widths): (Vec<f64>, Vec<f64>) = sides.into_iter().unzip();
        let upper = lower.iter().zip(&widths).map(|(l, w)| l + w).collect();
        Bounds::new(lower, upper).expect("a box")
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_report_is_consistent(pso in swarms(), bounds in boxes(), run in 0..9_usize) {
        let objective = FnObjective::new(bounds.dimension(), rastrigin);
        let seen = AtomicUsize::new(0);
        let watch = |progress: &Progress<'_>| {
            assert_eq!(progress.iteration, seen.fetch_add(1, Relaxed));
            ControlFlow::Continue(())
        };
        let report = pso.run(&objective, &bounds, run, &watch).unwrap();
        let best = report.best.as_ref().unwrap();

        prop_assert!(report.history.windows(2).all(|w| w[1] <= w[0]));
        prop_assert_eq!(report.history.len(), pso.iterations + 1);
        prop_assert_eq!(seen.into_inner(), pso.iterations + 1);
        prop_assert_eq!(report.history.last(), Some(&best.value));
        prop_assert_eq!(objective.value(&best.point).to_bits(), best.value.to_bits());
        prop_assert!(bounds.contains(&best.point));
        prop_assert_eq!(report.evaluations, (pso.particles * (pso.iterations + 1)) as u64);
        prop_assert_eq!(report.nan_evaluations, 0);
        prop_assert_eq!(report.reason, Reason::Budget);
        prop_assert!((0.0..=1.0).contains(&report.diameter));
        let falls = report.history.windows(2).rposition(|w| w[1] < w[0]);
        prop_assert_eq!(report.last_improvement, falls.map_or(0, |t| t + 1));
    }

    #[test]
    fn every_position_lies_in_the_box(pso in swarms(), bounds in boxes()) {
        let outside = AtomicUsize::new(0);
        // Lowest beyond a corner, so that the walls are met all the time; a tenth is NaN.
        let objective = FnObjective::new(bounds.dimension(), |x: &[f64]| {
            outside.fetch_add(usize::from(!bounds.contains(x)), Relaxed);
            patchy(x) - 100.0 * x[0]
        });
        pso.run(&objective, &bounds, 0, &()).unwrap();
        prop_assert_eq!(outside.into_inner(), 0);
    }

    #[test]
    fn a_ring_that_covers_everyone_is_global(
        pso in swarms(), bounds in boxes(), more in 0..5_usize,
    ) {
        let objective = FnObjective::new(bounds.dimension(), patchy);
        let neighbours = (pso.particles / 2).max(1) + more;
        let run = |topology| {
            Pso { topology, ..pso.clone() }.run(&objective, &bounds, 0, &()).unwrap()
        };
        assert_same_bits(&run(Topology::Global), &run(Topology::Ring { neighbours }));
    }

    #[test]
    fn nan_is_counted_and_never_spreads(pso in swarms(), bounds in boxes()) {
        let (nan, finite) = (AtomicU64::new(0), AtomicU64::new(0));
        let objective = FnObjective::new(bounds.dimension(), |x: &[f64]| {
            assert!(x.iter().all(|x| x.is_finite()));
            let value = patchy(x);
            let counter = if value.is_nan() { &nan } else { &finite };
            counter.fetch_add(1, Relaxed);
            value
        });
        let report = pso.run(&objective, &bounds, 0, &()).unwrap();
        let (nan, finite) = (nan.load(Relaxed), finite.load(Relaxed));
        prop_assert_eq!(report.nan_evaluations, nan);
        prop_assert_eq!(report.evaluations, nan + finite);
        prop_assert!(report.history.iter().all(|value| !value.is_nan()));
        prop_assert_eq!(report.best.is_some(), finite > 0);
        prop_assert!(report.best.is_none_or(|best| best.value.is_finite()));
    }
}

#[test]
fn a_tenth_of_nan_costs_little() {
    for seed in 0..100 {
        let pso = Pso::new(seed);
        let report = pso.run(&FnObjective::new(2, patchy), &cube(2, [-5.0, 5.0]), 0, &()).unwrap();
        let share = report.nan_evaluations as f64 / report.evaluations as f64;
        assert!((0.05..0.2).contains(&share), "seed {seed}: {share} NaN");
        assert!(report.value() < 1.1, "seed {seed}: {}", report.value());
    }
}

#[test]
fn a_narrow_ring_is_not_global() {
    let objective = FnObjective::new(3, rastrigin);
    let run = |topology| {
        let pso = Pso { topology, ..Pso::new(3) };
        pso.run(&objective, &cube(3, [-5.0, 5.0]), 0, &()).unwrap()
    };
    let ring = run(Topology::Ring { neighbours: 24 });
    assert_ne!(run(Topology::Global).history, ring.history);
}

#[test]
fn batches_and_threads_do_not_show() {
    let objective = FnObjective::new(3, patchy);
    let bounds = cube(3, [-5.0, 5.0]);
    for topology in [Topology::Global, Topology::Ring { neighbours: 2 }] {
        let pso = Pso { iterations: 40, topology, ..Pso::new(11) };
        let reference = pso.search(&objective, &bounds, 3, &()).unwrap();
        for threads in [1, 2, 4] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build().unwrap().install(|| {
                for batch in [1, 3, 8, 50] {
                    let pso = Pso { batch: Some(batch), ..pso.clone() };
                    let search = pso.search(&objective, &bounds, 3, &()).unwrap();
                    assert_same_search(&reference, &search);
                }
            });
        }
    }
}

#[test]
fn a_run_can_be_repeated_alone() {
    let objective = FnObjective::new(2, rastrigin);
    let bounds = cube(2, [-5.0, 5.0]);
    let pso = Pso::new(5);
    let search = pso.search(&objective, &bounds, 4, &()).unwrap();
    for (r, run) in search.runs.iter().enumerate() {
        assert_eq!((run.run, run.seed), (r, 5));
        assert_same_bits(run, &pso.run(&objective, &bounds, r, &()).unwrap());
    }
    assert_ne!(search.runs[0].history, search.runs[1].history);
    assert_ne!(search.runs[0].history, Pso::new(6).run(&objective, &bounds, 0, &()).unwrap().history);
    let least = search.runs.iter().map(Run::value).fold(f64::INFINITY, f64::min);
    assert_eq!(search.best().unwrap().value(), least);
    assert_eq!(search.evaluations(), 4 * 50 * 101);
}

#[test]
fn equal_values_prefer_the_smaller_index() {
    let flat = FnObjective::new(2, |_: &[f64]| 1.0);
    let bounds = cube(2, [0.0, 1.0]);
    let search = Pso::new(1).search(&flat, &bounds, 3, &()).unwrap();
    assert_eq!(search.best().unwrap().run, 0);
    // The first particle's first position: the same for a swarm of one.
    let alone = Pso { particles: 1, iterations: 0, ..Pso::new(1) };
    let alone = alone.run(&flat, &bounds, 0, &()).unwrap();
    assert_eq!(search.runs[0].best, alone.best);
}

#[test]
fn nothing_finite_is_said_and_not_a_panic() {
    let bounds = cube(2, [-1.0, 1.0]);
    let pso = Pso { iterations: 7, ..Pso::new(1) };
    for (value, nan) in [(f64::NAN, 400), (f64::INFINITY, 0)] {
        let run = pso.run(&FnObjective::new(2, |_: &[f64]| value), &bounds, 0, &()).unwrap();
        assert_eq!(run.reason, Reason::NothingFinite);
        assert_eq!((run.best.as_ref(), run.nan_evaluations), (None, nan));
        assert_eq!(run.value(), f64::INFINITY);
        assert!(run.to_string().contains("nothing found"));
    }
    let none = pso.search(&FnObjective::new(2, |_: &[f64]| f64::NAN), &bounds, 3, &()).unwrap();
    assert!(none.best().is_none());
    assert_eq!(none.nan_evaluations(), 1200);
}

/// Writes its first batch, then forgets all but the first value.
struct Forgetful(AtomicUsize);

impl Objective for Forgetful {
    fn dimension(&self) -> usize {
        1
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        let written = if self.0.fetch_add(1, Relaxed) == 0 { values.len() } else { 1 };
        values[..written].copy_from_slice(&points[..written]);
    }
}

#[test]
fn a_forgotten_value_is_nan() {
    let pso = Pso { particles: 10, iterations: 4, ..Pso::new(1) };
    let forgetful = Forgetful(AtomicUsize::new(0));
    let run = pso.run(&forgetful, &cube(1, [0.0, 1.0]), 0, &()).unwrap();
    assert_eq!(run.nan_evaluations, 9 * 4);
}

#[test]
fn runs_end_for_the_reason_they_say() {
    let sphere = FnObjective::new(2, functions::sphere);
    let bounds = cube(2, [-1.0, 1.0]);
    let pso = Pso { iterations: 1000, ..Pso::new(1) };

    let collapse = Pso { collapse: Some(1e-3), ..pso.clone() };
    let run = collapse.run(&sphere, &bounds, 0, &()).unwrap();
    assert_eq!(run.reason, Reason::Collapse);
    assert!(run.diameter <= 1e-3 && run.iterations() < 1000);

    let window = Stagnation { iterations: 5, tolerance: 1e-6 };
    let stagnation = Pso { stagnation: Some(window), ..pso.clone() };
    let shifted = FnObjective::new(2, |x: &[f64]| 1.0 + functions::sphere(x));
    let run = stagnation.run(&shifted, &bounds, 0, &()).unwrap();
    assert_eq!(run.reason, Reason::Stagnation);
    let t = run.iterations();
    assert!(t < 1000 && run.history[t - 5] - run.history[t] <= 1e-6 * run.history[t - 5]);
    for earlier in 5..t {
        let (before, after) = (run.history[earlier - 5], run.history[earlier]);
        assert!(before - after > 1e-6 * before, "iteration {earlier} was stagnant already");
    }

    let third = |progress: &Progress<'_>| match progress.iteration {
        3 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let run = pso.run(&sphere, &bounds, 0, &third).unwrap();
    assert_eq!((run.reason, run.iterations()), (Reason::Observer, 3));
    let free = pso.run(&sphere, &bounds, 0, &()).unwrap();
    assert_eq!(run.history, free.history[..4]);

    let pit = FnObjective::new(2, |x: &[f64]| if x[0] > 0.0 { f64::NEG_INFINITY } else { 1.0 });
    let run = pso.run(&pit, &bounds, 0, &()).unwrap();
    assert_eq!((run.reason, run.iterations()), (Reason::Unbounded, 0));
    assert!(run.best.unwrap().point[0] > 0.0);
}

#[test]
fn stagnation_waits_for_the_first_finite_value() {
    // Nothing is finite until 400 evaluations are done.
    let calls = AtomicUsize::new(0);
    let late =
        FnObjective::new(
            1,
            |x: &[f64]| {
                if calls.fetch_add(1, Relaxed) < 400 { f64::NAN } else { x[0] * x[0] + 1.0 }
            },
        );
    let window = Stagnation { iterations: 10, tolerance: 0.5 };
    let pso = Pso { stagnation: Some(window), ..Pso::new(1) };
    let run = pso.run(&late, &cube(1, [-1.0, 1.0]), 0, &()).unwrap();
    assert_eq!((run.reason, run.iterations()), (Reason::Stagnation, 18));
}

#[test]
fn stagnation_also_ends_a_search_for_nothing() {
    let nothing = FnObjective::new(1, |_: &[f64]| f64::NAN);
    let window = Stagnation { iterations: 10, tolerance: 0.0 };
    let pso = Pso { stagnation: Some(window), ..Pso::new(1) };
    let run = pso.run(&nothing, &cube(1, [-1.0, 1.0]), 0, &()).unwrap();
    assert_eq!((run.reason, run.iterations()), (Reason::NothingFinite, 10));
}

#[test]
fn bad_parameters_are_errors() {
    let sphere = FnObjective::new(2, functions::sphere);
    let bounds = cube(2, [-1.0, 1.0]);
    let error = |pso: Pso| pso.run(&sphere, &bounds, 0, &()).unwrap_err().to_string();
    let good = Pso::new(1);
    let window = |iterations, tolerance| Some(Stagnation { iterations, tolerance });
    let cases = [
        (Pso { particles: 0, ..good.clone() }, "particles"),
        (Pso { particles: 1_000_000_000_000, ..good.clone() }, "particles"),
        (Pso { iterations: usize::MAX, ..good.clone() }, "iterations"),
        (Pso { iterations: 40_000_000, ..good.clone() }, "iterations"),
        (Pso { particles: 1, iterations: 100_000_000, ..good.clone() }, "iterations"),
        (Pso { inertia: f64::NAN, ..good.clone() }, "inertia"),
        (Pso { social: f64::INFINITY, ..good.clone() }, "social"),
        (Pso { cognitive: -1.0, ..good.clone() }, "cognitive"),
        (Pso { initial_velocity: 1e9, ..good.clone() }, "initial velocity"),
        (Pso { topology: Topology::Ring { neighbours: 0 }, ..good.clone() }, "neighbours"),
        (Pso { batch: Some(0), ..good.clone() }, "batch"),
        (Pso { stagnation: window(0, 0.1), ..good.clone() }, "stagnation"),
        (Pso { stagnation: window(3, f64::NAN), ..good.clone() }, "stagnation"),
        (Pso { collapse: Some(1.5), ..good.clone() }, "collapse"),
    ];
    for (pso, word) in cases {
        let message = error(pso);
        assert!(message.contains(word), "{message:?} does not name {word}");
    }
    let wide = FnObjective::new(3, functions::sphere);
    assert_eq!(good.run(&wide, &bounds, 0, &()), Err(PsoError::Dimension { objective: 3, bounds: 2 }));
    for runs in [0, usize::MAX] {
        assert!(good.search(&sphere, &bounds, runs, &()).is_err());
    }
    let wide = Bounds::cube(5_000_000, 0.0, 1.0).unwrap();
    let many = FnObjective::new(5_000_000, functions::sphere);
    assert!(matches!(good.run(&many, &wide, 0, &()), Err(PsoError::Budget { .. })));
}

#[test]
fn bad_boxes_are_errors_by_index() {
    let error =
        |lower: &[f64], upper: &[f64]| Bounds::new(lower.to_vec(), upper.to_vec()).unwrap_err().to_string();
    assert!(error(&[], &[]).contains("dimension 0"));
    assert!(error(&[0.0], &[1.0, 2.0]).contains("1 lower but 2 upper"));
    assert!(error(&[0.0, 3.0], &[1.0, 3.0]).contains("component 1"));
    assert!(error(&[0.0, f64::NAN], &[1.0, 3.0]).contains("lower bound of component 1"));
    assert!(error(&[0.0], &[f64::INFINITY]).contains("upper bound of component 0"));
    assert!(error(&[-1e200], &[0.0]).contains("1e150"));

    let bounds = cube(2, [0.0, 1.0]);
    assert!(bounds.check(&[0.0, 1.0]).is_ok());
    assert!(bounds.check(&[0.0, 1.1]).unwrap_err().to_string().contains("component 1"));
    assert!(!bounds.contains(&[f64::NAN, 0.5]));
    assert!(!bounds.contains(&[0.5]));
}
