use std::fmt::{self, Display, Write};

use crate::printable::write_char;

/// Text colour.
pub(super) const INK: &str = "#1c2733";
/// Colour of what explains: ticks, captions.
pub(super) const FAINT: &str = "#5a6673";
/// Lines of a grid.
pub(super) const GRID: &str = "#e3e7ec";
/// The one line that matters.
pub(super) const ACCENT: &str = "#b3261e";
/// Colours of lines of one kind: dark enough on white for labels, and told apart by most who see colours badly. Repeated beyond seven.
pub(super) const LINES: [&str; 7] =
    [ACCENT, "#0b63b0", "#1a7f4b", "#8a4fb0", "#a05a00", "#00798a", "#4a4f57"];

/// Half the width of slits between faces that are closed.
const SLIT: f64 = 0.7;

/// An SVG picture as it grows, on a white ground.
pub(crate) struct Svg {
    body: String,
    width: f64,
    height: f64,
    title: String,
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Clone, Copy)]
pub(super) struct Font {
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) colour: &'static str,
}

impl Font {
    /// Titles of panels.
    pub(super) const TITLE: Self = Self { size: 13.0, bold: true, colour: INK };
    /// Labels of axes.
    pub(super) const LABEL: Self = Self { size: 12.0, bold: false, colour: INK };
    /// Numbers at ticks, captions.
    pub(super) const SMALL: Self = Self { size: 11.0, bold: false, colour: FAINT };
}

impl Svg {
    /// An empty picture; `title` is read out by screen readers.
    pub(super) fn new(width: f64, height: f64, title: &str) -> Self {
        Self { body: String::new(), width, height, title: title.to_owned() }
    }

    /// An element without content: its name and attributes.
    pub(super) fn element(&mut self, markup: fmt::Arguments<'_>) {
        let _ = writeln!(self.body, "<{markup}/>");
    }

    /// Opens a group; [`Self::close`] ends it.
    pub(super) fn open(&mut self, attributes: fmt::Arguments<'_>) {
        let _ = writeln!(self.body, "<g {attributes}>");
    }

    /// Opens a group whose colours run into each other over so many pixels, while its outline stays as it is.
    pub(super) fn open_smooth(&mut self, pixels: f64) {
        let pixels = Length(pixels.clamp(0.5, 8.0));
        let name = format!("smooth-{pixels}");
        // What is blurred beyond the outline is made opaque again and cut off along it; slits between faces, which are no part
        // of the outline, are closed first: by their width where it is some pixels, else because they are hardly transparent.
        let _ = writeln!(
            self.body,
            "<filter id=\"{name}\" color-interpolation-filters=\"sRGB\"><feGaussianBlur stdDeviation=\"{pixels}\"/>\
             <feComponentTransfer result=\"colours\"><feFuncA type=\"linear\" slope=\"1000\"/></feComponentTransfer>\
             <feMorphology in=\"SourceAlpha\" operator=\"dilate\" radius=\"{SLIT}\"/>\
             <feMorphology operator=\"erode\" radius=\"{SLIT}\"/>\
             <feComponentTransfer result=\"whole\"><feFuncA type=\"linear\" slope=\"4\"/></feComponentTransfer>\
             <feComposite operator=\"in\" in=\"colours\" in2=\"whole\"/></filter>"
        );
        self.open(format_args!(r#"filter="url(#{name})""#));
    }

    pub(super) fn close(&mut self) {
        self.body.push_str("</g>\n");
    }

    pub(super) fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], colour: &str, width: f64) {
        let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(Length);
        self.element(format_args!(
            r#"line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{colour}" stroke-width="{width}""#
        ));
    }

    pub(super) fn text(&mut self, at: [f64; 2], anchor: Anchor, font: Font, text: &str) {
        self.turned_text(at, anchor, font, text, 0.0);
    }

    /// The heading of a panel at its upper left corner: a title of at most `most` characters a line, in two lines if need be,
    /// and a caption. It ends 42 pixels below the corner.
    pub(super) fn heading(&mut self, [x, y]: [f64; 2], title: &str, most: usize, caption: &str) {
        let (first, second) = two_lines(title, most);
        let (title, below) = if second.is_empty() { (18.0, 35.0) } else { (12.0, 39.0) };
        self.text([x, y + title], Anchor::Start, Font::TITLE, &first);
        if !second.is_empty() {
            self.text([x, y + 26.0], Anchor::Start, Font::TITLE, &second);
        }
        self.text([x, y + below], Anchor::Start, Font::SMALL, caption);
    }

