//! Mean curvature over the parameters, all methods on one scale: the nephograms of the papers.

use std::fmt::Write;

use base64::prelude::{BASE64_STANDARD, Engine};
use surfaces::Domain;

use super::axis::{Axis, frame};
use super::panels::arrange;
use super::svg::{Anchor, Font, INK, Length, Svg, path};
use super::{Picture, colour_bar};
use crate::colour;
use crate::scene::{Chart, Field, Scene, Shown, spread};
use plateau::Notation;

/// Most maps in one picture.
const PANELS: usize = 12;
/// Side of a map, in pixels of the picture.
const SIDE: f64 = 190.0;
/// Space a map takes with its axes and titles.
const CELL: [f64; 2] = [258.0, 282.0];
/// Space for the colour bar.
const BAR: f64 = 110.0;
/// Samples of a map in each direction; fewer where there are many maps.
const PIXELS: [usize; 2] = [96, 64];
/// Index of "no value" in the palette.
const NO_VALUE: u8 = 255;
/// Largest |H| that is rounding, in units of the full scale.
const ROUNDING: f64 = 1e-9;
/// |H| of a least area that its degree leaves, in units of the full scale and of one over the radius of the scene.
const LEFT: [f64; 2] = [0.05, 0.01];
/// Level curves, in units of the full scale.
const LEVELS: [f64; 7] = [-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75];

/// The maps of all surfaces; none if they are all minimal.
pub(super) fn picture(scene: &Scene<'_>) -> Option<Picture> {
    let full = scene.full_scale(Field::Mean)?;
    let largest = scene.largest(Field::Mean)?;
    let flat: Vec<(&Shown<'_>, &Chart)> =
        scene.surfaces.iter().filter_map(|shown| Some((shown, shown.sample.chart()?))).collect();
    if flat.is_empty() {
        return None;
    }
    let chosen = spread(flat.len(), PANELS);
    let [columns, rows] = arrange(chosen.len(), 4);
    let (width, height) = (CELL[0] * columns as f64 + BAR, CELL[1] * rows as f64);
    let mut svg = Svg::new(width, height, "Mean curvature H over the parameters u and v");
    let least = (LEFT[0] * full).max(LEFT[1] / scene.radius);
    // Level curves of rounding, or of what the degree leaves of a minimal surface, would only show its noise; so would colours where nothing
    // else is to be seen.
    let is_told = |shown: &Shown<'_>| {
        let values = shown.sample.values(Field::Mean).iter().flatten().copied();
        let own = colour::full_scale(values, ROUNDING * full);
        own.is_some_and(|own| !shown.is_least() || own > least)
    };
    let any_told = chosen.iter().any(|&index| is_told(flat[index].0));
    let pixels = PIXELS[usize::from(chosen.len() > 4)];
    for (k, &index) in chosen.iter().enumerate() {
        let shown = flat[index];
        let image = any_told.then(|| raster(shown, full, pixels));
        map(
            &mut svg,
            shown,
            (full, is_told(shown.0)),
            image.as_deref(),
            [CELL[0] * (k % columns) as f64, CELL[1] * (k / columns) as f64],
            k,
        );
    }
    let bar = [CELL[0] * columns as f64 + 12.0, 46.0, SIDE];
    let caption = if any_told {
        colour_bar::draw(&mut svg, bar, Field::Mean, full, largest);
        let clipped = colour_bar::clipped(Field::Mean, full, largest);
        format!(
            "Mean curvature H over the parameters, all methods on one scale{clipped}. Thin lines are level curves at \
             quarters of the scale, the thick line is H = 0."
        )
    } else {
        for (k, line) in ["H is 0 to what", "the degree", "leaves of it"].into_iter().enumerate() {
            let at = [bar[0], bar[1] + 12.0 + 16.0 * k as f64];
            svg.text(at, Anchor::Start, Font::SMALL, line);
        }
        format!(
            "Mean curvature H over the parameters of surfaces of least area: the largest |H| is {} 1/length, zero to what the degree leaves \
             of it, and there is nothing to colour.",
            Notation::Digits(2).of(largest)
        )
    };
    Some(Picture { name: "mean-curvature", caption, svg: svg.finish() })
}

