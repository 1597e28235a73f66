//! Numbers as the file writes them.

use plateau::Notation;

/// A number for a message, with all its digits.
pub(crate) fn shown(value: f64) -> String {
    Notation::Exact.of(value)
}

/// A point for a message.
pub(crate) fn shown_point(point: &[f64]) -> String {
    let coordinates: Vec<String> = point.iter().map(|&x| shown(x)).collect();
    format!("[{}]", coordinates.join(", "))
}

/// Half a unit of the last digit of a TOML number: `38.0` gives 0.05, `1.5e-3` gives 5e-5, `38` gives 0.5.
///
/// The result is the double nearest to it; 0 or infinity where the exponent leaves the range of doubles.
pub(crate) fn half_unit_of_last_digit(text: &str) -> f64 {
    let text = text.replace('_', "");
    let unsigned = text.trim_start_matches(['+', '-']);
    if unsigned.starts_with("0x") || unsigned.starts_with("0o") || unsigned.starts_with("0b") {
        return 0.5;
    }
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().unwrap_or(0)),
        None => (unsigned, 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    let exponent = exponent.saturating_sub(i64::try_from(decimals).unwrap_or(i64::MAX));
    format!("0.5e{exponent}").parse().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerance_follows_the_digits_written() {
        for (text, half) in [
            ("38.0", 0.05),
            ("38", 0.5),
            ("-37.4396", 0.00005),
            ("37.43961", 0.000005),
            ("1.5e-3", 0.00005),
            ("1E3", 500.0),
            ("+1_000.25", 0.005),
            ("2e-13", 0.5e-13),
            ("0x1F", 0.5),
            ("0.0", 0.05),
        ] {
            assert_eq!(half_unit_of_last_digit(text), half, "{text}");
        }
        assert_eq!(half_unit_of_last_digit("1e-9999"), 0.0);
    }

    #[test]
    fn numbers_are_shown_shortly() {
        assert_eq!(shown_point(&[0.0, 6.0, 2.5]), "[0, 6, 2.5]");
    }
}
