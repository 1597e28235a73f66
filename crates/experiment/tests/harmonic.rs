//! Harmonic nets from two opposite sides, and the bound that harmonic surfaces set.

use experiment::{Experiment, Options, Plan, run};
use plateau::{Boundary, BoundaryFigures, MethodError, Surface};
use proptest::prelude::*;
use surfaces::{Net, Point, TensorPatch, tb_coons};

/// Coefficients of tᵃ in the Bernstein basis of degree d: C(i, a) / C(d, a).
fn power(d: usize, a: usize, i: usize) -> f64 {
    (0..a).map(|k| if i > k { (i - k) as f64 / (d - k) as f64 } else { 0.0 }).product()
}

fn choose(n: usize, k: usize) -> f64 {
    (1..=k).map(|i| (n + 1 - i) as f64 / i as f64).product()
}

/// Bernstein coefficients of bidegree (m, n) of Re zᵏ or Im zᵏ, z = u + iv; none if the degree does not hold it.
fn harmonic_polynomial(m: usize, n: usize, k: usize, imaginary: bool) -> Option<Vec<f64>> {
    let mut net = vec![0.0; (m + 1) * (n + 1)];
    for b in 0..=k {
        if (b % 2 == 1) != imaginary {
            continue;
        }
        let a = k - b;
        if a > m || b > n {
            return None;
        }
        let sign = if (b / 2) % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..=m {
            for j in 0..=n {
                net[i * (n + 1) + j] += sign * choose(k, b) * power(m, a, i) * power(n, b, j);
            }
        }
    }
    Some(net)
}

/// A net whose coordinates are combinations of all harmonic polynomials of bidegree (m, n).
fn harmonic_net(m: usize, n: usize) -> Vec<[f64; 3]> {
    let mut net = vec![[0.0; 3]; (m + 1) * (n + 1)];
    for k in 0..=m + n {
        for imaginary in [false, true] {
            let Some(values) = harmonic_polynomial(m, n, k, imaginary) else { continue };
            for d in 0..3 {
                let weight = weight_of(k, usize::from(imaginary), d);
                for (p, v) in net.iter_mut().zip(&values) {
                    p[d] += weight * v;
                }
            }
        }
    }
    net
}

/// Weights without a pattern.
fn weight_of(k: usize, part: usize, d: usize) -> f64 {
    ((7 * k + 3 * part + 5 * d + 1) % 11) as f64 / 5.0 - 1.0
}

