//! Laws of nets of least area, and the numbers they are known by.

use energy::{DenseForm, Functional, MetricForm, QuadraticForm, area};
use proptest::prelude::*;
use solve::{Partition, solve_partitioned};
use surfaces::{Mesh, Net, Patch, Point, TensorPatch, TriangleNet, TrianglePatch, tb_coons};

use super::{AreaEnd, AreaExtremal, least_area, least_area_triangle};

/// The tolerance of experiments that do not give one.
const DEFAULT: f64 = 1e-10;

/// GT Example 5.1 (P30 = (0, 6, 0)) for `s = 1`, Example 5.2 for `s = −1`.
fn bicubic(s: f64) -> Net {
    let points = |p: [[f64; 3]; 4]| p.map(Point::from);
    let row = |y: f64| points([[0.0, y, 0.0], [2.0, y, 2.0], [4.0, y, -2.0 * s], [6.0, y, 0.0]]);
    let col = |x: f64| points([[x, 0.0, 0.0], [x, 2.0, 2.0], [x, 4.0, -2.0 * s], [x, 6.0, 0.0]]);
    Net::from_boundary(&row(0.0), &row(6.0), &col(0.0), &col(6.0)).unwrap()
}

/// The border of z = x² − y² over [−1, 1]².
fn saddle() -> Net {
    let (square, line) = ([1.0, -1.0, 1.0], [-1.0, 0.0, 1.0]);
    let point = |i: usize, j: usize| Point::new(line[i], line[j], square[i] - square[j]);
    let row = |i: usize| [0, 1, 2].map(|j| point(i, j));
    let col = |j: usize| [0, 1, 2].map(|i| point(i, j));
    Net::from_boundary(&row(0), &row(2), &col(0), &col(2)).unwrap()
}

/// Enneper's surface (p − p³/3 + pv², v − v³/3 + vp², p² − v²) at p = u + 1, over the triangle, its middle point free.
fn enneper() -> TriangleNet {
    // The points of a cubic are its blossom at the corners.
    let blossom = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let [[p, v], [q, w], [r, z]] = [a, b, c];
        let mixed =
            |s: [f64; 3], t: [f64; 3]| (s[0] * t[1] * t[2] + s[1] * t[0] * t[2] + s[2] * t[0] * t[1]) / 3.0;
        let (ps, vs) = ([p, q, r], [v, w, z]);
        let mean = |s: [f64; 3]| (s[0] + s[1] + s[2]) / 3.0;
        let pairs = |s: [f64; 3]| (s[0] * s[1] + s[0] * s[2] + s[1] * s[2]) / 3.0;
        Point::new(
            mean(ps) - p * q * r / 3.0 + mixed(ps, vs),
            mean(vs) - v * w * z / 3.0 + mixed(vs, ps),
            pairs(ps) - pairs(vs),
        )
    };
    let (a, b, c) = ([2.0, 0.0], [1.0, 1.0], [1.0, 0.0]);
    let side = |s, t| [blossom(s, s, s), blossom(s, s, t), blossom(s, t, t), blossom(t, t, t)];
    TriangleNet::from_boundary(&side(a, b), &side(b, c), &side(c, a)).unwrap()
}

fn of(net: Net) -> (TensorPatch, AreaExtremal) {
    least_area(&TensorPatch::bernstein(net).unwrap(), 1e-11, &()).unwrap()
}

#[test]
fn bicubic_nets_and_their_raised_ones() {
    for (s, raise, expected, tolerance) in [
        (1.0, 0, 38.134_914_593_24, 1e-9),
        (-1.0, 0, 37.780_134_997_19, 1e-9),
        (1.0, 5, 37.999_849_612, 1e-8),
        (-1.0, 5, 37.716_954_674, 1e-8),
    ] {
        let (patch, found) = of(bicubic(s).raised(raise));
        assert!((found.area.value - expected).abs() <= tolerance, "{found:?}");
        assert!(found.area.settled && found.gradient <= 2e-8, "{found:?}");
        let (_, quick) =
            least_area(&TensorPatch::bernstein(bicubic(s).raised(raise)).unwrap(), DEFAULT, &()).unwrap();
        // Of the raised nets the control points would lie far away: they are pulled near, which is half of these steps.
        assert!(quick.iterations <= if raise == 0 { 15 } else { 80 }, "{quick:?}");
        assert!(quick.area.value / found.area.value - 1.0 <= 1e-7, "{quick:?}");
        assert!(found.second_variation.is_some_and(|sigma| (0.8..1.0).contains(&sigma)), "{found:?}");
        assert!((area(&patch).unwrap().value - found.area.value).abs() <= 1e-9);
    }
}

