//! Single values of the document.

use serde_spanned::Spanned;
use toml::de::{DeInteger, DeValue};

/// A value with its place.
pub(crate) type Value<'t> = Spanned<DeValue<'t>>;

/// A number that its type cannot hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooLarge;

/// A number, written with or without a point; may be NaN or infinite if the file says so. `None` if the value is no number.
pub(super) fn real(value: &DeValue<'_>) -> Option<Result<f64, TooLarge>> {
    match value {
        DeValue::Float(float) => {
            let said = float.as_str();
            let number = said.parse::<f64>().unwrap_or(f64::INFINITY);
            let overflows = number.is_infinite() && !said.contains("inf");
            Some(if overflows { Err(TooLarge) } else { Ok(number) })
        }
        DeValue::Integer(integer) if integer.radix() == 10 => {
            let number = integer.as_str().parse().unwrap_or(f64::INFINITY);
            Some(if number.is_finite() { Ok(number) } else { Err(TooLarge) })
        }
        DeValue::Integer(integer) => Some(integral(integer).map(|whole| whole as f64)),
        DeValue::String(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_)
        | DeValue::Array(_)
        | DeValue::Table(_) => None,
    }
}

/// The finite number that a value is, if it is one.
pub(crate) fn finite(value: &DeValue<'_>) -> Option<f64> {
    real(value)?.ok().filter(|number| number.is_finite())
}

/// A whole number of any sign. `None` if the value is none.
pub(super) fn whole(value: &DeValue<'_>) -> Option<Result<i128, TooLarge>> {
    value.as_integer().map(integral)
}

fn integral(integer: &DeInteger<'_>) -> Result<i128, TooLarge> {
    i128::from_str_radix(integer.as_str(), integer.radix()).map_err(|_| TooLarge)
}

/// What a value is, in words.
pub(super) fn noun(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text in quotes",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a number with a decimal point",
        DeValue::Boolean(_) => "`true` or `false`",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
