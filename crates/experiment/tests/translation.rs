//! A frame moved far from the origin has the same surface and the same figures, whatever finds it.

#![allow(clippy::print_stdout)] // the figures are worth reading

use experiment::{Finished, Options, Plan, run};
use plateau::{Done, Surface};
use surfaces::Point;

/// Four cubic sides in halves: moving them by whole numbers up to 2^50 rounds nothing.
const TENSOR: [(&str, &[[f64; 3]]); 4] = [
    ("u0", &[[0.0, 0.0, 0.0], [2.0, 0.0, 3.0], [4.0, 0.0, -1.0], [5.0, 0.0, 0.0]]),
    ("u1", &[[0.0, 7.0, 0.0], [2.0, 7.0, 1.0], [4.0, 6.5, -2.0], [5.0, 7.0, 1.0]]),
    ("v0", &[[0.0, 0.0, 0.0], [0.0, 2.0, 2.0], [0.0, 5.0, -2.0], [0.0, 7.0, 0.0]]),
    ("v1", &[[5.0, 0.0, 0.0], [5.5, 2.0, 2.0], [5.0, 4.0, -2.0], [5.0, 7.0, 1.0]]),
];

const TENSOR_METHODS: &[&str] = &[
    "energy = \"dirichlet\"",
    "energy = \"dirichlet\"\nraise = 5",
    "energy = \"dirichlet\"\nraise = 20",
    "energy = \"laplacian\"\nraise = 8",
    "energy = \"bending\"",
    "energy = \"coons\"",
    "energy = \"area\"\nraise = 2",
    "energy = \"dirichlet\"\nmetric-steps = 2",
    "mask = -0.2",
    "construction = \"discrete-coons\"",
    "basis = \"gt\"\nshape = [1, 2, 0.5, 3]\nenergy = \"bending\"",
    "basis = \"gt\"\nsearch = true\nenergy = \"dirichlet\"",
    "basis = \"gt\"\nsearch = \"polish\"\nenergy = \"dirichlet\"\nraise = 5",
    "basis = \"gt\"\nsearch = \"polish\"\nenergy = \"bending\"",
    "patch = \"tb-coons\"\nsearch = \"polish\"\nenergy = \"dirichlet\"",
    "patch = \"tb-coons\"\nshape = [1, 2, 0.5, 3]\nenergy = \"laplacian\"",
];

/// Two sides of a harmonic net; the others are found.
const ROWS_METHODS: &[&str] = &[
    "construction = \"harmonic\"",
    "construction = \"harmonic\"\nbasis = \"gt\"\nsearch = \"polish\"\nsearch-energy = \"laplacian\"",
];

/// Methods whose points slide within the surface: what the rounding of a frame does to their other figures is not bounded.
const TENSOR_AREAS: &[&str] = &[
    "energy = \"area\"\nraise = 4",
    "energy = \"area\"\nraise = 3\ntolerance = 1e-7",
    "basis = \"gt\"\nshape = [1, 2, 0.5, 3]\nenergy = \"area\"",
    "patch = \"tb-coons\"\nshape = [1, 2, 0.5, 3]\nenergy = \"area\"",
];

const TRIANGLE: [(&str, &[[f64; 3]]); 3] = [
    ("ab", &[[0.0, 0.0, 0.0], [2.0, -1.0, 3.0], [4.0, 0.5, -1.0], [6.0, 0.0, 0.0]]),
    ("bc", &[[6.0, 0.0, 0.0], [5.0, 2.0, 2.0], [3.5, 4.0, 2.0], [2.0, 6.0, 1.0]]),
    ("ca", &[[2.0, 6.0, 1.0], [1.0, 4.0, -2.0], [0.5, 2.0, 0.0], [0.0, 0.0, 0.0]]),
];

const TRIANGLE_METHODS: &[&str] = &[
    "energy = \"dirichlet\"",
    "energy = \"laplacian\"\nraise = 4",
    "energy = \"bending\"\nraise = 4",
    "energy = \"coons\"",
    "energy = \"dirichlet\"\ndomain = \"equilateral\"",
    "energy = \"bending\"\ndomain = \"equilateral\"\nraise = 3",
    "energy = \"area\"\nraise = 2",
    "energy = \"dirichlet\"\nmetric-steps = 2",
    "mask = 0.1",
    "mask = \"dirichlet\"",
    "construction = \"discrete-coons\"",
];

fn moved(sides: &[(&str, &[[f64; 3]])], by: [f64; 3]) -> String {
    let point = |p: &[f64; 3]| format!("[{}, {}, {}]", p[0] + by[0], p[1] + by[1], p[2] + by[2]);
    let side = |(name, points): &(&str, &[[f64; 3]])| {
        format!("{name} = [{}]\n", points.iter().map(point).collect::<Vec<_>>().join(", "))
    };
    sides.iter().map(side).collect()
}

