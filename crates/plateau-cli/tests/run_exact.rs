//! The command on helicoids and curves: exit status, table, files.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

const HELICOID: &str = r#"
title = "A helicoid"
[helicoid]
a = 1.0
b = 2.0
u-span = 1.5
v-span = 6.0
[expect]
deviation = { value = 0.0, tolerance = 1e-13 }
[output]
mesh = 8
formats = ["obj", "glb"]
"#;

const CURVE: &str = r#"
title = "A curve"
[curve]
basis = "gt"
shape = [1.0, 2.0]
points = [[0, 0], [1, 2], [3, 2], [4, 0]]
samples = [0.0, 0.25, 1.0]
[output]
formats = ["glb"]
"#;

/// Runs `text` as `experiment.toml`; status, stdout, stderr, and the record if there is one.
fn run(folder: &Path, text: &str) -> (i32, String, String, Option<Value>) {
    let file = folder.join("experiment.toml");
    std::fs::write(&file, text).unwrap();
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(["run", "--quiet", "--out"])
        .arg(folder.join("out"))
        .arg(file)
        .output()
        .unwrap();
    let record = std::fs::read_to_string(folder.join("out/experiment/result.json")).ok().map(|text| {
        assert!(!text.contains("null"), "{text}");
        serde_json::from_str(&text).unwrap()
    });
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr), record)
}

fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder.join("out/experiment")).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

#[test]
fn a_helicoid_in_one_piece() {
    let folder = tempfile::tempdir().unwrap();
    let (status, stdout, stderr, record) = run(folder.path(), HELICOID);
    assert_eq!((status, stderr.as_str()), (0, ""), "{stdout}");
    assert!(stdout.contains("deviation") && stdout.contains("expected numbers: 1 of 1 met"), "{stdout}");
    assert_eq!(
        files(folder.path()),
        ["helicoid.glb", "helicoid.obj", "report.html", "result.json", "surfaces.svg"]
    );
    let record = record.unwrap();
    let [method] = record["methods"].as_array().unwrap().as_slice() else { panic!("{record}") };
    assert_eq!(numbers(&method["weights"]), [1.0, 2.0]);
    assert!((method["area"].as_f64().unwrap() - 97.634_061_955_574_27).abs() < 1e-10);
    assert!(method["deviation"].as_f64().unwrap() < 1e-13);
    let net = method["net"].as_array().unwrap();
    assert_eq!((net.len(), net[0].as_array().unwrap().len()), (6, 6));
    assert_eq!(numbers(&net[0][0]), [0.0, 2.0, 0.0]);
    assert!(method["pieces"].is_null() && method["search"].is_null() && method["shape"].is_null());
}

#[test]
fn a_long_helicoid_is_cut_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let (status, stdout, _, record) = run(
        folder.path(),
        &HELICOID.replace("u-span = 1.5\nv-span = 6.0", "u-span = 8\nv-span = 21").replace("1e-13", "1e-11"),
    );
    assert_eq!(status, 0, "{stdout}");
    assert!(
        stdout.contains("u-span = 8 is cut into 2 equal parts: one patch holds spans below 7.8532"),
        "{stdout}"
    );
    assert!(stdout.contains("v-span = 21 is cut into 3 equal parts"), "{stdout}");
    let method = &record.unwrap()["methods"][0];
    let pieces = method["pieces"].as_array().unwrap();
    assert_eq!((pieces.len(), method["net"].is_null()), (6, true));
    assert_eq!((numbers(&pieces[5]["u"]), numbers(&pieces[0]["v"])), (vec![4.0, 8.0], vec![0.0, 7.0]));
    // Neighbours share a row of the net to rounding.
    let edge = |piece: usize, j: usize| -> Vec<f64> {
        (0..6).flat_map(|i| numbers(&pieces[piece]["net"][i][j])).collect()
    };
    let gap = edge(0, 5).iter().zip(edge(1, 0)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = edge(0, 5).iter().map(|x| x.abs()).fold(0.0, f64::max);
    assert!(gap <= 1e-14 * size, "{gap} of {size}");
}

#[test]
fn a_deformation_has_all_frames_and_one_animation() {
    let folder = tempfile::tempdir().unwrap();
    let text = HELICOID.replace("v-span", "frames = 5\npath = \"linear\"\nv-span");
    let (status, stdout, _, record) = run(folder.path(), &text);
    assert_eq!(status, 0, "{stdout}");
    assert!(stdout.contains("expected numbers: 6 of 6 met"), "{stdout}");
    let names = files(folder.path());
    assert_eq!(names.iter().filter(|name| name.starts_with("frame-")).count(), 10, "{names:?}");
    assert!(names.contains(&"frame-3-of-5.glb".into()) && names.contains(&"deformation.glb".into()));
    let record = record.unwrap();
    let methods = record["methods"].as_array().unwrap();
    assert_eq!((methods.len(), methods[2]["name"].as_str()), (6, Some("frame 2 of 5")));
    assert_eq!(numbers(&methods[2]["weights"]), [0.75, 0.25]);
    let [first, last] = [&methods[1]["net"], &methods[5]["net"]].map(|net| numbers(&net[2][3]));
    let middle = numbers(&methods[3]["net"][2][3]);
    for d in 0..3 {
        assert!((middle[d] - 0.5 * (first[d] + last[d])).abs() < 1e-13);
    }
    let animation = std::fs::read(folder.path().join("out/experiment/deformation.glb")).unwrap();
    assert_eq!(&animation[..8], b"glTF\x02\0\0\0");
}

