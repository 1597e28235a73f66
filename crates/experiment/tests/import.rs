//! Boundaries from files: what is printed is a sound experiment over the points of the file.

use experiment::{Experiment, ImportError, ImportOptions, Plan, import};
use plateau::Boundary;
use proptest::prelude::*;

fn imported(name: &str, text: &str, degree: Option<usize>) -> Result<String, ImportError> {
    import(text.as_bytes(), name, &ImportOptions { degree, ..ImportOptions::default() })
}

fn of_control_points(name: &str, text: &str) -> String {
    let options = ImportOptions { control_points: true, ..ImportOptions::default() };
    import(text.as_bytes(), name, &options).unwrap()
}

fn sides(text: &str) -> [Vec<[f64; 3]>; 4] {
    let plan = Plan::parse("imported.toml", text).unwrap();
    let Experiment::Patch(experiment) = plan.experiment else { panic!("patches") };
    let Boundary::Tensor(boundary) = experiment.boundary else { panic!("a tensor boundary") };
    boundary.sides().clone().map(|side| side.into_iter().map(Into::into).collect())
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
    assert_eq!(sides(&of_control_points("loop.obj", &text)), [u0, u1, v0, v1]);
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
    // Without a word they are points on curves, as for the filling of loops.
    let filled = imported("triangle.txt", text, None).unwrap();
    assert!(filled.contains("loops = [[") && filled.contains("tolerance = 1e-9"), "{filled}");
    let text = of_control_points("triangle.txt", text);
    assert!(text.contains("ca = [[1.0, 3.0, 0.0], [0.0, 1.0, -1.0], [0.0, 0.0, 0.0]]"), "{text}");
}

#[test]
fn what_makes_no_boundary_is_told() {
    let border_of = border;
    let border = border(3);
    let sound = table(&border);
    let cases = [
        (sound.replace("u0,0.0,0.0,0.0", "u0,0.0,0.5,0.0"), None, "should meet in a corner"),
        (sound.replace("v1,", "v0,").replace("u1,", "v0,"), None, "which of its cycles are faces is open"),
        (sound.replace("u1,1.0,0.0", "u1,1.0,nan"), None, "line 6: \"nan\" is no coordinate"),
        (sound.clone(), Some(4), "u0: 4 samples do not determine a curve of degree 4"),
        (String::new(), None, "is empty"),
        ("a,0,0,0\na,1,0,0\n".into(), None, "a begins at (0, 0, 0), a ends at (1, 0, 0), a gap of 1. Ends"),
        ("0,0,0\n".into(), None, "line 1: a curve has a single point"),
        // Rows and columns swapped.
        (
            sound.replace("u0,", "@").replace("v0,", "u0,").replace('@', "v0,"),
            None,
            "run as in an experiment",
        ),
        (sound.replace("u1,", "north,").replacen("north,", "north,9", 1), None, "north"),
        // Samples or control points?
        (table(&border_of(25)), None, "has 26 points, and what they are has to be said"),
        (sound.clone(), Some(65), "degree 65 is not offered"),
        // A gap, with its place and what closes it.
        (
            "a,0,0,0\na,2,0,0\nb,2,0,0\nb,2,2,0\nc,2,2,0\nc,0.3,0.5,0\n".into(),
            None,
            "c ends at (0.3, 0.5, 0), a gap of 0.5831. Ends within 2.83e-4 are welded: a side may be missing there, or `weld 0.59`",
        ),
        // No weld that would be refused is offered.
        (
            "a,0,0,0\na,2,0,0\nb,2,0,0\nb,2,2,0\nc,2,2,0\nc,0.5,1.5,0\n".into(),
            None,
            "Ends within 2.83e-4 are welded: a side may be missing there",
        ),
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
                prop_assert!(text.parse::<toml::Table>().is_ok(), "{}", text);
                prop_assert!(Plan::parse("fuzz.toml", &text).is_ok());
            }
        }
    }
}

