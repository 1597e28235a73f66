//! `plateau fill`: curves in, figures and files out.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn fill(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_plateau"))
        .arg("fill")
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The number after the name of a figure.
fn area(out: &Output) -> f64 {
    let text = text(&out.stdout);
    assert!(out.status.success(), "{text}{}", String::from_utf8_lossy(&out.stderr));
    text.lines()
        .find_map(|line| line.strip_prefix("area "))
        .unwrap()
        .split_whitespace()
        .next()
        .unwrap()
        .parse()
        .unwrap()
}

/// K(3/4)/K(1/4), the least area over the skew quadrilateral of four edges of a cube.
const SKEW: f64 = 1.279_261_571_171_006;

/// Six edges of a cube, out of order and in both senses.
const HEXAGON: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\nv 0 0 1\nl 4 3\nl 1 2\nl 1 6\nl 2 3\nl 5 6\nl 4 5\n";

#[test]
fn a_hexagon_comes_out_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("hexagon.obj"), HEXAGON).unwrap();
    let names = ["x.step", "x.stp", "x.glb", "x.ply", "x.obj", "x.stl", "x.vtu", "x.bezier.vtu", "x.toml"];
    let mut arguments = vec!["hexagon.obj"];
    names.iter().for_each(|name| arguments.extend(["-o", name]));
    let out = fill(folder.path(), &arguments);
    assert!((area(&out) - 1.5 * SKEW).abs() < 1e-10, "{}", text(&out.stdout));
    assert!(text(&out.stdout).contains("6 of degree 6"));
    for name in names {
        assert!(fs::metadata(folder.path().join(name)).unwrap().len() > 100, "{name}");
    }
    let step = fs::read_to_string(folder.path().join("x.step")).unwrap();
    assert_eq!((step.matches("OPEN_SHELL").count(), step.matches("ADVANCED_FACE").count()), (1, 6));
    // Vertices of the mesh on common edges are there once: V − E + F = 1.
    let mesh = fs::read_to_string(folder.path().join("x.obj")).unwrap();
    let (vertices, triangles) = (mesh.matches("\nv ").count(), mesh.matches("\nf ").count());
    // 6 · 16² squares, 12 · 16 of their edges on the rim.
    assert_eq!((vertices, triangles), (1 + (6 * 256 * 4 + 12 * 16) / 2 - 6 * 256, 6 * 2 * 256));
}

