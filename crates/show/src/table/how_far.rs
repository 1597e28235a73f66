//! How far a surface may lie above the least area, in words.

use plateau::Done;

/// What is known of the least area over the rim of a surface; none if nothing is.
pub fn how_far(done: &Done) -> Option<String> {
    let area = done.figures.area.value;
    let bound = done.bound.as_ref()?;
    let proved =
        format!("≥ {} (proved of {})", digits(bound.value, area - bound.value), bound.competitors.name());
    Some(format!("the least area is ≤ {} and {proved}", digits(area, area - bound.value)))
}

/// A figure with two digits of `difference`, and seven decimals at least.
fn digits(figure: f64, difference: f64) -> String {
    let decimals = 1.0 - difference.abs().max(f64::MIN_POSITIVE).log10().floor();
    let most = 15.0 - figure.abs().max(f64::MIN_POSITIVE).log10().floor();
    format!("{figure:.*}", decimals.max(7.0).min(most).max(0.0) as usize)
}
