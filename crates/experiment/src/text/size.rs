//! How much a text holds, counted before anything of it is kept in memory.
//!
//! A parsed document takes about a hundred bytes a value and a thousand a table, many times what the text takes: a text
//! within the limit of bytes could fill gigabytes. The lexer keeps nothing, so the count costs no memory.

use toml_parser::Source;
use toml_parser::lexer::{Token, TokenKind};

use super::depth::depth_after;
use crate::diagnostic::{Diagnostic, Fault};
use crate::limits::{MAX_KEYS, MAX_TOKENS};

/// Refuses a text with more keys or more tokens than are admitted, at the first that is too many.
pub(super) fn beyond(text: &str) -> Option<Diagnostic> {
    let (mut keys, mut tokens, mut depth) = (0, 0, 0usize);
    let (mut opens_line, mut last) = (true, [None::<Token>; 2]);
    for token in Source::new(text).lex() {
        let kind = token.kind();
        if kind == TokenKind::Whitespace {
            continue;
        }
        let span = token.span().start()..token.span().end();
        tokens += 1;
        let begins_key = matches!(kind, TokenKind::Equals | TokenKind::LeftCurlyBracket)
            || (kind == TokenKind::LeftSquareBracket && opens_line && depth == 0)
            || (kind == TokenKind::Dot && !is_decimal_point(text, span.start, last[1]));
        keys += usize::from(begins_key);
        depth = depth_after(kind, depth);
        opens_line = kind == TokenKind::Newline;
        last = [Some(token), last[0]];
        if keys > MAX_KEYS {
            let label = format!("the {}th", MAX_KEYS + 1);
            return Some(
                Diagnostic::at(
                    Fault::Inadmissible,
                    span,
                    format!("the file holds more than {MAX_KEYS} keys and tables"),
                    label,
                )
                .help("split it into several experiments: each file takes as many methods as fit into this limit"),
            );
        }
        if tokens > MAX_TOKENS {
            let label = format!("the {}th", MAX_TOKENS + 1);
            return Some(
                Diagnostic::at(
                    Fault::Inadmissible,
                    span,
                    format!("the file holds more than {MAX_TOKENS} numbers, names, commas, brackets and line ends"),
                    label,
                )
                .help(
                    "split it into several experiments; equally spaced samples of a curve are written as their number, \
                     samples = 1001",
                ),
            );
        }
    }
    None
}

/// Whether the dot at `at` stands inside a number: between digits, the part before it not behind another dot.
fn is_decimal_point(text: &str, at: usize, before_the_part: Option<Token>) -> bool {
    let digit = |k: Option<usize>| k.and_then(|k| text.as_bytes().get(k)).is_some_and(u8::is_ascii_digit);
    digit(at.checked_sub(1))
        && digit(at.checked_add(1))
        && before_the_part.is_none_or(|t| t.kind() != TokenKind::Dot)
}
