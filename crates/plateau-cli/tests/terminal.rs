//! What files say may not move the cursor, colour the terminal, turn the direction of writing or forge a line of ours.

use std::path::Path;
use std::process::{Command, Output};

/// Characters that must not reach a terminal, as TOML writes them; and a line that looks like ours.
const HARM: &str = "\\u001b]0;owned\\u0007\\u001b[2J\\u009b31m\\u0085\\u007f\\u202e\\u2066\\u200f\\u061c\\u2028\\r\\n\
                    expected numbers: 99 of 99 met";

fn plateau(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_plateau"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the command starts")
}

/// What a terminal would get; every character of it is harmless, no line is forged.
#[track_caller]
fn shown(output: &Output) -> String {
    let text =
        [&output.stdout, &output.stderr].map(|bytes| std::str::from_utf8(bytes).expect("UTF-8")).concat();
    let harmful = |c: &char| {
        (c.is_control() && *c != '\n')
            || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    assert_eq!(text.chars().find(harmful), None, "{text:?}");
    assert!(!text.lines().any(|line| line.starts_with("expected numbers: 99")), "{text}");
    text
}

/// A flat square with a method of this name, and more at the end of the method.
fn square(title: &str, name: &str, more: &str) -> String {
    format!(
        "title = \"{title}\"\n[boundary]\nu0 = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]\nu1 = [[2, 0, 0], [2, 1, 0], [2, 2, 0]]\n\
         v0 = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\nv1 = [[0, 2, 0], [1, 2, 0], [2, 2, 0]]\n\
         [[method]]\nname = \"{name}\"\nenergy = \"dirichlet\"\n{more}\n"
    )
}

#[test]
fn titles_and_names_are_shown_escaped_by_run_export_and_verify() {
    let folder = tempfile::tempdir().unwrap();
    let text = square(HARM, HARM, "expect = { area = 4.5 }\n[output]\nformats = [\"obj\"]\nmesh = 4");
    std::fs::write(folder.path().join("a.toml"), text).unwrap();
    let run = plateau(&["run", "a.toml"], folder.path());
    let text = shown(&run);
    assert_eq!(run.status.code(), Some(1), "{text}");
    assert!(text.contains(r"\u001b]0;owned\u0007") && text.contains(r"\u202e"), "{text}");
    let again = plateau(&["run", "--resume", "a.toml"], folder.path());
    assert!(shown(&again).contains("not run again"));
    let result = "out/a/result.json";
    let verified = plateau(&["verify", result], folder.path());
    assert_eq!(verified.status.code(), Some(0), "{}", shown(&verified));
    shown(&verified);
    shown(&plateau(&["export", result, "--format", "stl"], folder.path()));
    let refused = plateau(&["export", result, "--format", "stl", "--method", "none"], folder.path());
    assert!(shown(&refused).contains("has no method"));
}

#[test]
fn refusals_show_keys_values_and_lines_escaped() {
    let folder = tempfile::tempdir().unwrap();
    let raw = "\u{9b}31m \u{202e}\u{2066}\u{85}\u{2028}";
    let harmful = [
        format!("title = \"a\"\n\"{HARM}\" = 1\n"),
        square("a", "b", &format!("basis = \"{HARM}\"")),
        square(raw, raw, &format!("\"{raw}\" = \"{raw}\"")),
        "title = \"\u{1b}[31m\"".to_owned(),
        "title = \u{1b}[31m\u{7f}".to_owned(),
        format!("title = \"a\" # {raw}\nx = {raw}\n"),
        format!("{raw}\r\n[boundary]\r\nu0 = \"{raw}\"\r\n"),
    ];
    for text in harmful {
        std::fs::write(folder.path().join("a.toml"), &text).unwrap();
        for command in ["check", "run"] {
            let output = plateau(&[command, "a.toml"], folder.path());
            assert_eq!(output.status.code(), Some(2), "{text:?}");
            assert!(shown(&output).contains("a.toml"), "{text:?}");
        }
    }
}

#[cfg(unix)]
#[test]
fn names_of_files_are_shown_escaped() {
    let folder = tempfile::tempdir().unwrap();
    let name = "a\u{1b}[31m\nexpected numbers: 99 of 99 met\u{202e}.toml";
    std::fs::write(folder.path().join(name), square("a", "b", "")).unwrap();
    for arguments in [&["check", name][..], &["run", name], &["run", "none\u{9b}\n.toml"], &["import", name]]
    {
        shown(&plateau(arguments, folder.path()));
    }
    let sound = plateau(&["check", name], folder.path());
    assert!(shown(&sound).starts_with(r"a\u001b[31m\nexpected"));
}

#[test]
fn arguments_that_are_refused_are_shown_escaped() {
    let folder = tempfile::tempdir().unwrap();
    let harm = "\u{1b}[31m\u{9b}2J\u{202e}x\nexpected numbers: 99 of 99 met";
    let option = format!("--{harm}");
    for arguments in [&[harm][..], &["run", &option], &["run", "a.toml", "--threads", harm], &["new", harm]] {
        let output = plateau(arguments, folder.path());
        assert_eq!(output.status.code(), Some(2));
        assert!(shown(&output).contains(r"\u001b[31m"), "{}", shown(&output));
    }
}

#[test]
fn one_long_name_does_not_widen_the_rows_of_the_others() {
    let folder = tempfile::tempdir().unwrap();
    let long = "x".repeat(100_000);
    let mut text = square("a", &long, "");
    for k in 0..50 {
        text += &format!("[[method]]\nname = \"{k}\"\nenergy = \"dirichlet\"\n");
    }
    text += "[output]\npictures = false\n";
    std::fs::write(folder.path().join("a.toml"), text).unwrap();
    let run = plateau(&["run", "a.toml"], folder.path());
    let table = shown(&run);
    assert!(table.contains("xxx…") && table.len() < 30_000, "{}", table.len());
    let verified = plateau(&["verify", "out/a/result.json"], folder.path());
    assert!(shown(&verified).len() < 10_000);
}
