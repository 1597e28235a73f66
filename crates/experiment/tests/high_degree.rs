//! Large nets: the automatic choice of solver stays accurate where Gram matrices lose all digits.

#![allow(clippy::print_stdout)] // the figures are worth reading

use experiment::{Options, Plan, run};
use plateau::{MethodError, Quantity};
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
fn exponential_frame(d: usize, energy: &str, solver: &str) -> Plan {
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
        "title = \"frame\"\n[boundary]\nu0 = {:?}\nu1 = {:?}\nv0 = {:?}\nv1 = {:?}\n[[method]]\nname = \"x\"\nbasis = \"bernstein\"\nenergy = \"{energy}\"\n{solver}\n[output]\nmesh = 2\n",
        side(&|j| corner(0, j)),
        side(&|j| corner(d, j)),
        side(&|i| corner(i, 0)),
        side(&|i| corner(i, d)),
    );
    Plan::parse("frame.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)))
}

/// Largest distance of a patch from the graph of eˣ cos y.
fn misfit(patch: &dyn surfaces::Patch) -> f64 {
    let mut worst = 0.0f64;
    for i in 0..=40 {
        for j in 0..=40 {
            let p = patch.point(f64::from(i) / 40.0, f64::from(j) / 40.0);
            worst = worst.max((p.z - libm::exp(p.x) * libm::cos(p.y)).abs());
        }
    }
    worst
}

#[test]
fn harmonic_graphs_are_found_at_every_degree() {
    // The Taylor polynomial itself is off by 1/21! ≈ 2e-20 at degree 20: what is measured is the solver.
    for (energy, degree) in [
        ("dirichlet", 20),
        ("dirichlet", 21),
        ("dirichlet", 30),
        ("dirichlet", 45),
        ("dirichlet", 64),
        ("laplacian", 20),
        ("laplacian", 30),
        ("laplacian", 64),
    ] {
        let finished = run(&exponential_frame(degree, energy, ""), Options::default(), &()).unwrap();
        let done = finished.results.methods()[0].outcome.as_ref().expect("solved");
        let figures = done.solved.solve().expect("an extremal");
        let separable = energy == "dirichlet" && degree <= 20;
        assert_eq!(figures.solver, if separable { "separable" } else { "conjugate-gradients" });
        assert!(figures.residual < 30.0);
        let worst = misfit(done.solved.surface().patch().expect("one patch"));
        println!("{energy}, degree {degree}: {worst:.1e} from eˣ cos y");
        assert!(worst < 1e-12, "{energy}, degree {degree}: {worst:e}");
        // What the control points may lose is said beside.
        assert_eq!(figures.basis_condition.is_some_and(|c| c > 1e4), separable);
        assert!(figures.left_out.unwrap_or(0.0) < 1e-13, "{figures:?}");
    }
}

#[test]
fn the_dense_solver_asked_for_by_name_refuses_where_it_cannot() {
    let finished =
        run(&exponential_frame(20, "dirichlet", "solver = \"dense\""), Options::default(), &()).unwrap();
    match &finished.results.methods()[0].outcome {
        Err(error @ MethodError::Solve(SolveError::NotPositiveDefinite { .. })) => {
            assert!(error.to_string().contains("separable"), "the message must say what to do: {error}");
        }
        other => panic!("{other:?}"),
    }
}

