//! Boundaries from files: what is printed is a sound experiment over the points of the file.

use std::fs;
use std::path::PathBuf;

use plateau::Boundary;
use plateau_cli::{Experiment, ImportError, Plan, import};
use proptest::prelude::*;

fn file(name: &str, text: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("plateau-import-{}-{name}", std::process::id()));
    fs::write(&path, text).unwrap();
    path
}

fn imported(name: &str, text: &str, degree: Option<usize>) -> Result<String, ImportError> {
    let path = file(name, text);
    let outcome = import(&path, degree);
    fs::remove_file(path).unwrap();
    outcome
}

fn sides(text: &str) -> [Vec<[f64; 3]>; 4] {
    let plan = Plan::parse("imported.toml", text).unwrap();
    let Experiment::Patch(experiment) = plan.experiment else { panic!("patches") };
    let Boundary::Tensor { u0, u1, v0, v1 } = experiment.boundary else { panic!("a tensor boundary") };
    [u0, u1, v0, v1]
}

fn surface(u: f64, v: f64) -> [f64; 3] {
    [u, v, 0.3 * (2.0 * u + v).sin() + u * v]
}

/// The four sides of [`surface`], with n steps each, as u0, u1, v0, v1.
fn border(n: usize) -> [Vec<[f64; 3]>; 4] {
    let side = |at: fn(f64) -> (f64, f64)| {
        (0..=n).map(|k| at(k as f64 / n as f64)).map(|(u, v)| surface(u, v)).collect()
    };
    [side(|t| (0.0, t)), side(|t| (1.0, t)), side(|t| (t, 0.0)), side(|t| (t, 1.0))]
}

fn table(sides: &[Vec<[f64; 3]>; 4]) -> String {
    let rows = ["u0", "u1", "v0", "v1"]
        .iter()
        .zip(sides)
        .flat_map(|(name, points)| points.iter().map(move |[x, y, z]| format!("{name},{x:?},{y:?},{z:?}\n")));
    std::iter::once("side,x,y,z\n".to_owned()).chain(rows).collect()
}

#[test]
fn control_points_come_back_digit_for_digit() {
    let border = border(3);
    assert_eq!(sides(&imported("net.csv", &table(&border), None).unwrap()), border);
}

#[test]
fn lines_in_any_order_and_sense_are_one_boundary() {
    let [u0, u1, v0, v1] = border(4);
    let mut text = String::new();
    let mut vertices = 0;
    // u0 first and forward: the boundary runs as it does; the others shuffled, two of them backwards.
    for (k, side) in
        [u0.clone(), v0.clone(), u1.iter().rev().copied().collect(), v1.clone()].iter().enumerate()
    {
        text += &format!("o curve {k}\n");
        for [x, y, z] in side {
            text += &format!("v {x:?} {y:?} {z:?}\n");
        }
        for k in 1..side.len() {
            text += &format!("l {} {}\n", vertices + k, vertices + k + 1);
        }
        vertices += side.len();
    }
    assert_eq!(sides(&imported("loop.obj", &text, None).unwrap()), [u0, u1, v0, v1]);
}

#[test]
fn samples_become_curves_that_share_their_corners() {
    let samples = border(30);
    for degree in [1, 2, 5, 8] {
        let text = imported("samples.csv", &table(&samples), Some(degree)).unwrap();
        let fitted = sides(&text);
        for (curve, samples) in fitted.iter().zip(&samples) {
            assert_eq!((curve.len(), curve[0], curve[degree]), (degree + 1, samples[0], samples[30]));
        }
        let stated: Vec<f64> = text
            .lines()
            .filter_map(|line| line.split_once("farthest ")?.1.split(' ').next()?.parse().ok())
            .collect();
        let bound = [0.0, 0.2, 0.01, 0.0, 0.0, 1e-4, 0.0, 0.0, 1e-6][degree];
        assert!(stated.len() == 4 && stated.iter().all(|error| *error < bound), "{degree}: {stated:?}");
    }
}

#[test]
fn triangles_have_three_sides() {
    let text = "1 0 0 0\n1 1 0 1\n1 3 0 0\n2 3 0 0\n2 2 2 1\n2 1 3 0\n3 0 0 0\n3 0 1 -1\n3 1 3 0\n";
    let text = imported("triangle.txt", text, None).unwrap();
    assert!(text.contains("ca = [[1.0, 3.0, 0.0], [0.0, 1.0, -1.0], [0.0, 0.0, 0.0]]"), "{text}");
}

#[test]
fn what_makes_no_boundary_is_told() {
    let border = border(3);
    let sound = table(&border);
    let cases = [
        (sound.replace("u0,0.0,0.0,0.0", "u0,0.0,0.5,0.0"), None, "should meet in a corner"),
        (
            sound.replace("v1,", "v0,").replace("u1,", "v0,"),
            None,
            "there are 2 sides: four make a tensor boundary",
        ),
        (sound.replace("u1,1.0,0.0", "u1,1.0,nan"), None, "line 6: \"nan\" is no coordinate"),
        (sound.clone(), Some(4), "u0: 4 samples do not determine a curve of degree 4"),
        (String::new(), None, "there are 0 sides"),
        ("a,0,0,0\na,1,0,0\n".into(), None, "there is 1 side: four"),
        // Misread as 1, 5, 2 if the comma separated, too.
        ("u0;1,5;2\n".into(), None, "line 1: both commas and semicolons"),
        (
            "0,0,0\n".into(),
            None,
            "line 1: a row is a side and three coordinates, as in u0,1.5,0,2; here are 3 cells: the name",
        ),
        // Rows and columns swapped.
        (
            sound.replace("u0,", "x").replace("v0,", "u0,").replace('x', "v0,"),
            None,
            "run as in an experiment",
        ),
        (sound.replace("u1,", "north,").replacen("north,", "north,9", 1), None, "north"),
    ];
    for (text, degree, message) in cases {
        match imported("wrong.csv", &text, degree) {
            Err(error) => assert!(error.to_string().contains(message), "{error}\ninstead of {message}"),
            Ok(text) => panic!("{message}: {text}"),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn whatever_the_bytes(text in "([a-z0-9.,; lvo#-]{0,12}\n){0,12}", degree in prop::option::of(0..70usize)) {
        for name in ["fuzz.csv", "fuzz.obj"] {
            if let Ok(text) = imported(name, &text, degree) {
                prop_assert!(Plan::parse("fuzz.toml", &text).is_ok());
            }
        }
    }
}
