use std::borrow::Cow;

/// A column of a table on the terminal.
#[derive(Debug, Clone)]
pub struct Column {
    /// Its name.
    pub heading: &'static str,
    /// The unit below it, or what its numbers are called; empty if there is none.
    pub unit: Cow<'static, str>,
    /// Where the figure stands in a method's entry of `result.json`; empty where the column shows none.
    pub key: &'static str,
    /// Where there is no room the columns of the highest rank are left out first; those of rank 0 never.
    pub rank: u8,
    /// Words are read from the left, numbers from the right.
    pub is_words: bool,
}

impl Column {
    /// A column of words.
    pub fn words(heading: &'static str, unit: impl Into<Cow<'static, str>>) -> Self {
        Self { heading, unit: unit.into(), key: "", rank: 0, is_words: true }
    }

    /// A column of numbers.
    pub fn number(heading: &'static str, unit: impl Into<Cow<'static, str>>) -> Self {
        Self { heading, unit: unit.into(), key: "", rank: 0, is_words: false }
    }
}
