use super::axis::ticks;
use super::svg::{Anchor, Font, INK, Length, Svg};
use crate::colour;
use crate::scene::Field;
use plateau::Notation;

/// Width of the bar itself; its numbers stand to the right of it.
const WIDTH: f64 = 14.0;
/// Width of a digit of its numbers, in the widest of the fonts they may be shown in.
const DIGIT: f64 = 7.2;
/// Stripes of colour.
const STRIPES: usize = 64;

/// Whether values lie beyond the colours.
fn beyond(full: f64, largest: f64) -> bool {
    largest > full * 1.000_001
}

/// Where the colours of a field end, if values lie beyond: for captions.
pub(super) fn clipped(field: Field, full: f64, largest: f64) -> String {
    if !beyond(full, largest) {
        return String::new();
    }
    let [full, largest] = [full, largest].map(|x| Notation::Digits(3).of(x));
    match (field.is_signed(), field.symbol()) {
        (true, symbol) => format!(", clipped at ±{full}; largest |{symbol}| {largest}"),
        (false, symbol) => format!(", clipped at {full}; largest {symbol} {largest}"),
    }
}

/// A vertical colour bar for values up to ±`full` (from 0 for fields of one sign), with a pointed end where the largest
/// value lies beyond. `left`, `top`, `height` of the bar without its points.
pub(super) fn draw(svg: &mut Svg, [left, top, height]: [f64; 3], field: Field, full: f64, largest: f64) {
    let low = if field.is_signed() { -full } else { 0.0 };
    let shade = |t: f64| if field.is_signed() { colour::diverging(t) } else { colour::sequential(t) };
    let (right, bottom, tip) = (left + WIDTH, top + height, left + 0.5 * WIDTH);
    // Each stripe reaches down to the foot, so that no gap shows between neighbours.
    for k in 0..STRIPES {
        let t = 1.0 - (k as f64 + 0.5) / STRIPES as f64;
        let fill = colour::hex(shade(if field.is_signed() { 2.0 * t - 1.0 } else { t }));
        let y = top + height * k as f64 / STRIPES as f64;
        let [x, w, h] = [left, WIDTH, bottom - y].map(Length);
        let y = Length(y);
        svg.element(format_args!(r#"rect x="{x}" y="{y}" width="{w}" height="{h}" fill="{fill}""#));
    }
    let beyond = beyond(full, largest);
    let mut outline = format!("M{left} {top}");
    if beyond {
        outline += &format!("L{tip} {}", top - 10.0);
        let fill = colour::hex(shade(1.0));
        svg.element(format_args!(
            r#"path d="M{left} {top}L{tip} {}L{right} {top}z" fill="{fill}""#,
            top - 10.0
        ));
    }
    outline += &format!("L{right} {top}L{right} {bottom}");
    if beyond && field.is_signed() {
        outline += &format!("L{tip} {}", bottom + 10.0);
        let fill = colour::hex(shade(-1.0));
        svg.element(format_args!(
            r#"path d="M{left} {bottom}L{tip} {}L{right} {bottom}z" fill="{fill}""#,
            bottom + 10.0
        ));
    }
    svg.element(format_args!(
        r#"path d="{outline}L{left} {bottom}z" fill="none" stroke="{INK}" stroke-width="0.8""#
    ));
    let mut widest: f64 = 0.0;
    for (value, label) in ticks(low, full, 6) {
        widest = widest.max(DIGIT * label.chars().count() as f64);
        let y = bottom - height * (value - low) / (full - low);
        svg.line([right, y], [right + 4.0, y], INK, 0.8);
        svg.text([right + 7.0, y + 4.0], Anchor::Start, Font::SMALL, &label);
    }
    let unit = if field.unit().is_empty() { String::new() } else { format!(" ({})", field.unit()) };
    let label = format!("{} {}{unit}", field.name(), field.symbol());
    let beside = (right + 19.0 + widest).max(right + 62.0);
    svg.turned_text([beside, top + 0.5 * height], Anchor::Middle, Font::LABEL, &label, -90.0);
}