#[test]
fn the_saddle_frame_converges_with_the_degree() {
    let minimum = 7.383_505_602_602;
    for (degree, tolerance) in [(3, 1e-4), (5, 1e-6), (8, 1e-8)] {
        let (_, found) = of(saddle().raised(degree - 2));
        let relative = found.area.value / minimum - 1.0;
        assert!((-1e-10..tolerance).contains(&relative), "{degree}: {relative:e} {found:?}");
        // Stable: σ is far from 0, and below 1 on a surface that is not flat.
        assert!(found.second_variation.is_some_and(|sigma| (0.3..0.5).contains(&sigma)), "{found:?}");
    }
}

#[test]
fn enneper_is_found_exactly() {
    let (patch, found) = least_area_triangle(&TrianglePatch::new(enneper()).unwrap(), 1e-11, &()).unwrap();
    let middle = patch.net().point(1, 1);
    assert!(middle.distance(Point::new(2.0 / 3.0, 1.0, 5.0 / 3.0)) <= 1e-12, "{middle:?}");
    assert!(
        (found.area.value - 421.0 / 90.0).abs() <= 1e-12 && found.end == AreaEnd::Stationary,
        "{found:?}"
    );
}

#[test]
fn metric_corrections_tend_to_it() {
    let (_, found) = of(bicubic(1.0));
    let net = bicubic(1.0);
    let dirichlet =
        QuadraticForm::of(Functional::Dirichlet, &TensorPatch::bernstein(net.clone()).unwrap()).unwrap();
    let extremal = |form: &[f64], n: usize| {
        let x = solve_partitioned(n, form, &Partition::new(net.fixed()), 3, &net.coordinates()).unwrap().x;
        TensorPatch::bernstein(net.with_coordinates(&x).unwrap()).unwrap()
    };
    let matrix = dirichlet.matrix();
    let mut patch = extremal(matrix.as_slice(), matrix.rows());
    let mut last = area(&patch).unwrap().value;
    for _ in 0..150 {
        let metric = MetricForm::of_tensor(&patch, &patch).unwrap();
        patch = extremal(metric.form.matrix().as_slice(), matrix.rows());
        let next = area(&patch).unwrap().value;
        assert!(next <= last * (1.0 + 1e-12) && next >= found.area.value - 1e-9, "{next} {last}");
        last = next;
    }
    assert!((last - found.area.value).abs() <= 1e-5, "{last} {found:?}");
}

#[test]
fn plane_borders_have_flat_extremals() {
    let flat = |s: f64, t: f64| Point::new(s + 0.2 * s * t, t, 2.0 * (s + 0.2 * s * t) - t);
    let row = |s: f64| [0.0, 0.3, 1.0].map(|t| flat(s, t));
    let col = |t: f64| [0.0, 0.6, 1.0].map(|s| flat(s, t));
    let (_, found) = of(Net::from_boundary(&row(0.0), &row(1.0), &col(0.0), &col(1.0)).unwrap());
    assert_eq!(found.end, AreaEnd::Stationary);
    assert!((found.area.value - found.start).abs() <= 1e-9, "{found:?}");
    assert!(found.second_variation.is_some_and(|sigma| (sigma - 1.0).abs() <= 1e-9), "{found:?}");
}

#[test]
fn borders_without_freedom_or_without_area_are_told() {
    let corners = |z: f64| {
        let p = |i: usize, j: usize| Point::new(i as f64, j as f64 * z, 0.0);
        Net::from_boundary(&[p(0, 0), p(0, 1)], &[p(1, 0), p(1, 1)], &[p(0, 0), p(1, 0)], &[p(0, 1), p(1, 1)])
            .unwrap()
    };
    let (_, found) = of(corners(1.0));
    assert!((found.area.value - 1.0).abs() <= 1e-14 && found.second_variation.is_none(), "{found:?}");
    let error = least_area(&TensorPatch::bernstein(corners(0.0).raised(2)).unwrap(), 1e-11, &()).unwrap_err();
    assert!(error.to_string().contains("singular at (u, v) = ("), "{error}");
}

