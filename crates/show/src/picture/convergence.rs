//! How searches converged: every run, its best value and what it lacked to the best of all.

use super::Picture;
use super::axis::{Axis, frame};
use super::svg::{ACCENT, Anchor, FAINT, Font, Svg, path};
use plateau::{Notation, Quantity, Results, SearchOutcome, SearchRun};

/// Most searches in one picture.
const SEARCHES: usize = 6;
/// Most runs drawn of one search; the best is always among them.
const RUNS: usize = 60;
/// Corners of all runs of a search together: bounds the size of the picture.
const CORNERS: usize = 4000;
/// Width of the picture and height of one search.
const SIZE: [f64; 2] = [860.0, 330.0];
/// Colour of ordinary runs.
const RUN: &str = "#3d6fa5";

/// One row for each search by a swarm; none if there was none.
pub(super) fn picture(results: &Results) -> Option<Picture> {
    let searches: Vec<(&str, &SearchOutcome)> = results
        .methods()
        .iter()
        .filter_map(|method| {
            let search = method.outcome.as_ref().ok()?.solved.search()?;
            search.runs().iter().any(|run| run.history().len() > 1).then_some((method.name.as_str(), search))
        })
        .take(SEARCHES)
        .collect();
    if searches.is_empty() {
        return None;
    }
    let mut svg = Svg::new(SIZE[0], SIZE[1] * searches.len() as f64, "Convergence of the searches");
    for (k, (name, search)) in searches.iter().enumerate() {
        panels(&mut svg, name, search, SIZE[1] * k as f64, k);
    }
    let caption =
        "Every run of the search: the best value found so far, where it tells anything, and its gap to the least \
                   value of all runs. A curve of gaps ends where nothing is left of it."
            .into();
    Some(Picture { name: "convergence", caption, svg: svg.finish() })
}

fn panels(svg: &mut Svg, name: &str, search: &SearchOutcome, y: f64, row: usize) {
    let best = search.runs().iter().position(|run| run.value() == search.minimum()).unwrap_or(0);
    let mut drawn: Vec<usize> = (0..search.runs().len()).filter(|&k| k != best).take(RUNS - 1).collect();
    drawn.push(best);
    let runs: Vec<&SearchRun> = drawn.iter().map(|&k| &search.runs()[k]).collect();

    let inside = match Quantity::of_search(search.energy()).power() {
        Some(2) => " (length²)",
        _ => "",
    };
    heading(svg, name, search, runs.len(), y);
    let (top, bottom) = (y + 56.0, y + SIZE[1] - 54.0);
    let finite =
        || runs.iter().flat_map(|run| run.history().iter().copied()).filter(|value| value.is_finite());
    let length = runs.iter().map(|run| run.history().len()).max().unwrap_or(1);
    let low = finite().fold(search.minimum(), f64::min);
    let high = finite().fold(search.minimum(), f64::max);
    let x = |pixels| Axis::linear(0.0, (length - 1).max(1) as f64, pixels, 5);
    let most = (CORNERS / runs.len()).max(20);

    let tells = values_tell(&runs, low, high);
    if tells {
        let (iterations, values) = (x([96.0, 400.0]), Axis::linear(low, high, [bottom, top], 5));
        frame(svg, &iterations, &values, "iteration", &format!("best value{inside}"));
        svg.clip(&format!("values-{row}"), [96.0, top - 2.0, 402.0, bottom + 2.0]);
        draw(svg, &runs, &iterations, &values, most, Some);
    }
    let left = if tells { 520.0 } else { 96.0 };

    // Below this a gap is rounding.
    let floor = search.minimum().abs() * f64::EPSILON;
    let minimum = search.minimum();
    let gap = move |value: f64| Some(value - minimum).filter(|gap| *gap > floor);
    let gaps: Vec<f64> = finite().filter_map(gap).collect();
    let least = gaps.iter().copied().reduce(f64::min);
    let Some((least, largest)) = least.zip(gaps.iter().copied().reduce(f64::max)) else {
        svg.text(
            [0.5 * (left + 836.0), 0.5 * (top + bottom)],
            Anchor::Middle,
            Font::SMALL,
            "no run ever differed from the best",
        );
        return;
    };
    let (iterations, gaps) = (x([left, 836.0]), Axis::logarithmic(least, largest, [bottom, top], 7));
    frame(svg, &iterations, &gaps, "iteration", &format!("gap to the least value{inside}"));
    draw(svg, &runs, &iterations, &gaps, most, gap);
    if least < 1e-3 * largest {
        let note = format!("smallest gap {}", Notation::Digits(4).of(least));
        svg.text([832.0, top + 14.0], Anchor::End, Font { colour: FAINT, ..Font::SMALL }, &note);
    }
}

/// The name of the method, how many runs are drawn and which line is which.
fn heading(svg: &mut Svg, name: &str, search: &SearchOutcome, drawn: usize, y: f64) {
    let of = if drawn < search.runs().len() {
        format!("{drawn} of {}", search.runs().len())
    } else {
        drawn.to_string()
    };
    let unit = match Quantity::of_search(search.energy()).power() {
        Some(2) => " length²",
        _ => "",
    };
    let caption = format!("{of} runs; least value {:.7}{unit}", search.minimum());
    svg.heading([20.0, y + 4.0], name, 70, &caption);
    let mut key = SIZE[0] - 210.0;
    for (label, colour, width) in [("a run", RUN, 1.0), ("the best run", ACCENT, 2.0)] {
        svg.line([key, y + 20.0], [key + 22.0, y + 20.0], colour, width);
        svg.text([key + 28.0, y + 24.0], Anchor::Start, Font::SMALL, label);
        key += 86.0;
    }
}

/// Whether the best values themselves show how the runs went. If a tenth of the iterations leaves less than a twentieth of
/// their range, they are all one flat line, and only their gaps tell.
fn values_tell(runs: &[&SearchRun], low: f64, high: f64) -> bool {
    let after = runs.iter().filter_map(|run| run.history().get(run.history().len() / 10)).copied();
    let highest = after.filter(|value| value.is_finite()).fold(low, f64::max);
    highest - low >= 0.05 * (high - low)
}

/// Draws the runs as steps, the last one, the best, on top; a run ends where `of` has no value.
fn draw(
    svg: &mut Svg,
    runs: &[&SearchRun],
    x: &Axis,
    y: &Axis,
    most: usize,
    of: impl Fn(f64) -> Option<f64>,
) {
    for (k, run) in runs.iter().enumerate() {
        let best = k + 1 == runs.len();
        let values: Vec<f64> =
            run.history().iter().map_while(|&value| of(value).filter(|v| v.is_finite())).collect();
        let step = values.len().div_ceil(most).max(1);
        let corners = values.iter().enumerate().filter(|(i, _)| i % step == 0 || i + 1 == values.len());
        let points: Vec<[f64; 2]> = corners.map(|(i, &value)| [x.at(i as f64), y.at(value)]).collect();
        if points.len() < 2 {
            continue;
        }
        let (colour, width, opacity) = if best { (ACCENT, 2.0, 1.0) } else { (RUN, 1.0, 0.6) };
        svg.element(format_args!(
            r#"path d="{}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-opacity="{opacity}" stroke-linejoin="round""#,
            path(points, false)
        ));
    }
}
