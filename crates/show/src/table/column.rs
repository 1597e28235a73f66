/// A column of a table on the terminal.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its name.
    pub heading: &'static str,
    /// The unit below it; empty if there is none.
    pub unit: &'static str,
    /// Where the figure stands in a method's entry of `result.json`; empty where the column shows none.
    pub key: &'static str,
    /// Where there is no room the columns of the highest rank are left out first; those of rank 0 never.
    pub rank: u8,
    /// Words are read from the left, numbers from the right.
    pub is_words: bool,
}

impl Column {
    /// A column of words.
    pub const fn words(heading: &'static str, unit: &'static str) -> Self {
        Self { heading, unit, key: "", rank: 0, is_words: true }
    }

    /// A column of numbers.
    pub const fn number(heading: &'static str, unit: &'static str) -> Self {
        Self { heading, unit, key: "", rank: 0, is_words: false }
    }
}