#[test]
fn a_triangle_folded_along_a_line_is_singular_there() {
    let ab = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 2.0, 1.0], [3.0, 0.0, 0.0]].map(Point::from);
    let bc = [ab[3], ab[2], ab[1], ab[0]];
    let net = TriangleNet::from_boundary(&ab, &bc, &[Point::ZERO; 4]).unwrap();
    let error = least_area_triangle(&TrianglePatch::new(net).unwrap(), DEFAULT, &()).unwrap_err();
    assert!(error.to_string().contains("singular at (u, v) = ("), "{error}");
}

fn check(found: &AreaExtremal, patch: &dyn Patch, dirichlet: f64) -> Result<(), TestCaseError> {
    let tolerance = 1e-9 * found.area.value;
    prop_assert!(found.area.value <= found.start + tolerance, "{found:?}");
    prop_assert!(found.area.value <= dirichlet + tolerance, "{dirichlet} {found:?}");
    let exact = area(patch).unwrap();
    prop_assert!(
        (exact.value - found.area.value).abs() <= tolerance + 2.0 * (exact.error + found.area.error),
        "{found:?}"
    );
    prop_assert_eq!(found.end, AreaEnd::Stationary, "{:?}", found);
    // A net that folds nearly to a point is not settled by the largest rule, and says so; all others are stationary.
    if found.area.settled {
        prop_assert!(found.gradient <= 1e-11, "{found:?}");
    }
    prop_assert!(found.second_variation.is_some_and(f64::is_finite), "{found:?}");
    // Without positive curvature the form is at most that of a plane.
    if Mesh::of(patch, 24).gauss_curvature.iter().all(|k| k.is_some_and(|k| k <= 0.0)) {
        prop_assert!(found.second_variation.is_some_and(|sigma| sigma <= 1.0 + 1e-9), "{found:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn areas_are_at_most_those_of_dirichlet_extremals(
        bumps in prop::collection::vec([-0.1..0.1f64, -0.1..0.1, -0.3..0.3], 20), kind in 0..3, shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5],
    ) {
        let point = |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[5 * i + j]);
        let row = |i: usize| (0..5).map(|j| point(i, j)).collect::<Vec<_>>();
        let col = |j: usize| (0..4).map(|i| point(i, j)).collect::<Vec<_>>();
        let net = Net::from_boundary(&row(0), &row(3), &col(0), &col(4)).unwrap();
        let patch = match kind {
            0 => TensorPatch::bernstein(net.clone()).unwrap(),
            1 => TensorPatch::gt(net.clone(), shape).unwrap(),
            _ => tb_coons(net.clone(), shape).unwrap(),
        };
        let form = QuadraticForm::of(Functional::Dirichlet, &patch).unwrap();
        let matrix = form.matrix();
        let solved = solve_partitioned(20, matrix.as_slice(), &Partition::new(net.fixed()), 3, &net.coordinates()).unwrap();
        let (extremal, found) = least_area(&patch, DEFAULT, &()).unwrap();
        check(&found, &extremal, form.value(&solved.x))?;
        prop_assert_eq!(extremal.net().boundary(), net.boundary());
        // From its own extremal it goes nowhere.
        let (_, again) = least_area(&extremal, DEFAULT, &()).unwrap();
        prop_assert!((again.area.value - found.area.value).abs() <= 1e-9 * found.area.value);
    }

    #[test]
    fn triangular_areas_are_at_most_those_of_dirichlet_extremals(
        n in 3usize..=5, bumps in prop::collection::vec([-0.1..0.1f64, -0.1..0.1, -0.3..0.3], 21),
    ) {
        let point = |i: usize, j: usize| {
            let at = TriangleNet::new(n, vec![Point::ZERO; (n + 1) * (n + 2) / 2]).unwrap().position(i, j);
            Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[at])
        };
        let ab: Vec<Point> = (0..=n).map(|k| point(n - k, k)).collect();
        let bc: Vec<Point> = (0..=n).map(|k| point(0, n - k)).collect();
        let ca: Vec<Point> = (0..=n).map(|k| point(k, 0)).collect();
        let net = TriangleNet::from_boundary(&ab, &bc, &ca).unwrap();
        let form = DenseForm::of_triangle(Functional::Dirichlet, n).unwrap();
        let count = net.points().len();
        let solved =
            solve_partitioned(count, form.matrix().as_slice(), &Partition::new(net.fixed()), 3, &net.coordinates()).unwrap();
        let (extremal, found) = least_area_triangle(&TrianglePatch::new(net).unwrap(), DEFAULT, &()).unwrap();
        check(&found, &extremal, form.value(&solved.x))?;
    }
}
