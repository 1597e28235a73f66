//! How often the known minimum (0) is found within 1e-5, over 20 seeds.
//!
//! Rates are those of 20 fixed seeds, so they repeat exactly; the floors hold for
//! seven blocks of 20 other seeds too. `examples/success_rates.rs` prints the rates of 100 seeds.

mod functions;

use functions::{PROBLEMS, cube, rosenbrock, rosenbrock_with_gradient};
use optim::{FnObjective, FnSmooth, Polish, Pso, Topology};

/// Successes of 20 with 50 particles and 500 iterations.
fn successes(function: fn(&[f64]) -> f64, dimension: usize, sides: [f64; 2], topology: Topology) -> usize {
    let objective = FnObjective::new(dimension, function);
    let found = |&seed: &u64| {
        let pso = Pso { iterations: 500, topology, ..Pso::new(seed) };
        let run = pso.run(&objective, &cube(dimension, sides), 0, &());
        run.expect("valid parameters").value() < 1e-5
    };
    (0..20).filter(found).count()
}

/// Floors per problem, from two dimensions on.
fn assert_floors(topology: Topology, floors: [&[usize]; 5]) {
    for ((name, function, sides), floors) in PROBLEMS.into_iter().zip(floors) {
        for (dimension, &floor) in (2..).zip(floors) {
            let found = successes(function, dimension, sides, topology);
            assert!(found >= floor, "{name} in {dimension} dimensions: {found} of 20, floor {floor}");
        }
    }
}

#[test]
fn global_swarm() {
    let floors: [&[usize]; 5] = [&[20; 3], &[20], &[20, 17, 12], &[20; 3], &[11, 2]];
    assert_floors(Topology::Global, floors);
}

#[test]
fn ring_swarm() {
    let floors: [&[usize]; 5] = [&[20; 3], &[20], &[20, 17, 15], &[20; 3], &[17, 2]];
    assert_floors(Topology::Ring { neighbours: 2 }, floors);
}

#[test]
fn a_polish_finds_what_the_swarm_is_slow_to_find() {
    for (dimension, floor) in [(3, 20), (4, 15)] {
        let bounds = cube(dimension, [-2.0, 2.0]);
        let objective = FnObjective::new(dimension, rosenbrock);
        let smooth = FnSmooth::new(dimension, rosenbrock_with_gradient);
        let found = (0..20).filter(|&seed| {
            let run = Pso::new(seed).run(&objective, &bounds, 0, &()).unwrap();
            let start = run.best.unwrap();
            let polished = Polish::default().run(&smooth, &bounds, &start.point).unwrap();
            assert!(polished.value <= start.value);
            polished.value < 1e-20
        });
        let found = found.count();
        assert!(found >= floor, "{dimension} dimensions: {found} of 20, floor {floor}");
    }
}
