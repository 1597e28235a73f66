//! A text in its parts: what stands above the first header, and what each header opens.

use std::ops::Range;

use toml_parser::Source;
use toml_parser::lexer::TokenKind;

use crate::text::depth_after;

/// A header with the lines below it, up to the next header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Segment {
    /// The first name of the header, without quotes; empty above the first header.
    pub(super) table: String,
    pub(super) range: Range<usize>,
}

/// The parts of a TOML text, in order; together they are the text.
pub(super) fn segments(text: &str) -> Vec<Segment> {
    let mut segments = vec![Segment { table: String::new(), range: 0..0 }];
    let (mut depth, mut opens_line) = (0usize, true);
    let mut tokens = Source::new(text).lex().peekable();
    while let Some(token) = tokens.next() {
        let kind = token.kind();
        let start = token.span().start();
        if kind == TokenKind::LeftSquareBracket && depth == 0 && opens_line {
            while tokens.peek().is_some_and(|next| {
                matches!(next.kind(), TokenKind::LeftSquareBracket | TokenKind::Whitespace)
            }) {
                depth +=
                    usize::from(tokens.next().map(|next| next.kind()) == Some(TokenKind::LeftSquareBracket));
            }
            let name = tokens.peek().map_or("", |next| &text[next.span().start()..next.span().end()]);
            if let Some(last) = segments.last_mut() {
                last.range.end = start;
            }
            segments.push(Segment { table: name.trim_matches(['"', '\'']).to_owned(), range: start..start });
        }
        depth = depth_after(kind, depth);
        opens_line = kind == TokenKind::Newline || (opens_line && kind == TokenKind::Whitespace);
    }
    if let Some(last) = segments.last_mut() {
        last.range.end = text.len();
    }
    segments
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_begin_at_headers_and_are_the_whole_text() {
        let text = "a = [\n[1], [2]]\n# x\n[b] # y\nc = \"\"\"\n[d]\n\"\"\"\n  [[ \"sweep\".axis ]]\nk = 1\n[b.e]\nz = {q = [\n[3]]}";
        let found = segments(text);
        let tables: Vec<&str> = found.iter().map(|segment| segment.table.as_str()).collect();
        assert_eq!(tables, ["", "b", "sweep", "b"]);
        let whole: String = found.iter().map(|segment| &text[segment.range.clone()]).collect();
        assert_eq!(whole, text);
        assert!(text[found[2].range.clone()].contains("k = 1"));
    }
}
