//! Where results cannot be written, or nobody listens: one line on stderr, and nothing lost that was there.
#![cfg(unix)]

use std::fs::{self, OpenOptions};
use std::path::Path;
use std::process::{Command, Output, Stdio};

const QUICK: &str = r#"
title = "A saddle"
[boundary]
u0 = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]
u1 = [[2, 0, 0], [2, 1, 1], [2, 2, 2]]
v0 = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
v1 = [[0, 2, 0], [1, 2, 1], [2, 2, 2]]
[[method]]
name = "Dirichlet"
basis = "bernstein"
energy = "dirichlet"
"#;

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.toml", "b.toml"] {
        fs::write(folder.path().join(name), QUICK).unwrap();
    }
    folder
}

fn plateau(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plateau"));
    command.current_dir(folder).args(["run", "a.toml", "b.toml"]).stdin(Stdio::null());
    command
}

/// A shell that makes the surroundings what they should be, then becomes `plateau`, which is its `$0`.
fn shell(folder: &Path, script: &str) -> Output {
    let command = ["-c", script, env!("CARGO_BIN_EXE_plateau")];
    Command::new("sh").args(command).current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

fn is_whole(folder: &Path, stem: &str) {
    let record = fs::read(folder.join("out").join(stem).join("result.json")).unwrap();
    let record: serde_json::Value = serde_json::from_slice(&record).unwrap();
    assert_eq!(record["methods"][0]["name"], "Dirichlet");
}

/// Nothing half-written lies in the folder of `a`.
fn is_clean(folder: &Path) {
    for entry in fs::read_dir(folder.join("out/a")).into_iter().flatten() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(!name.starts_with(".plateau-"), "{name}");
    }
}

fn one_error_each(output: &Output, words: &str) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines.len() == 2 && lines.iter().all(|line| line.starts_with("error: ")), "{said}");
    assert!(lines[0].contains("a.toml") && lines[1].contains("b.toml") && said.contains(words), "{said}");
}

#[test]
fn a_listener_that_leaves_costs_no_result() {
    let folder = folder();
    let mut child = plateau(folder.path()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), ""));
    is_whole(folder.path(), "a");
    is_whole(folder.path(), "b");
    let output =
        shell(folder.path(), "rm -r out; \"$0\" run a.toml b.toml | head -n 1; test -f out/b/result.json");
    assert_eq!((output.status.code(), text(&output.stdout)), (Some(0), "A saddle\n"), "{output:?}");
}

#[test]
fn a_full_stdout_is_told_and_costs_no_result() {
    let Ok(full) = OpenOptions::new().write(true).open("/dev/full") else {
        return; // There is one on Linux only.
    };
    let folder = folder();
    let output = plateau(folder.path()).stdout(full).output().unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.starts_with("error: the output cannot be written: No space left") && said.lines().count() == 1,
        "{said}"
    );
    is_whole(folder.path(), "a");
    is_whole(folder.path(), "b");
}

#[test]
fn a_folder_that_cannot_be_made_is_told_before_anything_is_computed() {
    let folder = folder();
    // A file in its place refuses root, too.
    fs::write(folder.path().join("out"), "mine").unwrap();
    let output = plateau(folder.path()).output().unwrap();
    one_error_each(&output, "not run, for its result could not be written: out/a: ");
    assert_eq!(text(&output.stdout).trim(), "");
    assert_eq!(fs::read_to_string(folder.path().join("out")).unwrap(), "mine");
    let output = plateau(folder.path()).args(["--out", "/proc/self"]).output().unwrap();
    one_error_each(&output, "/proc/self/a: ");
}

#[test]
fn a_read_only_folder_is_told_before_anything_is_computed() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).unwrap();
    // Root may write everywhere: then the folder is read-only for nobody, and the tests above and below stand for it.
    if fs::write(out.join("probe"), "").is_err() {
        one_error_each(&plateau(folder.path()).output().unwrap(), "Permission denied");
    }
    fs::set_permissions(&out, fs::Permissions::from_mode(0o755)).unwrap();
}

