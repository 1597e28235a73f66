//! The command as its users type it: what lands on stdout, and the exit status.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn plateau(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the command starts")
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).expect("UTF-8")
}

#[test]
fn reproduce_needs_no_files_and_leaves_none() {
    let folder = tempfile::tempdir().unwrap();
    let table = plateau(&["reproduce"], folder.path());
    assert_eq!(table.status.code(), Some(0));
    assert!(
        stdout(&table).contains("38.0000   38.3538   misprint: ") && stdout(&table).contains(", 0 missed")
    );
    let json: Value =
        serde_json::from_slice(&plateau(&["reproduce", "--json"], folder.path()).stdout).unwrap();
    assert_eq!(json["schema"], "plateau-reproduction/1");
    assert_eq!(json["entries"][0]["verdict"], "agrees");
    assert_eq!(json["faults"], serde_json::json!([]));
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
}

#[test]
fn the_result_on_stdout_is_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let template = plateau(&["new", "triangle"], folder.path());
    std::fs::write(folder.path().join("triangle.toml"), &template.stdout).unwrap();
    let output = plateau(&["run", "--json", "triangle.toml"], folder.path());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let file = std::fs::read(folder.path().join("out/triangle/result.json")).unwrap();
    assert_eq!(output.stdout, file);
    assert_eq!(serde_json::from_slice::<Value>(&file).unwrap()["schema"], "plateau-result/1");
}

#[test]
fn a_missed_number_is_told_on_stderr_and_by_the_status_whatever_stdout_holds() {
    let folder = tempfile::tempdir().unwrap();
    let template = plateau(&["new", "helicoid"], folder.path());
    let wrong =
        stdout(&template).replace("conformality-gap = { value = 0.0,", "conformality-gap = { value = 1.0,");
    std::fs::write(folder.path().join("wrong.toml"), wrong).unwrap();
    for arguments in [&["run", "--json", "wrong.toml"][..], &["run", "wrong.toml"]] {
        let output = plateau(arguments, folder.path());
        assert_eq!(output.status.code(), Some(1));
        assert!(std::str::from_utf8(&output.stderr).unwrap().contains("conformality-gap = 1.0 expected"));
    }
}

#[test]
fn the_manual_page_and_the_schema_are_printed() {
    let folder = std::env::temp_dir();
    let page = plateau(&["man"], &folder);
    assert!(stdout(&page).starts_with(".ie") || stdout(&page).contains(".TH plateau 1"));
    for section in ["PLATEAU RUN", "PLATEAU REPRODUCE", "EXIT STATUS"] {
        assert!(stdout(&page).contains(&format!(".SH \"{section}\"")), "{section}");
    }
    assert!(stdout(&page).contains("\\-\\-threads"));
    assert_eq!(stdout(&plateau(&["schema"], &folder)), experiment::experiment_schema());
}
