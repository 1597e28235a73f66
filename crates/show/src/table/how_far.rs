//! How far surfaces may lie above the least area of their boundary, in words.

use crate::Printable;
use plateau::{AreaEnd, AreaExtremal, Done, Energy, Family, Notation, Results, Warning};

/// What is known of the least area over the rim of a surface of least area; none if nothing is.
pub(crate) fn how_far(done: &Done) -> Option<String> {
    if done.solved.minimised() != Some(Energy::Area) || done.estimate.is_none() && done.bound.is_none() {
        return None;
    }
    let area = done.figures.area.value;
    let bound = done.bound.as_ref();
    let difference = bound.map_or(f64::INFINITY, |bound| area - bound.value);
    let mut text = format!("least ≤ {}", digits(area, difference.min(done.estimate.unwrap_or(difference))));
    if let Some(estimate) = done.estimate {
        text += &format!(", about {} less (estimated)", Notation::Estimate.of(estimate));
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
        let estimate = done.estimate.filter(|_| done.solved.minimised() != Some(Energy::Area))?;
        Some(format!("{}: {}", Printable(&method.name).cut(Printable::NAME), Notation::Estimate.of(estimate)))
    };
    let all: Vec<String> = results.methods().iter().filter_map(of).collect();
    (!all.is_empty()).then(|| format!("above the least area of the boundary (estimated): {}", all.join("; ")))
}

/// Why there is no estimate where one would be too costly.
pub(crate) const NOT_ESTIMATED: &str = "not estimated, which would cost more than the surface did";

/// Whether a least area that was reached, and of which nothing is estimated, lacks that because it would be too costly: any other reason is told.
pub(crate) fn is_too_costly(found: &AreaExtremal, warnings: &[Warning]) -> bool {
    let is_told = warnings.iter().any(|warning| matches!(warning, Warning::NoEstimate(_)));
    found.end == AreaEnd::Stationary && found.area.settled && !is_told
}

/// The surfaces of least area that nothing is estimated of unasked, all in one line; none if there are none.
pub(crate) fn unestimated(results: &Results) -> Option<String> {
    let of = |method: &plateau::MethodResult| {
        let done = method.outcome.as_ref().ok()?;
        let found = done.solved.area()?;
        let is_polynomial = match done.solved.family() {
            Family::Bernstein | Family::Triangle | Family::Complex => true,
            // What they lack is not among functions of their shape.
            Family::Shaped(_) | Family::Aht | Family::At => false,
        };
        let is_costly = done.estimate.is_none() && is_too_costly(found, &done.warnings);
        (is_polynomial && is_costly).then(|| Printable(&method.name).cut(Printable::NAME))
    };
    let all: Vec<String> = results.methods().iter().filter_map(of).collect();
    (!all.is_empty()).then(|| {
        format!(
            "how far above the least area of the boundary is {NOT_ESTIMATED}: {}; over `sides`, `loops` and `polygon` `accuracy` asks for it",
            all.join(", ")
        )
    })
}

/// A figure with two digits of `difference`, and as many decimals as the table has at least.
fn digits(figure: f64, difference: f64) -> String {
    let [first, last] = [figure, difference].map(|x| Notation::decade(x.abs().max(f64::MIN_POSITIVE)));
    let least = if (-4..9).contains(&first) { 8 + first } else { 8 };
    Notation::Significant((first - last + 2).clamp(least, 16) as usize).of(figure)
}
