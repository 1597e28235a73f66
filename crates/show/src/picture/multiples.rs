//! Small multiples: one figure over one axis, a panel for each combination of the others.

use super::axis::{Axis, frame};
use super::svg::{ACCENT, Anchor, Font, Length, Svg, path};
use plateau::Notation;

/// Most panels in one picture.
const PANELS: usize = 48;
/// Most marks of one series in a panel.
const MARKS: usize = 400;
/// Panels beside one another, and the size of each.
const COLUMNS: usize = 3;
const SIZE: [f64; 2] = [330.0, 270.0];
/// Room above the first row, without the lines of the names of the series.
const TOP: f64 = 14.0;
/// Height of such a line.
const LINE: f64 = 20.0;
/// Most characters of a name in the key, and of the title of a panel.
const LONGEST: usize = 40;
/// Colours of the series, told apart also by those who see no red or green.
const COLOURS: [&str; 6] = ["#3d6fa5", "#c77f16", "#2f7d5b", "#8457a6", "#5a6673", "#9c4f2c"];

/// A figure of many experiments over one axis.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Multiples {
    /// What the picture shows, for those who hear it.
    pub title: String,
    /// What stands below the panels.
    pub x_label: String,
    /// What stands beside them.
    pub y_label: String,
    /// The words at the places 0, 1, … of the axis below, where these are no numbers.
    pub words: Option<Vec<String>>,
    /// Whether what is drawn is the distance to the least value of the panel, on a logarithmic axis.
    pub gap: bool,
    /// Whether only values at one place of the axis below are compared, where every place has a boundary of its own; else all of a panel are.
    pub by_place: bool,
    /// The names of the series.
    pub names: Vec<String>,
    /// The panels, in order.
    pub panels: Vec<Panel>,
}

/// One panel.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Panel {
    /// What its experiments have in common.
    pub title: String,
    /// For every name of a series its points from left to right, finite.
    pub series: Vec<Vec<[f64; 2]>>,
}

/// Where entries of one line of the key begin, and which they are: those beyond the names are the ring.
type KeyLine = Vec<(f64, usize)>;

impl Multiples {
    /// What the ring means.
    fn ring(&self) -> &'static str {
        if self.by_place { "the least over its boundary" } else { "the least of the panel" }
    }
}

impl Panel {
    fn values(&self, k: usize) -> impl Iterator<Item = f64> {
        self.series.iter().flatten().map(move |point| point[k])
    }

    fn least(&self) -> Option<f64> {
        self.values(1).reduce(f64::min)
    }

    /// The least of the values that one at `x` is compared with, and how many they are.
    fn compared(&self, x: f64, by_place: bool) -> (f64, usize) {
        let points = self.series.iter().flatten().filter(|point| !by_place || point[0] == x);
        points.fold((f64::INFINITY, 0), |(least, count), point| (least.min(point[1]), count + 1))
    }

    /// The points that are ringed: the first of the least of each group of several that are compared.
    fn ringed(&self, by_place: bool) -> Vec<[f64; 2]> {
        let mut ringed: Vec<[f64; 2]> = Vec::new();
        for &point in self.series.iter().flatten() {
            let (least, count) = self.compared(point[0], by_place);
            let has_one = ringed.iter().any(|other| !by_place || other[0] == point[0]);
            if point[1] == least && !has_one && (!by_place || count > 1) {
                ringed.push(point);
            }
        }
        ringed
    }
}

/// The picture as SVG: in every panel the least of the values that are compared is ringed. Axes have the same extent below, each panel its own beside it.
#[must_use]
pub fn multiples(what: &Multiples) -> String {
    let shown = &what.panels[..what.panels.len().min(PANELS)];
    let rows = shown.len().div_ceil(COLUMNS).max(1);
    let columns = shown.len().clamp(1, COLUMNS);
    let width = SIZE[0] * columns.max(2) as f64;
    let lines = key_lines(what, width);
    let top = TOP + LINE * lines.len() as f64;
    let size = [width, top + SIZE[1] * rows as f64 + 14.0];
    let mut svg = Svg::new(size[0], size[1], &what.title);
    key(&mut svg, what, &lines);
    for (k, panel) in shown.iter().enumerate() {
        let corner = [SIZE[0] * (k % COLUMNS) as f64, top + SIZE[1] * (k / COLUMNS) as f64];
        draw(&mut svg, what, panel, corner);
    }
    if shown.len() < what.panels.len() {
        let more =
            format!("{} more panels are not drawn; the table has all cells", what.panels.len() - shown.len());
        svg.text([12.0, size[1] - 4.0], Anchor::Start, Font::SMALL, &more);
    }
    svg.finish()
}

