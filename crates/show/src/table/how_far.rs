//! How far surfaces may lie above the least area of their boundary, in words.

use crate::Printable;
use plateau::{Done, Energy, Results};

/// What is known of the least area over the rim of a surface of least area; none if nothing is.
pub(crate) fn how_far(done: &Done) -> Option<String> {
    if done.solved.minimised != Some(Energy::Area) || done.estimate.is_none() && done.bound.is_none() {
        return None;
    }
    let area = done.figures.area.value;
    let bound = done.bound.as_ref();
    let difference = bound.map_or(f64::INFINITY, |bound| area - bound.value);
    let mut text = format!("least ≤ {}", digits(area, difference.min(done.estimate.unwrap_or(difference))));
    if let Some(estimate) = done.estimate {
        text += &format!(", about {} less (estimated)", small(estimate));
    }
    if let Some(bound) = bound {
        text += &format!(", ≥ {} (proved of {})", digits(bound.value, difference), bound.competitors.name());
    }
    Some(text)
}

/// What the surfaces that are none of least area are above it, all in one line; none if that of none is known.
pub(crate) fn losses(results: &Results) -> Option<String> {
    let of = |method: &plateau::MethodResult| {
        let done = method.outcome.as_ref().ok()?;
        let estimate = done.estimate.filter(|_| done.solved.minimised != Some(Energy::Area))?;
        Some(format!("{}: {}", Printable(&method.name).cut(Printable::NAME), small(estimate)))
    };
    let all: Vec<String> = results.methods.iter().filter_map(of).collect();
    (!all.is_empty()).then(|| format!("above the least area of the boundary (estimated): {}", all.join("; ")))
}

/// A figure with two digits of `difference`, and seven decimals at least.
fn digits(figure: f64, difference: f64) -> String {
    let decimals = 1.0 - difference.abs().max(f64::MIN_POSITIVE).log10().floor();
    let most = 15.0 - figure.abs().max(f64::MIN_POSITIVE).log10().floor();
    format!("{figure:.*}", decimals.max(7.0).min(most).max(0.0) as usize)
}

/// Two digits or more.
fn small(figure: f64) -> String {
    if figure < 0.01 { format!("{figure:.1e}") } else { format!("{figure:.3}") }
}
