//! The book in `docs/`: its links lead somewhere, every chapter is listed, and what it quotes is what the program says.

use std::fs;
use std::path::{Path, PathBuf};

use experiment::{Options, Plan, Template, run};
use record::reproduce;
use show::{WIDTH, table};

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

/// The rows of a quoted table, without what rounding may change between machines: error estimates like 5.5e-13.
fn rows(text: &str) -> Vec<String> {
    let words = |line: &str| {
        let words = line.split_whitespace().filter(|word| !word.contains("e-"));
        words.collect::<Vec<_>>().join(" ")
    };
    text.lines().map(words).filter(|row| !row.is_empty()).collect()
}

fn quotes(page: &str, table: &str) {
    let text = fs::read_to_string(docs().join(page)).unwrap();
    let page_rows = rows(&text);
    let table_rows = rows(table);
    let found = page_rows.windows(table_rows.len()).any(|window| window == table_rows);
    assert!(found, "docs/{page} should hold:\n{table}");
}

#[test]
fn quoted_tables_are_those_of_the_program() {
    let reproduction = reproduce(Options::default(), &()).table();
    // The last line counts what the fixtures expect besides.
    let published = reproduction.trim_end().rsplit_once('\n').expect("several lines").0;
    quotes("reproduced.md", published);
    quotes("tour.md", published.lines().last().expect("the counts"));
    let plan = Plan::parse("first.toml", Template::Tensor.text()).unwrap();
    quotes("tour.md", &table(&run(&plan, Options::default(), &()).unwrap().results, WIDTH));
    let plan = Plan::read(docs().join("../fixtures/gt-5.1.toml")).unwrap();
    quotes("../README.md", &table(&run(&plan, Options::default(), &()).unwrap().results, WIDTH));
}

#[test]
fn the_list_of_keys_is_that_of_the_program() {
    let page = fs::read_to_string(docs().join("keys.md")).unwrap();
    let right = experiment::key_list();
    let first = page.lines().zip(right.lines()).find(|(ours, theirs)| ours != theirs);
    assert!(
        page == right,
        "docs/keys.md is not what `cargo run -p plateau-experiment --example key_list` prints: {first:?}"
    );
}
