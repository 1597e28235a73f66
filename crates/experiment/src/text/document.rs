//! From a text to its document.

use serde_spanned::Spanned;
use toml::de::{DeTable, Error};

use super::key::Section;
use super::{size, syntax};
use crate::diagnostic::Diagnostic;

/// Largest text in bytes whose syntax errors are all collected: there may be one a byte, and each takes hundreds of them.
const LARGEST_FOR_ALL_ERRORS: usize = 32 * 1024;

/// The document with the place of every key and value, or why the text has none. Whatever the text, it takes no more than
/// some 50 MB. `section` is what the file may hold.
pub(crate) fn parse<'t>(text: &'t str, section: &Section) -> Result<Spanned<DeTable<'t>>, Vec<Diagnostic>> {
    if let Some(excess) = size::beyond(text) {
        return Err(vec![excess]);
    }
    document(text).map_err(|errors| syntax::diagnostics(text, &errors, section))
}

/// The document, or its syntax errors: of a large text the first one only.
fn document(text: &str) -> Result<Spanned<DeTable<'_>>, Vec<Error>> {
    if text.len() > LARGEST_FOR_ALL_ERRORS {
        return DeTable::parse(text).map_err(|error| vec![error]);
    }
    let (document, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() { Ok(document) } else { Err(errors) }
}
