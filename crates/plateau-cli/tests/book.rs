//! The book in `docs/`: its links lead somewhere, every chapter is listed, and what it quotes is what the program says.

use std::fs;
use std::path::{Path, PathBuf};

use plateau::{Options, Plan, Template, reproduce, run, table};

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn chapters(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable folder").path();
        if path.is_dir() {
            found.extend(chapters(&path));
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The targets of `[…](target)` and of `{{#include target}}`, without those on the web and those inside code.
fn links(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut code = false;
    for line in text.lines() {
        code ^= line.trim_start().starts_with("```");
        let targets = line.split("](").skip(1).filter_map(|rest| rest.split(')').next()).filter(|_| !code);
        found.extend(targets);
        found.extend(line.split("{{#include ").skip(1).filter_map(|rest| rest.split("}}").next()));
    }
    found.retain(|target| !target.contains("://"));
    found
}

#[test]
fn links_lead_somewhere() {
    let mut count = 0;
    for chapter in chapters(&docs()) {
        let text = fs::read_to_string(&chapter).unwrap();
        for link in links(&text) {
            let target = link.split('#').next().unwrap_or(link);
            let path =
                if target.is_empty() { chapter.clone() } else { chapter.parent().unwrap().join(target) };
            assert!(path.exists(), "{}: {link}", chapter.display());
            count += 1;
        }
    }
    assert!(count > 40, "{count}");
}

#[test]
fn every_chapter_is_listed() {
    let summary = fs::read_to_string(docs().join("SUMMARY.md")).unwrap();
    let listed = links(&summary);
    for chapter in chapters(&docs()) {
        let name = chapter.strip_prefix(docs()).unwrap().to_string_lossy().replace('\\', "/");
        assert!(name == "SUMMARY.md" || listed.contains(&name.as_str()), "{name} is missing in SUMMARY.md");
    }
}

#[test]
fn quoted_tables_are_those_of_the_program() {
    let page = fs::read_to_string(docs().join("reproduced.md")).unwrap();
    let reproduced = reproduce(Options::default(), &()).table();
    assert!(
        page.contains(&reproduced),
        "docs/reproduced.md should hold the output of `plateau reproduce`:\n{reproduced}"
    );
    let summary = reproduced.lines().find(|line| line.contains("printed numbers")).expect("a summary");
    let tour = fs::read_to_string(docs().join("tour.md")).unwrap();
    assert!(tour.contains(summary), "docs/tour.md should quote: {summary}");
    let plan = Plan::parse("first.toml", Template::Tensor.text()).unwrap();
    let first = table(&run(&plan, Options::default(), &()).unwrap());
    assert!(tour.contains(&first), "docs/tour.md should hold the table of `plateau new tensor`:\n{first}");
}
