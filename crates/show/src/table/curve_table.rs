//! The tables of a curve experiment.

use super::cells::Cells;
use super::column::Column;
use plateau::{CurveResult, CurveSample, Notation};

const FIGURE: Notation = Notation::Decimals(7);

/// Length and largest curvature of curves.
pub(crate) fn summary(curves: &[CurveResult]) -> Cells {
    let columns = vec![
        Column::words("curve", ""),
        Column { rank: 2, ..Column::number("samples", "") },
        Column::number("length", "length"),
        Column { rank: 1, ..Column::number("± of length", "length") },
        Column::number("largest |κ|", "1/length"),
        Column { rank: 3, ..Column::number("at t", "") },
    ];
    let row = |curve: &CurveResult| {
        let (largest, at) = match curve.sharpest() {
            Some((sample, curvature)) => (FIGURE.of(curvature.abs()), Notation::Short(9).of(sample.t)),
            None => ("–".into(), "–".into()),
        };
        let [length, error] = curve.length();
        let (name, samples) = (curve.name().to_owned(), curve.samples().len().to_string());
        vec![name, samples, FIGURE.of(length), Notation::Order.of(error), largest, at]
    };
    Cells::new(columns, curves.iter().map(row).collect())
}

/// The first samples, at most `most`, with their points and curvatures.
pub(crate) fn samples(curve: &CurveResult, most: usize) -> Cells {
    let names = ["t", "x", "y", "z"];
    let headings = names[..=curve.dimension()].iter().copied().chain(["curvature κ"]);
    let columns = headings.map(|heading| Column::number(heading, "")).collect();
    let row = |sample: &CurveSample| -> Vec<String> {
        let point = curve.coordinates(sample.jet.point);
        let curvature = sample.curvature.map_or("none".into(), |x| FIGURE.of(x));
        let figures = point.into_iter().map(|x| FIGURE.of(x));
        std::iter::once(Notation::Short(9).of(sample.t)).chain(figures).chain([curvature]).collect()
    };
    Cells::new(columns, curve.samples().iter().take(most).map(row).collect())
}
