//! The metric Dirichlet energy and the correction made from it.

mod interior;

use energy::{
    AreaExpansion, DenseForm, EnergyError, Functional, MetricForm, QuadraticForm, area, area_with_gradient,
    triangle_area_with_gradient,
};
use interior::{extremal, extremal_coordinates, ni, solve};
use proptest::prelude::*;
use surfaces::{Domain, Net, Patch, Point, TensorPatch, TriangleNet, TrianglePatch};

fn dirichlet(n: usize) -> DenseForm {
    DenseForm::of_triangle(Functional::Dirichlet, n).unwrap()
}

fn patch(net: &TriangleNet) -> TrianglePatch {
    TrianglePatch::new(net.clone()).unwrap()
}

/// Bumped flat borders over the triangle, interior the Dirichlet extremal.
fn triangle() -> impl Strategy<Value = TriangleNet> {
    (3usize..=5, prop::collection::vec([-0.1..0.1f64, -0.1..0.1, -0.8..0.8], 21)).prop_map(|(n, bumps)| {
        let flat = ni([false; 3], n);
        let all: Vec<f64> = flat
            .indices()
            .zip(bumps)
            .flat_map(|([i, j, _], b)| {
                let s = 1.0 / n as f64;
                [(i as f64 + b[0]) * s, (j as f64 + b[1]) * s, b[2]]
            })
            .collect();
        extremal(&dirichlet(n), &flat.with_coordinates(&all).unwrap())
    })
}

fn tensor() -> impl Strategy<Value = TensorPatch> {
    prop::collection::vec([-0.1..0.1f64, -0.1..0.1, -0.8..0.8], 20).prop_map(|bumps| {
        let point = |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[5 * i + j]);
        let row = |i: usize| (0..5).map(|j| point(i, j)).collect::<Vec<_>>();
        let col = |j: usize| (0..4).map(|i| point(i, j)).collect::<Vec<_>>();
        let net = Net::from_boundary(&row(0), &row(3), &col(0), &col(4)).unwrap();
        let patch = TensorPatch::bernstein(net).unwrap();
        let form = QuadraticForm::of(Functional::Dirichlet, &patch).unwrap().matrix();
        tensor_extremal(&form, &patch)
    })
}

