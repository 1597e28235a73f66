//! The table of a curve experiment.

use super::grid::{Column, figure, grid};
use plateau::CurveResult;

/// Most samples that are listed.
const LISTED: usize = 12;

/// Length and largest curvature; the samples themselves, where they are few.
pub(crate) fn curve_table(curve: &CurveResult) -> String {
    let number = |heading, unit| Column { heading, unit, is_words: false };
    let columns = [
        Column { heading: "curve", unit: "", is_words: true },
        number("samples", ""),
        number("length", "length"),
        number("± of length", "length"),
        number("largest |κ| of the samples", "1/length"),
        number("at t", ""),
    ];
    let (largest, at) = match curve.sharpest() {
        Some((k, curvature)) => (figure(curvature.abs()), curve.t[k].to_string()),
        None => ("–".into(), "–".into()),
    };
    let [length, error] = curve.length;
    let row = vec![
        curve.name.clone(),
        curve.t.len().to_string(),
        figure(length),
        format!("{error:.1e}"),
        largest,
        at,
    ];
    let mut text = grid(&columns, &[row]);
    if curve.t.len() <= LISTED {
        text.push('\n');
        text += &samples(curve);
    }
    text
}

fn samples(curve: &CurveResult) -> String {
    let heading = |heading| Column { heading, unit: "", is_words: false };
    let names = ["t", "x", "y", "z"];
    let columns: Vec<Column> =
        names[..=curve.dimension].iter().copied().chain(["curvature κ"]).map(heading).collect();
    let row = |k: usize| -> Vec<String> {
        let point = curve.coordinates(curve.jets[k].point);
        let curvature = curve.curvature[k].map_or("none".into(), figure);
        std::iter::once(curve.t[k].to_string())
            .chain(point.into_iter().map(figure))
            .chain([curvature])
            .collect()
    };
    grid(&columns, &(0..curve.t.len()).map(row).collect::<Vec<_>>())
}
