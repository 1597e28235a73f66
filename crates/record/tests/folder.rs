//! The folder of a result over several runs: what belongs to the result is there, what no longer does is gone, and nothing
//! else is touched.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use experiment::{Options, Plan, run};
use plateau::Progress;
use record::{deliver, deliver_watched, earlier, verify};
use serde_json::Value;

const EXPERIMENT: &str = r#"
title = "A saddle"
[boundary]
u0 = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]
u1 = [[2, 0, 0], [2, 1, 1], [2, 2, 2]]
v0 = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
v1 = [[0, 2, 0], [1, 2, 1], [2, 2, 2]]
[[method]]
name = "GT"
basis = "gt"
energy = "dirichlet"
search = true
[search]
particles = 5
iterations = 5
runs = 2
[output]
mesh = 8
formats = ["obj", "step"]
"#;

fn made(text: &str, out: &Path) -> Plan {
    let plan = Plan::parse("x.toml", text).unwrap_or_else(|refusal| panic!("{refusal}"));
    deliver(&plan, &run(&plan, Options::default(), &()).unwrap(), out).unwrap();
    plan
}

fn names(folder: &Path) -> BTreeSet<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

fn record(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("result.json")).unwrap()).unwrap()
}

#[test]
fn what_a_result_no_longer_names_is_removed_and_nothing_else() {
    let out = tempfile::tempdir().unwrap();
    let folder = out.path().join("x");
    made(EXPERIMENT, out.path());
    assert!(
        ["convergence.svg", "report.html", "gt.obj", "gt.step"]
            .iter()
            .all(|name| names(&folder).contains(*name))
    );
    // Files of others: a picture, an export that no record names, a neighbour of the folder.
    for name in ["x/mine.svg", "x/gt.ply", "mine.html"] {
        fs::write(out.path().join(name), "mine").unwrap();
    }
    // A record that was tampered with leads nowhere else.
    let path = folder.join("result.json");
    let mut damaged = record(&folder);
    damaged["files"].as_array_mut().unwrap().push(serde_json::json!({ "file": "../mine.html" }));
    fs::write(&path, damaged.to_string()).unwrap();
    let plain = EXPERIMENT.replace("search = true", "shape = [1.0, 1.0, 1.0, 1.0]");
    made(&plain.replace("formats = [\"obj\", \"step\"]", "pictures = false"), out.path());
    assert!(names(&folder).iter().eq(["gt.ply", "mine.svg", "result.json"]), "{:?}", names(&folder));
    assert!(out.path().join("mine.html").is_file());
}

#[test]
fn a_planted_record_removes_nothing() {
    let plain = EXPERIMENT.replace("formats = [\"obj\", \"step\"]", "pictures = false\nformats = [\"obj\"]");
    let foreign = ["thesis.tex", "thesis.obj", "mine.svg", "other.step"];
    let named =
        |files: &[&str]| files.iter().map(|file| serde_json::json!({ "file": file })).collect::<Vec<_>>();
    for sound in [false, true] {
        let out = tempfile::tempdir().unwrap();
        let folder = out.path().join("x");
        made(&plain, out.path());
        for name in foreign {
            fs::write(folder.join(name), "mine").unwrap();
        }
        fs::write(out.path().join("vv"), "mine").unwrap();
        let everything =
            named(&["thesis.tex", "result.json", "../vv", "gt.obj", "GT.obj", "checkpoint", "mine.svg"]);
        // Another experiment's record may name anything as its own; this one's may name what it can have written.
        let bare = serde_json::json!({ "schema": "plateau-result/1" });
        let mut planted = if sound { record(&folder) } else { bare };
        planted["files"] = everything.into();
        planted["methods"] = serde_json::json!([
            { "name": "GT", "files": named(&["thesis.obj", "result.json", "gt.obj", "gt.json"]) },
            { "name": "Other", "files": named(&["other.step"]) },
        ]);
        if sound {
            planted["manifest"]["file"] = "elsewhere.toml".into();
        }
        fs::write(folder.join("result.json"), planted.to_string()).unwrap();
        made(&plain, out.path());
        let expected = BTreeSet::from(foreign.map(str::to_owned))
            .into_iter()
            .chain(["gt.obj", "result.json"].map(str::to_owned));
        assert_eq!(names(&folder), expected.collect());
        assert!(out.path().join("vv").is_file());
    }
}

