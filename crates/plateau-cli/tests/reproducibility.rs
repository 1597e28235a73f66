//! The levels at which results repeat: the same bytes on any number of threads (R1), the same figures in the other arithmetic
//! (R3); and `verify`, by which a user sees it.
#![allow(clippy::print_stdout)] // the ignored test says what it did

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use experiment::{Finished, Options, Plan, run};
use plateau::Arithmetic;
use record::{Level, ResultFile, earlier, verify};
use serde_json::Value;

fn fixture(name: &str) -> Plan {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    Plan::read(folder.join(name)).expect("a sound fixture")
}

fn json(plan: &Plan, finished: &Finished) -> String {
    ResultFile::new(plan, finished).to_json().unwrap()
}

/// Results for several numbers of threads and seeds; how many were compared.
fn same_bytes(names: &[&str], seeds: u64, threads: &[usize]) -> usize {
    let mut compared = 0;
    for name in names {
        let plan = fixture(name);
        let mut different = std::collections::BTreeSet::new();
        for seed in 0..seeds {
            let options = Options { seed: Some(seed), ..Options::default() };
            let result = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| json(&plan, &run(&plan, options, &()).unwrap()))
            };
            let one = result(1);
            for &threads in threads {
                assert!(one == result(threads), "{name}, seed {seed}, {threads} threads");
                compared += 1;
            }
            different.insert(one);
        }
        assert_eq!(different.len() as u64, seeds, "{name}: the seed shows");
    }
    compared
}

/// Small and large nets, both swarms, both ways to evaluate the energy, and no search at all.
const SEARCHES: [&str; 3] = ["gt-5.1.toml", "gt-5.2-local.toml", "degree-5-4.toml"];

#[test]
fn some_threads_and_seeds_give_the_same_bytes() {
    assert_eq!(same_bytes(&SEARCHES, 2, &[2, 3, 8]), 18);
}

#[test]
#[ignore = "a minute: `just repeat`"]
fn all_threads_and_seeds_give_the_same_bytes() {
    let compared = same_bytes(&SEARCHES, 20, &[1, 2, 3, 4, 8, 16]);
    println!(
        "{compared} results of 3 fixtures, 20 seeds and 1 to 16 threads: the same bytes as on one thread"
    );
    assert_eq!(compared, 360);
}