/// Five skew edges, as a loop of sides.
const LOOP: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [6.0, 3.0, -1.0], [2.5, 6.0, 2.0], [-1.0, 3.0, 0.5]];

/// The loop as a polygon, moved.
fn polygon(by: [f64; 3]) -> String {
    let points: Vec<[f64; 3]> = LOOP.iter().map(|p| [p[0] + by[0], p[1] + by[1], p[2] + by[2]]).collect();
    format!("polygon = {points:?}\n")
}

fn results(boundary: &str, methods: &[&str]) -> Finished {
    let mut text = format!("title = \"moved\"\nseed = 3\n[boundary]\n{boundary}");
    for (k, method) in methods.iter().enumerate() {
        text += &format!("[[method]]\nname = \"{k}\"\n{method}\n");
    }
    if text.contains("search") {
        text += "[search]\nparticles = 20\niterations = 20\nruns = 3\n";
    }
    text += "[output]\nmesh = 6\npictures = false\n";
    let plan = Plan::parse("moved.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
    run(&plan, Options::default(), &()).unwrap()
}

/// Every figure of a method by its name.
fn figures(done: &Done) -> Vec<(&'static str, f64)> {
    let (f, none) = (&done.figures, f64::NAN);
    let mut all = vec![
        ("D", f.dirichlet.value),
        ("A", f.area.value),
        ("Laplacian defect", f.laplacian_defect.value),
        ("bending", f.bending.value),
        ("largest |H|", f.mean_curvature_max.unwrap_or(none)),
        ("rms of H", f.mean_curvature_rms.unwrap_or(none)),
    ];
    if let Some(boundary) = &done.boundary {
        all.extend([("moved by", boundary.deviation), ("bound of D", boundary.harmonic_bound)]);
    }
    if let Some(search) = &done.solved.search {
        all.push(("minimum", search.minimum));
    }
    all
}

fn compare(sides: &[(&str, &[[f64; 3]])], methods: &[&str], by: [f64; 3], tolerance: f64) {
    // Two sides leave the degree across them open.
    let sides = |by| moved(sides, by) + if sides.len() == 2 { "u-degree = 3\n" } else { "" };
    compare_boundaries(sides, methods, by, tolerance);
}

fn compare_boundaries(boundary: impl Fn([f64; 3]) -> String, methods: &[&str], by: [f64; 3], tolerance: f64) {
    let (near, far) = (results(&boundary([0.0; 3]), methods), results(&boundary(by), methods));
    for ((near, far), method) in near.results.methods.iter().zip(&far.results.methods).zip(methods) {
        let (Ok(near), Ok(far)) = (&near.outcome, &far.outcome) else {
            panic!("{method} moved by {by:?}: {:?}", far.outcome.as_ref().err())
        };
        let mut worst = (0.0f64, "");
        for ((name, a), (_, b)) in figures(near).into_iter().zip(figures(far)) {
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
fn films_depend_on_the_distance_from_the_origin_by_rounding_alone() {
    // Loops are cut where they lie: points of the cut, and with them the film, are rounded to 2^-35 there, in a size of 7; second
    // differences of degree 6 weigh that thirty times.
    let far = [131_072.0, -262_144.0, 4096.0];
    compare_boundaries(polygon, &["energy = \"dirichlet\""], far, 1e-7);
    compare_boundaries(polygon, &["energy = \"dirichlet\""], [388_096.37, -3_948_996.1, 77.7], 1e-7);
}

#[test]
fn a_film_far_away_is_not_said_to_fold() {
    let finished = |by| results(&polygon(by), &["energy = \"area\""]);
    let area = |finished: &Finished| {
        let done = finished.results.methods[0].outcome.as_ref().unwrap();
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
        for ((a, b), method) in near.results.methods.iter().zip(&far.results.methods).zip(methods) {
            let done = |result: &plateau::MethodResult| figures(result.outcome.as_ref().expect(method));
            assert_eq!(done(a), done(b), "{method}");
        }
    }
}

#[test]
fn the_boundary_is_kept_bit_for_bit() {
    let by = [388_096.25, 3_948_996.1, -1e9 / 3.0];
    let finished = results(&moved(&TENSOR, by), &["energy = \"dirichlet\""]);
    let done = finished.results.methods[0].outcome.as_ref().unwrap();
    let Surface::Tensor(patch) = &done.solved.surface else { panic!("a tensor patch") };
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
        let done = finished.results.methods[0].outcome.as_ref().unwrap();
        let found = done.figures.dirichlet.value;
        println!("at {distance:e}: {found:.10}");
        assert!((found - 38.484_965_097_6).abs() < 1e-9, "at {distance:e}: {found}");
    }
}
