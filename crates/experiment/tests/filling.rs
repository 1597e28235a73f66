//! Curves of files, filled.

use exchange::read_curves;
use experiment::{Filling, ImportError, ImportOptions, import};
use plateau::Fill;
use proptest::prelude::*;
use surfaces::{Bezier, Point};

fn filling(text: &str, options: &ImportOptions) -> Result<Filling, ImportError> {
    Filling::new(vec![read_curves(text.as_bytes(), "-")?], options)
}

fn controls() -> ImportOptions {
    ImportOptions { control_points: true, ..ImportOptions::default() }
}

/// Sides of a loop in the plane: chords of the unit circle bent a little by control points beside them, so that none crosses another.
fn loops(most: usize) -> impl Strategy<Value = Vec<Vec<Point>>> {
    prop::collection::vec(prop::collection::vec(-0.08..0.08, 1..5), 3..=most).prop_map(|sides| {
        let count = sides.len();
        let corner = |k: usize| {
            let (s, c) = (std::f64::consts::TAU * (k % count) as f64 / count as f64).sin_cos();
            Point::new(c, s, 0.0)
        };
        let side = |(k, bends): (usize, &Vec<f64>)| {
            let (from, to) = (corner(k), corner(k + 1));
            let across = Point::new(from.y - to.y, to.x - from.x, 0.0);
            let degree = bends.len() + 1;
            let inner = bends.iter().enumerate().map(|(i, bend)| {
                let t = (i + 1) as f64 / degree as f64;
                from * (1.0 - t) + to * t + across * *bend
            });
            std::iter::once(from).chain(inner).chain([to]).collect()
        };
        sides.iter().enumerate().map(side).collect()
    })
}

fn table(names: &[&str], sides: &[Vec<Point>]) -> String {
    let row = |name: &str, p: &Point| format!("{name},{:?},{:?},{:?}\n", p.x, p.y, p.z);
    let rows = |(k, side): (usize, &Vec<Point>)| {
        let name = names.get(k).map_or(format!("s{k}"), ToString::to_string);
        side.iter().map(|p| row(&name, p)).collect::<String>()
    };
    "side,x,y,z\n".to_owned() + &sides.iter().enumerate().map(rows).collect::<String>()
}

/// The same as lines of an OBJ file, which go on in each other.
fn lines(sides: &[Vec<Point>]) -> String {
    let (mut text, mut count) = (String::new(), 0);
    for side in sides {
        side.iter().for_each(|p| text += &format!("v {:?} {:?} {:?}\n", p.x, p.y, p.z));
        let line: Vec<String> = (1..side.len()).map(|k| (count + k).to_string()).collect();
        count += side.len();
        text += &format!("l {} {}\n", line.join(" "), if count == total(sides) { 1 } else { count + 1 });
    }
    text
}

fn total(sides: &[Vec<Point>]) -> usize {
    sides.iter().map(Vec::len).sum()
}

