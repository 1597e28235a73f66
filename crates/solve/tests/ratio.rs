//! Every solve is held against LAPACK's threshold: `‖b − A x‖ / (‖A‖ ‖x‖ n ε) ≤ 30`, or it is an error.
#![allow(clippy::print_stdout, reason = "the distribution is worth seeing with --nocapture")]

mod families;

use families::{
    Random, add_kronecker, bernstein_samples, gram, gt_dirichlet, gt_samples, interior, smooth_net,
};
use solve::{Parametric, Partition, Separable, SeparableParametric, SolveError, Triplet};

const RATIO: f64 = 30.0;

/// The ratio of its definition, one column after the other, and the larger of it.
fn ratio(n: usize, a: &[f64], columns: usize, b: &[f64], x: &[f64]) -> f64 {
    let norm = (0..n).map(|j| (0..n).map(|i| a[i * n + j].abs()).sum::<f64>()).fold(0.0, f64::max);
    let mut worst = 0.0f64;
    for c in 0..columns {
        let (mut defect, mut size) = (0.0, 0.0);
        for i in 0..n {
            let product: f64 = (0..n).map(|j| a[i * n + j] * x[j * columns + c]).sum();
            defect += (b[i * columns + c] - product).abs();
            size += x[i * columns + c].abs();
        }
        let ratio = if defect == 0.0 { 0.0 } else { defect / (norm * size * n as f64 * f64::EPSILON) };
        worst = worst.max(ratio);
    }
    worst
}

fn triplets(n: usize, a: &[f64]) -> Vec<Triplet> {
    let entries = a.iter().enumerate().filter(|(_, a)| **a != 0.0);
    entries.map(|(e, &value)| Triplet { row: e / n, column: e % n, value }).collect()
}

/// A random matrix in which about eight entries a row are not zero; symmetric and diagonally dominant, or neither.
fn sparse(random: &mut Random, n: usize, definite: bool) -> Vec<f64> {
    let mut a = vec![0.0; n * n];
    for i in 0..n {
        a[i * n + i] += if definite { 9.0 } else { 1.0 };
        for _ in 0..4 {
            let (j, value) = (random.next() as usize % n, random.signed());
            a[i * n + j] += value;
            if definite {
                a[j * n + i] += value;
            } else {
                a[(random.next() as usize % n) * n + i] += random.signed();
            }
        }
    }
    a
}

/// The reported ratio is the one of the solution, up to the rounding of a residual, which is itself rounding.
fn check(name: &str, n: usize, reported: f64, recomputed: f64) {
    assert!(reported <= RATIO && recomputed <= RATIO, "{name}, order {n}: {reported} {recomputed}");
    assert!((reported - recomputed).abs() <= 1.0, "{name}, order {n}: {reported} is not {recomputed}");
}

#[test]
fn all_solvers_at_lapacks_sizes() {
    let mut random = Random(1);
    let mut seen: Vec<f64> = Vec::new();
    for n in [0usize, 1, 2, 3, 5, 10, 50] {
        for _ in 0..100 {
            let b = random.vector(3 * n);
            let (spd, general) = (random.spd(n), random.vector(n * n));
            let mut record = |name: &str, a: &[f64], solution: Result<solve::Solution, SolveError>| {
                // A random matrix may be singular to working precision; it is not, for these seeds.
                let solution = solution.unwrap_or_else(|error| panic!("{name}, order {n}: {error}"));
                assert_eq!(solution.x.len(), 3 * n);
                check(name, n, solution.residual, ratio(n, a, 3, &b, &solution.x));
                if n > 0 {
                    seen.push(solution.residual);
                }
            };
            record("Cholesky", &spd, solve::solve_spd(n, &spd, 3, &b));
            record("LU", &general, solve::solve_general(n, &general, 3, &b));
            let definite = sparse(&mut random, n, true);
            record("sparse Cholesky", &definite, solve::solve_sparse_spd(n, &triplets(n, &definite), 3, &b));
            let any = sparse(&mut random, n, false);
            if let Ok(lu) = solve::SparseLu::new(n, &triplets(n, &any)) {
                record("sparse LU", &any, lu.solve(3, &b));
            }
        }
    }
    seen.sort_by(f64::total_cmp);
    let (median, largest) = (seen[seen.len() / 2], seen[seen.len() - 1]);
    println!("{} solves: median ratio {median:.3}, largest {largest:.3}", seen.len());
    assert!(seen.len() > 2300 && median > 0.0 && median <= 1.0 && largest <= RATIO);
}