#[test]
fn the_manifest_knows_no_place_and_no_threads() {
    let folder = tempfile::tempdir().unwrap();
    let text = fixture("gt-5.1.toml").text;
    let mut records = Vec::new();
    for (k, threads) in ["1", "3"].into_iter().enumerate() {
        let place = folder.path().join(format!("place-{k}"));
        fs::create_dir(&place).unwrap();
        fs::write(place.join("x.toml"), &text).unwrap();
        let output = plateau(&["run", place.join("x.toml").to_str().unwrap(), "--threads", threads], &place);
        assert_eq!(output.status.code(), Some(0));
        let files = ["result.json", "report.html"].map(|name| place.join("out/x").join(name));
        records.push(files.map(|file| fs::read_to_string(file).unwrap()));
    }
    assert!(records[0] == records[1]);
    let record: Value = serde_json::from_str(&records[0][0]).unwrap();
    let manifest = &record["manifest"];
    assert_eq!(manifest["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!((&manifest["file"], &manifest["seed"]), (&"x.toml".into(), &7.into()));
    assert_eq!(manifest["experiment"].as_str(), Some(text.as_str()));
    assert!(manifest["toolchain"].as_str().unwrap().starts_with("rustc "));
    for key in ["sha256", "lockfile_sha256"] {
        assert_eq!(manifest[key].as_str().unwrap().len(), 64, "{key}");
        assert!(records[0][1].contains(manifest[key].as_str().unwrap()), "{key} is in the report, too");
    }
}

/// Both arithmetics, compared as `verify` compares results of different processors.
#[test]
fn the_arithmetic_shows_in_no_figure() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("result.json");
    for name in ["gt-5.1.toml", "gt-5.2.toml", "gt-5.2-local.toml", "degree-5-4.toml", "tb-coons-5.1.toml"] {
        let options = Options { arithmetic: Arithmetic::Portable, ..Options::default() };
        let plan = fixture(name);
        let record = json(&plan, &run(&plan, options, &()).unwrap());
        assert!(record.contains("\"arithmetic\": \"portable\""));
        // As if from an older program: the figures are what is compared; and with the other arithmetic, if there is one.
        let elsewhere = record.replace("\"version\": \"0", "\"version\": \"00");
        let elsewhere = elsewhere.replace("\"arithmetic\": \"portable\"", "\"arithmetic\": \"auto\"");
        fs::write(&path, elsewhere).unwrap();
        let verification = verify(&path, &()).unwrap();
        assert!(verification.level == Level::Figures { because: vec!["version"] });
        assert!(verification.agrees(), "{name}: {verification:?}");
    }
}

fn plateau(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_plateau")).args(arguments).current_dir(folder).output().unwrap()
}

fn said(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn every_kind_of_result_verifies_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let names = [
        "degree-5-4.toml",
        "gt-6.1-case-1-net-5.1.toml",
        "tri-ni1-n3.toml",
        "helicoid-deformation.toml",
        "helicoid-ten-turns.toml",
        "trapezium-helicoid.toml",
        "trapezium-helicoid-geometric.toml",
        "net-aht.toml",
        "net-at.toml",
        "curve-aht.toml",
        "curve-gt-figure-1.toml",
        "curve-at-conical-spiral.toml",
        "curve-aht-catenary.toml",
        "area-saddle.toml",
    ];
    let mut results = Vec::new();
    for name in names {
        let mut text = fixture(name).text;
        if !text.contains("[output]") && !name.starts_with("curve") {
            text += "\n[output]\nformats = [\"step\", \"obj\"]\npictures = false\n";
        }
        fs::write(folder.path().join(name), text).unwrap();
        results.push(format!("out/{}/result.json", name.strip_suffix(".toml").unwrap()));
    }
    // A method that fails, and one that does not.
    let failing = fixture("tri-ni1-n3.toml").text;
    let failing = failing.split("[[method]]").next().unwrap().to_owned()
        + "[[method]]\nname = \"first\"\nenergy = \"dirichlet\"\n\
           [[method]]\nname = \"second\"\nraise = 3\nmask = \"coons\"\n";
    fs::write(folder.path().join("failing.toml"), failing).unwrap();
    results.push("out/failing/result.json".into());
    let output = plateau(&[&["run", "failing.toml"][..], &names].concat(), folder.path());
    assert_eq!(output.status.code(), Some(1), "{}", said(&output.stderr));
    let record = fs::read_to_string(folder.path().join("out/failing/result.json")).unwrap();
    assert!(record.contains("\"error\": ") && record.contains("\"dirichlet\": "), "{record}");

    let results: Vec<&str> = results.iter().map(String::as_str).collect();
    let output = plateau(&[&["verify"][..], &results].concat(), folder.path());
    let report = said(&output.stdout);
    assert_eq!((output.status.code(), said(&output.stderr)), (Some(0), ""), "{report}");
    assert_eq!(report.matches("compared bit for bit").count(), results.len(), "{report}");
    assert!(report.contains("  first   equal, ") && report.contains("  second  equal, 2 values"), "{report}");
    let output = plateau(&["verify", "--json", results[0], "--threads", "3"], folder.path());
    let verification: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&verification["equal"], &verification["level"]), (&true.into(), &"bits".into()));
}

/// The number changed in the last digit that matters.
fn changed(number: &str) -> String {
    let digits = number.bytes().enumerate().rev().filter(|(_, byte)| byte.is_ascii_digit());
    let other = |(at, byte): (usize, u8)| {
        let digit = if byte == b'9' { '8' } else { char::from(byte + 1) };
        format!("{}{digit}{}", &number[..at], &number[at + 1..])
    };
    let value = |text: &str| text.parse::<f64>().unwrap();
    digits.map(other).find(|other| value(other) != value(number)).expect("some digit matters")
}

