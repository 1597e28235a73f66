//! Sweeps as a cluster runs them: shards by argument and by scheduler, killed, doubled and out of room, and their table.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

const SWEEP: &str = r#"
title = "Saddles"
[boundary]
u0 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]]
u1 = [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]]
v1 = [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
[[method]]
name = "Least area"
energy = "area"
raise = 2
[output]
pictures = false
mesh = 2
[[sweep.axis]]
name = "height"
scale = "z"
from = 0.1
to = 1.2
count = 12
"#;

/// Variables of schedulers, of which none may come from the surroundings of the tests.
const VARIABLES: [&str; 5] = [
    "SLURM_ARRAY_TASK_ID",
    "SLURM_ARRAY_TASK_MIN",
    "SLURM_ARRAY_TASK_STEP",
    "SLURM_ARRAY_TASK_COUNT",
    "HQ_TASK_ID",
];

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("saddles.toml"), SWEEP).unwrap();
    folder
}

fn command(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plateau"));
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    VARIABLES.iter().for_each(|name| {
        command.env_remove(name);
    });
    command.envs(variables.iter().copied());
    command
}

fn plateau(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Output {
    command(folder, arguments, variables).output().expect("the command starts")
}

fn said(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn merged(folder: &Path, out: &str) -> Vec<Vec<u8>> {
    ["merged.json", "merged.csv"].map(|name| fs::read(folder.join(out).join(name)).unwrap()).into()
}

#[test]
fn shards_by_argument_slurm_and_hyperqueue_make_the_table_of_one_run() {
    let folder = folder();
    let whole = plateau(folder.path(), &["run", "saddles.toml"], &[]);
    assert_eq!(whole.status.code(), Some(0), "{whole:?}");
    assert!(said(&whole.stdout).contains("saddles: 12 cells run, 0 there already"), "{whole:?}");
    let expected = merged(folder.path(), "out/saddles");
    for (out, shards) in [("arguments", 4), ("slurm", 3), ("hq", 5)] {
        for k in 1..=shards {
            let (argument, task, of) = (format!("{k}/{shards}"), k.to_string(), shards.to_string());
            let (id, every) = ((k * 2 + 1).to_string(), format!("/{shards}"));
            let (shard, variables): (Vec<&str>, Vec<(&str, &str)>) = match out {
                "arguments" => (vec!["--shard", &argument], vec![]),
                "slurm" => (
                    vec![],
                    vec![
                        ("SLURM_ARRAY_TASK_ID", &id),
                        ("SLURM_ARRAY_TASK_MIN", "3"),
                        ("SLURM_ARRAY_TASK_STEP", "2"),
                        ("SLURM_ARRAY_TASK_COUNT", &of),
                    ],
                ),
                _ => (vec!["--shard", &every], vec![("HQ_TASK_ID", &task)]),
            };
            let arguments = [vec!["run", "saddles.toml", "--out", out], shard].concat();
            let output = plateau(folder.path(), &arguments, &variables);
            assert_eq!(output.status.code(), Some(0), "{output:?}");
            assert!(said(&output.stdout).contains(&format!("shard {k} of {shards}, ")), "{output:?}");
            // Whoever said so is told.
            assert_eq!(said(&output.stderr).contains("TASK_ID"), out != "arguments", "{output:?}");
        }
        let (from, to) = (format!("{out}/saddles"), format!("{out}-merged"));
        let output = plateau(folder.path(), &["merge", &from, "--out", &to], &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(merged(folder.path(), &format!("{out}-merged")), expected, "{out}");
    }
}

#[test]
fn a_file_without_a_sweep_is_never_shared_out_silently() {
    let folder = folder();
    let plain = SWEEP.split("[[sweep.axis]]").next().unwrap();
    fs::write(folder.path().join("plain.toml"), plain).unwrap();
    let output = plateau(folder.path(), &["run", "plain.toml", "--shard", "1/2"], &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("plain.toml has no [sweep]"), "{output:?}");
    let output = plateau(folder.path(), &["run", "plain.toml"], &[("SLURM_ARRAY_TASK_ID", "3")]);
    assert_eq!(output.status.code(), Some(0));
    assert!(
        said(&output.stderr).contains("all of it is run, whatever SLURM_ARRAY_TASK_ID says"),
        "{output:?}"
    );
    for (shard, variables) in [
        ("0/4", &[][..]),
        ("5/4", &[]),
        ("half", &[]),
        ("/4", &[]),
        ("/4", &[("HQ_TASK_ID", "0")]),
        ("", &[("HQ_TASK_ID", "1")]),
        ("", &[("SLURM_ARRAY_TASK_ID", "7"), ("SLURM_ARRAY_TASK_COUNT", "3")]),
    ] {
        let mut arguments = vec!["run", "saddles.toml"];
        if !shard.is_empty() {
            arguments.extend(["--shard", shard]);
        }
        let output = plateau(folder.path(), &arguments, variables);
        assert_eq!(output.status.code(), Some(2), "{shard} {variables:?}: {output:?}");
        assert!(!folder.path().join("out/saddles").exists());
    }
}

fn started(folder: &Path) -> Child {
    command(folder, &["run", "saddles.toml", "--threads", "1"], &[])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn cells(folder: &Path) -> usize {
    let cells = fs::read_dir(folder.join("out/saddles")).into_iter().flatten();
    cells.filter(|cell| cell.as_ref().unwrap().path().join("result.json").exists()).count()
}

#[test]
fn a_shard_that_is_killed_mid_cell_loses_no_cell_that_was_done() {
    let whole = folder();
    assert!(plateau(whole.path(), &["run", "saddles.toml"], &[]).status.success());
    let folder = folder();
    for _ in 0..6 {
        let before = cells(folder.path());
        let mut run = started(folder.path());
        while cells(folder.path()) == before && run.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        // SIGKILL, as when a node vanishes: nothing can be tidied up.
        let _ = run.kill();
        run.wait().unwrap();
        assert!(cells(folder.path()) >= before);
        let output = plateau(folder.path(), &["merge", "out/saddles"], &[]);
        let there = cells(folder.path());
        let missing = said(&output.stderr).lines().filter(|line| line.starts_with("missing: ")).count();
        assert_eq!((missing, output.status.code()), (12 - there, Some(i32::from(there < 12))), "{output:?}");
    }
    let last = plateau(folder.path(), &["run", "saddles.toml"], &[]);
    assert_eq!(last.status.code(), Some(0), "{last:?}");
    assert_eq!(merged(folder.path(), "out/saddles"), merged(whole.path(), "out/saddles"));
    let leftovers = fs::read_dir(folder.path().join("out/saddles")).unwrap().flat_map(|cell| {
        let cell = cell.unwrap().path();
        fs::read_dir(cell).into_iter().flatten().map(|file| file.unwrap().file_name())
    });
    assert_eq!(leftovers.filter(|name| name.to_string_lossy().starts_with('.')).count(), 0);
}

#[test]
fn two_processes_on_the_same_cells_double_nothing() {
    let whole = folder();
    assert!(plateau(whole.path(), &["run", "saddles.toml"], &[]).status.success());
    let folder = folder();
    let mut runs = [started(folder.path()), started(folder.path()), started(folder.path())];
    for run in &mut runs {
        // One that ends while another is still at a cell says so by its status.
        assert!(matches!(run.wait().unwrap().code(), Some(0 | 1)));
    }
    let output = plateau(folder.path(), &["merge", "out/saddles"], &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert_eq!(merged(folder.path(), "out/saddles"), merged(whole.path(), "out/saddles"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_costs_the_cells_that_did_not_fit_and_no_others() {
    let folder = folder();
    // Results larger than the outline of their sweep.
    let large = SWEEP.replace("energy = \"area\"\nraise = 2", "energy = \"dirichlet\"\nraise = 14");
    fs::write(folder.path().join("saddles.toml"), large).unwrap();
    // Files may have so many bytes, as on a disk with as little room.
    let limited = |blocks: &str| {
        let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" run saddles.toml --threads 1");
        let arguments = ["-c", &script, env!("CARGO_BIN_EXE_plateau")];
        let mut shell = Command::new("sh");
        VARIABLES.iter().for_each(|name| {
            shell.env_remove(name);
        });
        shell.args(arguments).current_dir(folder.path()).output().unwrap()
    };
    // Enough for the outline, not for a result.
    let full = limited("11");
    assert_eq!(full.status.code(), Some(1), "{full:?}");
    assert!(said(&full.stderr).contains("the result cannot be written"), "{full:?}");
    assert_eq!(cells(folder.path()), 0);
    let again = plateau(folder.path(), &["run", "saddles.toml"], &[]);
    assert_eq!(again.status.code(), Some(0), "{again:?}");
    assert_eq!(cells(folder.path()), 12);
}

#[test]
fn what_is_missing_or_torn_is_named_and_the_status_says_so() {
    let folder = folder();
    plateau(folder.path(), &["run", "saddles.toml", "--shard", "1/2"], &[]);
    fs::write(folder.path().join("out/saddles/height=0.1/result.json"), "{").unwrap();
    let output = plateau(folder.path(), &["merge", "out/saddles"], &[]);
    assert_eq!(output.status.code(), Some(1));
    let errors = said(&output.stderr);
    assert!(errors.contains("torn: height=0.1: ") && errors.contains("missing: height=0.2\n"), "{errors}");
    assert!(errors.contains("5 of 12 cells are there"), "{errors}");
    // What is there is shown and written nevertheless.
    assert!(
        said(&output.stdout).contains("Least area") && folder.path().join("out/saddles/index.html").exists()
    );
    let output = plateau(folder.path(), &["merge", "out"], &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("sweep.json"), "{output:?}");
}

#[test]
fn check_says_how_many_cells_there_are() {
    let folder = folder();
    let output = plateau(folder.path(), &["check", "saddles.toml"], &[]);
    assert!(
        said(&output.stdout).starts_with("saddles.toml: sound, a sweep of 12 cells (12 of height)\n"),
        "{output:?}"
    );
    let wrong = SWEEP.replace("raise = 2", "raise = 2\ntolerance = 2.0");
    fs::write(folder.path().join("wrong.toml"), wrong).unwrap();
    let output = plateau(folder.path(), &["check", "wrong.toml"], &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("wrong.toml:12:13"), "{output:?}");
}
