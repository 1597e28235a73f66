//! Curves with their control polygon, and their curvatures.

use super::Picture;
use super::axis::{Axis, frame};
use super::svg::{ACCENT, Anchor, FAINT, Font, INK, LINES, Length, Svg, path};
use plateau::{Curve, CurveResult, Notation, sample};

/// Parameters at which the curve is drawn, besides the samples of the file.
const FINE: usize = 401;
/// Width and height.
const SIZE: [f64; 2] = [860.0, 360.0];
/// A largest curvature this many times that of nine tenths of the curve is cut off.
const PEAK: f64 = 8.0;
/// Height of a line of the heading, of which several curves have one each.
const LINE: f64 = 18.0;

/// A curve as it is drawn.
struct Drawn<'a> {
    result: &'a CurveResult,
    /// Sampled finely.
    fine: CurveResult,
    colour: &'static str,
}

/// The picture of curves on the same control points; none if one of them cannot be drawn finely, or there is none.
pub(super) fn picture(results: &[CurveResult]) -> Option<Picture> {
    let first = results.first()?;
    let drawn = results.iter().zip(LINES.iter().copied().cycle()).map(|(result, colour)| {
        let plan = result.curve();
        let [start, end] = plan.basis().domain();
        let samples = (0..FINE)
            .map(|k| if k + 1 == FINE { end } else { start + (end - start) * (k as f64 / (FINE - 1) as f64) })
            .collect();
        let fine = sample(&plan.clone().sampled_at(samples).ok()?).ok()?;
        Some(Drawn { result, fine, colour: if results.len() == 1 { ACCENT } else { colour } })
    });
    let drawn: Vec<Drawn<'_>> = drawn.collect::<Option<_>>()?;
    let (title, caption) = match results.len() {
        1 => (
            "The curve with its control polygon, and its curvature",
            "The curve with its control polygon, and its curvature over the parameter; dots are the samples.",
        ),
        _several => (
            "The curves with their control polygon, and their curvatures",
            "The curves with their control polygon, and their curvatures over the parameter, one colour for each; dots are the samples.",
        ),
    };
    let below = LINE * (results.len() - 1) as f64;
    let mut svg = Svg::new(SIZE[0], SIZE[1] + below, title);
    for (k, Drawn { result, colour, .. }) in drawn.iter().enumerate() {
        let y = LINE * k as f64;
        let font = if results.len() == 1 { Font::TITLE } else { Font { colour, ..Font::TITLE } };
        svg.text([20.0, 22.0 + y], Anchor::Start, font, result.name());
        let caption = format!(
            "length {} in {} samples",
            Notation::Digits(4).of(result.length()[0]),
            result.samples().len()
        );
        let at = if results.len() == 1 { [20.0, 39.0] } else { [240.0, 22.0 + y] };
        svg.text(at, Anchor::Start, Font::SMALL, &caption);
    }
    shape(&mut svg, first.curve(), &drawn, below);
    curvature(&mut svg, &drawn, first.dimension() == 2, below);
    Some(Picture { name: "curvature", caption: caption.into(), svg: svg.finish() })
}

