//! Text from outside as a terminal may show it: names, titles, file names, messages that quote them.

use std::fmt::{self, Display, Write};

use unicode_width::UnicodeWidthStr;

/// Text on one line that moves no cursor, changes no colour and turns no direction of writing: line breaks, controls (C0,
/// C1, delete), and the marks of bidirectional text are written as an experiment file would write them, `\n` or `\u001b`.
/// What is shown can therefore never be mistaken for a line of ours.
///
/// ```
/// use show::Printable;
///
/// assert_eq!(Printable("steep\nerror: \u{1b}[31mα").to_string(), r"steep\nerror: \u001b[31mα");
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Printable<'a>(pub &'a str);

impl Display for Printable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| write_char(f, c))
    }
}

impl Printable<'_> {
    /// Most columns of a name in a table: one long name must not push all others apart.
    pub const NAME: usize = 44;

    /// Most columns of a title.
    pub const TITLE: usize = 240;

    /// The text in at most `most` ≥ 1 columns of a terminal; what is cut off is an ellipsis. Marks and joined emoji beyond
    /// those of any script are cut off, too, though they take no column: what is shown, and the time that it takes, do not
    /// grow with the text.
    pub fn cut(self, most: usize) -> String {
        let mut shown = String::new();
        let (mut width, mut piled) = (0, 0);
        for (at, c) in self.0.char_indices() {
            let before = shown.len();
            // Writing to a string does not fail.
            let _ = write_char(&mut shown, c);
            let rest = usize::from(at + c.len_utf8() < self.0.len());
            let wider = columns(&shown);
            piled = if wider > width { 0 } else { piled + 1 };
            width = wider;
            if width + rest > most || piled > PILED {
                shown.truncate(before);
                while columns(&shown) >= most {
                    shown.pop();
                }
                return shown + "…";
            }
        }
        shown
    }

    /// [`Self::cut`] to `width` columns and filled up with blanks.
    pub fn fitted(self, width: usize) -> String {
        let shown = self.cut(width);
        let blanks = " ".repeat(width.saturating_sub(columns(&shown)));
        shown + &blanks
    }
}

/// Most characters in a row that take no column of their own: an emoji of two people has nine.
const PILED: usize = 16;

/// The columns that a list of names takes, [`Printable::NAME`] at most.
pub fn width_of_names<'a>(names: impl IntoIterator<Item = &'a str>) -> usize {
    names.into_iter().map(|name| columns(&Printable(name).cut(Printable::NAME))).max().unwrap_or(0)
}

/// The columns of a terminal that a shown text takes.
pub(crate) fn columns(shown: &str) -> usize {
    UnicodeWidthStr::width(shown)
}

/// Whether a character must not reach a terminal as it is.
pub(crate) fn is_hidden(c: char) -> bool {
    let turns =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let breaks = matches!(c, '\u{2028}' | '\u{2029}');
    // Names that differ in these look the same. Joiners (ZWJ, ZWNJ) and the marks of variants belong to scripts and emoji.
    let vanishes = matches!(
        c,
        '\u{ad}' | '\u{34f}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180e}' | '\u{200b}' | '\u{2060}'
            ..='\u{2065}' | '\u{206a}'..='\u{206f}' | '\u{3164}' | '\u{ffa0}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}'
    );
    let annotates = matches!(c, '\u{feff}' | '\u{fff9}'..='\u{fffb}');
    c.is_control() || turns || breaks || vanishes || annotates
}

/// A character as it may be shown.
pub(crate) fn write_char(out: &mut impl Write, c: char) -> fmt::Result {
    match c {
        '\n' => out.write_str("\\n"),
        '\r' => out.write_str("\\r"),
        '\t' => out.write_str("\\t"),
        _ if is_hidden(c) => write!(out, "\\u{:04x}", u32::from(c)),
        _ => out.write_char(c),
    }
}

/// Source text for an excerpt: every character that must not reach a terminal is replaced by a visible one that takes as
/// many bytes, so that places in the text stay where they are. Line breaks and tabs remain.
pub fn stand_ins(text: &str) -> String {
    let text_of = |c: char| match c.len_utf8() {
        _ if !is_hidden(c) || matches!(c, '\n' | '\r' | '\t') => c,
        1 => '?',
        2 => '¿',
        3 => '\u{fffd}',
        _ => '\u{1f6c7}',
    };
    text.chars().map(text_of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Characters of every kind that can do harm.
    const HARMFUL: [char; 18] = [
        '\0',
        '\u{7}',
        '\u{8}',
        '\n',
        '\r',
        '\u{1b}',
        '\u{7f}',
        '\u{85}',
        '\u{9b}',
        '\u{61c}',
        '\u{2028}',
        '\u{202e}',
        '\u{2066}',
        '\u{feff}',
        '\u{ad}',
        '\u{200b}',
        '\u{3164}',
        '\u{e0041}',
    ];

    #[test]
    fn nothing_harmful_is_shown_and_nothing_else_is_changed() {
        for c in HARMFUL {
            let shown = Printable(&format!("a{c}b")).to_string();
            assert!(shown.starts_with("a\\") && shown.ends_with('b'), "{shown:?}");
            assert!(!shown.chars().any(is_hidden), "{shown:?}");
        }
        let plain = "Häßlich α1, 最小曲面, 👩‍👩‍👧 \\n 'x'";
        assert_eq!(Printable(plain).to_string(), plain);
    }

    #[test]
    fn what_is_cut_is_as_wide_as_allowed_and_says_so() {
        assert_eq!(Printable("bicubic").cut(7), "bicubic");
        assert_eq!(Printable("bicubic").cut(6), "bicub…");
        assert_eq!(Printable("最小曲面").cut(6), "最小…");
        assert_eq!(Printable("abc\u{1b}").cut(6), "abc…");
        assert_eq!(Printable("最").cut(1), "…");
        for most in 1..12 {
            assert!(columns(&Printable("a最\u{1b}b\nc小d").cut(most)) <= most, "{most}");
        }
    }

    #[test]
    fn what_piles_up_in_one_column_is_cut() {
        let couple = "👩🏽‍❤️‍💋‍👨🏽";
        assert_eq!(Printable(&couple.repeat(3)).cut(44), couple.repeat(3));
        for pile in ["a".to_owned() + &"\u{301}".repeat(3000), "👩\u{200d}".repeat(60_000)] {
            let shown = Printable(&pile).cut(Printable::NAME);
            assert!(shown.ends_with('…') && shown.chars().count() < 40, "{shown}");
        }
        // However it is mixed, no more than so many are shown for each column.
        let mixed = ("x".to_owned() + &"\u{301}".repeat(PILED)).repeat(5000);
        let shown = Printable(&mixed).cut(Printable::TITLE);
        assert_eq!((columns(&shown), shown.chars().count()), (240, 239 * (PILED + 1) + 1));
    }

    #[test]
    fn stand_ins_keep_every_place_of_the_text() {
        for c in HARMFUL {
            let text = format!("é{c}x");
            let shown = stand_ins(&text);
            assert_eq!((shown.len(), shown.find('x')), (text.len(), text.find('x')), "{c:?}");
            assert!(shown.chars().all(|c| !is_hidden(c) || "\n\r\t".contains(c)), "{c:?}");
        }
    }
}
