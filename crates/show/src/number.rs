//! Numbers for people: a few digits of a number, in the form that can be read.

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// So many decimals, aligned in a column; with an exponent where they would show less than three digits, or more than
    /// nine before the point.
    Decimals(usize),
    /// A hundredfold with so many decimals and a per cent sign; with an exponent from 1e4 on.
    Percent(usize),
    /// One decimal and the exponent: errors, of which the exponent is what there is to read.
    Order,
    /// Three decimals, or one and the exponent below 0.01 and from 1e6 on: estimates.
    Estimate,
    /// Exactly so many digits, 1 to 17; with an exponent outside of 1e-5 to 1e12.
    Significant(usize),
    /// At most so many digits, 1 to 17, as print sets them: `1.2·10⁻⁷`. For pictures and sentences.
    Digits(usize),
}

impl Form {
    /// A finite number in this form.
    #[must_use]
    pub fn of(self, x: f64) -> String {
        match self {
            Self::Decimals(decimals) => {
                let least = libm::exp10(3.0 - decimals as f64).min(1e-3);
                let is_plain = x == 0.0 || (least..1e9).contains(&x.abs());
                if is_plain { format!("{x:.decimals$}") } else { format!("{x:.decimals$e}") }
            }
            Self::Percent(decimals) if x.abs() < 1e4 => format!("{:.decimals$} %", 100.0 * x),
            Self::Percent(_) => Self::Order.of(x),
            Self::Order | Self::Estimate | Self::Significant(_) | Self::Digits(_) if x == 0.0 => "0".into(),
            Self::Estimate if (0.01..1e6).contains(&x.abs()) => format!("{x:.3}"),
            Self::Estimate => Self::Order.of(x),
            Self::Significant(count) => significant(x, count),
            Self::Order => format!("{x:.1e}"),
            Self::Digits(most) => digits(x, most),
        }
    }
}

/// The power of ten of the first digit of a number that is not 0.
pub(crate) fn decade(x: f64) -> i32 {
    // That of print, which no rounding of a logarithm moves.
    format!("{x:e}").rsplit_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

fn significant(x: f64, count: usize) -> String {
    let (decade, behind) = (decade(x), count.saturating_sub(1));
    let decimals = usize::try_from(behind as i32 - decade).unwrap_or(0);
    if (-5..12).contains(&decade) { format!("{x:.decimals$}") } else { format!("{x:.behind$e}") }
}

/// A number in four digits at most.
pub(crate) fn number(x: f64) -> String {
    Form::Digits(4).of(x)
}

fn digits(x: f64, most: usize) -> String {
    let decade = libm::floor(libm::log10(x.abs()) + 1e-12) as i32;
    let text = if (-3..6).contains(&decade) {
        let decimals = (most as i32 - 1 - decade).max(0) as usize;
        without_zeros(&format!("{x:.decimals$}")).to_owned()
    } else {
        let text = format!("{x:.*e}", most - 1);
        match text.split_once('e') {
            Some((digits, exponent)) => {
                let exponent: i32 = exponent.parse().unwrap_or(decade);
                format!("{}·{}", without_zeros(digits), power_of_ten(exponent))
            }
            None => text,
        }
    };
    text.replace('-', "−")
}

/// Decimals without the zeros at their end.
fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// 10ⁿ.
pub(crate) fn power_of_ten(n: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if n < 0 { "⁻" } else { "" };
    let digits = n.unsigned_abs().to_string();
    let raised: String = digits.bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect();
    format!("10{sign}{raised}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_readable_at_any_size() {
        let shown = [0.0, 37.5, 1e-4, -1e-7, 2.5e90].map(|x| Form::Decimals(7).of(x));
        assert_eq!(shown, ["0.0000000", "37.5000000", "0.0001000", "-1.0000000e-7", "2.5000000e90"]);
        let shown = [0.005_164, 1.0, 3e-9, 3e7].map(|x| Form::Percent(4).of(x));
        assert_eq!(shown, ["0.5164 %", "100.0000 %", "0.0000 %", "3.0e7"]);
        assert_eq!(Form::Order.of(5.46e-13), "5.5e-13");
        let shown = [0.0, 0.154_12, 1e-100, 6.57e60, -3.5e-3].map(|x| Form::Estimate.of(x));
        assert_eq!(shown, ["0", "0.154", "1.0e-100", "6.6e60", "-3.5e-3"]);
        let shown = [0.0, 36.767_191_079, 6.5e-24, 1e-100, 6.5e60].map(|x| Form::Significant(5).of(x));
        assert_eq!(shown, ["0", "36.767", "6.5000e-24", "1.0000e-100", "6.5000e60"]);
    }

    #[test]
    fn digits_are_as_few_as_say_it() {
        let shown = [0.61210, -0.5, 1234.56, 1.2e-7, 3.0, 0.001].map(number);
        assert_eq!(shown, ["0.6121", "−0.5", "1235", "1.2·10⁻⁷", "3", "0.001"]);
    }

    #[test]
    fn what_is_written_is_the_number_to_its_last_digit() {
        for x in [1.0, -0.123_456_789, 9.999_999_96, 1.234_567_891_2e-5, 3.8e-21, 6.021e23, 999_999.96] {
            let forms = [
                (Form::Decimals(7), 1e-3),
                (Form::Order, 0.05),
                (Form::Significant(9), 1e-8),
                (Form::Digits(9), 1e-8),
            ];
            for (form, relative) in forms {
                let text = form.of(x).replace('−', "-").replace("·10", "e");
                let plain: String = text
                    .chars()
                    .map(|c| {
                        "⁰¹²³⁴⁵⁶⁷⁸⁹"
                            .chars()
                            .position(|raised| raised == c)
                            .map_or(c, |k| (b'0' + k as u8) as char)
                    })
                    .map(|c| if c == '⁻' { '-' } else { c })
                    .collect();
                let read: f64 = plain.parse().unwrap();
                assert!((read - x).abs() <= relative * x.abs(), "{form:?} {x}: {text}");
            }
        }
    }
}
