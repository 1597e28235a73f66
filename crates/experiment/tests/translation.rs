//! A frame moved far from the origin has the same surface and the same figures, whatever finds it.

#![allow(clippy::print_stdout)] // the figures are worth reading

mod subjects;

use plateau::Surface;
use subjects::{
    FILM_METHODS, Map, ROWS_METHODS, TENSOR, TENSOR_AREAS, TENSOR_METHODS, TRIANGLE, TRIANGLE_METHODS,
    figures, polygon, results, rings, sides, stay, wings,
};
use surfaces::Point;

/// What moves every point.
fn mover(by: [f64; 3]) -> impl Fn([f64; 3]) -> [f64; 3] {
    move |p| [p[0] + by[0], p[1] + by[1], p[2] + by[2]]
}

fn moved(points: &[(&str, &[[f64; 3]])], by: [f64; 3]) -> String {
    sides(points, &mover(by))
}

fn compare(sides: &[(&str, &[[f64; 3]])], methods: &[&str], by: [f64; 3], tolerance: f64) {
    compare_boundaries(|map| self::sides(sides, map), methods, by, tolerance);
}

fn compare_boundaries(boundary: impl Fn(Map<'_>) -> String, methods: &[&str], by: [f64; 3], tolerance: f64) {
    let (near, far) = (results(&boundary(&stay), methods), results(&boundary(&mover(by)), methods));
    for ((near, far), method) in near.results.methods().iter().zip(far.results.methods()).zip(methods) {
        let (Ok(near), Ok(far)) = (&near.outcome, &far.outcome) else {
            panic!("{method} moved by {by:?}: {:?}", far.outcome.as_ref().err())
        };
        let mut worst = (0.0f64, "");
        for ((name, _, a), (_, _, b)) in figures(near).into_iter().zip(figures(far)) {
            let change = (a - b).abs() / a.abs().max(1e-3);
            assert!(change <= tolerance, "{method}, moved by {by:?}: {name} {a} becomes {b}");
            worst = if change > worst.0 { (change, name) } else { worst };
        }
        println!("{}: {:.0e} ({})", method.replace('\n', ", "), worst.0, worst.1);
        assert_eq!(near.warnings.len(), far.warnings.len(), "{method}: {:?}", far.warnings);
        let by = Point::from(by);
        // Surfaces: control points of degree 23 are determined to fewer digits.
        let largest = by.norm() * f64::EPSILON + 10.0 * tolerance;
        for (p, q) in near.mesh.points.iter().zip(&far.mesh.points) {
            assert!((*p + by).distance(*q) <= largest, "{method}: {p:?} {q:?}");
        }
    }
}

#[test]
fn nothing_depends_on_the_distance_from_the_origin() {
    // Moved exactly: the same numbers relative to the anchor, and then the same figures.
    let far = [131_072.0, -16_777_216.0, 16_777_216.0 + 4096.0];
    compare(&TENSOR, TENSOR_METHODS, far, 1e-13);
    compare(&TENSOR, TENSOR_AREAS, far, 1e-13);
    compare(&TRIANGLE, TRIANGLE_METHODS, far, 1e-13);
    compare(&TENSOR[..2], ROWS_METHODS, far, 1e-13);
    // Map coordinates, to which the frame itself is rounded: 2^-31 of a length of 5, 2^-33 of second derivatives.
    let map = [388_096.37, -3_948_996.1, 77.7];
    compare(&TENSOR, TENSOR_METHODS, map, 1e-7);
    compare(&TRIANGLE, TRIANGLE_METHODS, map, 1e-7);
}

#[test]
fn films_do_not_depend_on_the_distance_from_the_origin() {
    let far = [131_072.0, -16_777_216.0, 16_777_216.0 + 4096.0];
    compare_boundaries(polygon, FILM_METHODS, far, 1e-13);
    compare_boundaries(rings, &FILM_METHODS[..2], far, 1e-13);
    compare_boundaries(wings, &FILM_METHODS[..2], far, 1e-13);
    // Points of the frame are rounded to 2^-31 at map coordinates.
    compare_boundaries(polygon, &FILM_METHODS[..1], [388_096.37, -3_948_996.1, 77.7], 1e-7);
}

#[test]
fn a_film_far_away_is_not_said_to_fold() {
    let finished = |by| results(&polygon(&mover(by)), &["energy = \"area\""]);
    let area = |finished: &experiment::Finished| {
        let done = finished.results.methods()[0].outcome.as_ref().unwrap();
        assert!(done.warnings.is_empty(), "{:?}", done.warnings);
        done.figures.area.value
    };
    let near = area(&finished([0.0; 3]));
    for by in [[1e6, 1e6, 0.0], [134_217_728.0, -268_435_456.0, 0.0]] {
        let far = area(&finished(by));
        assert!((far / near - 1.0).abs() < 1e-7, "at {by:?}: {far}, not {near}");
    }
}

#[test]
fn whole_steps_of_the_anchor_change_no_bit() {
    let up = |sides: &[(&'static str, &'static [[f64; 3]])]| {
        // Moved so that no coordinate is negative, and then by 2^30: the same numbers relative to the anchor.
        let raised = moved(sides, [64.0, 64.0, 64.0]);
        let far = moved(sides, [64.0 + 1_073_741_824.0; 3]);
        (raised, far)
    };
    for (sides, methods) in [(up(&TENSOR), TENSOR_METHODS), (up(&TRIANGLE), TRIANGLE_METHODS)] {
        let (near, far) = (results(&sides.0, methods), results(&sides.1, methods));
        for ((a, b), method) in near.results.methods().iter().zip(far.results.methods()).zip(methods) {
            let done = |result: &plateau::MethodResult| figures(result.outcome.as_ref().expect(method));
            assert_eq!(done(a), done(b), "{method}");
        }
    }
}

#[test]
fn the_boundary_is_kept_bit_for_bit() {
    let by = [388_096.25, 3_948_996.1, -1e9 / 3.0];
    let finished = results(&moved(&TENSOR, by), &["energy = \"dirichlet\""]);
    let done = finished.results.methods()[0].outcome.as_ref().unwrap();
    let Surface::Tensor(patch) = done.solved.surface() else { panic!("a tensor patch") };
    for (side, (_, given)) in patch.net().boundary().iter().zip(TENSOR) {
        for (p, g) in side.iter().zip(given) {
            assert_eq!(<[f64; 3]>::from(*p), [g[0] + by[0], g[1] + by[1], g[2] + by[2]]);
        }
    }
}

#[test]
fn a_search_far_away_finds_the_minimum() {
    let method = ["basis = \"gt\"\nsearch = true\nenergy = \"dirichlet\""];
    for distance in [0.0, 131_072.0, 16_777_216.0, 1e12] {
        let finished = results(&moved(&TENSOR, [distance; 3]), &method);
        let done = finished.results.methods()[0].outcome.as_ref().unwrap();
        let found = done.figures.dirichlet.value;
        println!("at {distance:e}: {found:.10}");
        assert!((found - 38.484_965_097_6).abs() < 1e-9, "at {distance:e}: {found}");
    }
}