/// ½ ∮ x dy − y dx, exact for the degrees here.
fn enclosed(sides: &[Vec<Point>]) -> f64 {
    let of_side = |points: &Vec<Point>| {
        let curve = Bezier::new(points.clone()).unwrap();
        let steps = 4000;
        // Simpson's rule: 1e-13 and better for degree 9.
        let at = |k: usize| {
            let t = k as f64 / steps as f64;
            let (p, d) = (curve.point(t), curve.derivative(t));
            0.5 * (p.x * d.y - p.y * d.x)
        };
        let weight = |k: usize| {
            if k == 0 || k == steps {
                1.0
            } else if k % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        (0..=steps).map(|k| weight(k) * at(k)).sum::<f64>() / (3 * steps) as f64
    };
    sides.iter().map(of_side).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// The plane spanned is that between the Bézier curves, not between curves through their control points.
    #[test]
    fn control_points_are_those_of_the_rim(sides in loops(6)) {
        for text in [table(&[], &sides), lines(&sides)] {
            let film = filling(&text, &controls()).unwrap().span(&Fill::default(), &()).unwrap();
            prop_assert!((film.figures.area.value / enclosed(&sides) - 1.0).abs() < 1e-9, "{}", text);
            prop_assert_eq!(film.rim.largest, 0.0);
        }
    }

    /// A table means the same to `fill` and to `import`: under names of its own and under those of the sides of an experiment.
    #[test]
    fn columns_mean_the_same_to_both(sides in loops(5), is_said in any::<bool>()) {
        let names: &[&str] = match sides.len() {
            3 => &["ab", "bc", "ca"],
            4 => &["u0", "v1", "u1", "v0"],
            _ => &[],
        };
        let mut sides = sides;
        // Opposite sides run alike in an experiment.
        if sides.len() == 4 {
            sides[2].reverse();
            sides[3].reverse();
        }
        let text = table(names, &sides);
        let options = if is_said || names.is_empty() { controls() } else { ImportOptions::default() };
        let printed = import(text.as_bytes(), "-", &options).unwrap();
        let filled = filling(&text, &options).unwrap().experiment("t", &Fill::default()).unwrap();
        prop_assert!(!filled.contains("through"), "{}", filled);
        let digits = |p: &Point| format!("[{:?}, {:?}, {:?}]", p.x, p.y, p.z);
        for side in &sides {
            let points = |forward: bool| {
                let mut points: Vec<String> = side.iter().map(digits).collect();
                if !forward { points.reverse() }
                format!("= [{}]", points.join(", "))
            };
            prop_assert!(filled.contains(&points(true)) || filled.contains(&points(false)), "{}", filled);
            let raised = printed.contains("raised from degree");
            prop_assert!(raised || printed.contains(&points(true)) || printed.contains(&points(false)), "{}", printed);
        }
    }
}

#[test]
fn many_points_under_names_of_sides_are_asked_about_by_both() {
    let arch = |y: f64| (0..=20).map(move |k| Point::new(f64::from(k), y, f64::from(k * (20 - k)) / 50.0));
    let line = |x: f64| vec![Point::new(x, 0.0, 0.0), Point::new(x, 9.0, 0.0)];
    let sides = [arch(0.0).collect(), arch(9.0).collect(), line(0.0), line(20.0)];
    let text = table(&["v0", "v1", "u0", "u1"], &sides);
    let by_import = import(text.as_bytes(), "-", &ImportOptions::default()).unwrap_err().to_string();
    let by_fill = filling(&text, &ImportOptions::default()).unwrap_err().to_string();
    assert_eq!(by_import, by_fill);
    assert!(by_fill.contains("--degree") && by_fill.contains("--control-points"), "{by_fill}");
    // Both answers are taken, and are two surfaces.
    let area = |options: &ImportOptions| {
        filling(&text, options).unwrap().span(&Fill::default(), &()).unwrap().figures.area.value
    };
    let samples = area(&ImportOptions { degree: Some(6), ..ImportOptions::default() });
    let controlled = area(&controls());
    assert!(samples > 1.001 * controlled, "{samples} {controlled}");
    // Under other names they are points on curves without a word.
    let other = text.replace("v0", "north").replace("v1", "south").replace("u0", "east");
    assert!((area_of(&other) / samples - 1.0).abs() < 1e-12);
}

fn area_of(text: &str) -> f64 {
    let filling = filling(text, &ImportOptions::default()).unwrap();
    filling.span(&Fill::default(), &()).unwrap().figures.area.value
}

#[test]
fn control_points_that_make_no_curve_say_what_to_do() {
    let ring: String = (0..6).map(|k| format!("{},{},0\n", k % 3, k / 3)).collect();
    let many: String = (0..40).map(|k| format!("a,{k},0,{}\n", k % 2)).collect();
    for (text, said) in [
        (ring, "name the sides in a column, or repeat the first point at the end"),
        (
            many + "b,39,0,1\nb,20,20,20\nb,0,0,0\n",
            "as control points they are a curve of degree 39, and 30 is the highest",
        ),
    ] {
        let error = filling(&text, &controls()).unwrap_err().to_string();
        assert!(error.contains(said) && error.starts_with("line 1"), "{error}");
    }
}

/// What is proposed for sides of many points is then taken.
#[test]
fn many_points_are_asked_about_with_ways_out_that_are_open() {
    let table = |count: usize| -> String {
        let side = |name: &str, v: usize| -> String {
            (0..count).map(|k| format!("{name},{k},{v},{}\n", k % 2)).collect()
        };
        let end = (count - 1) % 2;
        let last = count - 1;
        side("u0", 0)
            + &side("u1", 1)
            + &format!("v0,0,0,0\nv0,0,1,0\nv1,{last},0,{end}\nv1,{last},1,{end}\n")
    };
    for count in [14, 31, 32, 41, 65, 66] {
        let text = table(count);
        let filled = filling(&text, &ImportOptions::default()).unwrap_err().to_string();
        let imported =
            import(text.as_bytes(), "many.csv", &ImportOptions::default()).unwrap_err().to_string();
        let offers = |said: &str| said.contains("then `--control-points`");
        assert_eq!(offers(&filled), filling(&text, &controls()).is_ok(), "{count}: {filled}");
        assert_eq!(
            offers(&imported),
            import(text.as_bytes(), "many.csv", &controls()).is_ok(),
            "{count}: {imported}"
        );
        for said in [&filled, &imported] {
            assert!(said.contains("`--degree 6`"), "{said}");
            assert_eq!(offers(said), !said.contains("is the highest"), "{said}");
        }
        assert!(filling(&text, &ImportOptions { degree: Some(6), ..ImportOptions::default() }).is_ok());
    }
}

/// As many corners as `run` takes, no more, and a way out for more.
#[test]
fn loops_of_more_corners_than_are_offered_are_refused_at_once() {
    let gear = |teeth: usize| -> String {
        let corner = |k: usize| {
            let (s, c) = (std::f64::consts::TAU * k as f64 / (2 * teeth) as f64).sin_cos();
            let r = if k.is_multiple_of(2) { 1.0 } else { 1.3 };
            format!("{:?},{:?},0\n", r * c, r * s)
        };
        (0..2 * teeth).map(corner).collect()
    };
    let options = ImportOptions::default();
    assert!(filling(&gear(100), &options).is_ok());
    assert!(import(gear(100).as_bytes(), "gear.csv", &options).is_ok());
    let smooth = ImportOptions {
        assembly: exchange::AssemblyOptions { corner_angle: 179.0, ..exchange::AssemblyOptions::default() },
        ..ImportOptions::default()
    };
    for teeth in [101, 150] {
        let text = gear(teeth);
        let refused = [
            filling(&text, &options).unwrap_err().to_string(),
            import(text.as_bytes(), "gear.csv", &options).unwrap_err().to_string(),
        ];
        assert_eq!(refused[0], refused[1]);
        for word in [&format!("{} sides", 2 * teeth), "at most 200", "fewer points", "a larger corner angle"]
        {
            assert!(refused[0].contains(word), "{refused:?}");
        }
        assert!(filling(&text, &smooth).is_ok());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A weld that is proposed is taken, and joins what it was proposed for.
    #[test]
    fn a_weld_that_is_proposed_is_one_that_joins(gaps in prop::collection::vec(0.0..0.7, 8), is_named in any::<bool>()) {
        let names: &[&str] = if is_named { &["u0", "v1", "u1", "v0"] } else { &["a", "b", "c", "d"] };
        let corner = |k: usize| [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]][k % 4];
        let end = |k: usize, gap: f64| Point::new(corner(k)[0], corner(k)[1], gap);
        let mut sides: Vec<Vec<Point>> =
            (0..4).map(|k| vec![end(k, gaps[2 * k]), end(k + 1, gaps[2 * k + 1])]).collect();
        sides[2].reverse();
        sides[3].reverse();
        let text = table(names, &sides);
        let mut options = ImportOptions { control_points: true, ..ImportOptions::default() };
        // One gap after the other is told, each wider than what was given.
        for _ in 0..5 {
            let Err(error) = import(text.as_bytes(), "-", &options) else { break };
            let said = error.to_string();
            let Some((_, proposed)) = said.split_once("`weld ") else { break };
            let proposed: f64 = proposed.split('`').next().unwrap().parse().unwrap();
            prop_assert!(options.assembly.weld.is_none_or(|given| proposed > given), "{}", said);
            options.assembly.weld = Some(proposed);
            if let Err(error) = import(text.as_bytes(), "-", &options) {
                let now = error.to_string();
                prop_assert!(!now.contains("a quarter of the size") && now != said, "{} {}", said, now);
            }
        }
    }
}

/// Samples of a bent circle.
fn ring(count: usize) -> String {
    let row = |k: usize| {
        let (s, c) = (std::f64::consts::TAU * k as f64 / count as f64).sin_cos();
        format!("{c:?},{s:?},{:?}\n", 0.3 * (c * c - s * s))
    };
    "x,y,z\n".to_owned() + &(0..count).map(row).collect::<String>()
}

#[test]
fn the_tolerance_that_is_advised_makes_the_rim_as_near_as_the_accuracy() {
    let mut advised = 0;
    for count in [24, 200] {
        for accuracy in [1e-3, 1e-5, 1e-7] {
            let fill = Fill::default().with_accuracy(accuracy);
            let coarse = filling(&ring(count), &ImportOptions::default()).unwrap();
            let film = coarse.span(&fill, &()).unwrap();
            let wanted = accuracy * film.figures.area.value;
            let Some(advice) = coarse.advice(&fill, &film) else {
                assert!(film.rim.area <= wanted);
                continue;
            };
            assert!(film.rim.area > wanted);
            let (_, tolerance) = advice.split_once("`--tolerance ").unwrap();
            let tolerance: f64 = tolerance.split('`').next().unwrap().parse().unwrap();
            let options = ImportOptions { tolerance: Some(tolerance), ..ImportOptions::default() };
            let fine = filling(&ring(count), &options).unwrap();
            let film = fine.span(&fill, &()).unwrap();
            assert!(film.rim.area <= wanted, "{accuracy} {count}: {:?}", film.rim);
            assert_eq!(fine.advice(&fill, &film), None);
            advised += 1;
        }
    }
    assert!(advised >= 2, "{advised}");
}

#[test]
fn the_experiment_of_a_file_keeps_its_unit() {
    let text = "# Units: inches\nv 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nl 1 2 3 4 1\n";
    let printed =
        filling(text, &ImportOptions::default()).unwrap().experiment("t", &Fill::default()).unwrap();
    assert!(printed.ends_with("[output]\nstep-unit = \"inch\"\n"), "{printed}");
    assert!(
        import(text.as_bytes(), "-", &ImportOptions::default()).unwrap().ends_with("step-unit = \"inch\"\n")
    );
    let bare = text.replace("Units", "Made by");
    assert!(!import(bare.as_bytes(), "-", &ImportOptions::default()).unwrap().contains("[output]"));
}
