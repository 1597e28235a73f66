//! Text to [`Spec`], with as many faults as one reading can tell apart.
//!
//! serde stops at the first unknown key or wrong type. So the offending entry is taken out of the
//! parsed document and the rest is read again, until nothing offends or enough faults are known; the
//! document remembers where entries were taken out, lest they be reported missing afterwards.

use std::ops::Range;

use serde::Deserialize;
use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

use super::{Spec, size};
use crate::diagnostic::{Diagnostic, Fault, nearest};

/// Syntax errors shown: each may cause others behind it.
const MOST_SYNTAX_ERRORS: usize = 3;

/// Syntax errors looked at: finding the lines of all of them would take the square of their number.
const MOST_EXAMINED: usize = 64;

/// Largest text in bytes whose syntax errors are all collected: there may be one a byte, and each takes hundreds of them.
const LARGEST_FOR_ALL_ERRORS: usize = 32 * 1024;

/// The remedy for an error behind which nothing is read as it was meant.
const UNCLOSED: &str =
    "a list that begins further up is not closed: count its brackets, or look for a missing comma";

/// Entries taken out before the reading gives up.
const MOST_REMOVED: usize = 12;

/// One step from a table to an entry inside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// A key of a table.
    Key(String),
    /// An element of a list of tables.
    Index(usize),
}

/// What could be read.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    /// The sound entries; `None` if the text is not TOML.
    pub(crate) spec: Option<Spec>,
    /// The faults found.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The paths of the entries that were taken out.
    pub(crate) removed: Vec<Vec<Step>>,
}

/// Reads a text; never panics, whatever the text, and takes no more than some 50 MB for it.
pub(crate) fn read(text: &str) -> Reading {
    let mut reading = Reading::default();
    if let Some(excess) = size::beyond(text) {
        reading.diagnostics.push(excess);
        return reading;
    }
    let mut document = match parse(text) {
        Ok(document) => document,
        Err(errors) => {
            reading.diagnostics = syntax_errors(text, &errors);
            return reading;
        }
    };
    loop {
        let error = match Spec::deserialize(Deserializer::from(document.clone())) {
            Ok(spec) => {
                reading.spec = Some(spec);
                return reading;
            }
            Err(error) => error,
        };
        let span = error.span().unwrap_or(0..0);
        let Some(path) = locate(document.get_ref(), &span) else {
            reading.diagnostics.push(structure(text, &error, span, None));
            return reading;
        };
        let present = keys_beside(document.get_ref(), &path);
        reading.diagnostics.push(structure(text, &error, span, Some((&path, &present))));
        remove(document.get_mut(), &path);
        reading.removed.push(path);
        if reading.removed.len() == MOST_REMOVED {
            return reading;
        }
    }
}

/// The document, or its syntax errors: of a large text the first one only.
fn parse(text: &str) -> Result<Spanned<DeTable<'_>>, Vec<Error>> {
    if text.len() > LARGEST_FOR_ALL_ERRORS {
        return DeTable::parse(text).map_err(|error| vec![error]);
    }
    let (document, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() { Ok(document) } else { Err(errors) }
}

/// The path of the innermost entry whose key or value holds `span`.
fn locate(table: &DeTable<'_>, span: &Range<usize>) -> Option<Vec<Step>> {
    for (key, value) in table {
        let step = || Step::Key(key.get_ref().clone().into_owned());
        if let Some(inner) = locate_inside(value, span) {
            return Some([vec![step()], inner].concat());
        }
        if holds(&key.span(), span) || holds(&value.span(), span) {
            return Some(vec![step()]);
        }
    }
    None
}

fn locate_inside(value: &Spanned<DeValue<'_>>, span: &Range<usize>) -> Option<Vec<Step>> {
    match value.get_ref() {
        DeValue::Table(table) => locate(table, span),
        DeValue::Array(list) => list.iter().enumerate().find_map(|(k, element)| {
            let table = element.get_ref().as_table()?;
            locate(table, span).map(|inner| [vec![Step::Index(k)], inner].concat())
        }),
        _ => None,
    }
}

