//! Laws of least areas of high degree, whose inside is sought by displacements of lower degree.

use plateau::{AreaEnd, DisplacementEnd, least_area, least_area_raised};
use surfaces::{Net, Point, TensorPatch};

const TOLERANCE: f64 = 1e-10;

/// The border of z = `height(x, y)` over the square [0, 1]², its control points those of a net of degree n on the surface.
fn border(degree: usize, height: impl Fn(f64, f64) -> f64) -> Net {
    let at = |i: usize, j: usize| {
        let (x, y) = (i as f64 / degree as f64, j as f64 / degree as f64);
        Point::new(x, y, height(x, y))
    };
    let row = |i: usize| (0..=degree).map(|j| at(i, j)).collect::<Vec<_>>();
    let column = |j: usize| (0..=degree).map(|i| at(i, j)).collect::<Vec<_>>();
    Net::from_boundary(&row(0), &row(degree), &column(0), &column(degree)).unwrap()
}

fn saddle(x: f64, y: f64) -> f64 {
    (2.0 * x - 1.0).powi(2) - (2.0 * y - 1.0).powi(2)
}

fn wave(x: f64, y: f64) -> f64 {
    0.15 * libm::sin(5.0 * x) * libm::cos(4.0 * y)
}

/// How far the furthest control point lies from the middle, in units of the square.
fn furthest(patch: &TensorPatch) -> f64 {
    patch.net().points().iter().map(|p| p.distance(Point::new(0.5, 0.5, 0.0))).fold(0.0, f64::max)
}

#[test]
fn raising_to_any_degree_neither_enlarges_the_area_nor_throws_control_points_away() {
    for height in [saddle, wave] {
        let net = border(4, height);
        let mut last = f64::INFINITY;
        for degree in [12, 16, 17, 24, 33, 48, 64] {
            let (patch, found) = least_area_raised(&net, degree - 4, &[], TOLERANCE, &()).unwrap();
            let area = found.area.value;
            assert!(area <= last * (1.0 + 1e-9), "{degree}: {area} after {last}");
            assert_eq!(found.end, AreaEnd::Stationary, "{degree}");
            assert_eq!(found.displacement.is_some(), degree > 16, "{degree}");
            // Control points of degree 16 are thousands of times as far; raising takes means of them.
            let far = if degree < 33 { 1e4 } else { 20.0 };
            assert!(furthest(&patch) < far, "{degree}: {}", furthest(&patch));
            last = area;
        }
    }
}

#[test]
fn the_border_of_a_high_degree_keeps_its_last_bit() {
    let net = border(40, wave);
    let (patch, _) = least_area(&TensorPatch::bernstein(net.clone()).unwrap(), TOLERANCE, &()).unwrap();
    assert_eq!(patch.net().boundary(), net.boundary());
}

#[test]
fn what_a_displacement_has_converged_to_is_the_least_area() {
    // A border of degree 2 described by more points than it needs: the same curve, and the same least area.
    let low = border(2, saddle);
    let (_, expected) = least_area_raised(&low, 12, &[], TOLERANCE, &()).unwrap();
    for degree in [24, 40, 64] {
        let raised = TensorPatch::bernstein(low.raised(degree - 2)).unwrap();
        let (_, found) = least_area(&raised, TOLERANCE, &()).unwrap();
        assert_eq!(found.displacement.map(|d| d.end), Some(DisplacementEnd::Tolerance), "{degree}");
        let apart = found.area.value / expected.area.value - 1.0;
        assert!(apart.abs() < 1e-9, "{degree}: {apart:e}");
    }
}

#[test]
fn a_displacement_that_has_not_converged_says_what_the_last_degrees_gained() {
    let net = border(40, |x, y| 0.4 * libm::sin(14.0 * x) * libm::cos(14.0 * y));
    let (_, found) = least_area(&TensorPatch::bernstein(net).unwrap(), 1e-10, &()).unwrap();
    let displacement = found.displacement.unwrap();
    match displacement.end {
        DisplacementEnd::Largest { gained } | DisplacementEnd::Rounding { gained } => assert!(gained > 1e-10),
        end => panic!("{end:?}"),
    }
    assert!(found.reason().contains("of the area"), "{}", found.reason());
}

#[test]
fn narrow_nets_of_high_degree_are_sought_too() {
    let net = border(20, saddle);
    let [_, _, v0, v1] = net.boundary();
    let straight = |a: Point, b: Point| [a, b];
    let ends = (straight(v0[0], v1[0]), straight(v0[20], v1[20]));
    let ruled = Net::from_boundary(&ends.0, &ends.1, &v0, &v1).unwrap();
    let (patch, found) = least_area(&TensorPatch::bernstein(ruled.clone()).unwrap(), TOLERANCE, &()).unwrap();
    assert!(found.area.value > 0.0);
    assert_eq!(patch.net().points(), ruled.points(), "nothing is free");
}