#[test]
fn rings_of_a_table_close_and_step_says_its_unit() {
    let folder = tempfile::tempdir().unwrap();
    let ring = |name: &str, z: f64| {
        let point = |k: i32| {
            let (s, c) = (f64::from(k) * std::f64::consts::TAU / 48.0).sin_cos();
            format!("{name},{c},{s},{z}\n")
        };
        (0..48).map(point).collect::<String>()
    };
    let rows = ring("low", 0.0) + &ring("high", 0.4);
    fs::write(folder.path().join("rings.csv"), format!("ring,x,y,z\n{rows}")).unwrap();
    let out = fill(folder.path(), &["rings.csv", "--unit", "inch", "-o", "x.step", "-o", "x.html"]);
    // Below that of the cylinder.
    assert!((2.0..0.8 * std::f64::consts::PI).contains(&area(&out)), "{}", text(&out.stdout));
    assert!(text(&out.stderr).contains("its numbers are inches"), "{}", text(&out.stderr));
    let step = fs::read_to_string(folder.path().join("x.step")).unwrap();
    assert!(step.contains("CONVERSION_BASED_UNIT('INCH'") && step.contains("LENGTH_MEASURE(2.54E1)"));
    assert!(fs::read_to_string(folder.path().join("x.html")).unwrap().contains("</html>"));
    // Sides are no rings: their ends are looked at.
    fs::write(folder.path().join("sides.csv"), format!("side,x,y,z\n{rows}")).unwrap();
    let out = fill(folder.path(), &["sides.csv"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("call the column of sides `ring`"), "{}", text(&out.stderr));
    let out = fill(folder.path(), &["rings.csv", "--degree", "25"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("1..=24"), "{}", text(&out.stderr));
}

#[test]
fn two_rings_are_joined_and_compared_with_two_discs() {
    let folder = tempfile::tempdir().unwrap();
    let ring = |z: f64| {
        let point = |k: i32| {
            let (s, c) = (f64::from(k) * std::f64::consts::TAU / 64.0).sin_cos();
            format!("v {c} {s} {z}\n")
        };
        (0..64).map(point).collect::<String>()
            + "l "
            + &(0..65).map(|k| format!("{} ", k % 64 - 64)).collect::<String>()
    };
    for (name, z) in [("below.obj", -0.2), ("above.obj", 0.2)] {
        fs::write(folder.path().join(name), ring(z)).unwrap();
    }
    // One file of each: π c (0.4 + c sinh(0.4/c)) with c cosh(0.2/c) = 1.
    let mut c: f64 = 1.0;
    (0..60).for_each(|_| c = 1.0 / (0.2 / c).cosh());
    let exact = std::f64::consts::PI * c * (0.4 + c * (0.4 / c).sinh());
    let out = fill(folder.path(), &["below.obj", "above.obj"]);
    assert!((area(&out) / exact - 1.0).abs() < 1e-3, "{} {exact}", text(&out.stdout));
    assert!(text(&out.stdout).contains("one by one      6.28"), "{}", text(&out.stdout));
}

#[test]
fn gaps_are_welded_and_counted() {
    let folder = tempfile::tempdir().unwrap();
    let sides = "v 0 0 0\nv 1 0 0\nv 1 0 0.00002\nv 1 1 1\nv 0 1 0\nl 1 2\nl 3 4\nl 4 5\nl 5 1\n";
    fs::write(folder.path().join("near.obj"), sides).unwrap();
    let out = fill(folder.path(), &["near.obj"]);
    assert!((area(&out) - SKEW).abs() < 1e-4);
    assert!(text(&out.stdout).contains("welded          1 end,"), "{}", text(&out.stdout));
    let out = fill(folder.path(), &["near.obj", "--weld", "1e-6"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("--weld"), "{}", text(&out.stderr));
}

#[test]
fn what_cannot_be_filled_or_written_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("hexagon.obj"), HEXAGON).unwrap();
    let triangle = |k: i32| format!("v {k} 0 0\nv {k} 0.5 0\nv {k} 0 0.5\nl -3 -2 -1 -3\n");
    fs::write(folder.path().join("three.obj"), (0..3).map(triangle).collect::<String>()).unwrap();
    fs::write(folder.path().join("line.csv"), "x,y,z\n0,0,0\n1,1,1\n2,2,2\n").unwrap();
    for (arguments, said) in [
        (vec!["hexagon.obj", "-o", "x.jpg"], "step"),
        (vec!["hexagon.obj", "-o", "hexagon.obj"], "would be replaced"),
        (vec!["hexagon.obj", "--corner-angle", "200"], "corner angle"),
        (vec!["hexagon.obj", "--tolerance", "0"], "tolerance"),
        (vec!["three.obj"], "[[face]]"),
        (vec!["nowhere.obj"], "nowhere.obj"),
        (vec!["line.csv"], "one straight line"),
    ] {
        let out = fill(folder.path(), &arguments);
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains(said), "{arguments:?}: {}", text(&out.stderr));
        assert!(out.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn running_a_file_of_curves_says_what_fills_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("hexagon.obj"), HEXAGON).unwrap();
    fs::write(folder.path().join("notes.txt"), "no curves here, and no experiment\n").unwrap();
    for (name, said) in [("hexagon.obj", true), ("notes.txt", false)] {
        let run = Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(["run", name])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(2), "{name}");
        let told = text(&run.stderr).contains(&format!("plateau fill {name} -o surface.step"));
        assert_eq!(told, said, "{name}: {}", text(&run.stderr));
    }
}

#[test]
fn an_experiment_that_was_made_of_curves_finds_what_was_filled() {
    let folder = tempfile::tempdir().unwrap();
    // Six sides, one of few samples that turn by up to 40 degrees: smooth by the rule of files and of experiments.
    let arch: Vec<String> =
        [(0, 0.), (2, 1.), (4, 2.), (6, 1.), (8, 0.)].iter().map(|(y, z)| format!("v 0 {y} {z}\n")).collect();
    let rim = arch.concat() + "v 6 8 0\nv 9 4 3\nv 6 0 0\nl 1 2 3 4 5\nl 5 6\nl 6 7 8\nl 8 1\n";
    fs::write(folder.path().join("hexagon.obj"), HEXAGON).unwrap();
    fs::write(folder.path().join("rim.obj"), rim).unwrap();
    let plateau = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(arguments)
            .current_dir(folder.path())
            .output()
            .unwrap()
    };
    for (file, options) in [
        ("hexagon.obj", vec![]),
        ("rim.obj", vec![]),
        ("rim.obj", vec!["--corner-angle", "30", "--degree", "5"]),
        ("rim.obj", vec!["--corner-angle", "60"]),
    ] {
        let out =
            fill(folder.path(), &[vec![file, "-o", "x.toml", "-o", "x.json"], options.clone()].concat());
        let filled = area(&out);
        let import = plateau(&[vec!["import", file], options.clone()].concat());
        let written = fs::read_to_string(folder.path().join("x.toml")).unwrap();
        assert_eq!(text(&import.stdout), written, "{file} {options:?}: {}", text(&import.stderr));
        let run = plateau(&["run", "x.toml", "--out", "out"]);
        assert!(run.status.success(), "{}", text(&run.stderr));
        let record = |path: &str| -> serde_json::Value {
            serde_json::from_slice(&fs::read(folder.path().join(path)).unwrap()).unwrap()
        };
        let (run, told) = (record("out/x/result.json"), record("x.json"));
        // Twelve digits are printed.
        let ran = run["methods"][0]["area"].as_f64().unwrap();
        assert!((ran / filled - 1.0).abs() < 1e-11, "{file} {options:?}: {ran} {filled}");
        assert_eq!(run["methods"][0]["faces"], told["methods"][0]["faces"]);
        let verified = plateau(&["verify", "x.json"]);
        assert!(verified.status.success(), "{}{}", text(&verified.stdout), text(&verified.stderr));
    }
}

