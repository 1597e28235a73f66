//! How much a result holds, counted before anything of it is kept in memory.
//!
//! A parsed document takes some thirty bytes a value and hundreds a table, many times what the text takes: a text within the
//! limit of bytes could fill gigabytes.

/// Most values, of all kinds, in a result. A number with all digits takes 18 bytes, so that larger ones end at the limit of bytes.
pub(crate) const MAX_VALUES: usize = 4_000_000;

/// Most tables in a result: methods, runs, pieces, points of triangular nets. As this program writes them each takes more than
/// a hundred bytes.
pub(crate) const MAX_TABLES: usize = 400_000;

/// What a text has too much of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Excess {
    Values,
    Tables,
}

/// Whether a JSON text holds more than is admitted. Nothing is kept; what is no JSON at all is left to the parser.
pub(crate) fn excess(text: &[u8]) -> Option<Excess> {
    let (mut values, mut tables) = (0, 0);
    let (mut in_text, mut escaped) = (false, false);
    for byte in text {
        match (in_text, byte) {
            (true, _) if escaped => escaped = false,
            (true, b'\\') => escaped = true,
            (_, b'"') => in_text = !in_text,
            (false, b'{') => (tables, values) = (tables + 1, values + 1),
            // Every value but the first of a list or a table follows one of these.
            (false, b',' | b'[') => values += 1,
            (true | false, _) => {}
        }
        if tables > MAX_TABLES {
            return Some(Excess::Tables);
        }
        if values > MAX_VALUES {
            return Some(Excess::Values);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_tables_are_counted_outside_of_texts() {
        assert_eq!(excess(&b"{\"\":0},".repeat(MAX_TABLES)), None);
        assert_eq!(excess(&b"{\"\":0},".repeat(MAX_TABLES + 1)), Some(Excess::Tables));
        assert_eq!(excess(&b"0,".repeat(MAX_VALUES + 1)), Some(Excess::Values));
        assert_eq!(excess(&b"[".repeat(MAX_VALUES + 1)), Some(Excess::Values));
        let text = [b"\"\\\"\\\\".as_slice(), &b"{,[".repeat(MAX_VALUES), b"\""].concat();
        assert_eq!(excess(&text), None);
    }
}
