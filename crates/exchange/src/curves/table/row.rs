//! Rows of a table and their separator.

use super::number::{is_number, plain};
use crate::curves::text;

/// What stands between the cells of all rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Separator {
    Tab,
    Semicolon,
    Bar,
    Comma,
    Blanks,
}

/// A row that is not empty.
pub(super) struct Row<'a> {
    pub(super) line: usize,
    /// How many blank lines stand above it, counted once where several follow each other.
    pub(super) block: usize,
    pub(super) text: &'a str,
    pub(super) cells: Vec<String>,
}

/// Rows by which the separator is chosen.
const LOOKED_AT: usize = 60;

impl Separator {
    const ALL: [Self; 5] = [Self::Tab, Self::Semicolon, Self::Bar, Self::Comma, Self::Blanks];

    /// The one that makes most of the first rows out of numbers.
    pub(super) fn of(text: &str) -> Self {
        let lines: Vec<&str> = content(text).take(LOOKED_AT).map(|(_, _, line)| line).collect();
        let score = |separator: Self| lines.iter().filter(|line| separator.fits(line)).count();
        let present = |separator: Self| lines.first().is_some_and(|line| cells(line, separator).len() > 1);
        // The first of equals: tabs, semicolons and bars separate on purpose, commas may stand in numbers, blanks anywhere.
        let best = Self::ALL.into_iter().map(score).max().unwrap_or(0);
        let chosen = Self::ALL
            .into_iter()
            .find(|separator| score(*separator) == best && (best > 0 || present(*separator)));
        chosen.unwrap_or(Self::Blanks)
    }

    /// Whether two or more cells of a line are numbers and none is several.
    fn fits(self, line: &str) -> bool {
        let cells = cells(line, self);
        let is_number = |cell: &str| match self {
            Self::Comma => plain(cell).parse::<f64>().is_ok(),
            Self::Tab | Self::Semicolon | Self::Bar | Self::Blanks => is_number(cell),
        };
        let is_several = |cell: &str| {
            let mut parts = cell.split_whitespace();
            parts.clone().count() > 1 && parts.all(|part| part.replacen(',', ".", 1).parse::<f64>().is_ok())
        };
        cells.iter().filter(|cell| is_number(cell)).count() > 1 && !cells.iter().any(|cell| is_several(cell))
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Tab => "tabs",
            Self::Semicolon => "semicolons",
            Self::Bar => "bars (|)",
            Self::Comma => "commas",
            Self::Blanks => "blanks",
        }
    }

    const fn separates(self, c: char) -> bool {
        match self {
            Self::Tab => c == '\t',
            Self::Semicolon => c == ';',
            Self::Bar => c == '|',
            Self::Comma => c == ',',
            Self::Blanks => c == ' ' || c == '\t',
        }
    }
}

/// The rows of a text.
pub(super) fn rows(text: &str, separator: Separator) -> impl Iterator<Item = Row<'_>> {
    content(text).map(move |(line, block, text)| Row { line, block, text, cells: cells(text, separator) })
}

/// Whether the cells of a column count the rows: whole numbers, each one more than the one before.
pub(super) fn are_counted(text: &str, separator: Separator, place: usize) -> bool {
    let mut numbers = rows(text, separator)
        .map(|row| row.cells.get(place).and_then(|cell| cell.parse::<i64>().ok()))
        .peekable();
    let Some(Some(first)) = numbers.peek().copied() else { return false };
    numbers.enumerate().all(|(k, number)| {
        number.is_some_and(|number| i64::try_from(k).is_ok_and(|k| number.checked_sub(first) == Some(k)))
    })
}

/// Lines with something on them: number, block, text.
fn content(text: &str) -> impl Iterator<Item = (usize, usize, &str)> {
    let (mut block, mut is_blank) = (0, true);
    text::lines(text).filter_map(move |(number, line)| {
        if line.is_empty() {
            is_blank = true;
            return None;
        }
        // Excel's own way to say what separates, and the rule below a heading between bars.
        if line.starts_with('#')
            || is_rule(line)
            || (number == 1 && line.to_ascii_lowercase().starts_with("sep="))
        {
            return None;
        }
        block += usize::from(std::mem::take(&mut is_blank));
        Some((number, block, line))
    })
}

/// Whether a line is nothing but bars and dashes: `|---|---|`.
fn is_rule(line: &str) -> bool {
    line.contains('|') && line.contains("--") && line.chars().all(|c| "|-:+ ".contains(c))
}

/// The cells of a line. Quotes keep what stands between them together, doubled ones are one. Empty cells at the end, which
/// spreadsheets leave, are dropped.
fn cells(line: &str, separator: Separator) -> Vec<String> {
    let mut cells = Vec::new();
    let (mut cell, mut is_quoted, mut was_quoted) = (String::new(), false, false);
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        if is_quoted {
            match c {
                '"' if chars.peek() == Some(&'"') => {
                    chars.next();
                    cell.push('"');
                }
                '"' => is_quoted = false,
                c => cell.push(c),
            }
        } else if c == '"' && cell.trim().is_empty() {
            cell.clear();
            (is_quoted, was_quoted) = (true, true);
        } else if separator.separates(c) {
            let done = std::mem::take(&mut cell);
            // Several blanks separate once.
            if separator != Separator::Blanks || was_quoted || !done.is_empty() {
                cells.push(done.trim().to_owned());
            }
            was_quoted = false;
        } else {
            cell.push(c);
        }
    }
    cells.push(cell.trim().to_owned());
    // Bars may frame a line.
    if separator == Separator::Bar && cells.len() > 1 && cells[0].is_empty() {
        cells.remove(0);
    }
    while cells.len() > 1 && cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    cells
}

impl Row<'_> {
    /// Whether it names columns: no cell but the first is a number.
    pub(super) fn is_heading(&self) -> bool {
        // `nan` and `inf` are numbers to a parser, and no names of columns.
        self.cells.len() > 1
            && !self.cells.iter().skip(1).any(|cell| is_number(cell))
            && !is_number(&self.cells[0])
    }
}
