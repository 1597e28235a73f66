//! Every way to fill a boundary, each over a boundary on which it is at work: what the laws are tried on.

#![allow(dead_code)] // no file of tests needs all of it

use experiment::{Finished, Options, Plan, run};
use plateau::Done;

/// What is done to every point of a boundary.
pub(crate) type Map<'a> = &'a dyn Fn([f64; 3]) -> [f64; 3];

/// Every point where it is.
pub(crate) fn stay(p: [f64; 3]) -> [f64; 3] {
    p
}

/// Four cubic sides in halves: moving them by whole numbers up to 2^50 rounds nothing.
pub(crate) const TENSOR: [(&str, &[[f64; 3]]); 4] = [
    ("u0", &[[0.0, 0.0, 0.0], [2.0, 0.0, 3.0], [4.0, 0.0, -1.0], [5.0, 0.0, 0.0]]),
    ("u1", &[[0.0, 7.0, 0.0], [2.0, 7.0, 1.0], [4.0, 6.5, -2.0], [5.0, 7.0, 1.0]]),
    ("v0", &[[0.0, 0.0, 0.0], [0.0, 2.0, 2.0], [0.0, 5.0, -2.0], [0.0, 7.0, 0.0]]),
    ("v1", &[[5.0, 0.0, 0.0], [5.5, 2.0, 2.0], [5.0, 4.0, -2.0], [5.0, 7.0, 1.0]]),
];