fn holds(outer: &Range<usize>, inner: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end && inner.start < inner.end
}

/// The keys of the table in which `path` ends.
fn keys_beside(table: &DeTable<'_>, path: &[Step]) -> Vec<String> {
    match path {
        [Step::Key(_)] => table.keys().map(|key| key.get_ref().clone().into_owned()).collect(),
        [Step::Key(key), rest @ ..] => match (table.get(key.as_str()).map(Spanned::get_ref), rest) {
            (Some(DeValue::Table(inner)), rest) => keys_beside(inner, rest),
            (Some(DeValue::Array(list)), [Step::Index(k), rest @ ..]) => {
                let inner = list.get(*k).and_then(|element| element.get_ref().as_table());
                inner.map(|inner| keys_beside(inner, rest)).unwrap_or_default()
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

fn remove(table: &mut DeTable<'_>, path: &[Step]) {
    match path {
        [Step::Key(key)] => {
            table.remove(key.as_str());
        }
        [Step::Key(key), Step::Index(k), rest @ ..] => {
            if let Some(DeValue::Array(list)) = table.get_mut(key.as_str()).map(Spanned::get_mut)
                && let Some(DeValue::Table(inner)) = list.get_mut(*k).map(Spanned::get_mut)
            {
                remove(inner, rest);
            }
        }
        [Step::Key(key), rest @ ..] => {
            if let Some(DeValue::Table(inner)) = table.get_mut(key.as_str()).map(Spanned::get_mut) {
                remove(inner, rest);
            }
        }
        _ => {}
    }
}

/// `method`, `search`, …: the name of the innermost table of a path, as its header writes it.
fn table_name(path: &[Step]) -> String {
    let keys: Vec<&str> = path[..path.len() - 1]
        .iter()
        .filter_map(|step| match step {
            Step::Key(key) => Some(key.as_str()),
            Step::Index(_) => None,
        })
        .collect();
    match (keys.join(".").as_str(), path.get(path.len().wrapping_sub(2))) {
        ("", _) => String::new(),
        (name, Some(Step::Index(_))) => format!("[[{name}]]"),
        (name, _) => format!("[{name}]"),
    }
}

/// The first syntax errors: one a line, and no kind of them twice, since the later ones are mostly
/// consequences of the earlier.
fn syntax_errors(text: &str, errors: &[Error]) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let mut lines = Vec::new();
    let mut kinds = Vec::new();
    for error in errors.iter().take(MOST_EXAMINED) {
        let kind = error.message().split(", expected ").next();
        let diagnostic = syntax(text, error);
        let line = diagnostic.position(text).map(|(line, _)| line);
        if lines.contains(&line) || kinds.contains(&kind) {
            continue;
        }
        lines.push(line);
        kinds.push(kind);
        let swallows_the_rest = diagnostic.remedies().iter().any(|help| help == UNCLOSED);
        diagnostics.push(diagnostic);
        if swallows_the_rest || diagnostics.len() == MOST_SYNTAX_ERRORS {
            break;
        }
    }
    diagnostics
}

/// A syntax error in our words.
fn syntax(text: &str, error: &Error) -> Diagnostic {
    let span = error.span().unwrap_or(text.len()..text.len());
    let message = error.message();
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    let at = |what: &str, label: &str, help: &str| {
        Diagnostic::at(Fault::Syntax, span.clone(), format!("this is not TOML: {what}"), label).help(help)
    };
    if what == "duplicate key" {
        let key = shorten(text.get(span.clone()).unwrap_or_default());
        if let Some(misspelt) = misspelt_header(text, span.start) {
            return misspelt;
        }
        return Diagnostic::at(
            Fault::Syntax,
            span,
            format!("`{key}` stands here for the second time"),
            "already given above",
        )
        .help("keep one of the two; only methods are repeated, as [[method]] tables with two brackets");
    }
    let before = text.get(..span.start).unwrap_or_default();
    let opens_line = before[before.rfind('\n').map_or(0, |k| k + 1)..].trim().is_empty();
    let ends_line =
        text.get(span.start..).is_none_or(|rest| rest.lines().next().unwrap_or("").trim().is_empty());
    if what.starts_with("string values must be quoted") {
        return if ends_line {
            at(
                "a value is missing",
                "expected a value",
                "write the value behind the `=`, or take the line out",
            )
        } else if text[span.start..].starts_with('(') {
            at(
                "a round bracket begins no value",
                "expected a value",
                "lists and points stand in square brackets: [[0, 0, 0], [2, 0, 2]]",
            )
        } else {
            at(
                "a text stands without quotes",
                "expected a value",
                "put a text into quotes: energy = \"dirichlet\"",
            )
        };
    }
    let label = if expected.is_empty() { what.to_owned() } else { format!("expected {expected}") };
    let help = if opens_line && what.contains("array") {
        UNCLOSED
    } else if what.contains("string") || what.contains("quote") {
        "a text ends on its line, with the quote it began with: title = \"…\""
    } else {
        "TOML writes key = value, texts in \"quotes\", lists in [brackets] with commas, and tables under a [header]"
    };
    at(what, &label, help)
}

/// The tables of an experiment.
const TABLES: [&str; 8] =
    ["boundary", "method", "search", "helicoid", "trapezium-helicoid", "curve", "expect", "output"];

/// The header that is misspelt, where the header at `end` comes for the second time: a table inside, [method.expect]
/// below [[methd]], makes the next [[method]], or the next [method.expect], the second of its name.
fn misspelt_header(text: &str, end: usize) -> Option<Diagnostic> {
    let table = |line: &str| -> Option<(usize, usize)> {
        let name = line.trim_start().trim_start_matches('[');
        let is_header = line.trim_start().starts_with('[') && line.contains(']');
        let length = name.find([']', '.']).unwrap_or(name.len());
        is_header.then_some((line.len() - name.len(), length))
    };
    let line_start = text[..end].rfind('\n').map_or(0, |k| k + 1);
    let last = text[line_start..].lines().next()?;
    let meant = table(last).map(|(at, length)| last[at..at + length].trim())?;
    let mut start = 0;
    for line in text[..line_start].split_inclusive('\n') {
        if let Some((at, length)) = table(line) {
            let name = &line[at..at + length];
            if !TABLES.contains(&name) && nearest(name, TABLES) == Some(meant) {
                let span = start + at..start + at + length;
                let what = format!("an experiment has no table or key `{}`", shorten(name));
                return Some(
                    Diagnostic::at(Fault::UnknownKey, span, what, "unknown table or key")
                        .help(format!("did you mean `{meant}`?"))
                        .help(format!("an experiment may hold: title, seed, {}", TABLES.join(", "))),
                );
            }
        }
        start += line.len();
    }
    None
}

/// A fault of structure (an unknown key, a wrong type) in our words.
fn structure(
    text: &str,
    error: &Error,
    span: Range<usize>,
    place: Option<(&[Step], &[String])>,
) -> Diagnostic {
    let message = error.message();
    let (path, present) = place.map_or((None, [].as_slice()), |(path, present)| (Some(path), present));
    let key = match path.and_then(<[Step]>::last) {
        Some(Step::Key(key)) => shorten(key),
        _ => String::new(),
    };
    let place = path.map(table_name).filter(|name| !name.is_empty());
    let inside = place.as_ref().map_or(String::new(), |name| format!(" in {name}"));
    if message.starts_with("unknown field") {
        return unknown_key(message, span, &key, place.as_deref(), present);
    }
    if let Some((found, expected)) =
        message.strip_prefix("invalid type: ").and_then(|m| m.rsplit_once(", expected "))
    {
        let table = text.get(span.clone()).is_some_and(|text| text.starts_with(['[', '{']));
        let found = found_in_toml(found, table);
        let expected = match expected {
            "a sequence" => "a list of tables",
            other => other,
        };
        let diagnostic = Diagnostic::at(
            Fault::WrongType,
            span,
            format!("`{key}`{inside} has a value of the wrong type"),
            format!("expected {expected}; this is {found}"),
        );
        return diagnostic.help(type_help(&key, place.is_some(), found, expected));
    }
    if message.contains("overflowed") {
        return Diagnostic::at(
            Fault::Inadmissible,
            span,
            format!("`{key}`{inside} holds a number too large to be represented"),
            "too large",
        )
        .help("whole numbers end at 2^63 - 1 and others at 1.8e308; coordinates are admitted up to 1e60: choose a larger unit");
    }
    Diagnostic::at(Fault::WrongType, span, format!("`{key}`{inside} cannot be read"), shorten(message))
        .help("compare it with a template: `plateau new tensor` prints one")
}

/// `present` are the keys of the same table, which are not likely to be meant once more.
fn unknown_key(
    message: &str,
    span: Range<usize>,
    key: &str,
    place: Option<&str>,
    present: &[String],
) -> Diagnostic {
    // serde lists the keys of the struct behind the last "expected", between backticks.
    let allowed: Vec<&str> = message
        .rsplit_once(", expected ")
        .map(|(_, keys)| keys.split('`').skip(1).step_by(2).collect())
        .unwrap_or_default();
    let (what, label, keys) = match place {
        Some(table) => (
            format!("{table} has no key `{key}`"),
            "unknown key",
            format!("the keys of {table} are: {}", allowed.join(", ")),
        ),
        None => (
            format!("an experiment has no table or key `{key}`"),
            "unknown table or key",
            format!("an experiment may hold: {}", allowed.join(", ")),
        ),
    };
    let diagnostic = Diagnostic::at(Fault::UnknownKey, span, what, label);
    let absent = allowed.iter().copied().filter(|name| !present.iter().any(|p| p == name));
    let diagnostic = match nearest(key, absent).or_else(|| nearest(key, allowed.iter().copied())) {
        Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
        None => diagnostic,
    };
    diagnostic.help(keys)
}

/// serde's "string", "sequence", "map" in TOML's words.
fn found_in_toml(found: &str, table: bool) -> &'static str {
    match found.split([' ', '`']).next() {
        Some("boolean") => "`true` or `false`",
        Some("integer") => "a whole number",
        Some("floating") => "a number with a decimal point",
        Some("sequence") => "a list",
        Some("map") if table => "a table",
        Some("map") => "a date",
        _ if found == "an integer" => "a whole number",
        _ => "a text in quotes",
    }
}

fn type_help(key: &str, inside: bool, found: &str, expected: &str) -> String {
    if key == "method" && !inside {
        return "write [[method]] with two brackets: each such table is one row of the result".to_owned();
    }
    if found == "a list" && expected.starts_with("a table") {
        return format!("write [{key}] with single brackets: an experiment has only one");
    }
    if expected.contains("points") || expected.contains("a point") {
        return format!(
            "write `{key}` as a list of points, each a list of numbers: {key} = [[0, 0, 0], [2, 0, 2], [4, 0, -2]]"
        );
    }
    if expected.starts_with("a table") {
        return format!("open it by the header [{key}] on a line of its own, and write its keys below");
    }
    if found == "a text in quotes" && (expected == "a number" || expected == "a whole number") {
        return "take the quotes away: numbers stand without them".to_owned();
    }
    if found == "a number with a decimal point" && expected == "a whole number" {
        return "write it without a decimal point".to_owned();
    }
    format!("write `{key} = …` with {expected}")
}

/// At most 60 characters of a text that comes from the file.
pub(crate) fn shorten(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
