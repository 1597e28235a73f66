//! Whatever the bytes: no panic, no unbounded work, and a place for every fault.

use std::time::{Duration, Instant};

use experiment::{Fault, MAX_FILE_SIZE, Plan, Refusal, Template};
use proptest::prelude::*;

/// A refusal must render, and every place in it must lie in the text.
fn inspect(text: &str, outcome: Result<Plan, Refusal>) {
    match outcome {
        Ok(plan) => assert!(!plan.title.trim().is_empty() && !plan.stem.is_empty()),
        Err(refusal) => {
            assert!((1..=10).contains(&refusal.diagnostics().len()));
            for diagnostic in refusal.diagnostics() {
                assert!(!diagnostic.message().is_empty());
                if let Some(span) = diagnostic.span() {
                    assert!(span.start <= span.end && span.end <= text.len(), "{span:?} of {}", text.len());
                    assert!(refusal.position(diagnostic).is_some());
                }
            }
            assert!(!refusal.render(false).is_empty() && !refusal.render(true).is_empty());
        }
    }
}

fn parse(text: &str) {
    inspect(text, Plan::parse("fuzz.toml", text));
}

fn template() -> impl Strategy<Value = &'static str> {
    proptest::sample::select(Template::ALL.map(Template::text).to_vec())
}