pub(crate) const TENSOR_METHODS: &[&str] = &[
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

/// Methods whose points slide within the surface: what the rounding of a frame does to their other figures is not bounded.
pub(crate) const TENSOR_AREAS: &[&str] = &[
    "energy = \"area\"\nraise = 4",
    "energy = \"area\"\nraise = 3\ntolerance = 1e-7",
    "basis = \"gt\"\nshape = [1, 2, 0.5, 3]\nenergy = \"area\"",
    "patch = \"tb-coons\"\nshape = [1, 2, 0.5, 3]\nenergy = \"area\"",
];

/// Two sides of a harmonic net; the others are found.
pub(crate) const ROWS_METHODS: &[&str] = &[
    "construction = \"harmonic\"",
    "construction = \"harmonic\"\nbasis = \"gt\"\nsearch = \"polish\"\nsearch-energy = \"laplacian\"",
];

pub(crate) const TRIANGLE: [(&str, &[[f64; 3]]); 3] = [
    ("ab", &[[0.0, 0.0, 0.0], [2.0, -1.0, 3.0], [4.0, 0.5, -1.0], [6.0, 0.0, 0.0]]),
    ("bc", &[[6.0, 0.0, 0.0], [5.0, 2.0, 2.0], [3.5, 4.0, 2.0], [2.0, 6.0, 1.0]]),
    ("ca", &[[2.0, 6.0, 1.0], [1.0, 4.0, -2.0], [0.5, 2.0, 0.0], [0.0, 0.0, 0.0]]),
];

pub(crate) const TRIANGLE_METHODS: &[&str] = &[
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

pub(crate) const FILM_METHODS: &[&str] =
    &["energy = \"dirichlet\"", "energy = \"area\"", "energy = \"area\"\nlayers = 1\ndegree = 4"];

/// Sides with what is done to their points.
pub(crate) fn sides(sides: &[(&str, &[[f64; 3]])], map: Map<'_>) -> String {
    let side = |(name, points): &(&str, &[[f64; 3]])| format!("{name} = {:?}\n", mapped(points, map));
    // Two sides leave the degree across them open.
    sides.iter().map(side).collect::<String>() + if sides.len() == 2 { "u-degree = 3\n" } else { "" }
}

fn mapped(points: &[[f64; 3]], map: Map<'_>) -> Vec<[f64; 3]> {
    points.iter().map(|&p| map(p)).collect()
}

/// Five skew edges, as a loop of sides.
pub(crate) const LOOP: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [6.0, 3.0, -1.0], [2.5, 6.0, 2.0], [-1.0, 3.0, 0.5]];

/// The loop as a polygon.
pub(crate) fn polygon(map: Map<'_>) -> String {
    format!("polygon = {:?}\n", mapped(&LOOP, map))
}

/// Two rings: each a curve through a centre, in a plane, of a radius.
pub(crate) fn rings(map: Map<'_>) -> String {
    let length = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    let ring = |name: &str, radius: f64, z: f64| {
        let [center, top] = [map([0.0, 0.0, z]), map([0.0, 0.0, z + 1.0])];
        let normal = [0, 1, 2].map(|k| top[k] - center[k]);
        let radius = radius * length(center, top);
        format!(
            "[[curve]]\nname = \"{name}\"\ncircle = {{ center = {center:?}, normal = {normal:?}, radius = {radius:?} }}\n"
        )
    };
    "loops = [[\"a\"], [\"b\"]]\n".to_owned() + &ring("a", 1.0, 0.0) + &ring("b", 1.25, 0.5)
}

/// Three wings that meet in a free edge, between curved sides.
pub(crate) fn wings(map: Map<'_>) -> String {
    let corners = [
        ('a', [0.0, 0.0, 0.0]),
        ('b', [4.0, 0.0, 0.0]),
        ('c', [5.0, 3.0, 1.0]),
        ('d', [-1.0, 3.0, 1.0]),
        ('e', [4.0, -2.0, 2.0]),
        ('f', [0.0, -3.0, 1.5]),
        ('g', [0.5, 0.0, -3.0]),
        ('h', [4.5, 0.5, -2.5]),
    ];
    let place = |name: char| corners.iter().find(|(n, _)| *n == name).map(|(_, p)| *p).unwrap();
    let mut text = String::new();
    for (k, ends) in ["bc", "cd", "da", "be", "ef", "fa", "ag", "gh", "hb"].iter().enumerate() {
        let names: Vec<char> = ends.chars().collect();
        let (from, to) = (place(names[0]), place(names[1]));
        let middle = [0, 1, 2].map(|i| 0.5 * (from[i] + to[i]) + if i == 2 { 0.25 } else { 0.0 });
        text += &format!(
            "[[curve]]\nname = \"c{k}\"\nends = [\"{}\", \"{}\"]\npoints = {:?}\n",
            names[0],
            names[1],
            mapped(&[from, middle, to], map)
        );
    }
    for face in ["abcd", "abef", "abhg"] {
        let names: Vec<String> = face.chars().map(|c| format!("\"{c}\"")).collect();
        text += &format!("[[face]]\nvertices = [{}]\n", names.join(", "));
    }
    text
}

/// What the methods find over a boundary.
pub(crate) fn results(boundary: &str, methods: &[&str]) -> Finished {
    let mut text = format!("title = \"laws\"\nseed = 3\n[boundary]\n{boundary}");
    for (k, method) in methods.iter().enumerate() {
        text += &format!("[[method]]\nname = \"{k}\"\n{method}\n");
    }
    if text.contains("search") {
        text += "[search]\nparticles = 20\niterations = 20\nruns = 3\n";
    }
    text += "[output]\nmesh = 6\npictures = false\n";
    let plan = Plan::parse("laws.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
    run(&plan, Options::default(), &()).unwrap()
}

/// Every figure of a method: its name, the power of length in it, its value.
pub(crate) fn figures(done: &Done) -> Vec<(&'static str, i32, f64)> {
    let (f, none) = (&done.figures, f64::NAN);
    let mut all = vec![
        ("D", 2, f.dirichlet.value),
        ("A", 2, f.area.value),
        ("Laplacian defect", 2, f.laplacian_defect.value),
        ("bending", 2, f.bending.value),
        ("largest |H|", -1, f.mean_curvature_max.unwrap_or(none)),
        ("rms of H", -1, f.mean_curvature_rms.unwrap_or(none)),
    ];
    if let Some(boundary) = &done.boundary {
        all.extend([("moved by", 1, boundary.deviation), ("bound of D", 2, boundary.harmonic_bound)]);
    }
    if let Some(search) = done.solved.search() {
        all.push(("minimum", 2, search.minimum()));
    }
    all
}
