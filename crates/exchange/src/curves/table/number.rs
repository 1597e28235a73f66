//! Cells as numbers.

use std::borrow::Cow;

/// A cell with the minus sign of typesetters as that of programs, and with an exponent of Fortran, `1.0D+00`, as one of all others.
pub(super) fn plain(cell: &str) -> Cow<'_, str> {
    let cell = if cell.contains(MINUS) { cell.replace(MINUS, "-").into() } else { Cow::Borrowed(cell) };
    match fortran_exponent(&cell) {
        Some(place) => format!("{}e{}", &cell[..place], &cell[place + 1..]).into(),
        None => cell,
    }
}

/// Whether a cell is a number, its decimals behind a point or a comma. So are `nan` and `inf`.
pub(super) fn is_number(cell: &str) -> bool {
    plain(cell).replacen(',', ".", 1).parse::<f64>().is_ok()
}

/// What keeps a cell from being a number, and what to do; nothing where no digit says that it was to be one.
pub(super) fn obstacle(cell: &str) -> String {
    let cell = plain(cell);
    if !cell.chars().any(char::is_numeric) {
        return String::new();
    }
    let is_of_numbers = |c: char| c.is_ascii_digit() || "+-.,eE".contains(c);
    let Some(c) = cell.chars().find(|c| !is_of_numbers(*c)) else { return String::new() };
    let code = format!("U+{:04X}", u32::from(c));
    let without_letters = !cell.chars().any(char::is_alphabetic);
    match c {
        '\'' | '\u{2019}' if without_letters => {
            ": an apostrophe is in the way: write numbers without separators of thousands".into()
        }
        c if c.is_whitespace() && without_letters => {
            format!(": a space ({code}) is in the way: write numbers without separators of thousands")
        }
        '\u{2010}'..='\u{2015}' | '\u{FE63}' | '\u{FF0D}' => {
            format!(": a dash ({code}) is in the way: write the minus sign - of the keyboard (U+002D)")
        }
        c if c.is_numeric() => {
            format!(": the digit {c} ({code}) is in the way: write digits 0 to 9 (U+0030 to U+0039)")
        }
        c if c.is_control() => format!(": the character {code} is in the way: write the number alone"),
        c => format!(": the character {c} ({code}) is in the way: write the number alone"),
    }
}

/// The minus sign of typesetters.
const MINUS: char = '\u{2212}';

/// Where the D of an exponent stands: behind decimals or before a sign, for `1d2` may be a name.
fn fortran_exponent(cell: &str) -> Option<usize> {
    let place = cell.find(['d', 'D'])?;
    let (mantissa, exponent) = (&cell[..place], &cell[place + 1..]);
    let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    let is_marked = digits.len() < exponent.len() || mantissa.contains(['.', ',']);
    let is_exponent = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let is_mantissa = mantissa.bytes().any(|byte| byte.is_ascii_digit())
        && mantissa.bytes().all(|byte| byte.is_ascii_digit() || b"+-.,".contains(&byte));
    (is_marked && is_exponent && is_mantissa).then_some(place)
}
