//! Texts that are not TOML.
//!
//! The `toml` crate says where a text breaks its rules. What is wrong there, and what to do, is told from the tokens and
//! events around the place; the crate's own sentence is passed on where nothing better is known, but never examined.

use std::borrow::Cow;
use std::ops::Range;

use toml::de::Error;
use toml_parser::decoder::ScalarKind;
use toml_parser::lexer::{Token, TokenKind};
use toml_parser::parser::{Event, EventKind, RecursionGuard, ValidateWhitespace, parse_document};
use toml_parser::{ErrorSink, Expected, ParseError, Source, Span};

use super::key::Section;
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};

/// Syntax errors shown: each may cause others behind it.
const MOST_SHOWN: usize = 3;

/// Syntax errors looked at: finding the lines of all of them would take the square of their number.
const MOST_EXAMINED: usize = 64;

/// Lists and tables inside one another that the `toml` crate follows.
const DEEPEST: u32 = 80;

/// The remedy for an error behind which nothing is read as it was meant.
const UNCLOSED: &str =
    "a list that begins further up is not closed: count its brackets, or look for a missing comma";

/// What is said of JSON.
const JSON: &str = "of a result.json `plateau verify` computes every number again and `plateau export` writes the surfaces; the experiment it came from \
     stands in it as manifest.experiment";

/// The first of the errors: one a line, and no kind of them twice, since the later ones are mostly consequences of the earlier.
pub(super) fn diagnostics(text: &str, errors: &[Error], section: &Section) -> Vec<Diagnostic> {
    let syntax = Syntax::new(text, section);
    let start = text.len() - text.trim_start().len();
    if text[start..].starts_with('{') {
        return vec![syntax.at(start..start + 1, "it is JSON", "JSON begins so", JSON)];
    }
    let (mut diagnostics, mut lines, mut kinds) = (Vec::new(), Vec::new(), Vec::new());
    for error in errors.iter().take(MOST_EXAMINED) {
        let span = error.span().unwrap_or(text.len()..text.len());
        let broken = syntax.broken.iter().find(|rule| rule.unexpected().map(range) == Some(span.clone()));
        let kind = broken.map_or(error.message(), ParseError::description);
        let diagnostic = match broken {
            Some(rule) => syntax.broken_rule(rule, span),
            None if syntax.is_key(&span) => syntax.repeated_key(span),
            None => syntax.at(span, error.message(), error.message(), TOML),
        };
        let line = diagnostic.position(text).map(|(line, _)| line);
        if lines.contains(&line) || kinds.contains(&kind) {
            continue;
        }
        lines.push(line);
        kinds.push(kind);
        let swallows_the_rest = diagnostic.remedies().iter().any(|help| help == UNCLOSED);
        diagnostics.push(diagnostic);
        if swallows_the_rest || diagnostics.len() == MOST_SHOWN {
            break;
        }
    }
    diagnostics
}

const TOML: &str = "TOML writes key = value, texts in \"quotes\", lists in [brackets] with commas, and tables under a [header]";

fn range(span: Span) -> Range<usize> {
    span.start()..span.end()
}

/// A text that is not TOML: its tokens, its events, and the rules of grammar and of writing values that it breaks.
struct Syntax<'a> {
    text: &'a str,
    section: &'a Section,
    tokens: Vec<Token>,
    events: Vec<Event>,
    broken: Vec<ParseError>,
}

/// The first errors only: there may be one a byte.
struct First(Vec<ParseError>);

impl ErrorSink for First {
    fn report_error(&mut self, error: ParseError) {
        if self.0.len() < 2 * MOST_EXAMINED {
            self.0.push(error);
        }
    }
}

impl<'a> Syntax<'a> {
    fn new(text: &'a str, section: &'a Section) -> Self {
        let source = Source::new(text);
        let tokens = source.lex().into_vec();
        let (mut events, mut errors) = (Vec::new(), First(Vec::new()));
        let mut validated = ValidateWhitespace::new(&mut events, source);
        parse_document(&tokens, &mut RecursionGuard::new(&mut validated, DEEPEST), &mut errors);
        for event in &events {
            let Some(raw) = source.get(event) else { continue };
            let mut decoded = Cow::Borrowed("");
            if event.kind() == EventKind::SimpleKey {
                raw.decode_key(&mut decoded, &mut errors);
            } else if event.kind() == EventKind::Scalar {
                let _: ScalarKind = raw.decode_scalar(&mut decoded, &mut errors);
            }
        }
        Self { text, section, tokens, events, broken: errors.0 }
    }

    fn at(&self, span: Range<usize>, what: &str, label: &str, help: &str) -> Diagnostic {
        Diagnostic::at(Fault::Syntax, span, format!("this is not TOML: {what}"), label).help(help)
    }

    /// Whether a whole key stands at the place.
    fn is_key(&self, span: &Range<usize>) -> bool {
        self.events.iter().any(|event| event.kind() == EventKind::SimpleKey && range(event.span()) == *span)
    }

    /// A key that breaks no rule by itself.
    fn repeated_key(&self, span: Range<usize>) -> Diagnostic {
        if let Some(misspelt) = self.misspelt_header(span.start) {
            return misspelt;
        }
        let key = shorten(self.text.get(span.clone()).unwrap_or_default());
        let what = format!("`{key}` stands here for the second time");
        Diagnostic::at(Fault::Syntax, span, what, "already given above")
            .help("keep one of the two; only methods are repeated, as [[method]] tables with two brackets")
    }