    /// A text turned by so many degrees, clockwise.
    pub(super) fn turned_text(
        &mut self,
        [x, y]: [f64; 2],
        anchor: Anchor,
        font: Font,
        text: &str,
        turn: f64,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let [x, y] = [x, y].map(Length);
        let weight = if font.bold { r#" font-weight="600""# } else { "" };
        let transform =
            if turn == 0.0 { String::new() } else { format!(r#" transform="rotate({turn} {x} {y})""#) };
        let (size, colour, text) = (font.size, font.colour, Escaped(text));
        let _ = writeln!(
            self.body,
            r#"<text x="{x}" y="{y}" text-anchor="{anchor}" font-size="{size}"{weight} fill="{colour}"{transform}>{text}</text>"#
        );
    }

    /// A rectangle that `clip-path="url(#name)"` refers to.
    pub(super) fn clip(&mut self, name: &str, [left, top, right, bottom]: [f64; 4]) {
        let [x, y, w, h] = [left, top, right - left, bottom - top].map(Length);
        let _ = writeln!(
            self.body,
            r#"<clipPath id="{name}"><rect x="{x}" y="{y}" width="{w}" height="{h}"/></clipPath>"#
        );
    }

    /// Raw markup, already escaped.
    pub(super) fn raw(&mut self, markup: &str) {
        self.body.push_str(markup);
    }

    /// The whole picture.
    pub(super) fn finish(self) -> String {
        let (w, h, title) = (Length(self.width), Length(self.height), Escaped(&self.title));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
             viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" \
             font-family=\"system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif\">\n\
             <title>{title}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            self.body
        )
    }
}

/// A coordinate in pixels, to a tenth.
pub(super) struct Length(pub(super) f64);

impl Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tenths = (self.0 * 10.0).round() as i64;
        let (sign, size) = (if tenths < 0 { "-" } else { "" }, tenths.unsigned_abs());
        match size % 10 {
            0 => write!(f, "{sign}{}", size / 10),
            tenth => write!(f, "{sign}{}.{tenth}", size / 10),
        }
    }
}

/// Text as character data of XML and HTML, safe in attributes too. Controls, which XML does not admit, and the marks of bidirectional text, which
/// would turn what stands beside them, are shown as [`crate::Printable`] shows them.
pub(crate) struct Escaped<'a>(pub(crate) &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '&' => f.write_str("&amp;")?,
                '"' => f.write_str("&quot;")?,
                '\'' => f.write_str("&#39;")?,
                '\t' | '\n' | '\r' => f.write_char(c)?,
                '\u{fffe}' | '\u{ffff}' => f.write_char('\u{fffd}')?,
                _ => write_char(f, c)?,
            }
        }
        Ok(())
    }
}

/// A closed or open path through points, relative to the tenth of a pixel: the shortest way to write it.
pub(super) fn path(points: impl IntoIterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    let tenths = |point: [i64; 2]| point.map(|x| Length(x as f64 / 10.0));
    let (mut last, mut moved): (Option<[i64; 2]>, bool) = (None, false);
    for point in points {
        let here = point.map(|x| (x * 10.0).round() as i64);
        match last {
            None => {
                let [x, y] = tenths(here);
                let _ = write!(d, "M{x} {y}");
            }
            Some(last) if last != here => {
                // One letter serves all steps, and a sign parts numbers as well as a space does.
                d.push_str(if moved { " " } else { "l" });
                moved = true;
                let step = [here[0] - last[0], here[1] - last[1]];
                let [x, y] = tenths(step);
                let space = if step[1] < 0 { "" } else { " " };
                let _ = write!(d, "{x}{space}{y}");
            }
            Some(_) => {}
        }
        last = Some(here);
    }
    if closed {
        d.push('z');
    }
    d
}

/// `text` in at most `most` characters, its middle left out if it must be.
fn shortened(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let head: String = text.chars().take(most.div_ceil(2)).collect();
    let tail: String = text.chars().skip(count - (most / 2).saturating_sub(1)).collect();
    format!("{}…{}", head.trim_end(), tail.trim_start())
}

/// A text broken after a word into two lines of at most `most` characters; what does not fit is cut from the middle of the
/// second. Short texts leave it empty.
fn two_lines(text: &str, most: usize) -> (String, String) {
    if text.chars().count() <= most {
        return (text.to_owned(), String::new());
    }
    let end = text.char_indices().nth(most).map_or(text.len(), |(at, _)| at);
    // A blank right behind the line ends it, too.
    let at = if text[end..].starts_with(' ') { end } else { text[..end].rfind(' ').unwrap_or(end) };
    (text[..at].trim_end().to_owned(), shortened(text[at..].trim_start(), most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_short() {
        let shown = [0.0, -0.04, 3.0, 2.14159, -12.55, 100.96].map(|x| Length(x).to_string());
        assert_eq!(shown, ["0", "0", "3", "2.1", "-12.6", "101"]);
    }

    #[test]
    fn paths_end_where_they_should() {
        assert_eq!(path([[0.0, 0.0], [1.04, 0.0], [2.08, 0.0]], true), "M0 0l1 0 1.1 0z");
        assert_eq!(path([[5.0, 5.0], [5.0, 5.01], [4.0, 3.0], [6.0, 7.0]], false), "M5 5l-1-2 2 4");
    }

    #[test]
    fn texts_lose_their_middle() {
        let lines = |text, most| {
            let (first, second) = two_lines(text, most);
            [first, second]
        };
        assert_eq!(lines("metric correction, 3 steps", 20), ["metric correction, 3", "steps"]);
        assert_eq!(lines("TB–Coons, least area", 20), ["TB–Coons, least area", ""]);
        assert_eq!(lines("最小曲面最小曲面", 5), ["最小曲面最", "小曲面"]);
        assert_eq!(shortened("frame 07 of 11", 20), "frame 07 of 11");
        assert_eq!(shortened("abcdefghijklmnop", 8), "abcd…nop");
    }

    #[test]
    fn no_markup_and_no_control_characters_survive() {
        assert_eq!(Escaped("</a> & \"'\u{1}").to_string(), "&lt;/a&gt; &amp; &quot;&#39;\\u0001");
    }
}