#[test]
fn tensor_nets_by_every_solver() {
    let mut random = Random(2);
    let mut seen: Vec<f64> = Vec::new();
    for degree in 2..=8 {
        for _ in 0..20 {
            let net = smooth_net(&mut random, [degree, degree]);
            let free = interior(degree);
            let order = (degree + 1) * (degree + 1);
            let partition = Partition::of_net(degree + 1, degree + 1, &free, &free).unwrap();
            let samples = bernstein_samples(degree);
            let (k, m) = (
                gram(&samples.weights, degree + 1, &samples.derivatives),
                gram(&samples.weights, degree + 1, &samples.values),
            );
            let mut q = vec![0.0; order * order];
            add_kronecker(&mut q, 0.5, &k, degree + 1, &m, degree + 1);
            add_kronecker(&mut q, 0.5, &m, degree + 1, &k, degree + 1);
            let block = partition.free_block(&q).unwrap();
            let defect = |x: &[f64]| {
                let p = partition.gather_free(3, x).unwrap();
                let mut b = vec![0.0; p.len()];
                for (r, &i) in partition.free().iter().enumerate() {
                    for &j in partition.fixed() {
                        (0..3).for_each(|d| b[3 * r + d] -= q[i * order + j] * x[3 * j + d]);
                    }
                }
                ratio(partition.free().len(), &block, 3, &b, &p)
            };
            let dense = solve::solve_partitioned(order, &q, &partition, 3, &net).unwrap();
            check("dense", order, dense.residual, defect(&dense.x));
            let separable = Separable::new(&samples, &samples, &free, &free).unwrap().solve(&net).unwrap();
            // In its own functions; in those of the net the ratio may be larger, the net being worse conditioned.
            assert!(separable.residual <= RATIO && defect(&separable.x) <= RATIO, "separable, {degree}");
            let shape = [0.0; 4].map(|_: f64| 2.0 + 1.5 * random.signed());
            let parametric = Parametric::new(&gt_dirichlet([degree; 2], net.clone())).unwrap();
            let of_tables = parametric.solve(&shape).unwrap();
            let system =
                SeparableParametric::new(gt_samples(degree), gt_samples(degree), &free, &free, &net).unwrap();
            let of_samples = system.solve(&shape).unwrap();
            seen.extend([dense.residual, separable.residual, of_tables.residual, of_samples.residual]);
        }
    }
    seen.sort_by(f64::total_cmp);
    let (median, largest) = (seen[seen.len() / 2], seen[seen.len() - 1]);
    println!("{} solves of nets: median ratio {median:.3}, largest {largest:.3}", seen.len());
    assert!(median > 0.0 && median <= 1.0 && largest <= RATIO);
}

/// Wilkinson's matrix: elimination with partial pivoting doubles its last column at every step, so that the answer is
/// wrong although the matrix is well conditioned.
fn wilkinson(n: usize) -> Vec<f64> {
    (0..n * n)
        .map(|e| match (e / n, e % n) {
            (i, j) if i == j || j == n - 1 => 1.0,
            (i, j) if i > j => -1.0,
            _ => 0.0,
        })
        .collect()
}

#[test]
fn a_solution_that_misses_its_system_is_an_error() {
    let mut random = Random(3);
    let b = random.vector(3 * 70);
    match solve::solve_general(70, &wilkinson(70), 3, &b) {
        Err(error @ SolveError::Residual { order: 70, ratio }) => {
            assert!(ratio > RATIO);
            let message = error.to_string();
            assert!(message.contains("above 30") && message.contains("order 70"), "{message}");
        }
        other => panic!("{other:?}"),
    }
    // The same matrix small: growth of 2⁹ is within what is tolerated.
    assert!(solve::solve_general(10, &wilkinson(10), 3, &b[..30]).is_ok());
}