/// A hexagon with a re-entrant corner, by straight sides.
const CONCAVE: &str = "v 0 0 0\nv 2 0 0.5\nv 2 1 0\nv 1 1 0.6\nv 1 2 0\nv 0 2 0.5\nl 1 2 3 4 5 6 1\n";

#[test]
fn a_layer_around_corners_comes_out_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("l.obj"), CONCAVE).unwrap();
    let without = area(&fill(folder.path(), &["l.obj"]));
    let outs = ["-o", "x.step", "-o", "x.obj", "-o", "x.toml", "-o", "x.json"];
    let out = fill(folder.path(), &[&["l.obj", "--layers", "1"], &outs[..]].concat());
    let with = area(&out);
    let printed = text(&out.stdout);
    assert!(printed.contains("42 of degree 6") && printed.contains("a layer of smaller ones"), "{printed}");
    // The least area to twelve digits, by other patches of higher degrees within layers of other widths.
    const LEAST: f64 = 3.180_501_003_610;
    assert!((with - LEAST).abs() < 1e-10 && with < without && (without - LEAST).abs() < 1e-7);
    let step = fs::read_to_string(folder.path().join("x.step")).unwrap();
    assert_eq!((step.matches("OPEN_SHELL").count(), step.matches("ADVANCED_FACE").count()), (1, 42));
    // Every edge is there once: a disc of 42 quads and 24 edges on the rim.
    assert_eq!(step.matches("=EDGE_CURVE(").count(), (42 * 4 + 24) / 2);
    let mesh = fs::read_to_string(folder.path().join("x.obj")).unwrap();
    let (vertices, triangles) = (mesh.matches("\nv ").count(), mesh.matches("\nf ").count());
    assert_eq!((vertices, triangles), (1 + (42 * 256 * 4 + 24 * 16) / 2 - 42 * 256, 42 * 2 * 256));
    assert!(fs::read_to_string(folder.path().join("x.toml")).unwrap().contains("\nlayers = 1\n"));
    let result = fs::read_to_string(folder.path().join("x.json")).unwrap();
    let result: serde_json::Value = serde_json::from_str(&result).unwrap();
    let method = &result["methods"][0];
    assert_eq!(method["faces"].as_array().unwrap().len(), 42);
    // Twelve digits are printed.
    assert!((method["area"].as_f64().unwrap() / with - 1.0).abs() < 1e-11);
    let verified = Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(["verify", "x.json"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(verified.status.success(), "{}", text(&verified.stdout));
}

#[test]
fn what_the_numbers_are_is_carried_to_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let scale = |path: &str| -> f64 {
        let bytes = fs::read(folder.path().join(path)).unwrap();
        let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        let root: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
        root["nodes"][0]["scale"][0].as_f64().unwrap_or(1.0)
    };
    for (comment, options, unit, metres) in [
        ("# inches\n", vec![], "CONVERSION_BASED_UNIT('INCH'", 0.0254),
        ("# Units: inches\n", vec!["--unit", "cm"], ".CENTI.,.METRE.", 0.01),
        ("", vec!["--unit", "mm"], ".MILLI.,.METRE.", 0.001),
        // Nothing is known: as ever.
        ("", vec![], ".MILLI.,.METRE.", 1.0),
    ] {
        fs::write(folder.path().join("rim.obj"), format!("{comment}{HEXAGON}")).unwrap();
        let out =
            fill(folder.path(), &[vec!["rim.obj", "-o", "x.step", "-o", "x.glb"], options.clone()].concat());
        assert!((area(&out) - 1.5 * SKEW).abs() < 1e-10);
        let step = fs::read_to_string(folder.path().join("x.step")).unwrap();
        assert!(step.contains(unit), "{unit}");
        assert_eq!(scale("x.glb"), metres);
        let said = text(&out.stderr);
        assert_eq!(said.contains("--unit says what they are"), metres == 1.0, "{said}");
        // The experiment, its result and what is exported of that know it, too.
        let toml = [&["rim.obj", "-o", "x.toml"], &options[..]].concat();
        assert!(fill(folder.path(), &toml).status.success());
        let experiment = fs::read_to_string(folder.path().join("x.toml")).unwrap();
        let output = if experiment.contains("[output]") { "" } else { "[output]\n" };
        let formats = "formats = [\"glb\"]\npictures = false\n";
        fs::write(folder.path().join("x.toml"), format!("{experiment}{output}{formats}")).unwrap();
        let plateau = |arguments: &[&str]| {
            let out = Command::new(env!("CARGO_BIN_EXE_plateau"))
                .args(arguments)
                .current_dir(folder.path())
                .output();
            text(&out.unwrap().stdout)
        };
        let said = plateau(&["run", "x.toml", "--out", "."]);
        assert_eq!(said.contains("in metres, as glTF is"), metres != 1.0, "{said}");
        assert_eq!(scale("x/least-area.glb"), metres);
        let said = plateau(&["export", "x/result.json", "--format", "glb", "--out", "y.glb"]);
        assert_eq!(said.contains("in metres, as glTF is"), metres != 1.0, "{said}");
        plateau(&["export", "x/result.json", "--format", "glb", "--unit", "ft", "--out", "z.glb"]);
        assert_eq!((scale("y.glb"), scale("z.glb")), (metres, 0.3048));
    }
}

