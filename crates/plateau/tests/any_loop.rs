//! Random loops of every kind, of one to twelve corners: each is filled or refused with a reason, none folds without a word, and how it is
//! cut does not matter beyond what is said.

#![allow(clippy::print_stdout)] // the ignored test says what it found

#[allow(dead_code, reason = "the frames of other tests come with it")]
mod frames;

use std::collections::HashMap;
use std::f64::consts::TAU;

use energy::EnergyError;
use frames::Stream;
use plateau::{CuttingError, Fill, Film, Loop, MethodError, Warning, Way, estimate_complex};
use surfaces::{BoundaryCurve, Mesh, Point};

/// What a boundary is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Zigzag,
    Fourier,
    Rings,
    Star,
    Flat,
}

const KINDS: [Kind; 5] = [Kind::Zigzag, Kind::Fourier, Kind::Rings, Kind::Star, Kind::Flat];

/// A boundary: its kind, the number of its corners, or of the waves of a smooth one, and its loops.
struct Rim {
    kind: Kind,
    corners: usize,
    loops: Vec<Loop>,
    /// The area inside, if it is flat.
    area: Option<f64>,
}

/// Corners around the axis at given radii and heights; where they are one or two, with bowed sides between them.
fn around(corners: &[(f64, f64)]) -> (Loop, f64) {
    let n = corners.len();
    let place = |turns: f64, (radius, z): (f64, f64)| {
        Point::new(radius * (TAU * turns).cos(), radius * (TAU * turns).sin(), z)
    };
    let at = |k: usize| place(k as f64 / n as f64, corners[k % n]);
    if n >= 3 {
        let points: Vec<Point> = (0..n).map(at).collect();
        let area = (0..n).map(|k| 0.5 * points[k].cross(points[(k + 1) % n]).z).sum();
        return (Loop::polygon(&points).expect("a polygon"), area);
    }
    // Cubics from corner to corner whose inner control points go round with them: a drop, a lens.
    let side = |k: usize| {
        let (a, b) = (corners[k], corners[(k + 1) % n]);
        let between = |share: f64| {
            let wide = if n == 1 { 2.2 } else { 1.3 };
            let (radius, z) = (wide * (a.0 + b.0) / 2.0, a.1 * (1.0 - share) + b.1 * share);
            place((k as f64 + share) / n as f64, (radius, z))
        };
        vec![at(k), between(0.3), between(0.7), at(k + 1)]
    };
    let sides: Vec<Vec<Point>> = (0..n).map(side).collect();
    // ½∮ x × dx of a cubic with control points b: (6 b₀×b₁ + 3 b₀×b₂ + b₀×b₃ + 3 b₁×b₂ + 3 b₁×b₃ + 6 b₂×b₃) / 20.
    let area = sides.iter().map(|b| {
        let cross = |i: usize, j: usize| b[i].cross(b[j]).z;
        (6.0 * cross(0, 1)
            + 3.0 * cross(0, 2)
            + cross(0, 3)
            + 3.0 * cross(1, 2)
            + 3.0 * cross(1, 3)
            + 6.0 * cross(2, 3))
            / 20.0
    });
    (Loop::sides(sides.clone()).expect("sides"), area.sum())
}

/// A smooth closed curve with a few waves in its radius and height, by samples from this one on.
fn fourier(waves: &[[f64; 4]], z: f64, first: usize) -> Loop {
    const SAMPLES: usize = 240;
    let point = |k: usize| {
        let angle = TAU * (k % SAMPLES) as f64 / SAMPLES as f64;
        let (mut radius, mut z) = (1.0, z);
        for (wave, [a, b, c, d]) in waves.iter().enumerate() {
            let turned = (wave + 2) as f64 * angle;
            radius += a * turned.cos() + b * turned.sin();
            z += c * turned.cos() + d * turned.sin();
        }
        Point::new(radius * angle.cos(), radius * angle.sin(), z)
    };
    let samples = (0..=SAMPLES).map(|k| point(k + first)).collect();
    Loop::new(vec![BoundaryCurve::through(samples, 1e-5).expect("samples")], None).expect("a loop")
}

/// Amplitudes that fall with the wave.
fn waves(count: usize, size: f64, stream: &mut Stream) -> Vec<[f64; 4]> {
    let wave = |k: usize, stream: &mut Stream| [0; 4].map(|_| size * stream.signed() / (k + 2) as f64);
    (0..count).map(|k| wave(k, stream)).collect()
}

/// Boundary `seed`; smooth ones begun at a sample of their own.
fn random(seed: u64, first: usize) -> Rim {
    let mut stream = Stream::new(seed);
    let kind = KINDS[seed as usize % KINDS.len()];
    let corners = 1 + seed as usize / KINDS.len() % 12;
    let mut area = None;
    let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + stream.signed());
    let loops = match kind {
        Kind::Zigzag => {
            let height = between(0.1, 0.5);
            let up = |k: usize| if k.is_multiple_of(2) { height } else { -height };
            vec![around(&(0..corners).map(|k| (between(0.8, 1.2), up(k))).collect::<Vec<_>>()).0]
        }
        Kind::Star => {
            let reach = |k: usize| if k.is_multiple_of(2) { 1.0 } else { 0.55 };
            vec![
                around(
                    &(0..corners)
                        .map(|k| (reach(k) * between(0.8, 1.2), between(-0.3, 0.3)))
                        .collect::<Vec<_>>(),
                )
                .0,
            ]
        }
        Kind::Flat => {
            let (flat, inside) = around(&(0..corners).map(|_| (between(0.35, 1.2), 0.0)).collect::<Vec<_>>());
            area = Some(inside);
            vec![flat]
        }
        Kind::Fourier => vec![fourier(&waves(corners.min(5), 0.3, &mut stream), 0.0, first)],
        Kind::Rings => {
            let apart = between(0.2, 0.45);
            let ring = |z: f64, stream: &mut Stream| fourier(&waves(corners.min(4), 0.12, stream), z, first);
            vec![ring(-apart, &mut stream), ring(apart, &mut stream)]
        }
    };
    Rim { kind, corners, loops, area }
}