/// The curves in their plane; space curves from the front, the left and above.
fn shape(svg: &mut Svg, plan: &Curve, drawn: &[Drawn<'_>], below: f64) {
    let flat = |p: [f64; 3]| {
        if plan.dimension() == 2 {
            [p[0], p[1]]
        } else {
            [0.85 * p[0] + 0.53 * p[1], 0.26 * p[1] - 0.42 * p[0] + 0.87 * p[2]]
        }
    };
    let polygon: Vec<[f64; 2]> = plan.points().iter().map(|&p| flat(p.into())).collect();
    let curves: Vec<Vec<[f64; 2]>> = drawn
        .iter()
        .map(|drawn| drawn.fine.samples().iter().map(|sample| flat(sample.jet.point.into())).collect())
        .collect();
    let all = || polygon.iter().chain(curves.iter().flatten());
    let bound = |k: usize, pick: fn(f64, f64) -> f64, from: f64| all().map(|p| p[k]).fold(from, pick);
    let low = [0, 1].map(|k| bound(k, f64::min, f64::INFINITY));
    let high = [0, 1].map(|k| bound(k, f64::max, f64::NEG_INFINITY));
    // Equal scales on both axes, the shorter one padded.
    let room = [312.0, 240.0];
    let size = (0..2).map(|k| (high[k] - low[k]) / room[k]).fold(0.0, f64::max).max(f64::MIN_POSITIVE) * 1.08;
    let range = |k: usize| {
        let middle = 0.5 * low[k] + 0.5 * high[k];
        (middle - 0.5 * size * room[k], middle + 0.5 * size * room[k])
    };
    let ((x0, x1), (y0, y1)) = (range(0), range(1));
    let x = Axis::linear(x0, x1, [76.0, 76.0 + room[0]], 5);
    let y = Axis::linear(y0, y1, [56.0 + below + room[1], 56.0 + below], 5);
    let labels =
        if plan.dimension() == 2 { ["x (length)", "y (length)"] } else { ["across (length)", "up (length)"] };
    frame(svg, &x, &y, labels[0], labels[1]);
    let at = |p: &[f64; 2]| [x.at(p[0]), y.at(p[1])];
    let d = path(polygon.iter().map(at), false);
    svg.element(format_args!(
        r#"path d="{d}" fill="none" stroke="{FAINT}" stroke-width="1" stroke-dasharray="4 3""#
    ));
    for point in &polygon {
        dot(svg, at(point), 3.0, "#ffffff", FAINT);
    }
    for (Drawn { result, colour, .. }, curve) in drawn.iter().zip(&curves) {
        let d = path(curve.iter().map(at), false);
        svg.element(format_args!(
            r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="2" stroke-linejoin="round""#
        ));
        let ink = if drawn.len() == 1 { INK } else { colour };
        for sample in few(result.samples()) {
            dot(svg, at(&flat(sample.jet.point.into())), 2.6, ink, ink);
        }
    }
}

fn curvature(svg: &mut Svg, drawn: &[Drawn<'_>], signed: bool, below: f64) {
    let mut known: Vec<f64> =
        drawn.iter().flat_map(|drawn| drawn.fine.samples()).filter_map(|sample| sample.curvature).collect();
    let (left, right, top, bottom) = (500.0, 836.0, 56.0 + below, 296.0 + below);
    let Some(largest) = known.iter().map(|k| k.abs()).reduce(f64::max) else {
        svg.text(
            [0.5 * (left + right), 176.0 + below],
            Anchor::Middle,
            Font::SMALL,
            "no point of it has a curvature",
        );
        return;
    };
    known.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let common = known[known.len() * 9 / 10].abs();
    let cut = if largest > PEAK * common && common > 0.0 { PEAK * common } else { largest };
    let shown = |k: f64| k.clamp(-cut, cut);
    let low = known.iter().fold(0.0, |low: f64, &k| low.min(shown(k)));
    let high = known.iter().fold(0.0, |high: f64, &k| high.max(shown(k)));
    let pad = 0.06 * (high - low);
    let (under, above) = (if low < 0.0 { pad } else { 0.0 }, if high > 0.0 { pad } else { 0.0 });
    let domain = drawn[0].result.curve().basis().domain();
    let t = Axis::linear(domain[0], domain[1], [left, right], 5);
    let k = Axis::linear(low - under, high + above, [bottom, top], 5);
    let label = if signed { "signed curvature κ (1/length)" } else { "curvature κ (1/length)" };
    frame(svg, &t, &k, "parameter t", label);
    if low < 0.0 && high > 0.0 {
        svg.line([left, k.at(0.0)], [right, k.at(0.0)], FAINT, 1.0);
    }
    for drawn_curve in drawn {
        line_of_curvature(svg, drawn_curve, (&t, &k), cut, drawn.len() == 1);
    }
    if cut < largest {
        let note = format!("beyond the panel: up to {}", Notation::Digits(4).of(largest));
        svg.text([right - 4.0, top - 6.0], Anchor::End, Font::SMALL, &note);
    }
}

/// Where the curvature is missing or beyond `cut` the line is broken.
fn line_of_curvature(svg: &mut Svg, drawn: &Drawn<'_>, (t, k): (&Axis, &Axis), cut: f64, alone: bool) {
    let Drawn { result, fine, colour } = drawn;
    let mut pieces: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    for sample in fine.samples() {
        match sample.curvature.filter(|value| value.abs() <= cut) {
            Some(value) => {
                pieces.last_mut().into_iter().for_each(|piece| piece.push([t.at(sample.t), k.at(value)]))
            }
            None => pieces.push(Vec::new()),
        }
    }
    for piece in pieces.into_iter().filter(|piece| piece.len() > 1) {
        let d = path(piece, false);
        svg.element(format_args!(
            r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="2" stroke-linejoin="round""#
        ));
    }
    let ink = if alone { INK } else { colour };
    for sample in few(result.samples()) {
        if let Some(value) = sample.curvature.filter(|value| value.abs() <= cut) {
            dot(svg, [t.at(sample.t), k.at(value)], 2.6, ink, ink);
        }
    }
}

fn dot(svg: &mut Svg, [x, y]: [f64; 2], radius: f64, fill: &str, stroke: &str) {
    let (x, y) = (Length(x), Length(y));
    svg.element(format_args!(
        r#"circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{stroke}" stroke-width="1""#
    ));
}

/// The samples to mark: all, unless there are so many that they hide the curve.
fn few<T>(samples: &[T]) -> &[T] {
    if samples.len() <= 60 { samples } else { &[] }
}