/// A cubic frame raised to a degree, and methods over it, one a row.
fn raised_frame(degree: usize, methods: &[String]) -> Plan {
    let mut text = "title = \"frame\"\n[boundary]\n\
        u0 = [[0,0,0],[0,1,0.4],[0,2,-0.2],[0,3,0]]\nu1 = [[3,0,0.3],[3,1,0],[3.2,2,0.5],[3,3,-0.4]]\n\
        v0 = [[0,0,0],[1,0.2,0],[2,0,-0.5],[3,0,0.3]]\nv1 = [[0,3,0],[1,3,0.6],[2,2.9,0.2],[3,3,-0.4]]\n\
        [output]\nmesh = 2\n"
        .to_owned();
    for (k, method) in methods.iter().enumerate() {
        let raise = degree - 3;
        text += &format!("[[method]]\nname = \"{k}\"\nraise = {raise}\n{method}\n");
    }
    Plan::parse("frame.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)))
}

/// The energies of every kind, by their keys, of three kinds of patch.
fn every_extremal() -> Vec<(String, Quantity)> {
    let shape = "shape = [1.3, 0.6, 2.9, 1.0]";
    let kinds = [
        "basis = \"bernstein\"".to_owned(),
        format!("basis = \"gt\"\n{shape}"),
        format!("patch = \"tb-coons\"\nbasis = \"gt\"\n{shape}"),
    ];
    let energies = [
        ("dirichlet", Quantity::Dirichlet),
        ("laplacian", Quantity::LaplacianDefect),
        ("bending", Quantity::Bending),
        ("coons", Quantity::Dirichlet),
    ];
    let with = |kind: &String| energies.map(|(energy, q)| (format!("{kind}\nenergy = \"{energy}\""), q));
    kinds.iter().flat_map(with).collect()
}

#[test]
fn conjugate_gradients_find_what_the_dense_solver_finds() {
    let methods = every_extremal();
    let keys: Vec<String> =
        methods.iter().flat_map(|(keys, _)| [keys.clone(), format!("{keys}\nsolver = \"dense\"")]).collect();
    let finished = run(&raised_frame(12, &keys), Options::default(), &()).unwrap();
    for (pair, (keys, quantity)) in finished.results.methods().chunks_exact(2).zip(&methods) {
        let solver = |k: usize| pair[k].outcome.as_ref().expect(keys).solved.solve().expect("solved").solver;
        assert_eq!(solver(1), "dense");
        assert!(["separable", "conjugate-gradients"].contains(&solver(0)));
        let figure = |k: usize| pair[k].figure(*quantity).expect("a figure");
        let (ours, dense) = (figure(0), figure(1));
        println!("{}: {ours:.12} {:.1e}", keys.replace('\n', ", "), ours / dense - 1.0);
        assert!((ours / dense - 1.0).abs() < 1e-9, "{keys}: {ours} {dense}");
    }
}

#[test]
fn raising_never_enlarges_a_minimum_and_settles() {
    for (keys, quantity) in every_extremal() {
        // GT families of a higher degree do not hold those of a lower one on the raised net; energies without a figure are
        // compared by another one.
        if !keys.contains("bernstein") || keys.contains("coons") {
            continue;
        }
        let figures: Vec<f64> = [8, 24, 64]
            .map(|degree| {
                let finished =
                    run(&raised_frame(degree, std::slice::from_ref(&keys)), Options::default(), &()).unwrap();
                finished.results.methods()[0].figure(quantity).expect("solved")
            })
            .into();
        println!("{}: {figures:?}", keys.replace('\n', ", "));
        for pair in figures.windows(2) {
            assert!(pair[1] <= pair[0] * (1.0 + 1e-12), "{keys}: {figures:?}");
        }
        // The Laplacian defect tends to 0, slowly; the others settle, bending slowly where sides meet.
        let settled = figures[1] - figures[2] < 1e-4 * figures[2];
        assert!(settled || quantity == Quantity::LaplacianDefect, "{keys}: {figures:?}");
    }
}

#[test]
fn two_and_sixty_four_are_degrees_like_others() {
    for (keys, _) in every_extremal() {
        let side = |of: &str, n: usize| {
            let point = |k: usize| {
                let t = k as f64 / n as f64;
                match of {
                    "u0" => format!("[0, {t}, {}]", t * (1.0 - t)),
                    "u1" => format!("[1, {t}, {}]", 0.3 * t),
                    "v0" => format!("[{t}, 0, 0]"),
                    _ => format!("[{t}, 1, {}]", 0.3 * t),
                }
            };
            (0..=n).map(point).collect::<Vec<_>>().join(", ")
        };
        let text = format!(
            "title = \"x\"\n[boundary]\nu0 = [{}]\nu1 = [{}]\nv0 = [{}]\nv1 = [{}]\n[[method]]\nname = \"x\"\n{keys}\n[output]\nmesh = 2",
            side("u0", 64),
            side("u1", 64),
            side("v0", 2),
            side("v1", 2)
        );
        let plan = Plan::parse("x.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
        let finished = run(&plan, Options::default(), &()).unwrap();
        let done =
            finished.results.methods()[0].outcome.as_ref().unwrap_or_else(|error| panic!("{keys}: {error}"));
        assert!(done.figures.area.settled && done.solved.surface().cancellation() < 1e-9, "{keys}");
    }
}