fn tensor_extremal(form: &bases::Matrix, patch: &TensorPatch) -> TensorPatch {
    let net = patch.net();
    let x = extremal_coordinates(form, &net.coordinates(), net.fixed());
    patch.with_net(net.with_coordinates(&x).unwrap()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn the_energy_in_ones_own_metric_is_twice_the_area(net in triangle(), other in triangle()) {
        let metric = MetricForm::of_triangle(&patch(&net), net.degree()).unwrap();
        let area_of = |net: &TriangleNet| area(&patch(net)).unwrap();
        let (own, foreign) = (area_of(&net), area_of(&other));
        if metric.settled {
            prop_assert!((metric.form.value(&net.coordinates()) - 2.0 * own.value).abs() <= 1e-9 * own.value + own.error);
        }
        // D^g ≥ 2 A for every chart, whatever its own metric.
        if net.degree() == other.degree() {
            prop_assert!(metric.form.value(&other.coordinates()) >= 2.0 * foreign.value * (1.0 - 1e-9) - foreign.error);
        }
    }

    #[test]
    fn corrections_never_enlarge_the_area_of_a_triangular_patch(start in triangle()) {
        let mut net = start;
        let mut last = area(&patch(&net)).unwrap();
        for _ in 0..4 {
            let metric = MetricForm::of_triangle(&patch(&net), net.degree()).unwrap();
            prop_assume!(metric.settled);
            net = extremal(&metric.form, &net);
            let next = area(&patch(&net)).unwrap();
            prop_assert!(next.value <= last.value * (1.0 + 1e-9) + next.error + last.error, "{next:?} {last:?}");
            last = next;
        }
    }

    #[test]
    fn corrections_never_enlarge_the_area_of_a_tensor_patch(start in tensor()) {
        let mut patch = start;
        let mut last = area(&patch).unwrap();
        for _ in 0..4 {
            let metric = MetricForm::of_tensor(&patch, &patch).unwrap();
            prop_assume!(metric.settled);
            patch = tensor_extremal(metric.form.matrix(), &patch);
            let next = area(&patch).unwrap();
            prop_assert!(next.value <= last.value * (1.0 + 1e-9) + next.error + last.error, "{next:?} {last:?}");
            last = next;
        }
    }
}

#[test]
fn a_conformal_metric_gives_twice_the_dirichlet_energy() {
    // Constant E = G, F = 0: the weights are 1, whatever the scale.
    let [a, b, c] = [[3., 0., 0.], [0., 3., 0.], [0., 0., 0.]].map(Point::from);
    let metric = patch(&TriangleNet::from_boundary(&[a, b], &[b, c], &[c, a]).unwrap());
    let form = MetricForm::of_triangle(&metric, 4).unwrap();
    assert!(form.settled && form.points == 12);
    for (x, y) in form.form.matrix().as_slice().iter().zip(dirichlet(4).matrix().as_slice()) {
        assert!((x - 2.0 * y).abs() <= 1e-14, "{x} {y}");
    }
    let square = (0..4).map(|k| Point::new(2.0 * (k / 2) as f64, 2.0 * (k % 2) as f64, 1.0)).collect();
    let metric = TensorPatch::bernstein(Net::new(2, 2, square).unwrap()).unwrap();
    let cubic =
        TensorPatch::gt(Net::new(4, 3, vec![Point::ZERO; 12]).unwrap(), [1.0, 2.0, 3.0, 0.5]).unwrap();
    let form = MetricForm::of_tensor(&metric, &cubic).unwrap();
    let dirichlet = QuadraticForm::of(Functional::Dirichlet, &cubic).unwrap().matrix();
    for (x, y) in form.form.matrix().as_slice().iter().zip(dirichlet.as_slice()) {
        assert!((x - 2.0 * y).abs() <= 1e-13, "{x} {y}");
    }
}

#[test]
fn corrections_tend_to_the_stationary_point_of_the_area_and_rest_there() {
    for arcs in [[true, false, false], [true; 3]] {
        let start = extremal(&dirichlet(3), &ni(arcs, 3));
        let at = 3 * start.position(1, 1);
        let moved = |net: &TriangleNet, by: [f64; 3]| {
            let mut x = net.coordinates();
            (0..3).for_each(|d| x[at + d] += by[d]);
            net.with_coordinates(&x).unwrap()
        };
        // The one free point of the cubic net by Newton's method on the area itself.
        let mut rest = start.clone();
        for _ in 0..6 {
            let step = AreaExpansion::of_triangle(&patch(&rest), 32).unwrap();
            let rows = (0..3).map(|r| step.hessian.row(r).to_vec()).collect();
            let by = solve(rows, step.gradient.iter().map(|g| [-g, 0.0, 0.0]).collect());
            rest = moved(&rest, [by[0][0], by[1][0], by[2][0]]);
        }
        let correct =
            |net: &TriangleNet| extremal(&MetricForm::of_triangle(&patch(net), 3).unwrap().form, net);
        assert!(correct(&rest).point(1, 1).distance(rest.point(1, 1)) <= 1e-13);
        // Two steps gain nearly all that there is to gain; the rest comes by about a hundredth a step.
        let excess =
            |net: &TriangleNet| area(&patch(net)).unwrap().value - area(&patch(&rest)).unwrap().value;
        let two = correct(&correct(&start));
        assert!(excess(&start) > 5e-4 && excess(&two) > 0.0, "{} {}", excess(&start), excess(&two));
        assert!(excess(&two) <= 0.03 * excess(&start), "{} {}", excess(&start), excess(&two));
        let later = (0..30).fold(two.clone(), |net, _| correct(&net));
        assert!(excess(&later) <= 0.7 * excess(&two), "{} {}", excess(&two), excess(&later));
        assert!(later.point(1, 1).distance(rest.point(1, 1)) < two.point(1, 1).distance(rest.point(1, 1)));
    }
}

#[test]
fn the_gradient_of_the_energy_in_ones_own_metric_is_twice_that_of_the_area() {
    // Why fixed points of the correction are stationary for the area.
    let net = extremal(&dirichlet(3), &ni([true, false, false], 3));
    let form = MetricForm::of_triangle(&patch(&net), 3).unwrap().form;
    let (_, gradient) = triangle_area_with_gradient(&patch(&net)).unwrap();
    for (d, a) in form.gradient(&net.coordinates()).iter().zip(&gradient) {
        assert!((d - 2.0 * a).abs() <= 1e-11, "{d} {a}");
    }
    let points =
        (0..9).map(|k| Point::new((k / 3) as f64, (k % 3) as f64, [0., 1., 0.][k / 3] * (k % 3) as f64));
    let patch = TensorPatch::gt(Net::new(3, 3, points.collect()).unwrap(), [1.0, 2.0, 0.7, 3.0]).unwrap();
    let form = MetricForm::of_tensor(&patch, &patch).unwrap().form;
    let (_, gradient) = area_with_gradient(&patch).unwrap();
    for (d, a) in form.gradient(&patch.net().coordinates()).iter().zip(&gradient) {
        assert!((d - 2.0 * a).abs() <= 1e-9, "{d} {a}");
    }
}

#[test]
fn metrics_that_do_not_fit_are_errors() {
    let flat = patch(&ni([false; 3], 3));
    let square = TensorPatch::bernstein(Net::new(2, 2, vec![Point::ZERO; 4]).unwrap()).unwrap();
    assert_eq!(
        MetricForm::of_triangle(&square, 3).unwrap_err(),
        EnergyError::Domain { expected: Domain::Triangle, found: square.domain() }
    );
    assert!(matches!(MetricForm::of_tensor(&flat, &square), Err(EnergyError::Domain { .. })));
    let error = MetricForm::of_tensor(&square, &square).unwrap_err();
    assert!(matches!(error, EnergyError::Singular { .. }));
    assert!(error.to_string().contains("singular at (u, v) = (0."), "{error}");
    let [a, b] = [Point::ZERO, Point::new(1.0, 1.0, 1.0)];
    let segment = patch(&TriangleNet::from_boundary(&[a, b], &[b, a], &[a, a]).unwrap());
    assert!(matches!(MetricForm::of_triangle(&segment, 3), Err(EnergyError::Singular { .. })));
}
