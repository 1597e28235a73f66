//! Intervals of numbers that a key admits.

use std::fmt;

use serde_json::{Map, Value as Json, json};

use super::number::shown;

/// Finite numbers between two bounds, either of which may be infinite or left out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    lower: f64,
    upper: f64,
    without_lower: bool,
    without_upper: bool,
}

impl Interval {
    /// Every finite number.
    pub(crate) const FINITE: Self = Self::between(f64::NEG_INFINITY, f64::INFINITY);

    /// `lower ≤ x ≤ upper`.
    pub(crate) const fn between(lower: f64, upper: f64) -> Self {
        Self { lower, upper, without_lower: false, without_upper: false }
    }

    /// `lower < x ≤ upper`.
    pub(crate) const fn above(lower: f64, upper: f64) -> Self {
        Self { without_lower: true, ..Self::between(lower, upper) }
    }

    /// `lower ≤ x < upper`.
    pub(crate) const fn below(lower: f64, upper: f64) -> Self {
        Self { without_upper: true, ..Self::between(lower, upper) }
    }

    pub(crate) fn holds(&self, x: f64) -> bool {
        let above = if self.without_lower { x > self.lower } else { x >= self.lower };
        let below = if self.without_upper { x < self.upper } else { x <= self.upper };
        x.is_finite() && above && below
    }

    /// The interval in words, for the book.
    pub(super) fn words(&self) -> String {
        let (lower, upper) = (shown(self.lower), shown(self.upper));
        let without = |excluded: bool| if excluded { ", excluded" } else { "" };
        let (least, most) = (without(self.without_lower), without(self.without_upper));
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (false, false) => "any number".to_owned(),
            (true, false) => format!("from {lower}{least}"),
            (false, true) => format!("up to {upper}{most}"),
            (true, true) => format!("{lower}{least} to {upper}{most}"),
        }
    }

    /// `minimum`, `maximum` and their exclusive forms.
    pub(super) fn bounds(&self) -> Map<String, Json> {
        let mut bounds = Map::new();
        // Whole bounds are written as such: 4, not 4.0.
        let number = |x: f64| if x.fract() == 0.0 && x.abs() < 1e15 { json!(x as i64) } else { json!(x) };
        if self.lower.is_finite() {
            let keyword = if self.without_lower { "exclusiveMinimum" } else { "minimum" };
            bounds.insert(keyword.into(), number(self.lower));
        }
        if self.upper.is_finite() {
            let keyword = if self.without_upper { "exclusiveMaximum" } else { "maximum" };
            bounds.insert(keyword.into(), number(self.upper));
        }
        bounds
    }
}

impl fmt::Display for Interval {
    /// What a number must do: "lie between 0 and 4".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (lower, upper) = (shown(self.lower), shown(self.upper));
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (false, false) => f.write_str("be finite"),
            (true, false) if self.lower == 0.0 && !self.without_lower => f.write_str("be 0 or positive"),
            (true, false) if self.without_lower => write!(f, "lie above {lower}"),
            (true, false) => write!(f, "be at least {lower}"),
            (false, true) if self.without_upper => write!(f, "lie below {upper}"),
            (false, true) => write!(f, "be at most {upper}"),
            (true, true) => match (self.without_lower, self.without_upper) {
                (false, false) => write!(f, "lie between {lower} and {upper}"),
                (true, false) => write!(f, "be above {lower} and at most {upper}"),
                (false, true) => write!(f, "be at least {lower} and below {upper}"),
                (true, true) => write!(f, "be above {lower} and below {upper}"),
            },
        }
    }
}