/// A wall of 21 samples and three straight sides of two points each.
fn nozzle() -> String {
    let mut wall = (0..=20).map(|k| f64::from(k) / 10.0).map(|x| (x, 1.0 + 0.1 * (1.5 * x).sin()));
    let mut text: String = wall.clone().map(|(x, y)| format!("wall,{x},{y},0\n")).collect();
    let (x, y) = wall.next_back().unwrap();
    text +=
        &format!("outlet,{x},{y},0\noutlet,{x},0,0\nsymm,0,0,0\nsymm,{x},0,0\ninlet,0,0,0\ninlet,0,1,0\n");
    text
}

#[test]
fn straight_sides_are_straight_whatever_the_degree() {
    for degree in [1, 5, 9] {
        let text = imported("nozzle.csv", &nozzle(), Some(degree)).unwrap();
        let [u0, u1, v0, v1] = sides(&text);
        assert_eq!(
            (u0.len(), u1.len(), v0.len(), v1.len()),
            (degree + 1, degree + 1, degree + 1, degree + 1)
        );
        for (k, p) in u1.iter().enumerate() {
            assert!((p[0] - 2.0 * k as f64 / degree as f64).abs() < 1e-15 && p[1] == 0.0, "{u1:?}");
        }
        assert_eq!(text.matches("a straight line, exact").count(), 3);
    }
    // Control points of different degrees: the straight ones are raised, too.
    let few: String = nozzle()
        .lines()
        .enumerate()
        .filter(|(k, _)| k % 5 == 0 || *k > 20)
        .map(|(_, line)| format!("{line}\n"))
        .collect();
    let text = of_control_points("few.csv", &few);
    assert!(
        sides(&text)[1].len() == 5 && text.contains("# u1: raised from degree 1 to 4, the same curve"),
        "{text}"
    );
}