fn experiment(rows: bool, m: usize, n: usize, net: &[[f64; 3]]) -> Plan {
    let row = |i: usize| (0..=n).map(|j| net[i * (n + 1) + j]).collect::<Vec<_>>();
    let col = |j: usize| (0..=m).map(|i| net[i * (n + 1) + j]).collect::<Vec<_>>();
    let boundary = if rows {
        format!("u0 = {:?}\nu1 = {:?}\nu-degree = {m}", row(0), row(m))
    } else {
        format!("v0 = {:?}\nv1 = {:?}\nv-degree = {n}", col(0), col(n))
    };
    let text = format!(
        "title = \"harmonic\"\n[boundary]\n{boundary}\n[[method]]\nname = \"harmonic\"\nbasis = \"bernstein\"\nconstruction = \"harmonic\"\n"
    );
    Plan::parse("harmonic.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)))
}

fn solved(plan: &Plan) -> Result<Net, MethodError> {
    let finished = run(plan, Options::default(), &()).expect("a patch experiment");
    let method = finished.results.into_methods().into_iter().next().expect("one method");
    match method.outcome?.solved.surface() {
        Surface::Tensor(patch) => Ok(patch.net().clone()),
        other => panic!("a rectangular net was asked for, not {other:?}"),
    }
}

fn assert_reproduced(rows: bool, m: usize, n: usize) {
    let net = harmonic_net(m, n);
    let ours =
        solved(&experiment(rows, m, n, &net)).unwrap_or_else(|e| panic!("({m}, {n}), rows {rows}: {e}"));
    for (p, exact) in ours.points().iter().zip(&net) {
        assert!(p.distance(Point::from(*exact)) < 1e-12, "({m}, {n}), rows {rows}: {p:?} {exact:?}");
    }
}

#[test]
fn harmonic_polynomials_come_back_from_two_sides() {
    for (m, n) in [(3, 3), (4, 3), (5, 3), (5, 5), (7, 7)] {
        assert_reproduced(true, m, n);
        assert_reproduced(false, n, m);
    }
}

#[test]
fn consistent_data_of_other_degrees_give_the_net_too() {
    for (m, n) in [(3, 4), (4, 4), (3, 5)] {
        assert_reproduced(true, m, n);
    }
}

#[test]
fn inconsistent_data_give_an_error_that_counts_the_conditions() {
    for (m, n, expected) in [(3, 4, 2), (4, 4, 1)] {
        let mut net = harmonic_net(m, n);
        net[1][2] += 0.5;
        match solved(&experiment(true, m, n, &net)) {
            Err(error @ MethodError::HarmonicConflict { conditions, .. }) => {
                assert_eq!(conditions, expected, "({m}, {n})");
                let least = if n % 2 == 0 { n + 1 } else { n };
                let way_out =
                    format!("two rows of degree {n} determine the net with degree {least} in u or more");
                assert!(error.to_string().contains(&way_out), "{error}");
            }
            other => panic!("({m}, {n}): {other:?}"),
        }
    }
}

#[test]
fn the_degree_that_a_refusal_names_works_for_all_rows_and_columns() {
    for along in 1..=9usize {
        let least = if along.is_multiple_of(2) { along + 1 } else { along };
        for across in [least, least + 1, least + 2] {
            for rows in [true, false] {
                // Rows of any kind: a net that is not harmonic at all.
                let (m, n) = if rows { (across, along) } else { (along, across) };
                let entry = |i: usize, j: usize, d: usize| {
                    0.3 * (i * i + d) as f64 - libm::sin((3 * j + i * (d + 1)) as f64)
                };
                let point = |k: usize| [0, 1, 2].map(|d| entry(k / (n + 1), k % (n + 1), d));
                let net: Vec<[f64; 3]> = (0..(m + 1) * (n + 1)).map(point).collect();
                let found = solved(&experiment(rows, m, n, &net));
                assert!(found.is_ok(), "({m}, {n}), rows {rows}: {found:?}");
            }
        }
    }
}

#[test]
fn what_rounding_decides_is_told_as_rounding() {
    let along = 17;
    for across in [17, 18, 19] {
        for rows in [true, false] {
            let (m, n) = if rows { (across, along) } else { (along, across) };
            let entry = |k: usize, d: usize| libm::sin((3 * (k % (n + 1)) + k / (n + 1) * (d + 1)) as f64);
            let net: Vec<[f64; 3]> = (0..(m + 1) * (n + 1)).map(|k| [0, 1, 2].map(|d| entry(k, d))).collect();
            let found = solved(&experiment(rows, m, n, &net));
            assert!(matches!(found, Err(MethodError::HarmonicRounding { .. })), "({m}, {n}): {found:?}");
        }
    }
}

#[test]
fn all_four_sides_of_a_net_that_is_not_harmonic_are_in_conflict() {
    let text = "title = \"four\"\n[boundary]\nu0 = [[0,0,0],[0,1,0],[0,2,0],[0,3,0]]\nu1 = [[3,0,0],[3,1,5],[3,2,0],[3,3,0]]\nv0 = [[0,0,0],[1,0,0],[2,0,0],[3,0,0]]\nv1 = [[0,3,0],[1,3,0],[2,3,0],[3,3,0]]\n[[method]]\nname = \"h\"\nconstruction = \"harmonic\"\n";
    let plan = Plan::parse("four.toml", text).unwrap();
    let Experiment::Patch(experiment) = &plan.experiment else { panic!("a patch experiment") };
    assert!(matches!(experiment.boundary, Boundary::Tensor(_)));
    assert!(matches!(solved(&plan), Err(MethodError::HarmonicConflict { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn no_patch_has_less_energy_than_its_boundary_admits(
        points in prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], 20),
        shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5],
    ) {
        let net = Net::new(4, 5, points.into_iter().map(Point::from).collect()).unwrap();
        for patch in [
            TensorPatch::bernstein(net.clone()).unwrap(),
            TensorPatch::gt(net.clone(), shape).unwrap(),
            tb_coons(net, shape).unwrap(),
        ] {
            let form = energy::QuadraticForm::of(energy::Functional::Dirichlet, &patch).unwrap();
            let dirichlet = form.value(&patch.net().coordinates());
            let figures = BoundaryFigures::of(&patch).unwrap();
            prop_assert!(dirichlet >= figures.harmonic_bound - figures.harmonic_bound_error);
            prop_assert!(figures.harmonic_bound_error <= 1e-6 * figures.harmonic_bound);
            prop_assert!(figures.harmonic_bound > 0.0);
        }
    }
}

#[test]
fn the_bound_is_met_by_a_harmonic_patch_and_approached_by_raised_extremals() {
    let net = harmonic_net(3, 3).into_iter().map(Point::from).collect();
    let patch = TensorPatch::bernstein(Net::new(4, 4, net).unwrap()).unwrap();
    let form = energy::QuadraticForm::of(energy::Functional::Dirichlet, &patch).unwrap();
    let (figures, dirichlet) = (BoundaryFigures::of(&patch).unwrap(), form.value(&patch.net().coordinates()));
    assert!((figures.harmonic_bound / dirichlet - 1.0).abs() < 1e-12);
    assert_eq!(figures.deviation, 0.0);
}
