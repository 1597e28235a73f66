//! How deep a place of a text lies in brackets.

use toml_parser::lexer::TokenKind;

/// The depth behind a token; brackets that close nothing do not count.
pub(crate) fn depth_after(kind: TokenKind, depth: usize) -> usize {
    if matches!(kind, TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket) {
        depth + 1
    } else if matches!(kind, TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket) {
        depth.saturating_sub(1)
    } else {
        depth
    }
}
