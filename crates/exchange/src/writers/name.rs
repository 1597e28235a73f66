//! Names of surfaces as other programs take them. They come from the experiment file and may hold anything.

/// On one line, for formats that are read by lines: what some reader takes for a line break is a space.
pub(super) fn one_line(name: &str) -> String {
    let breaks = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    name.chars().map(|c| if breaks(c) { ' ' } else { c }).collect()
}

/// For headers that are read as ASCII: dashes and quotes become plain ones, whatever else there is a question mark.
pub(super) fn ascii(name: &str) -> String {
    let plain = |c| match c {
        '\u{2010}'..='\u{2015}' | '\u{2212}' => '-',
        '\u{2018}' | '\u{2019}' => '\'',
        c if c.is_ascii() => c,
        _ => '?',
    };
    one_line(name).chars().map(plain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_one_line_and_plain_where_they_must_be() {
        assert_eq!(one_line("α\nb\u{85}c\u{2028}d\u{1b}"), "α b c d ");
        assert_eq!(ascii("TB–Coons’ α"), "TB-Coons' ?");
        assert_eq!(ascii("mask −1/4\r\n"), "mask -1/4  ");
    }
}
