//! One net, every solver: the surfaces agree to `100 ε κ̂`, with κ̂ the condition that the dense solver reports.
//!
//! The table: `cargo test --release -p plateau-solve --test agreement -- --nocapture`.
#![allow(clippy::print_stdout, reason = "the table is the point")]

mod families;

use families::{GtSamples, Random, add_kronecker, gram, gt, gt_dirichlet, gt_samples, interior, smooth_net};
use solve::{Parametric, Partition, Path, Samples, Separable, SeparableParametric, Triplet};

/// Points of the surface of a GT net at a shape, on a grid.
fn surface([m, n]: [usize; 2], shape: &[f64; 4], net: &[f64]) -> Vec<f64> {
    let at = |degree: usize, theta: [f64; 2], t: f64| -> Vec<f64> {
        let parts = gt(degree, t);
        (0..=degree).map(|k| parts[0].0[k] + theta[0] * parts[1].0[k] + theta[1] * parts[2].0[k]).collect()
    };
    let grid = |degree: usize, theta: [f64; 2]| -> Vec<Vec<f64>> {
        (0..=20).map(|k| at(degree, theta, f64::from(k) / 20.0)).collect()
    };
    let (along, across) = (grid(m, [shape[0], shape[1]]), grid(n, [shape[2], shape[3]]));
    let mut points = Vec::new();
    for f in &along {
        for g in &across {
            for d in 0..3 {
                let row = |i: usize| (0..=n).map(|j| g[j] * net[3 * (i * (n + 1) + j) + d]).sum::<f64>();
                points.push((0..=m).map(|i| f[i] * row(i)).sum::<f64>());
            }
        }
    }
    points
}

/// The extremal by the sparse factorisations: the free block as triplets, zeros left out.
fn sparse(order: usize, q: &[f64], partition: &Partition, net: &[f64], definite: bool) -> Vec<f64> {
    let block = partition.free_block(q).unwrap();
    let free = partition.free().len();
    let triplets: Vec<Triplet> = (0..free * free)
        .filter(|&e| block[e] != 0.0)
        .map(|e| Triplet { row: e / free, column: e % free, value: block[e] })
        .collect();
    let mut rhs = vec![0.0; 3 * free];
    for (k, &i) in partition.free().iter().enumerate() {
        for &j in partition.fixed() {
            (0..3).for_each(|d| rhs[3 * k + d] -= q[i * order + j] * net[3 * j + d]);
        }
    }
    let solve = if definite { solve::solve_sparse_spd } else { solve::solve_sparse };
    let solution = solve(free, &triplets, 3, &rhs).unwrap();
    let mut x = net.to_vec();
    partition.scatter_free(3, &solution.x, &mut x).unwrap();
    x
}

#[test]
fn every_solver_finds_the_same_surface() {
    let mut random = Random(1);
    println!(
        "{:<10}{:>10}  difference of the surface from the dense one, relative to its size, over eps k",
        "degrees", "k"
    );
    println!(
        "{:<20}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}",
        "", "sparse", "sparse LU", "separable", "by tables", "portable", "by samples"
    );
    for degrees @ [m, n] in [[2, 2], [2, 5], [3, 3], [4, 3], [4, 4], [5, 5], [6, 6], [7, 8], [9, 9], [10, 10]]
    {
        let (mut worst, mut condition) = ([0.0f64; 6], 0.0f64);
        for _ in 0..5 {
            let net = smooth_net(&mut random, degrees);
            let shape = [0.0; 4].map(|_: f64| 2.0 + 1.5 * random.signed());
            let samples = |degree: usize, theta: [f64; 2]| {
                let samples = GtSamples::new(degree);
                let (values, derivatives) = samples.at(theta);
                let GtSamples { points, functions, weights, .. } = samples;
                Samples { points, functions, weights, values, derivatives }
            };
            let (u, v) = (samples(m, [shape[0], shape[1]]), samples(n, [shape[2], shape[3]]));
            let grams = |s: &Samples| {
                [&s.derivatives, &s.values].map(|samples| gram(&s.weights, s.functions, samples))
            };
            let ([ku, mu], [kv, mv]) = (grams(&u), grams(&v));
            let order = (m + 1) * (n + 1);
            let mut q = vec![0.0; order * order];
            add_kronecker(&mut q, 0.5, &ku, m + 1, &mv, n + 1);
            add_kronecker(&mut q, 0.5, &mu, m + 1, &kv, n + 1);
            let (free_u, free_v) = (interior(m), interior(n));
            let partition = Partition::of_net(m + 1, n + 1, &free_u, &free_v).unwrap();
            let dense = solve::solve_partitioned(order, &q, &partition, 3, &net).unwrap();
            let parametric = Parametric::new(&gt_dirichlet(degrees, net.clone())).unwrap();
            let portable = parametric.clone().with_path(Path::Portable).unwrap();
            let others = [
                sparse(order, &q, &partition, &net, true),
                sparse(order, &q, &partition, &net, false),
                Separable::new(&u, &v, &free_u, &free_v).unwrap().solve(&net).unwrap().x,
                parametric.solve(&shape).unwrap().x,
                portable.solve(&shape).unwrap().x,
                SeparableParametric::new(gt_samples(m), gt_samples(n), &free_u, &free_v, &net)
                    .unwrap()
                    .solve(&shape)
                    .unwrap()
                    .x,
            ];
            let known = surface(degrees, &shape, &dense.x);
            let size = known.iter().fold(0.0f64, |s, x| s.max(x.abs()));
            condition = condition.max(dense.condition);
            for (worst, other) in worst.iter_mut().zip(&others) {
                let found = surface(degrees, &shape, other);
                let difference = known.iter().zip(&found).fold(0.0f64, |d, (a, b)| d.max((a - b).abs()));
                *worst = worst.max(difference / (size * f64::EPSILON * dense.condition));
            }
        }
        print!("{:<10}{condition:>10.1e}", format!("{m} x {n}"));
        worst.iter().for_each(|w| print!("{w:>12.1e}"));
        println!();
        assert!(worst.iter().all(|w| *w <= 100.0), "{m} × {n}: {worst:?}");
    }
}
