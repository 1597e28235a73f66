//! What a user sees: whole reports, and the command's streams and exit status.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use experiment::{Plan, Template};

/// A folder of its own for each test, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("plateau-messages-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a temporary folder");
        Self(folder)
    }

    fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        let path = self.0.join(name);
        fs::write(&path, bytes).expect("a temporary file");
        path.display().to_string()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn plateau(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

#[test]
fn a_whole_report() {
    let file = "title = \"Net\"\n\n[boundary]\n\
                u0 = [[0, 0, 0], [6, 0, 0]]\nu1 = [[0, 6, 0], [6, 6, 0]]\n\
                v0 = [[0, 0, 0], [0, 6, 2]]\nv1 = [[6, 0, 0], [6, 6, 0]]\n\n\
                [[method]]\nname = \"Dirichlet\"\nenrgy = \"dirichlet\"\n";
    let expected = "\
error: `u1` and `v0` in [boundary] disagree at the corner P_m0: [0, 6, 0] and [0, 6, 2]
 --> net.toml:6:18
  |
5 | u1 = [[0, 6, 0], [6, 6, 0]]
  |       --------- the first point of `u1` is [0, 6, 0]
6 | v0 = [[0, 0, 0], [0, 6, 2]]
  |                  ^^^^^^^^^ the last point of `v0` is [0, 6, 2]
  |
  = help: corners are repeated: make the first point of `u1` and the last point of `v0` the same; what differs by no more than 9e-6, a millionth of the size, is made one

error: [[method]] has no key `enrgy`
  --> net.toml:11:1
   |
11 | enrgy = \"dirichlet\"
   | ^^^^^ unknown key
   |
   = help: did you mean `energy`?
   = help: the keys of [[method]] are: name, patch, basis, shape, search, energy, raise, domain, metric-steps, mask, construction, search-energy, solver, tolerance, degree, layers, rim-tolerance, accuracy, bound, expect, published";
    let refusal = Plan::parse("net.toml", file).unwrap_err();
    assert_eq!(refusal.to_string(), expected);
    assert!(refusal.render(true).contains("\u{1b}["));
    assert!(!refusal.render(false).contains('\u{1b}'));
}

#[test]
fn check_accepts_every_template_on_stdout() {
    let folder = Folder::new("templates");
    for template in Template::ALL {
        let printed = plateau(&["new", template.name()]);
        assert_eq!(printed.status.code(), Some(0));
        assert_eq!(text(&printed.stdout), template.text());
        let file = folder.file(&format!("{}.toml", template.name()), &printed.stdout);
        let checked = plateau(&["check", &file]);
        assert_eq!((checked.status.code(), text(&checked.stderr)), (Some(0), String::new()));
        assert!(text(&checked.stdout).starts_with(&format!("{file}: sound, ")));
    }
    assert_eq!(plateau(&["new", "patch"]).stdout, plateau(&["new", "tensor"]).stdout);
}

#[test]
fn bad_files_are_reported_on_stderr_with_status_2() {
    let folder = Folder::new("bad");
    let good = folder.file("good.toml", Template::Curve.text());
    let bad = folder.file("bad.toml", Template::Curve.text().replace("[curve]", "[kurve]"));
    for command in ["check", "run"] {
        let output = plateau(&[command, &good, &bad]);
        assert_eq!(output.status.code(), Some(2), "{command}");
        let report = text(&output.stderr);
        assert!(report.contains("bad.toml:5:2") && report.contains("did you mean `curve`?"), "{report}");
        assert!(!report.contains('\u{1b}'), "no colours off a terminal");
    }
    assert!(text(&plateau(&["check", &good, &bad]).stdout).contains("good.toml: sound"));
}

#[test]
fn unreadable_files_get_one_clear_line() {
    let folder = Folder::new("unreadable");
    let missing = folder.0.join("missing.toml").display().to_string();
    let folder_name = folder.0.display().to_string();
    let latin = folder.file("latin.toml", b"title = \"x\"\n# caf\xe9\n");
    let large = folder.0.join("large.toml");
    fs::File::create(&large).and_then(|file| file.set_len(1 << 40)).expect("a sparse file");
    let large = large.display().to_string();
    for (file, words) in [
        (&missing, "there is no such file"),
        (&folder_name, "this is a folder"),
        (&latin, "not UTF-8 text, from line 2 on"),
        (&large, "1099511627776 bytes or more, above the limit of 1048576"),
    ] {
        let output = plateau(&["check", file]);
        let report = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{report}");
        assert!(report.contains(words) && report.contains(file.as_str()), "{report}");
        assert_eq!(report.matches("error:").count(), 1, "{report}");
        assert!(report.contains("help: "), "{report}");
    }
}

#[test]
fn a_dash_is_stdin() {
    let through = |command: &[&str], text: &str| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(command)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        child.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("it reads");
        child.wait_with_output().expect("it ends")
    };
    let folder = Folder::new("stdin");
    let sound = through(&["check", "-"], Template::Curve.text());
    assert_eq!((sound.status.code(), text(&sound.stderr)), (Some(0), String::new()));
    assert!(text(&sound.stdout).starts_with("stdin: sound, "), "{}", text(&sound.stdout));
    let bad = through(&["check", "-"], &Template::Curve.text().replace("[curve]", "[kurve]"));
    assert_eq!(bad.status.code(), Some(2));
    assert!(text(&bad.stderr).contains("stdin:5:2"), "{}", text(&bad.stderr));
    let out = folder.0.join("out").display().to_string();
    let run = through(&["run", "-", "--out", &out], Template::Curve.text());
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    assert!(folder.0.join("out/stdin/result.json").exists());
}

#[test]
fn bad_usage_is_status_2() {
    for arguments in [
        &["fly"][..],
        &["check"],
        &["new", "sphere"],
        &["run", "x.toml", "--threads", "0"],
        &["run", "x.toml", "--seed", "-1"],
        &["run", "x.toml", "--seed", "9223372036854775808"],
        &["run", "x.toml", "--arithmetic", "decimal"],
        &[],
    ] {
        let output = plateau(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn help_version_and_completions_go_to_stdout() {
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["run", "--help"],
        &["completions", "bash"],
        &["completions", "zsh"],
    ] {
        let output = plateau(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(!output.stdout.is_empty() && output.stderr.is_empty(), "{arguments:?}");
    }
    let help = text(&plateau(&["--help"]).stdout);
    for word in ["run", "check", "new", "completions", "Exit status"] {
        assert!(help.contains(word), "{word}:\n{help}");
    }
}

#[test]
fn two_files_of_one_stem_would_overwrite_each_other() {
    let folder = Folder::new("stems");
    fs::create_dir_all(folder.0.join("other")).expect("a folder");
    let one = folder.file("same.toml", Template::Curve.text());
    let other = folder.file("other/same.toml", Template::Curve.text());
    let output = plateau(&["run", &one, &other, "--out", &folder.0.join("out").display().to_string()]);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("same.toml"), "{}", text(&output.stderr));
    assert!(!folder.0.join("out").exists());
}

#[test]
fn a_closed_stdout_is_no_panic() {
    for arguments in [&["new", "tensor"][..], &["completions", "bash"], &["--help"]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_plateau"))
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let report = text(&output.stderr);
        assert!(!report.contains("panicked"), "{arguments:?}: {report}");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {report}");
    }
}