#[test]
fn an_imported_experiment_asks_for_what_is_offered_at_its_degree() {
    // Sides as control points of any degree: what is printed is an experiment that `run` takes.
    let side = |name: &str, from: [f64; 2], to: [f64; 2], degree: usize| -> String {
        let at = |k: usize, i: usize| from[i] + (to[i] - from[i]) * k as f64 / degree as f64;
        (0..=degree).map(|k| format!("{name},{:?},{:?},0\n", at(k, 0), at(k, 1))).collect()
    };
    let [a, b, c, d] = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
    for degree in [1, 18, 19, 24, 25, 32, 33, 64] {
        let around = |corners: &[[f64; 2]]| -> String {
            let ends = corners.iter().zip(corners.iter().cycle().skip(1)).enumerate();
            ends.map(|(k, (from, to))| side(&format!("s{k}"), *from, *to, degree)).collect()
        };
        for (corners, limit) in [(&[a, b, c][..], 18), (&[a, b, c, d][..], 64)] {
            let text = of_control_points("sides.csv", &around(corners));
            assert_eq!(text.contains("energy = \"area\""), degree <= limit, "{text}");
            assert_eq!(text.contains("# no least area of degree"), degree > limit, "{text}");
            Plan::parse("sides.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
        }
    }
}

#[test]
fn ends_are_welded_within_a_share_of_the_size() {
    let text = nozzle().replace("outlet,2,0,0", "outlet,2,0.0001,0");
    let found = imported("sloppy.csv", &text, Some(5)).unwrap();
    assert!(found.contains("# 1 corner welded: ends moved by at most 1.00e-4"), "{found}");
    let strict = ImportOptions {
        degree: Some(5),
        assembly: exchange::AssemblyOptions { weld: Some(1e-6), ..exchange::AssemblyOptions::default() },
        ..ImportOptions::default()
    };
    let refused = import(text.as_bytes(), "sloppy.csv", &strict).unwrap_err().to_string();
    assert!(refused.contains("a gap of 0.0001") && refused.contains("weld 0.00011"), "{refused}");
}

#[test]
fn equal_samples_are_left_out_and_counted() {
    let doubled: String = nozzle().lines().map(|line| format!("{line}\n{line}\n")).collect();
    let text = imported("double.csv", &doubled, Some(5)).unwrap();
    assert!(text.contains("21 samples equal to the ones before them were left out"), "{text}");
    let once = imported("once.csv", &nozzle(), Some(5)).unwrap();
    assert_eq!(sides(&text), sides(&once));
}

#[test]
fn loops_of_any_kind_become_curves() {
    let ring: String = (0..32)
        .map(|k| f64::from(k) / 16.0 * std::f64::consts::PI)
        .map(|t| format!("{},{},0\n", t.cos(), t.sin()))
        .collect();
    let text = imported("ring.csv", &ring, None).unwrap();
    assert!(
        text.contains("loops = [[\"side-1\"]]")
            && text.contains("through = { points = [")
            && !text.contains("ends ="),
        "{text}"
    );
    let five = "g e0\nv 1 0 0\nv 0.3 0.9 0.1\nl 1 2\ng e1\nv -0.8 0.6 0\nl 2 3\ng e2\nv -0.8 -0.6 0.1\nl 4 3\ng e3\nv 0.3 -0.9 0\nl 4 5\ng e4\nl 5 1\n";
    let text = imported("five.obj", five, None).unwrap();
    assert!(text.contains("loops = [[\"e0\", \"e1\", \"-e2\", \"e3\", \"e4\"]]"), "{text}");
    assert!(
        text.contains("name = \"e1\"\nends = [\"p2\", \"p3\"]\npoints = [[0.3, 0.9, 0.1], [-0.8, 0.6, 0.0]]"),
        "{text}"
    );
    let tent = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\nl 1 2 3 4 1\nl 1 5\nl 2 5\nl 3 5\nl 4 5\n";
    let text = imported("tent.obj", tent, None).unwrap();
    assert_eq!((text.matches("[[face]]").count(), text.contains("[boundary]")), (4, false), "{text}");
    let dxf = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nrim\n10\n0\n20\n0\n30\n1\n40\n2\n0\nENDSEC\n0\nEOF\n";
    let text = imported("circle.dxf", dxf, None).unwrap();
    assert!(
        text.contains("circle = { center = [0.0, 0.0, 1.0], normal = [0.0, 0.0, 1.0], radius = 2.0 }"),
        "{text}"
    );
}

#[test]
fn loops_of_three_or_four_exact_sides_are_sides_where_a_degree_is_given() {
    let quad = "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nl 1 2 3 4 1\n";
    assert!(imported("quad.obj", quad, None).unwrap().contains("loops = [["));
    let [u0, u1, v0, v1] = sides(&imported("quad.obj", quad, Some(1)).unwrap());
    assert_eq!((u0, u1), (vec![[0., 0., 0.], [1., 0., 0.]], vec![[0., 1., 0.], [1., 1., 1.]]));
    assert_eq!((v0, v1), (vec![[0., 0., 0.], [0., 1., 0.]], vec![[1., 0., 0.], [1., 1., 1.]]));
    let curves = "v 0 0 0\nv 1 0 1\nv 2 0 0\nv 2 1 1\nv 2 2 0\nv 0 2 0\ncstype bezier\ndeg 2\ncurv 0 1 1 2 3\nend\ncurv 0 1 3 4 5\nend\nl 5 6\nl 6 1\n";
    let [u0, u1, ..] = sides(&imported("curves.obj", curves, Some(2)).unwrap());
    assert_eq!((u0.len(), u1), (3, vec![[0., 2., 0.], [1., 2., 0.], [2., 2., 0.]]));
    // A closed polyline with four corners, fitted.
    let loop_of_four: String = border(12).iter().enumerate().fold(String::new(), |text, (k, _)| {
        let [u0, u1, v0, v1] = border(12);
        let reversed = |side: Vec<[f64; 3]>| side.into_iter().rev().collect::<Vec<_>>();
        let side = &[u0, v1, reversed(u1), reversed(v0)][k];
        text + &side[..12].iter().map(|[x, y, z]| format!("{x:?} {y:?} {z:?}\n")).collect::<String>()
    });
    let text = imported("loop.txt", &loop_of_four, Some(4)).unwrap();
    assert!(sides(&text).iter().all(|side| side.len() == 5), "{text}");
}
