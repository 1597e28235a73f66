//! Large nets: the automatic choice of solver stays accurate where Gram matrices lose all digits.

#![allow(clippy::print_stdout)] // the figures are worth reading

use experiment::{Options, Plan, run};
use plateau::MethodError;
use solve::SolveError;

/// Bernstein coefficients of degree d of the function with these Taylor coefficients: exact sums of positive weights
/// C(i, a)/C(d, a).
fn bernstein(d: usize, taylor: &[f64]) -> Vec<f64> {
    (0..=d)
        .map(|i| {
            let mut weight = 1.0;
            let mut sum = 0.0;
            for (a, c) in taylor.iter().enumerate().take(i + 1) {
                sum += c * weight;
                weight *= (i - a) as f64 / (d - a).max(1) as f64;
            }
            sum
        })
        .collect()
}

/// The graph of eˣ cos y over the unit square: its four sides as control points of degree d.
fn exponential_frame(d: usize, solver: &str) -> Plan {
    let mut factorial = vec![1.0f64; d + 1];
    (1..=d).for_each(|k| factorial[k] = factorial[k - 1] * k as f64);
    let exp: Vec<f64> = factorial.iter().map(|f| 1.0 / f).collect();
    let cos: Vec<f64> = (0..=d)
        .map(|k| {
            if k % 2 == 1 {
                0.0
            } else if k % 4 == 0 {
                1.0 / factorial[k]
            } else {
                -1.0 / factorial[k]
            }
        })
        .collect();
    let (e, c) = (bernstein(d, &exp), bernstein(d, &cos));
    let at = |k: usize| k as f64 / d as f64;
    let corner = |i: usize, j: usize| [at(i), at(j), e[i] * c[j]];
    let side = |f: &dyn Fn(usize) -> [f64; 3]| (0..=d).map(f).collect::<Vec<_>>();
    let text = format!(
        "title = \"frame\"\n[boundary]\nu0 = {:?}\nu1 = {:?}\nv0 = {:?}\nv1 = {:?}\n[[method]]\nname = \"x\"\nbasis = \"bernstein\"\nenergy = \"dirichlet\"\n{solver}\n[output]\nmesh = 2\n",
        side(&|j| corner(0, j)),
        side(&|j| corner(d, j)),
        side(&|i| corner(i, 0)),
        side(&|i| corner(i, d)),
    );
    Plan::parse("frame.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)))
}

#[test]
fn harmonic_graphs_are_found_at_degrees_20_and_30() {
    // The Taylor polynomial itself is off by 1/21! ≈ 2e-20 at degree 20: what is measured is the solver.
    for (degree, bound) in [(20, 1e-12), (30, 1e-8)] {
        let finished = run(&exponential_frame(degree, ""), Options::default(), &()).unwrap();
        let done = finished.results.methods[0].outcome.as_ref().expect("solved");
        let figures = done.solved.solve.expect("an extremal");
        assert_eq!(figures.solver, "separable");
        assert!(figures.residual < 30.0);
        let patch = done.solved.surface.patch();
        let mut worst = 0.0f64;
        for i in 0..=40 {
            for j in 0..=40 {
                let p = patch.point(f64::from(i) / 40.0, f64::from(j) / 40.0);
                worst = worst.max((p.z - libm::exp(p.x) * libm::cos(p.y)).abs());
            }
        }
        println!("degree {degree}: {worst:.1e} from eˣ cos y, allowed {bound:.0e}");
        assert!(worst < bound, "degree {degree}: {worst:e}");
        // What the control points may lose is said beside.
        assert!(figures.basis_condition.is_some_and(|c| c > 1e4));
    }
}

#[test]
fn the_dense_solver_asked_for_by_name_refuses_where_it_cannot() {
    let finished = run(&exponential_frame(20, "solver = \"dense\""), Options::default(), &()).unwrap();
    match &finished.results.methods[0].outcome {
        Err(error @ MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => {
            assert!(error.to_string().contains("separable"), "the message must say what to do: {error}");
        }
        other => panic!("{other:?}"),
    }
}