/// The names of the series with their colours, and what the ring means.
fn key(svg: &mut Svg, what: &Multiples, lines: &[KeyLine]) {
    for (line, entries) in lines.iter().enumerate() {
        let y = 20.0 + LINE * line as f64;
        for &(x, entry) in entries {
            let Some(name) = what.names.get(entry) else {
                ring(svg, [x + 8.0, y]);
                svg.text([x + 20.0, y + 4.0], Anchor::Start, Font::SMALL, what.ring());
                continue;
            };
            svg.line([x, y], [x + 20.0, y], COLOURS[entry % COLOURS.len()], 2.0);
            svg.text([x + 26.0, y + 4.0], Anchor::Start, Font::SMALL, &short(name));
        }
    }
}

/// The entries of the key, where they stand in lines of a width; the last one is the ring.
fn key_lines(what: &Multiples, width: f64) -> Vec<KeyLine> {
    let mut lines: Vec<KeyLine> = vec![Vec::new()];
    let mut x = 14.0;
    for entry in 0..=what.names.len() {
        let text = what.names.get(entry).map_or_else(|| what.ring().to_owned(), |name| short(name));
        let wide = 44.0 + 6.4 * text.chars().count() as f64;
        if x + wide > width && x > 14.0 {
            lines.push(Vec::new());
            x = 14.0;
        }
        if let Some(line) = lines.last_mut() {
            line.push((x, entry));
        }
        x += wide;
    }
    lines
}

/// A name of a series as the key has room for it.
fn short(name: &str) -> String {
    crate::Printable(name).cut(LONGEST)
}

fn ring(svg: &mut Svg, [x, y]: [f64; 2]) {
    let (x, y) = (Length(x), Length(y));
    svg.element(format_args!(
        r#"circle cx="{x}" cy="{y}" r="6" fill="none" stroke="{ACCENT}" stroke-width="2""#
    ));
}

