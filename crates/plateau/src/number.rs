//! Numbers for people: as many digits of a number as are of use, in the notation that can be read. Sentences, tables and pictures take
//! it wherever one notation is not right for every size; an error with two digits is always `{:.1e}`.

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// So many decimals, aligned in a column; with an exponent where they would show less than three digits, or more than
    /// nine before the point.
    Decimals(usize),
    /// A hundredfold with so many decimals and a per cent sign; with an exponent from 1e4 on.
    Percent(usize),
    /// One decimal and the exponent: errors, of which the exponent is what there is to read.
    Order,
    /// Three decimals, or one and the exponent below 0.01 and from 1e6 on: estimates.
    Estimate,
    /// An angle in radians, by so many digits of its degrees as [`Self::Significant`].
    Degrees(usize),
    /// Exactly so many digits, 1 to 17; with an exponent outside of 1e-5 to 1e12.
    Significant(usize),
    /// At most so many digits, 1 to 17, as print sets them: `1.2·10⁻⁷`. For pictures and pages.
    Digits(usize),
    /// At most so many digits, 1 to 17, as a file takes them: with an exponent outside of 1e-5 to 1e15. For messages.
    Short(usize),
    /// All digits that the double has, written as those of [`Self::Short`].
    Exact,
    /// Two decimals, or one digit and the exponent below 0.01: shares.
    Share,
}

impl Notation {
    /// A number in this notation; what is not finite is written as `f64` writes it.
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
            Self::Order | Self::Estimate | Self::Degrees(_) | Self::Significant(_) | Self::Digits(_)
                if x == 0.0 =>
            {
                "0".into()
            }
            Self::Estimate if (0.01..1e6).contains(&x.abs()) => format!("{x:.3}"),
            Self::Estimate => Self::Order.of(x),
            Self::Degrees(count) => significant(x.to_degrees(), count),
            Self::Significant(count) => significant(x, count),
            Self::Order => format!("{x:.1e}"),
            Self::Digits(most) => digits(x, most),
            Self::Short(most) => exact(rounded(x, most)),
            Self::Exact => exact(x),
            Self::Share if x < 0.01 => format!("{x:.0e}"),
            Self::Share => format!("{x:.2}"),
        }
    }

    /// 10ⁿ, as print sets it.
    #[must_use]
    pub fn power_of_ten(n: i32) -> String {
        power_of_ten(n)
    }

    /// The power of ten of the first digit of a number that is not 0.
    #[must_use]
    pub fn decade(x: f64) -> i32 {
        decade(x)
    }
}

/// `1 point`, `4 points`: a count and what is counted.
#[must_use]
pub fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// Seconds by one digit, in words, for what is known within a factor of a few: `10 s`, `80 min`, `2 h`; never less than `1 s`.
#[must_use]
pub fn rough_duration(seconds: f64) -> String {
    const UNITS: [(f64, &str); 4] = [(86400.0, "days"), (3600.0, "h"), (60.0, "min"), (1.0, "s")];
    let (unit, name) = UNITS.into_iter().find(|(unit, _)| seconds >= 2.0 * unit).unwrap_or((1.0, "s"));
    let count = (seconds / unit).max(1.0);
    let digit = 10f64.powf(count.log10().floor());
    format!("{:.0} {name}", (count / digit).round() * digit)
}

fn decade(x: f64) -> i32 {
    // That of print, which no rounding of a logarithm moves.
    format!("{x:e}").rsplit_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

fn exact(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// The double nearest to the first digits of x.
fn rounded(x: f64, count: usize) -> f64 {
    format!("{x:.*e}", count.saturating_sub(1)).parse().unwrap_or(x)
}

fn significant(x: f64, count: usize) -> String {
    let (decade, behind) = (decade(x), count.saturating_sub(1));
    let decimals = usize::try_from(behind as i32 - decade).unwrap_or(0);
    if (-5..12).contains(&decade) { format!("{x:.decimals$}") } else { format!("{x:.behind$e}") }
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

fn power_of_ten(n: i32) -> String {
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
    fn seconds_are_told_by_one_digit_in_the_unit_that_suits() {
        let told = [0.2, 1.0, 14.9, 119.0, 121.0, 5000.0, 8000.0, 1e6].map(rough_duration);
        assert_eq!(told, ["1 s", "1 s", "10 s", "100 s", "2 min", "80 min", "2 h", "10 days"]);
    }

    #[test]
    fn numbers_stay_readable_at_any_size() {
        let shown = [0.0, 37.5, 1e-4, -1e-7, 2.5e90].map(|x| Notation::Decimals(7).of(x));
        assert_eq!(shown, ["0.0000000", "37.5000000", "0.0001000", "-1.0000000e-7", "2.5000000e90"]);
        let shown = [0.005_164, 1.0, 3e-9, 3e7].map(|x| Notation::Percent(4).of(x));
        assert_eq!(shown, ["0.5164 %", "100.0000 %", "0.0000 %", "3.0e7"]);
        assert_eq!(Notation::Order.of(5.46e-13), "5.5e-13");
        let shown = [0.0, 0.5, 4.1e-3, 1e-9].map(|x| Notation::Degrees(2).of(x));
        assert_eq!(shown, ["0", "29", "0.23", "5.7e-8"]);
        let shown = [0.0, 0.154_12, 1e-100, 6.57e60, -3.5e-3].map(|x| Notation::Estimate.of(x));
        assert_eq!(shown, ["0", "0.154", "1.0e-100", "6.6e60", "-3.5e-3"]);
        let shown = [0.0, 36.767_191_079, 6.5e-24, 1e-100, 6.5e60].map(|x| Notation::Significant(5).of(x));
        assert_eq!(shown, ["0", "36.767", "6.5000e-24", "1.0000e-100", "6.5000e60"]);
    }

    #[test]
    fn digits_are_as_few_as_say_it() {
        let shown = [0.61210, -0.5, 1234.56, 1.2e-7, 3.0, 0.001].map(|x| Notation::Digits(4).of(x));
        assert_eq!(shown, ["0.6121", "−0.5", "1235", "1.2·10⁻⁷", "3", "0.001"]);
    }

    #[test]
    fn messages_have_plain_numbers() {
        let shown = [2.0, -0.5, 1e200, 1e-9, f64::NAN, f64::INFINITY].map(|x| Notation::Exact.of(x));
        assert_eq!(shown, ["2", "-0.5", "1e200", "1e-9", "NaN", "inf"]);
        let shown = [1.0 / 3.0, 2e-9 / 3.0, 123_456.0, 0.0].map(|x| Notation::Short(4).of(x));
        assert_eq!(shown, ["0.3333", "6.667e-10", "123500", "0"]);
        assert_eq!([0.254, 1.0, 3.4e-3].map(|x| Notation::Share.of(x)), ["0.25", "1.00", "3e-3"]);
        assert_eq!([0, 1, 2].map(|count| counted(count, "point")), ["0 points", "1 point", "2 points"]);
    }

    #[test]
    fn what_is_written_is_the_number_to_its_last_digit() {
        for x in [1.0, -0.123_456_789, 9.999_999_96, 1.234_567_891_2e-5, 3.8e-21, 6.021e23, 999_999.96] {
            let forms = [
                (Notation::Decimals(7), 1e-3),
                (Notation::Order, 0.05),
                (Notation::Significant(9), 1e-8),
                (Notation::Digits(9), 1e-8),
                (Notation::Short(9), 1e-8),
                (Notation::Exact, 0.0),
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