#[test]
fn a_circle_is_met_as_near_as_the_tolerance_asks() {
    let folder = tempfile::tempdir().unwrap();
    let circle =
        "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nrim\n10\n0\n20\n0\n30\n0\n40\n1\n0\nENDSEC\n0\nEOF\n";
    fs::write(folder.path().join("rim.dxf"), circle).unwrap();
    let out = fill(folder.path(), &["rim.dxf", "--tolerance", "1e-11", "-o", "x.toml", "-o", "x.json"]);
    assert!((area(&out) / std::f64::consts::PI - 1.0).abs() < 1e-11, "{}", text(&out.stdout));
    let experiment = fs::read_to_string(folder.path().join("x.toml")).unwrap();
    assert!(experiment.contains("rim-tolerance = 1e-11"), "{experiment}");
    let result = fs::read_to_string(folder.path().join("x.json")).unwrap();
    let result: serde_json::Value = serde_json::from_str(&result).unwrap();
    assert!(result["methods"][0]["rim_deviation"].as_f64().unwrap() <= 1e-11);
    // A wide one leaves circles as they are.
    let out = fill(folder.path(), &["rim.dxf", "--tolerance", "0.1", "-o", "x.toml"]);
    assert!((area(&out) / std::f64::consts::PI - 1.0).abs() < 1e-5, "{}", text(&out.stdout));
    assert!(!fs::read_to_string(folder.path().join("x.toml")).unwrap().contains("rim-tolerance"));
}

#[test]
fn results_in_one_folder_keep_their_exports_apart() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("hexagon.obj"), HEXAGON).unwrap();
    fs::write(folder.path().join("l.obj"), CONCAVE).unwrap();
    for (file, result) in [("hexagon.obj", "a.json"), ("l.obj", "b.json"), ("l.obj", "result.json")] {
        assert!(fill(folder.path(), &[file, "-o", result]).status.success());
    }
    let mut files = Vec::new();
    for result in ["a.json", "b.json", "result.json"] {
        let out = Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(["export", result, "--format", "obj"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(out.status.success());
        files.push(text(&out.stdout).trim().to_owned());
    }
    assert_eq!(files[2], "least-area.obj");
    let content = |k: usize| fs::read_to_string(folder.path().join(&files[k])).unwrap();
    assert!(content(0) != content(1) && content(1) == content(2), "{files:?}");
}

#[test]
fn the_error_of_an_area_holds_that_of_its_rim() {
    let folder = tempfile::tempdir().unwrap();
    // 40 samples of a circle in a plane, met within a tolerance that shows.
    let row = |k: i32| {
        let (s, c) = (f64::from(k) * std::f64::consts::TAU / 40.0).sin_cos();
        format!("{c},{s},0\n")
    };
    let rows: String = (0..40).map(row).collect();
    fs::write(folder.path().join("circle.csv"), format!("x,y,z\n{rows}")).unwrap();
    let mut errors = Vec::new();
    for tolerance in ["1e-2", "1e-4", "1e-6"] {
        let out = fill(folder.path(), &["circle.csv", "--tolerance", tolerance]);
        let printed = text(&out.stdout);
        let error = printed.lines().next().unwrap().split(" ± ").nth(1).unwrap();
        let error: f64 = error.split([':', '\n']).next().unwrap().parse().unwrap();
        let off = (area(&out) - std::f64::consts::PI).abs();
        assert!(off <= error, "{tolerance}: {off} {error}");
        errors.push(error);
    }
    assert!(errors[2] < errors[1] && errors[1] < errors[0], "{errors:?}");
}
