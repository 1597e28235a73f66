//! What is said of a key whatever its kind.

use super::words::Words;

/// What is said of a key whatever its kind.
#[derive(Clone, Copy)]
pub(crate) struct Head {
    /// As the file writes it.
    pub(crate) name: &'static str,
    /// What it is, as a noun phrase: "the seed of every random choice".
    pub(crate) doc: Words,
    /// The value that an absent key has, as the file would write it.
    pub(crate) default: Option<&'static str>,
    /// What to do about a value that is refused or missing, where the meaning does not say it.
    pub(crate) hint: Words,
    /// Whether its table is nothing without it.
    pub(crate) required: bool,
    /// The kinds of boundary over which a method may have it; empty if over all.
    pub(crate) over: &'static [&'static str],
    pub(super) example: Option<&'static str>,
}

impl Head {
    /// A value as the file would write it.
    pub(crate) fn example(&self) -> &'static str {
        self.example.or(self.default).unwrap_or("…")
    }

    /// What to do: the hint, or what the key means with an example.
    pub(crate) fn remedy(&self) -> String {
        let hint = self.hint.phrase();
        if !hint.is_empty() {
            return hint.into_owned();
        }
        format!("write, for instance, {} = {}: {}", self.name, self.example(), self.doc.phrase())
    }
}