/// Pairs of neighbouring triangles whose normals are more than a right angle apart.
fn folds(mesh: &Mesh) -> usize {
    let mut at: HashMap<[u32; 2], Point> = HashMap::new();
    let mut count = 0;
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|k| mesh.points[k as usize]);
        let normal = (b - a).cross(c - a);
        for k in 0..3 {
            let (i, j) = (triangle[k], triangle[(k + 1) % 3]);
            if let Some(other) = at.insert([i.min(j), i.max(j)], normal) {
                count += usize::from(other.dot(normal) < 0.0);
            }
        }
    }
    count
}

/// Subdivisions of a patch among which no two neighbouring triangles turn by a right angle unless it folds: surfaces turn fast near sharp corners.
const FINE: usize = 100;

/// The share of the area by which it may depend on the cutting without a word.
const SPREAD: f64 = 1e-6;

/// Whether a film says of itself that it may lie this much above the least area.
fn is_said(film: &Film, above: f64) -> bool {
    let covers = |estimate: f64| estimate >= 0.5 * above;
    let found = film.extremal.as_ref().expect("a least area");
    !film.warnings.is_empty()
        || film.estimate.is_some_and(covers)
        || estimate_complex(film.complex(), found, &()).expect("a system").map_or(true, covers)
}

/// The same boundary cut in other ways: a disc by midpoints and by rings, a band from other points of its loops on.
fn cut_otherwise(rim: &Rim, seed: u64) -> Vec<Film> {
    let cut = |way| match Fill::default().with_way(way).loops(&rim.loops, &()) {
        Ok(film) => Some(film),
        Err(MethodError::Cutting(CuttingError::Unsuitable { .. }))
            if rim.corners < 3 || rim.kind == Kind::Fourier =>
        {
            None
        }
        // Where the start is singular, so is that way.
        Err(MethodError::Energy(EnergyError::Singular { .. })) => None,
        Err(error) => panic!("{seed}: {error}"),
    };
    match rim.kind {
        Kind::Rings => [20, 47]
            .map(|first| Fill::default().loops(&random(seed, first).loops, &()).expect("a band"))
            .into(),
        Kind::Zigzag | Kind::Fourier | Kind::Star | Kind::Flat => {
            [Way::Midpoint, Way::Ring, Way::TurnedRing].into_iter().filter_map(cut).collect()
        }
    }
}

/// Fills a boundary, looks for folds and compares cuttings. Gives the largest share by which a sound one of them is higher.
fn judge(seed: u64) -> f64 {
    let rim = random(seed, 0);
    let film = Fill::default().loops(&rim.loops, &()).unwrap_or_else(|error| panic!("{seed}: {error}"));
    let area = film.figures.area.value;
    let is_told = |film: &Film| film.warnings.iter().any(|warning| matches!(warning, Warning::Folded { .. }));
    let mesh = film.complex().mesh(FINE).expect("a mesh").mesh;
    assert!(folds(&mesh) == 0 || is_told(&film), "{seed}: {:?} folds without a word", rim.kind);
    if let Some(inside) = rim.area {
        assert!((area / inside - 1.0).abs() < 1e-9, "{seed}: {area} over a flat loop with {inside} inside");
    }
    let mut spread: f64 = 0.0;
    for other in cut_otherwise(&rim, seed) {
        let above = other.figures.area.value - area;
        // Points of a smooth curve from which arcs are fitted move it by as much as is told.
        let moved = if rim.kind == Kind::Rings { film.rim.area + other.rim.area } else { 0.0 };
        let admitted = moved.max(SPREAD * area);
        match rim.kind {
            Kind::Zigzag | Kind::Fourier | Kind::Rings => {
                assert!(
                    above.abs() <= admitted,
                    "{seed}: {:?} has {above:e} more than {:?}",
                    other.way,
                    film.way
                );
            }
            Kind::Star | Kind::Flat => {
                let higher = if above > 0.0 { &other } else { &film };
                let said = above.abs() <= admitted || is_said(higher, above.abs());
                assert!(said, "{seed}: {:?} has {above:e} more than {:?} unsaid", other.way, film.way);
            }
        }
        if !is_told(&other) {
            spread = spread.max(above.abs() / area);
        }
    }
    spread
}

#[test]
fn how_a_loop_is_cut_does_not_matter() {
    // Every kind with one to seven corners.
    (0..35).for_each(|seed| {
        judge(seed);
    });
}

#[test]
#[ignore = "half an hour; `just loops`"]
fn how_two_hundred_loops_are_cut_does_not_matter() {
    let mut worst: HashMap<&str, f64> = HashMap::new();
    for seed in 0..200 {
        let kind = match KINDS[seed as usize % KINDS.len()] {
            Kind::Zigzag => "zigzags",
            Kind::Fourier => "smooth loops",
            Kind::Rings => "pairs of rings",
            Kind::Star => "stars",
            Kind::Flat => "flat loops",
        };
        let spread = worst.entry(kind).or_default();
        *spread = spread.max(judge(seed));
    }
    for (kind, spread) in worst {
        println!("{kind}: areas of several cuttings differ by at most {spread:.1e} of themselves");
    }
}