/// The results of a first run, then another run that `limit` leaves no room; what the first run wrote stays.
fn keeps_the_old(folder: &Path, run: impl Fn() -> Output, words: &str) {
    assert!(plateau(folder).output().unwrap().status.success());
    let record = folder.join("out/a/result.json");
    let old = fs::read(&record).unwrap();
    // Another experiment, so that its record would have other bytes.
    for name in ["a.toml", "b.toml"] {
        fs::write(folder.join(name), QUICK.replace("A saddle", "Another saddle")).unwrap();
    }
    let output = run();
    one_error_each(&output, words);
    assert!(text(&output.stdout).contains("Another saddle"), "{output:?}");
    assert!(fs::read(&record).unwrap() == old);
    is_clean(folder);
}

#[test]
fn a_limit_of_the_size_of_files_is_told_and_the_old_result_stays() {
    let folder = folder();
    // Also where the signal of that limit is ignored, as a parent process may have it.
    for trap in ["", "trap '' XFSZ; "] {
        fs::write(folder.path().join("a.toml"), QUICK).unwrap();
        fs::write(folder.path().join("b.toml"), QUICK).unwrap();
        let run = || {
            shell(folder.path(), &format!("{trap}ulimit -c 0; ulimit -f 1; exec \"$0\" run a.toml b.toml"))
        };
        keeps_the_old(folder.path(), run, "the result cannot be written: out/a/");
    }
}

#[test]
fn a_stdout_beyond_that_limit_is_told() {
    let folder = folder();
    let script = "ulimit -c 0; head -c 2048 /dev/zero > said; ulimit -f 1; exec \"$0\" new tensor >> said";
    let output = shell(folder.path(), script);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.starts_with("error: the output cannot be written: File too large") && said.lines().count() == 1,
        "{said}"
    );
}

#[test]
fn a_full_disk_is_told_and_the_old_result_stays() {
    let folder = folder();
    let mount = "mkdir -p out && mount -t tmpfs -o size=1m none out";
    // A name space of its own is gone with the process; root has the right to one, users on most systems.
    let may = Command::new("unshare")
        .args(["--user", "--map-root-user", "--mount", "sh", "-c", mount])
        .current_dir(folder.path())
        .output();
    if !may.is_ok_and(|output| output.status.success()) {
        return; // The limit of the size of files, above, stands for it.
    }
    let script = format!(
        "{mount} && \"$0\" run a.toml b.toml >first.log && cp out/a/result.json old.json && \
         sed -i 's/A saddle/Another saddle/' a.toml b.toml && cat /dev/zero >out/ballast 2>/dev/null; \
         \"$0\" run a.toml b.toml; status=$?; cmp out/a/result.json old.json && ls -A out/a >names && exit $status"
    );
    let output = Command::new("unshare")
        .args(["--user", "--map-root-user", "--mount", "sh", "-c", &script, env!("CARGO_BIN_EXE_plateau")])
        .current_dir(folder.path())
        .output()
        .unwrap();
    one_error_each(&output, "No space left on device");
    assert!(text(&output.stdout).contains("Another saddle"), "{output:?}");
    let names = fs::read_to_string(folder.path().join("names")).unwrap();
    assert!(names.contains("result.json") && !names.contains(".plateau-"), "{names}");
}

#[test]
fn a_checkpoint_that_cannot_be_written_is_a_warning() {
    let folder = folder();
    let fixture = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/gt-5.2-local.toml");
    let text_of_it = fs::read_to_string(fixture).unwrap().replace("runs = 10", "runs = 40");
    fs::write(folder.path().join("a.toml"), text_of_it + "\n[output]\npictures = false\n").unwrap();
    // Room for the record, none for a checkpoint: that is a folder.
    fs::create_dir_all(folder.path().join("out/a/checkpoint/x")).unwrap();
    let output = plateau(folder.path()).args(["--checkpoint-every", "0"]).output().unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.starts_with("warning: out/a/checkpoint: finished runs could not be kept: "), "{said}");
    assert!(folder.path().join("out/a/result.json").exists());
}

#[test]
fn what_killed_runs_left_is_removed() {
    let folder = folder();
    fs::create_dir_all(folder.path().join("out/a")).unwrap();
    let (stale, held) =
        (folder.path().join("out/a/.plateau-ORQySU"), folder.path().join("out/a/.plateau-2bCd3E"));
    let foreign = folder.path().join("out/a/.plateau-notes-2026");
    for file in [&stale, &held, &foreign] {
        fs::write(file, "half of a res").unwrap();
    }
    // Another program still writes this one.
    let writer = fs::File::open(&held).unwrap();
    writer.lock().unwrap();
    assert!(plateau(folder.path()).output().unwrap().status.success());
    assert!(!stale.exists() && held.exists() && foreign.exists());
}