#[test]
fn a_trapezium_helicoid_runs_and_a_missed_number_shows_in_the_status() {
    let text = "title = \"T\"\n[trapezium-helicoid]\nspan = 3.9\ngamma = [6.2, 12.5]\nbeta = [1.0, 0.5]\n\
                [expect]\narea = 223.69007\n";
    let folder = tempfile::tempdir().unwrap();
    let (status, stdout, _, record) = run(folder.path(), text);
    assert_eq!(status, 0, "{stdout}");
    let net = record.unwrap()["methods"][0]["net"].as_array().unwrap().len();
    assert_eq!(net, 2);
    let (status, _, stderr, _) = run(folder.path(), &text.replace("223.69007", "223.69008"));
    assert_eq!(status, 1);
    assert!(stderr.contains("experiment.toml:7") && stderr.contains("area = 223.69008 expected"), "{stderr}");
}

#[test]
fn a_curve_is_sampled() {
    let folder = tempfile::tempdir().unwrap();
    let (status, stdout, _, record) = run(folder.path(), CURVE);
    assert_eq!(status, 0, "{stdout}");
    assert!(stdout.contains("largest |κ|") && stdout.contains("GT, degree 3, θ = (1, 2)"), "{stdout}");
    assert!(stdout.contains("note: a curve has no mesh: nothing is written as glb"), "{stdout}");
    assert_eq!(files(folder.path()), ["curvature.svg", "curve.csv", "report.html", "result.json"]);
    let curve = &record.unwrap()["curve"];
    assert_eq!(numbers(&curve["t"]), [0.0, 0.25, 1.0]);
    for (key, width) in [("basis", 4), ("basis_d1", 4), ("basis_d2", 4), ("point", 2), ("d1", 2), ("d2", 2)] {
        let rows: Vec<Vec<f64>> = curve[key].as_array().unwrap().iter().map(numbers).collect();
        assert_eq!(rows.iter().map(Vec::len).collect::<Vec<_>>(), [width; 3], "{key}");
    }
    // GT (2.3): the end tangent is (n − 2 + θ₁π/4)(P₁ − P₀).
    let tangent = 1.0 + std::f64::consts::FRAC_PI_4;
    let d1 = numbers(&curve["d1"][0]);
    assert!((d1[0] - tangent).abs() < 1e-14 && (d1[1] - 2.0 * tangent).abs() < 1e-14);
    assert!((numbers(&curve["curvature"])[1] + 0.409_644_988_560_6).abs() < 1e-12);
    let csv = std::fs::read_to_string(folder.path().join("out/experiment/curve.csv")).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!((lines.len(), lines[0]), (4, "t,x,y,d1_x,d1_y,d2_x,d2_y,curvature"));
    assert_eq!(
        lines[3].split(',').next_back().unwrap().parse::<f64>().unwrap(),
        numbers(&curve["curvature"])[2]
    );
}

#[test]
fn a_cusp_leaves_the_list_of_curvatures_out_and_its_cell_empty() {
    let folder = tempfile::tempdir().unwrap();
    let text = CURVE
        .replace("[output]\nformats = [\"glb\"]\n", "")
        .replace("[[0, 0], [1, 2]", "[[0, 0], [0, 0]")
        .replace("samples = [", "samples = [0.5, ");
    let (status, stdout, _, record) = run(folder.path(), &text);
    assert_eq!(status, 0, "{stdout}");
    assert!(stdout.contains("note: the tangent vanishes at t = 0:"), "{stdout}");
    let curve = &record.unwrap()["curve"];
    assert!(curve["curvature"].is_null() && curve["point"].as_array().unwrap().len() == 4);
    let csv = std::fs::read_to_string(folder.path().join("out/experiment/curve.csv")).unwrap();
    let empty: Vec<bool> = csv.lines().skip(1).map(|line| line.ends_with(',')).collect();
    assert_eq!(empty, [false, true, false, false]);
    // What is expected of the singular sample is missed, of the others it is compared.
    let (status, stdout, stderr, _) = run(folder.path(), &(text + "[expect]\ncurvature = 0.0\n"));
    assert_eq!(status, 1, "{stdout}");
    assert!(stderr.contains("curvature[1] = 0.0 expected, there is no such figure"), "{stderr}");
}

#[test]
fn derivatives_beyond_double_precision_end_with_status_1_and_no_record() {
    let folder = tempfile::tempdir().unwrap();
    let text = "title = \"t\"\n[curve]\nbasis = \"at\"\nspan = 1e-100\nsamples = 3\n\
                points = [[0,0],[1e150,0],[0,1e150],[0,0],[1,1],[2,2]]\n";
    let (status, _, stderr, record) = run(folder.path(), text);
    assert_eq!((status, record), (1, None));
    assert!(stderr.contains("beyond double precision"), "{stderr}");
}