fn draw(svg: &mut Svg, what: &Multiples, panel: &Panel, [left, top]: [f64; 2]) {
    let room = if what.gap && !what.by_place { LONGEST - 14 } else { LONGEST };
    let title = crate::Printable(&panel.title).cut(room);
    svg.text([left + 14.0, top + 16.0], Anchor::Start, Font::TITLE, &title);
    let (x_pixels, y_pixels) = ([left + 84.0, left + SIZE[0] - 16.0], [top + SIZE[1] - 56.0, top + 30.0]);
    let Some(least) = panel.least() else {
        let middle = [0.5 * (x_pixels[0] + x_pixels[1]), 0.5 * (y_pixels[0] + y_pixels[1])];
        svg.text(middle, Anchor::Middle, Font::SMALL, "no cell has this figure");
        return;
    };
    let x = below(what, x_pixels);
    // Below this a distance is rounding, and has no place on a logarithmic axis: it is drawn at its foot.
    let height = |point: &[f64; 2]| {
        let (least, _) = panel.compared(point[0], what.by_place);
        let floor = least.abs() * 4.0 * f64::EPSILON;
        if what.gap { Some(point[1] - least).filter(|gap| *gap > floor) } else { Some(point[1]) }
    };
    let heights = || panel.series.iter().flatten().filter_map(height);
    let low = heights().reduce(f64::min);
    let Some((low, high)) = low.zip(heights().reduce(f64::max)) else {
        let middle = [0.5 * (x_pixels[0] + x_pixels[1]), 0.5 * (y_pixels[0] + y_pixels[1])];
        svg.text(middle, Anchor::Middle, Font::SMALL, "all values are equal");
        return;
    };
    let y = if what.gap {
        Axis::logarithmic(low, high, y_pixels, 6)
    } else {
        Axis::linear(low, high, y_pixels, 5)
    };
    frame(svg, &x, &y, &what.x_label, &what.y_label);
    let place = |point: &[f64; 2]| [x.at(point[0]), height(point).map_or(y_pixels[0], |height| y.at(height))];
    for (series, colour) in panel.series.iter().zip(COLOURS.into_iter().cycle()) {
        let points: Vec<[f64; 2]> = series.iter().map(place).collect();
        svg.element(format_args!(
            r#"path d="{}" fill="none" stroke="{colour}" stroke-width="1.5" stroke-linejoin="round""#,
            path(points.iter().copied(), false)
        ));
        for point in points.iter().take(MARKS) {
            let [cx, cy] = point.map(Length);
            svg.element(format_args!(r#"circle cx="{cx}" cy="{cy}" r="2.6" fill="{colour}""#));
        }
    }
    for point in panel.ringed(what.by_place).iter().take(MARKS) {
        ring(svg, place(point));
    }
    if what.gap && !what.by_place {
        let least = format!("least {}", Notation::Digits(10).of(least));
        svg.text([x_pixels[1], top + 16.0], Anchor::End, Font::SMALL, &least);
    }
}

/// The axis below, which all panels share.
fn below(what: &Multiples, pixels: [f64; 2]) -> Axis {
    let values = || what.panels.iter().flat_map(|panel| panel.values(0));
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let Some(words) = &what.words else {
        // Equal ratios are drawn as equal distances where the values span more than a decade and a half.
        return if low > 0.0 && high >= 30.0 * low {
            Axis::logarithmic(low, high, pixels, 5)
        } else {
            Axis::linear(low, high, pixels, 4)
        };
    };
    let mut axis = Axis::linear(-0.5, words.len() as f64 - 0.5, pixels, 4);
    let step = words.len().div_ceil(4).max(1);
    let short = |word: &String| crate::Printable(word).cut(12);
    axis.ticks = words.iter().enumerate().step_by(step).map(|(k, word)| (k as f64, short(word))).collect();
    axis
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(gap: bool, words: Option<Vec<String>>) -> Multiples {
        let series = vec![vec![[0.0, 2.0], [1.0, 1.0], [2.0, 1.5]], vec![[0.0, 3.0], [1.0, 1.25]]];
        let panel = |title: &str| Panel { title: title.into(), series: series.clone() };
        Multiples {
            title: "area".into(),
            x_label: "degree".into(),
            y_label: "area".into(),
            words,
            gap,
            by_place: false,
            names: vec!["<a>".into(), "b".into()],
            panels: vec![panel("h = 1"), panel("h = 2"), Panel { title: "empty".into(), series: Vec::new() }],
        }
    }

    #[test]
    fn every_panel_has_its_points_and_one_ring() {
        for gap in [false, true] {
            for words in [None, Some(vec!["x".to_owned(), "y".into(), "z".into()])] {
                let svg = multiples(&picture(gap, words));
                assert_eq!(svg.matches(r#"r="2.6""#).count(), 10, "{svg}");
                // One in each panel, one in the key.
                assert_eq!(svg.matches(r#"r="6""#).count(), 3, "{svg}");
                assert!(svg.contains("no cell has this figure") && svg.contains("&lt;a&gt;"), "{svg}");
            }
        }
    }

    #[test]
    fn values_over_other_boundaries_are_not_compared() {
        let svg = multiples(&Multiples { by_place: true, ..picture(false, None) });
        // At the two places that both series have, in each of two panels; and one in the key.
        assert_eq!(svg.matches(r#"r="6""#).count(), 5, "{svg}");
        let gap = multiples(&Multiples { by_place: true, ..picture(true, None) });
        assert!(gap.contains("the least over its boundary") && !gap.contains("least 1"), "{gap}");
    }

    #[test]
    fn long_names_take_lines_of_their_own_and_are_cut() {
        let mut many = picture(false, None);
        many.names =
            (0..4).map(|k| format!("{k} {}", "metric correction of a long name ".repeat(3))).collect();
        let (few, many) = (multiples(&picture(false, None)), multiples(&many));
        assert!(many.contains('…'));
        let height =
            |svg: &str| svg.split("height=\"").nth(1).map(|rest| rest.split('"').next().map(str::to_owned));
        assert_ne!(height(&few), height(&many));
    }

    #[test]
    fn a_picture_of_many_panels_says_how_many_are_left_out() {
        let mut many = picture(false, None);
        many.panels = vec![many.panels[0].clone(); PANELS + 5];
        let svg = multiples(&many);
        assert!(svg.contains("5 more panels") && svg.matches(r#"r="6""#).count() == PANELS + 1);
    }
}