#[test]
fn a_folder_that_another_run_writes_to_is_left_to_it() {
    let folder = folder();
    let a = folder.path().join("out/a");
    fs::create_dir_all(&a).unwrap();
    let other = fs::File::open(&a).unwrap();
    other.lock().unwrap();
    let output = plateau(folder.path()).output().unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.starts_with("error: a.toml: not run, ") && said.contains("out/a: another run is writing to"),
        "{said}"
    );
    assert_eq!(fs::read_dir(&a).unwrap().count(), 0);
    is_whole(folder.path(), "b");
    drop(other);
    assert!(plateau(folder.path()).output().unwrap().status.success());
    is_whole(folder.path(), "a");
}

#[test]
fn several_runs_at_once_leave_the_files_of_one() {
    let folder = folder();
    let contents = || -> Vec<(String, Vec<u8>)> {
        let files = fs::read_dir(folder.path().join("out/a")).unwrap().map(|file| file.unwrap());
        let mut files: Vec<_> = files
            .map(|file| (file.file_name().into_string().unwrap(), fs::read(file.path()).unwrap()))
            .collect();
        files.sort();
        files
    };
    assert!(plateau(folder.path()).output().unwrap().status.success());
    let alone = contents();
    for _ in 0..4 {
        fs::remove_dir_all(folder.path().join("out")).unwrap();
        let start = |_| plateau(folder.path()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let children: Vec<_> = (0..6).map(start).collect();
        for child in children {
            let output = child.wait_with_output().unwrap();
            // Whoever came late was told so; nobody failed on the way.
            let said = text(&output.stderr);
            assert!(said.lines().all(|line| line.contains("another run is writing to")), "{said}");
            assert_eq!(output.status.code(), Some(i32::from(!said.is_empty())));
        }
        assert!(contents() == alone);
    }
}

#[test]
fn results_are_as_readable_as_the_user_wants_his_files() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    for (mask, mode) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        // A file that is replaced passes its permissions on.
        let _ = fs::remove_dir_all(folder.path().join("out"));
        let output = shell(folder.path(), &format!("umask {mask}; exec \"$0\" run a.toml"));
        assert!(output.status.success(), "{output:?}");
        let metadata = fs::metadata(folder.path().join("out/a/result.json")).unwrap();
        assert_eq!(metadata.permissions().mode() & 0o777, mode, "umask {mask}");
    }
}

#[test]
fn a_file_that_cannot_be_written_keeps_no_other_back() {
    let folder = folder();
    let path = folder.path().join("a.toml");
    fs::write(&path, QUICK.to_owned() + "[output]\nformats = [\"obj\", \"stl\"]\n").unwrap();
    let run = || shell(folder.path(), "\"$0\" run a.toml");
    let a = folder.path().join("out/a");
    assert!(run().status.success());
    let names = || -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(&a)
            .unwrap()
            .map(|file| file.unwrap())
            .filter(|file| file.file_type().unwrap().is_file())
            .map(|file| file.file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    let all = names();
    let taken = ["dirichlet.obj", "surfaces.svg", "report.html"];
    assert!(taken.iter().all(|name| all.iter().any(|other| other == name)), "{all:?}");
    // Anew, and where the files of a result were there before.
    for before in [false, true] {
        fs::remove_dir_all(&a).unwrap();
        if before {
            assert!(run().status.success());
        }
        for name in taken {
            let _ = fs::remove_file(a.join(name));
            fs::create_dir_all(a.join(name).join("mine")).unwrap();
        }
        let output = run();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert_eq!(said.lines().count(), taken.len(), "{said}");
        for (line, name) in said.lines().zip(taken) {
            assert!(line.starts_with(&format!("error: out/a/{name}: ")), "{said}");
        }
        let others: Vec<_> = all.iter().filter(|name| !taken.contains(&name.as_str())).cloned().collect();
        assert_eq!(names(), others);
        assert!(!text(&output.stdout).contains("cannot be removed"), "{output:?}");
        let record = fs::read(a.join("result.json")).unwrap();
        let record: serde_json::Value = serde_json::from_slice(&record).unwrap();
        assert_eq!(record["unwritten"], serde_json::json!(taken));
        assert!(taken.iter().all(|name| a.join(name).join("mine").is_dir()));
    }
}