    /// The last token that begins before a place, blanks aside.
    fn token_before(&self, at: usize) -> Option<&Token> {
        let end = self.tokens.partition_point(|token| token.span().start() < at);
        self.tokens[..end].iter().rev().find(|token| token.kind() != TokenKind::Whitespace)
    }

    /// The token that begins at a place.
    fn token_at(&self, at: usize) -> Option<&Token> {
        let first = self.tokens.partition_point(|token| token.span().start() < at);
        self.tokens.get(first).filter(|token| token.span().start() == at)
    }

    /// Lists that are open at a place.
    fn open_lists(&self, at: usize) -> usize {
        let (mut depth, mut opens_line) = (0usize, true);
        for token in self.tokens.iter().take_while(|token| token.span().start() < at) {
            let kind = token.kind();
            // A header, which may lack its end.
            let is_header = kind == TokenKind::LeftSquareBracket && opens_line && depth == 0;
            if is_header || kind == TokenKind::Whitespace {
                continue;
            }
            if kind == TokenKind::LeftSquareBracket {
                depth += 1;
            } else if kind == TokenKind::RightSquareBracket {
                depth = depth.saturating_sub(1);
            }
            opens_line = kind == TokenKind::Newline;
        }
        depth
    }

    fn broken_rule(&self, rule: &ParseError, span: Range<usize>) -> Diagnostic {
        let (before, here) = (self.token_before(span.start), self.token_at(span.start));
        let is_value = before.is_some_and(|token| {
            use TokenKind::{Comma, Equals, LeftSquareBracket};
            matches!(token.kind(), Equals | Comma | LeftSquareBracket)
        });
        let rest = self.text.get(span.start..).unwrap_or_default();
        let ends_line = rest.lines().next().unwrap_or("").trim().is_empty();
        if before.is_some_and(|token| token.kind() == TokenKind::Equals) && ends_line {
            let help = "write the value behind the `=`, or take the line out";
            return self.at(span, "a value is missing", "expected a value", help);
        }
        if is_value && rest.starts_with('(') {
            let help = "lists and points stand in square brackets: [[0, 0, 0], [2, 0, 2]]";
            return self.at(span, "a round bracket begins no value", "expected a value", help);
        }
        let is_word = rest.starts_with(|letter: char| letter.is_alphabetic() || letter == '_');
        if is_value && is_word && here.is_some_and(|token| token.kind() == TokenKind::Atom) {
            let help = "put a text into quotes: energy = \"dirichlet\"";
            return self.at(span, "a text stands without quotes", "expected a value", help);
        }
        let opens_line = before.is_none_or(|token| token.kind() == TokenKind::Newline);
        let help = if opens_line && self.open_lists(span.start) > 0 {
            UNCLOSED
        } else if self.is_in_text(span.start) {
            "a text ends on its line, with the quote it began with: title = \"…\""
        } else {
            TOML
        };
        let label = match rule.expected() {
            Some(expected) => format!("expected {}", listed(expected)),
            None => rule.description().to_owned(),
        };
        self.at(span, rule.description(), &label, help)
    }

    /// Whether a text in quotes holds the place, or ends at it.
    fn is_in_text(&self, at: usize) -> bool {
        use TokenKind::{BasicString, LiteralString, MlBasicString, MlLiteralString, Newline};
        let here = self.token_at(at).filter(|token| token.kind() != Newline);
        here.or_else(|| self.token_before(at)).is_some_and(|token| {
            let is_text =
                matches!(token.kind(), BasicString | LiteralString | MlBasicString | MlLiteralString);
            is_text && at <= token.span().end()
        })
    }

    /// The header that is misspelt, where the header at `end` comes for the second time: a table inside, [method.expect]
    /// below [[methd]], makes the next [[method]], or the next [method.expect], the second of its name.
    fn misspelt_header(&self, end: usize) -> Option<Diagnostic> {
        let table = |line: &str| -> Option<(usize, usize)> {
            let name = line.trim_start().trim_start_matches('[');
            let is_header = line.trim_start().starts_with('[') && line.contains(']');
            let length = name.find([']', '.']).unwrap_or(name.len());
            is_header.then_some((line.len() - name.len(), length))
        };
        let line_start = self.text[..end].rfind('\n').map_or(0, |k| k + 1);
        let last = self.text[line_start..].lines().next()?;
        let meant = table(last).map(|(at, length)| last[at..at + length].trim())?;
        let mut start = 0;
        for line in self.text[..line_start].split_inclusive('\n') {
            if let Some((at, length)) = table(line) {
                let name = &line[at..at + length];
                let names = self.section.names();
                if !names.clone().any(|known| known == name) && nearest(name, names.clone()) == Some(meant) {
                    let span = start + at..start + at + length;
                    let what = format!("an experiment has no table or key `{}`", shorten(name));
                    return Some(
                        Diagnostic::at(Fault::UnknownKey, span, what, "unknown table or key")
                            .help(format!("did you mean `{meant}`?"))
                            .help(format!(
                                "an experiment may hold: {}",
                                names.collect::<Vec<_>>().join(", ")
                            )),
                    );
                }
            }
            start += line.len();
        }
        None
    }
}

/// What the grammar admits, as a list.
fn listed(expected: &[Expected]) -> String {
    let words = expected.iter().map(|one| match one {
        Expected::Literal("\n") => "the end of the line".to_owned(),
        Expected::Literal(text) => format!("`{text}`"),
        Expected::Description(text) => (*text).to_owned(),
        _ => "something else".to_owned(),
    });
    let words: Vec<String> = words.collect();
    if words.is_empty() { "nothing".to_owned() } else { words.join(", ") }
}