#[test]
fn files_of_every_kind_go_when_they_are_not_asked_for_any_more() {
    let curve =
        "title = \"c\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0, 0], [1, 1], [2, 0]]\nsamples = 5\n";
    let helicoid = "title = \"h\"\n[helicoid]\na = 1.0\nb = 2.0\nu-span = 1.0\nv-span = 1.0\nframes = 3\n\
                    [output]\nmesh = 4\nformats = [\"glb\"]\n";
    let bare =
        EXPERIMENT.replace("formats = [\"obj\", \"step\"]", "pictures = false").replace("search = true", "");
    let bare = bare.replace("basis = \"gt\"", "");
    for text in [EXPERIMENT, curve, helicoid] {
        let out = tempfile::tempdir().unwrap();
        made(text, out.path());
        assert!(names(&out.path().join("x")).len() > 2);
        made(&bare, out.path());
        assert!(
            names(&out.path().join("x")).iter().eq(["result.json"]),
            "{:?}",
            names(&out.path().join("x"))
        );
    }
}

#[cfg(unix)]
#[test]
fn pipes_in_the_folder_keep_nobody_waiting() {
    let out = tempfile::tempdir().unwrap();
    let folder = out.path().join("x");
    fs::create_dir(&folder).unwrap();
    for name in ["result.json", "checkpoint", ".plateau-abcdef"] {
        let made = std::process::Command::new("mkfifo").arg(folder.join(name)).status().unwrap();
        assert!(made.success());
    }
    let plan = Plan::parse("x.toml", EXPERIMENT).unwrap();
    let _claim = record::prepare(&plan, out.path()).unwrap();
    assert!(earlier(&plan, Options::default(), out.path()).is_none());
    let manifest = record::Manifest::new(&plan, Options::default());
    let checkpoint = record::Checkpoint::new(&folder, manifest, std::time::Duration::ZERO);
    assert!(checkpoint.load().unwrap_err().to_string().contains("not a regular file"));
    made(EXPERIMENT, out.path());
    checkpoint.remove().unwrap();
    assert!(fs::symlink_metadata(folder.join("result.json")).unwrap().is_file());
    assert!(folder.join("checkpoint").exists() && folder.join(".plateau-abcdef").exists());
}

#[test]
fn a_result_lacking_one_of_its_files_is_run_again() {
    let curve =
        "title = \"c\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0, 0], [1, 1], [2, 0]]\nsamples = 5\n";
    let helicoid = "title = \"h\"\n[helicoid]\na = 1.0\nb = 2.0\nu-span = 1.0\nv-span = 1.0\nframes = 3\n\
                    [output]\nmesh = 4\nformats = [\"glb\"]\n";
    for (text, least) in [(EXPERIMENT, 6), (curve, 3), (helicoid, 7)] {
        let out = tempfile::tempdir().unwrap();
        let folder = out.path().join("x");
        let plan = made(text, out.path());
        let files = names(&folder);
        assert!(files.len() > least, "{files:?}");
        for name in &files {
            assert!(earlier(&plan, Options::default(), out.path()).is_some());
            let bytes = fs::read(folder.join(name)).unwrap();
            fs::remove_file(folder.join(name)).unwrap();
            assert!(earlier(&plan, Options::default(), out.path()).is_none(), "without {name}");
            fs::write(folder.join(name), bytes).unwrap();
        }
    }
}

/// Somebody who has seen enough.
struct Impatient;

impl Progress for Impatient {
    fn begin(&self, _: &str, _: Option<u64>) {}
    fn step(&self) {}
    fn end(&self) {}
    fn cancelled(&self) -> bool {
        true
    }
}

#[test]
fn an_interruption_costs_files_but_no_number() {
    let out = tempfile::tempdir().unwrap();
    let folder = out.path().join("x");
    let plan = Plan::parse("x.toml", EXPERIMENT).unwrap();
    let finished = run(&plan, Options::default(), &()).unwrap();
    let delivered = deliver_watched(&plan, &finished, out.path(), &Impatient).unwrap();
    assert_eq!(delivered.record.unwritten(), ["gt.obj", "gt.step", "report.html"]);
    assert!(names(&folder).iter().eq(["result.json"]));
    assert!(earlier(&plan, Options::default(), out.path()).is_none());
    assert!(verify(&folder.join("result.json"), &()).unwrap().agrees());
    made(EXPERIMENT, out.path());
    assert!(earlier(&plan, Options::default(), out.path()).is_some());
}

#[test]
fn results_stay_inside_the_folder_asked_for() {
    for file in ["..toml", "...toml", "a/..", ""] {
        assert_eq!(Plan::parse(file, EXPERIMENT).unwrap().stem, "experiment", "{file}");
    }
}
