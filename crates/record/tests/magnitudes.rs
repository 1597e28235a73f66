//! Boundaries of any size: from 1e-60 to 1e60 the results are those of the unit size, scaled, and finite in every figure; beyond,
//! the boundary is refused with the point.

use experiment::{Fault, Options, Plan, run};
use plateau::Done;
use proptest::prelude::*;
use record::ResultFile;

const METHODS: &str = r#"
[[method]]
name = "Dirichlet"
energy = "dirichlet"
[[method]]
name = "Laplacian"
energy = "laplacian"
[[method]]
name = "bending"
energy = "bending"
[[method]]
name = "Coons"
energy = "coons"
[[method]]
name = "area"
energy = "area"
[[method]]
name = "metric"
energy = "dirichlet"
metric-steps = 2
[[method]]
name = "mask"
mask = -0.25
"#;

const TENSOR_METHODS: &str = r#"
[[method]]
name = "swarm"
basis = "gt"
energy = "dirichlet"
search = "pso"
[[method]]
name = "polish"
basis = "gt"
energy = "bending"
search = "polish"
[[method]]
name = "TB–Coons"
patch = "tb-coons"
energy = "dirichlet"
shape = [1, 2, 0.5, 3]
[[method]]
name = "discrete Coons"
construction = "discrete-coons"
[search]
particles = 4
iterations = 4
runs = 1
"#;

const TENSOR: [(&str, &[[f64; 3]]); 4] = [
    ("u0", &[[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [4.0, 0.0, -2.0], [6.0, 0.0, 0.0]]),
    ("u1", &[[0.0, 6.0, 0.0], [2.0, 6.0, 2.0], [4.0, 6.0, -2.0], [6.0, 6.0, 0.0]]),
    ("v0", &[[0.0, 0.0, 0.0], [0.0, 2.0, 2.0], [0.0, 4.0, -2.0], [0.0, 6.0, 0.0]]),
    ("v1", &[[6.0, 0.0, 0.0], [6.0, 2.0, 2.0], [6.0, 4.0, -2.0], [6.0, 6.0, 0.0]]),
];

const TRIANGLE: [(&str, &[[f64; 3]]); 3] = [
    ("ab", &[[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [2.0, 0.0, -1.0], [3.0, 0.0, 0.0]]),
    ("bc", &[[3.0, 0.0, 0.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0], [0.0, 3.0, 0.0]]),
    ("ca", &[[0.0, 3.0, 0.0], [0.0, 2.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]]),
];

fn experiment(sides: &[(&str, &[[f64; 3]])], scale: f64, methods: &str) -> String {
    let mut text = "title = \"scaled\"\n[boundary]\n".to_owned();
    for (name, points) in sides {
        let points: Vec<[f64; 3]> = points.iter().map(|p| p.map(|x| x * scale)).collect();
        // `inf` and `NaN` in TOML's words.
        text += &format!("{name} = {points:?}\n").replace("NaN", "nan");
    }
    text + methods + "[output]\nmesh = 4\npictures = false\n"
}

fn texts(scale: f64) -> [String; 2] {
    [
        experiment(&TENSOR, scale, &(METHODS.to_owned() + TENSOR_METHODS)),
        experiment(&TRIANGLE, scale, METHODS),
    ]
}

/// Figures of a patch with the power of the length each goes with.
fn figures(done: &Done) -> Vec<(&'static str, f64, i32)> {
    let f = &done.figures;
    let mut all = vec![
        ("D", f.dirichlet.value, 2),
        ("A", f.area.value, 2),
        ("L", f.laplacian_defect.value, 2),
        ("B", f.bending.value, 2),
        ("gap", f.conformality_gap.expect("an area"), 0),
        ("max H", f.mean_curvature_max.expect("a curvature"), -1),
        ("rms H", f.mean_curvature_rms.expect("a curvature"), -1),
    ];
    all.extend(done.boundary.map(|b| ("bound", b.harmonic_bound, 2)));
    all.extend(done.solved.search().map(|s| ("minimum", s.minimum(), 2)));
    all
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10, ..ProptestConfig::default() })]

    /// Over all exponents of doubles, denormal ones included.
    #[test]
    fn results_scale_or_are_refused(exponent in -1074..1024i32, within in -197..195i32) {
        for exponent in [exponent, within] {
            // In two steps: 2^-1074 is not 1/2^1074.
            let scale = 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
            for (unit, text) in texts(1.0).iter().zip(texts(scale)) {
                let size = 3.0 * scale;
                let plan = match Plan::parse("scaled.toml", &text) {
                    Ok(plan) => plan,
                    Err(refusal) => {
                        prop_assert!(!(2e-60..1e59).contains(&size), "{scale:e}: {refusal}");
                        let first = &refusal.diagnostics()[0];
                        prop_assert_eq!(first.fault(), Fault::Inadmissible);
                        prop_assert!(first.message().contains(" of point ") && refusal.position(first).is_some(), "{}", refusal);
                        continue;
                    }
                };
                prop_assert!((1e-61..1e61).contains(&size), "{scale:e} was admitted");
                let scaled = run(&plan, Options::default(), &()).unwrap();
                let unit = run(&Plan::parse("unit.toml", unit).unwrap(), Options::default(), &()).unwrap();
                prop_assert!(!ResultFile::new(&plan, &scaled).to_json().unwrap().contains("null"));
                for (a, b) in scaled.results.methods().iter().zip(unit.results.methods()) {
                    let (a, b) = (a.outcome.as_ref().unwrap(), b.outcome.as_ref().unwrap());
                    for ((name, x, power), (_, y, _)) in figures(a).into_iter().zip(figures(b)) {
                        // A power of two times a double is exact: the same operations on the same bits.
                        let expected = y * scale.powi(power);
                        prop_assert!((x - expected).abs() <= 1e-12 * expected.abs(), "{name} at {scale:e}: {x:e}, not {expected:e}");
                    }
                }
            }
        }
    }

    /// One coordinate of another magnitude than the rest: finite everywhere, or refused.
    #[test]
    fn mixed_magnitudes_stay_finite(exponent in -320f64..308.0, side in 0..4usize, point in 1..3usize, axis in 0..3usize) {
        let mut sides: Vec<(&str, Vec<[f64; 3]>)> = TENSOR.iter().map(|(name, points)| (*name, points.to_vec())).collect();
        sides[side].1[point][axis] = 10f64.powf(exponent);
        let borrowed: Vec<(&str, &[[f64; 3]])> = sides.iter().map(|(name, points)| (*name, points.as_slice())).collect();
        let text = experiment(&borrowed, 1.0, &(METHODS.to_owned() + TENSOR_METHODS));
        if let Ok(plan) = Plan::parse("mixed.toml", &text) {
            prop_assert!(exponent <= 60.1);
            let finished = run(&plan, Options::default(), &()).unwrap();
            for done in finished.results.methods().iter().filter_map(|method| method.outcome.as_ref().ok()) {
                let f = &done.figures;
                for integral in [f.dirichlet, f.area, f.laplacian_defect, f.bending] {
                    prop_assert!(integral.value.is_finite() && integral.error.is_finite());
                }
                prop_assert!(done.mesh.points.iter().all(|p| p.is_finite()));
            }
            prop_assert!(!ResultFile::new(&plan, &finished).to_json().unwrap().contains("null"));
        } else {
            prop_assert!(exponent > 59.9);
        }
    }
}