fn map(
    svg: &mut Svg,
    (shown, chart): (&Shown<'_>, &Chart),
    (full, is_told): (f64, bool),
    image: Option<&str>,
    [x, y]: [f64; 2],
    panel: usize,
) {
    let (left, top) = (x + 56.0, y + 46.0);
    let (right, bottom) = (left + SIDE, top + SIDE);
    let values = shown.sample.values(Field::Mean);
    let largest = values.iter().flatten().map(|h| h.abs()).reduce(f64::max);
    let caption = largest.map_or("singular everywhere".into(), |h| {
        format!("max |H| = {} 1/length", Notation::Digits(4).of(h))
    });
    svg.heading([left, y], shown.name, 26, &caption);

    let (u, v) = match chart.domain {
        Domain::Rectangle { u, v } => (u, v),
        Domain::Triangle => ((0.0, 1.0), (0.0, 1.0)),
    };
    let u = Axis::linear(u.0, u.1, [left, right], 4);
    let v = Axis::linear(v.0, v.1, [bottom, top], 4);
    frame(svg, &u, &v, "u", "v");

    let clip = format!("map-{panel}");
    let outline = match chart.domain {
        Domain::Rectangle { .. } => path([[left, top], [right, top], [right, bottom], [left, bottom]], true),
        Domain::Triangle => path([[left, bottom], [right, bottom], [left, top]], true),
    };
    svg.raw(&format!("<clipPath id=\"{clip}\"><path d=\"{outline}\"/></clipPath>\n"));
    let [left_px, top_px, side] = [left, top, SIDE].map(Length);
    if let Some(image) = image {
        svg.element(format_args!(
            r#"image x="{left_px}" y="{top_px}" width="{side}" height="{side}" preserveAspectRatio="none" clip-path="url(#{clip})" xlink:href="data:image/png;base64,{image}""#
        ));
    } else {
        let zero = colour::hex(colour::diverging(0.0));
        svg.element(format_args!(r#"path d="{outline}" fill="{zero}""#));
    }
    let levels = if is_told { LEVELS.as_slice() } else { &[] };
    for &level in levels {
        let (level, width) = (level * full, if level == 0.0 { 1.4 } else { 0.5 });
        let d = level_curve(chart, values, level, [left, bottom]);
        if !d.is_empty() {
            svg.element(format_args!(
                r#"path d="{d}" fill="none" stroke="{INK}" stroke-width="{width}" stroke-linecap="round""#
            ));
        }
    }
    svg.element(format_args!(r#"path d="{outline}" fill="none" stroke="{INK}" stroke-width="1""#));
}

/// The map as a small PNG, which viewers smooth.
fn raster((shown, chart): (&Shown<'_>, &Chart), full: f64, side: usize) -> String {
    let values = shown.sample.values(Field::Mean);
    let mut palette: Vec<u8> =
        (0..NO_VALUE).flat_map(|k| colour::diverging((f64::from(k) - 127.0) / 127.0)).collect();
    palette.extend(colour::NONE);
    let at = |k: usize| (k as f64 + 0.5) / side as f64;
    let mut pixels = Vec::with_capacity(side * side);
    for row in (0..side).rev() {
        for column in 0..side {
            let value = chart.interpolate(values, at(column), at(row));
            // What lies beyond the scale has the colour of its end, as the points of the colour bar say.
            pixels.push(
                value.map_or(NO_VALUE, |h| (127.0 + 127.0 * (h / full).clamp(-1.0, 1.0)).round() as u8),
            );
        }
    }
    BASE64_STANDARD
        .encode(image(side, &pixels, palette).expect("pixels for each place, and memory takes all bytes"))
}

/// A square PNG whose pixels are places in a palette.
pub(super) fn image(side: usize, pixels: &[u8], palette: Vec<u8>) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side as u32, side as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette(palette);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// The segments in which the linear interpolant on triangles has the value `level`.
fn level_curve(chart: &Chart, values: &[Option<f64>], level: f64, [left, bottom]: [f64; 2]) -> String {
    let [nu, nv] = chart.steps.map(|n| n as f64);
    let mut d = String::new();
    for face in chart.faces(1) {
        for last in 2..face.len() {
            let corners = [face[0], face[last - 1], face[last]];
            let known: Option<Vec<f64>> = corners.iter().map(|&at| values[chart.at(at)]).collect();
            let Some(known) = known else { continue };
            let mut ends = Vec::with_capacity(2);
            for (p, q) in [(0, 1), (1, 2), (2, 0)] {
                let (f, g) = (known[p] - level, known[q] - level);
                if (f < 0.0) != (g < 0.0) {
                    let t = f / (f - g);
                    let mix = |k: usize, n: f64| {
                        (corners[p][k] as f64 + t * (corners[q][k] as f64 - corners[p][k] as f64)) / n
                    };
                    ends.push([left + SIDE * mix(0, nu), bottom - SIDE * mix(1, nv)]);
                }
            }
            if let [from, to] = ends.as_slice() {
                let _ = write!(d, "{}", path([*from, *to], false));
            }
        }
    }
    d
}
