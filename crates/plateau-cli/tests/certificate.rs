//! What is said to be proved can be verified without our code.
#![allow(clippy::print_stderr, reason = "what was left out is told")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// The checker of the book, by Python; none where it or mpmath is missing.
fn checked(result: &Path) -> Option<Output> {
    let has_mpmath = Command::new("python3").args(["-c", "import mpmath"]).output();
    if !has_mpmath.is_ok_and(|out| out.status.success()) {
        eprintln!("no python3 with mpmath: only the record is looked at");
        return None;
    }
    let checker = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reliability/certificate.py");
    Some(Command::new("python3").arg(checker).arg(result).output().unwrap())
}

/// The result of an experiment with the least area over a boundary and its bound.
fn result(folder: &Path, boundary: &str, degree: &str) -> Value {
    let method = format!("[[method]]\nname = \"least\"\nenergy = \"area\"\n{degree}\nbound = true\n");
    fs::write(folder.join("x.toml"), format!("title = \"x\"\n[boundary]\n{boundary}\n{method}")).unwrap();
    let out = Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(["run", "x.toml", "--out", "."])
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let bound = String::from_utf8_lossy(&out.stdout).lines().any(|line| line.contains("(proved of every "));
    let value: Value = serde_json::from_slice(&fs::read(folder.join("x/result.json")).unwrap()).unwrap();
    assert_eq!(bound, value["methods"][0]["lower_bound"].is_number());
    value
}

#[test]
fn certificates_are_confirmed_and_forged_ones_refused() {
    let boundaries = [
        (
            "v0 = [[0,0,0],[1,0,0]]\nv1 = [[0,1,0],[1,1,1]]\nu0 = [[0,0,0],[0,1,0]]\nu1 = [[1,0,0],[1,1,1]]",
            "raise = 2",
        ),
        // A tensor net of degrees (2, 1), which is raised to (2, 2).
        (
            "v0 = [[0,0,0],[1,0,1],[2,0,0]]\nv1 = [[0,1,0],[1,1,0],[2,1,1]]\nu0 = [[0,0,0],[0,1,0]]\nu1 = [[2,0,0],[2,1,1]]",
            "raise = 2",
        ),
        ("polygon = [[0,0,0],[1,0,0],[1.5,0.8,0.3],[0.5,1.5,0],[-0.5,0.8,0.2]]", "degree = 3"),
    ];
    for (boundary, degree) in boundaries {
        let folder = tempfile::tempdir().unwrap();
        let mut result = result(folder.path(), boundary, degree);
        let method = &result["methods"][0];
        let (bound, area) = (method["lower_bound"].as_f64().unwrap(), method["area"].as_f64().unwrap());
        assert!(bound <= area && area - bound < 1e-3 * area, "{bound} {area}");
        assert_eq!(method["lower_bound_proof"]["holds_for"], "every surface with this rim");
        let path = folder.path().join("x/result.json");
        let Some(out) = checked(&path) else { continue };
        assert!(
            out.status.success(),
            "{}{}",
            String::from_utf8_lossy(&out.stdout),
            String::from_utf8_lossy(&out.stderr)
        );
        result["methods"][0]["lower_bound"] = (bound * (1.0 + 1e-5)).into();
        fs::write(&path, result.to_string()).unwrap();
        let out = checked(&path).unwrap();
        assert_eq!(out.status.code(), Some(1), "{}", String::from_utf8_lossy(&out.stderr));
        assert!(String::from_utf8_lossy(&out.stdout).starts_with("refused: "));
    }
}

#[test]
fn what_is_no_graph_has_no_bound_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    // Two circles one above the other.
    let loops = "loops = [[\"a\"], [\"b\"]]\n[[curve]]\nname = \"a\"\ncircle = { center = [0,0,0], normal = [0,0,1], radius = 1 }\n\
                 [[curve]]\nname = \"b\"\ncircle = { center = [0,0,0.6], normal = [0,0,1], radius = 1 }";
    let result = result(folder.path(), loops, "degree = 4");
    let method = &result["methods"][0];
    assert!(method["lower_bound"].is_null() && method["lower_bound_proof"].is_null());
    let warnings = method["warnings"].as_array().unwrap();
    assert!(
        warnings.iter().any(|w| w.as_str().unwrap().starts_with("no lower bound of the area: ")),
        "{warnings:?}"
    );
}