/// Numbers all over a record, changed one at a time.
#[test]
fn a_changed_number_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let text = fixture("degree-5-4.toml").text.replace("runs = 10", "runs = 2");
    let text = text.replace("iterations = 100", "iterations = 5").replace("particles = 50", "particles = 4");
    fs::write(folder.path().join("x.toml"), text + "\n[output]\nformats = [\"step\"]\npictures = false\n")
        .unwrap();
    plateau(&["run", "x.toml"], folder.path());
    let path = folder.path().join("out/x/result.json");
    let record = fs::read_to_string(&path).unwrap();
    let end = record.find("\"manifest\"").unwrap();
    let (mut numbers, mut in_bits_only) = (0, 0);
    for (at, _) in record[..end].match_indices(['\n', ',']) {
        let number = record[..at].rsplit([' ', '\n']).next().unwrap_or_default();
        if number.parse::<f64>().is_err() {
            continue;
        }
        numbers += 1;
        if numbers % 29 != 0 {
            continue;
        }
        fs::write(&path, [&record[..at - number.len()], &changed(number), &record[at..]].concat()).unwrap();
        let verification = verify(&path, &()).unwrap();
        let differences: usize = verification.entries.iter().map(|entry| entry.differences.len()).sum();
        assert_eq!(differences, 1, "{number}: {verification:?}");
        in_bits_only += verification.entries.iter().filter(|entry| entry.differs_in_bits_only).count();
    }
    assert!(numbers > 300 && in_bits_only > 0, "{numbers} {in_bits_only}");

    let other = record.replace("title = \\\"", "title = \\\"Not ");
    assert_ne!(other, record);
    fs::write(&path, other).unwrap();
    let output = plateau(&["verify", "out/x/result.json"], folder.path());
    assert_eq!(output.status.code(), Some(1));
    let report = said(&output.stdout);
    assert!(report.contains("title: the file has") && report.contains("sha256: the file has"), "{report}");
}

#[test]
fn what_is_no_result_has_status_2() {
    let folder = tempfile::tempdir().unwrap();
    let early = r#"{"schema": "plateau-result/1", "title": "early", "seed": 0, "methods": []}"#;
    let cases = [
        ("early.json", early, "`manifest` is missing"),
        ("other.json", r#"{"schema": "other/1"}"#, "`schema` is \"other/1\""),
        ("toml.json", "title = 1", "should be a result.json of `plateau run`"),
        ("empty.json", "", "should be a result.json of `plateau run`"),
        ("list.json", "[]", "`schema` is missing"),
        ("manifest.json", r#"{"schema": "plateau-result/1", "manifest": 3}"#, "`manifest`: "),
    ];
    for (name, text, words) in cases {
        fs::write(folder.path().join(name), text).unwrap();
        let output = plateau(&["verify", name], folder.path());
        assert_eq!(output.status.code(), Some(2), "{name}");
        let error = said(&output.stderr);
        assert!(error.starts_with(&format!("error: {name}: ")) && error.contains(words), "{error}");
    }
    let output = plateau(&["verify", "there-is-none.json"], folder.path());
    assert_eq!(output.status.code(), Some(2));
    // The old reader needs no manifest.
    assert!(record::StoredResult::parse(early.as_bytes()).is_ok());
}

#[test]
fn only_the_same_experiment_with_all_its_files_is_done_already() {
    let folder = tempfile::tempdir().unwrap();
    let text = fixture("area-saddle.toml").text + "\n[output]\nformats = [\"obj\"]\npictures = false\n";
    fs::write(folder.path().join("x.toml"), &text).unwrap();
    plateau(&["run", folder.path().join("x.toml").to_str().unwrap()], folder.path());
    let out = folder.path().join("out");
    let plan = Plan::read(folder.path().join("x.toml")).unwrap();
    let options = Options::default();
    assert!(earlier(&plan, options, &out).is_some());
    assert!(earlier(&plan, Options { seed: Some(1), ..options }, &out).is_none());
    assert!(earlier(&plan, Options { arithmetic: Arithmetic::Portable, ..options }, &out).is_none());
    let mut other = Plan::parse("x.toml", &(text + "# a remark\n")).unwrap();
    other.stem = plan.stem.clone();
    assert!(earlier(&other, options, &out).is_none());
    let obj = fs::read_dir(out.join("x")).unwrap().find_map(|entry| {
        let path = entry.unwrap().path();
        path.extension().is_some_and(|e| e == "obj").then_some(path)
    });
    fs::remove_file(obj.unwrap()).unwrap();
    assert!(earlier(&plan, options, &out).is_none());
}