/// Pieces that mean something to TOML or to experiments.
const PIECES: [&str; 36] = [
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    ".",
    "\"",
    "'",
    "\"\"\"",
    "#",
    "\n",
    "\r\n",
    " ",
    "-",
    "nan",
    "inf",
    "1e308",
    "-1",
    "9223372036854775808",
    "0x7f",
    "1979-05-27",
    "true",
    "[boundary]",
    "[[method]]",
    "[search]",
    "u0",
    "method.expect",
    "shape",
    "title = \"x\"",
    "é",
    "\u{feff}",
    "\0",
    "\u{1b}[31m",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        parse(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn random_pieces(pieces in proptest::collection::vec(proptest::sample::select(&PIECES[..]), 0..60)) {
        parse(&pieces.concat());
    }

    #[test]
    fn one_character_replaced(text in template(), at in any::<proptest::sample::Index>(), by in any::<char>()) {
        let mut letters: Vec<char> = text.chars().collect();
        let at = at.index(letters.len());
        letters[at] = by;
        parse(&letters.into_iter().collect::<String>());
    }

    #[test]
    fn pieces_put_in(
        text in template(),
        places in proptest::collection::vec((any::<proptest::sample::Index>(), proptest::sample::select(&PIECES[..])), 1..4),
    ) {
        let mut letters: Vec<String> = text.chars().map(String::from).collect();
        for (at, piece) in places {
            let at = at.index(letters.len());
            letters.insert(at, piece.to_owned());
        }
        parse(&letters.concat());
    }

    #[test]
    fn a_value_replaced(text in template(), line in any::<proptest::sample::Index>(), by in proptest::sample::select(&PIECES[..])) {
        let lines: Vec<&str> = text.lines().collect();
        let chosen = line.index(lines.len());
        let mutated: Vec<String> = lines
            .iter()
            .enumerate()
            .map(|(k, line)| match line.split_once('=') {
                Some((key, _)) if k == chosen => format!("{key}= {by}"),
                _ => (*line).to_owned(),
            })
            .collect();
        parse(&mutated.join("\n"));
    }

    #[test]
    fn a_line_lost_or_doubled(text in template(), line in any::<proptest::sample::Index>(), doubled in any::<bool>()) {
        let mut lines: Vec<&str> = text.lines().collect();
        let k = line.index(lines.len());
        if doubled { lines.insert(k, lines[k]) } else { lines.remove(k); }
        parse(&lines.join("\n"));
    }

    #[test]
    fn cut_off(text in template(), at in any::<proptest::sample::Index>()) {
        let at = text.floor_char_boundary(at.index(text.len()));
        parse(&text[..at]);
    }
}

fn within(limit: Duration, what: &str, work: impl FnOnce()) {
    let start = Instant::now();
    work();
    let took = start.elapsed();
    assert!(took < limit, "{what} took {took:?}");
}

#[test]
fn large_texts_take_bounded_time() {
    let limit = Duration::from_secs(20);
    let row: String = (0..200_000).map(|k| format!("[{k}, 0.5, 1],")).collect();
    within(limit, "a long row", || parse(&format!("title = \"x\"\n[boundary]\nu0 = [{row}]\n")));
    within(limit, "a row of wrong points", || {
        parse(&format!("title = \"x\"\n[boundary]\nu0 = [{}]\n", "[1],".repeat(200_000)));
    });
    within(limit, "many methods", || {
        parse(&format!("title = \"x\"\n{}", "[[method]]\nname = \"a\"\n".repeat(20_000)))
    });
    within(limit, "many unknown keys", || {
        parse(&(0..50_000).map(|k| format!("key{k} = {k}\n")).collect::<String>());
    });
    within(limit, "deep nesting", || parse(&format!("a = {}", "[".repeat(200_000))));
    within(limit, "a long key", || parse(&format!("{} = 1", "k".repeat(1_000_000))));
    within(limit, "a long text", || {
        let text = format!("title = \"x\"\n[helicoid]\na = \"{}\"\n", "t".repeat(1_000_000));
        let refusal = Plan::parse("long.toml", &text).unwrap_err();
        assert!(refusal.to_string().len() < 100_000, "{}", refusal.to_string().len());
    });
}

#[test]
fn a_text_above_the_limit_is_refused_unread() {
    let text = "#".repeat(usize::try_from(MAX_FILE_SIZE).unwrap() + 1);
    let refusal = Plan::parse("large.toml", &text).unwrap_err();
    assert_eq!(refusal.diagnostics()[0].fault(), Fault::File);
    assert!(refusal.to_string().contains("1048576"), "{refusal}");
}

#[test]
fn control_characters_of_a_file_never_reach_the_terminal() {
    let text = "title = \"x\"\n[boundary]\n\"\\u001b[31mred\" = 1\n[[method]]\nname = \"\\u001b[2J\"\nenergy = \"\\u0007\"\n";
    let refusal = Plan::parse("escape.toml", text).unwrap_err();
    assert!(!refusal.to_string().contains(['\u{1b}', '\u{7}']), "{:?}", refusal.to_string());
}

#[test]
fn windows_line_ends_keep_lines_and_columns() {
    let text = "title = \"x\"\r\nseed = -1\r\n[curve]\r\nbasis = \"bernstein\"\r\npoints = [[0,0],[1,1]]\r\n";
    let refusal = Plan::parse("crlf.toml", text).unwrap_err();
    assert_eq!(refusal.diagnostics().len(), 1, "{refusal}");
    assert_eq!(refusal.position(&refusal.diagnostics()[0]), Some((2, 8)));
    assert!(Plan::parse("crlf.toml", &text.replace("-1", "1")).is_ok());
}

#[test]
fn columns_count_characters() {
    let text = "title = \"x\"\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,1]]\n\"Ünïcödé\" = 1 # ñ\n";
    let refusal = Plan::parse("wide.toml", text).unwrap_err();
    assert_eq!(refusal.position(&refusal.diagnostics()[0]), Some((5, 1)));
    let text = "title = \"x\"\nexpect = { \"ü\" = 1, area = 1.0 }\n[curve]\nbasis = \"bernstein\"\npoints = [[0,0],[1,1]]\n";
    let refusal = Plan::parse(
        "wide.toml",
        &text.replace("\"ü\" = 1, ", "area = \"ü\", ").replace("area = 1.0", "bending = true"),
    )
    .unwrap_err();
    assert_eq!(refusal.position(&refusal.diagnostics()[1]), Some((2, 34)), "{refusal}");
}
