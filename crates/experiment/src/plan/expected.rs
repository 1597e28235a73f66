//! Numbers a result must reproduce, and numbers printed elsewhere.

use plateau::Quantity;

pub(super) mod check;

/// What a file says of the figures of one method, helicoid or curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted {
    /// Numbers the result must reproduce.
    pub expect: Vec<Expected>,
    /// Numbers printed elsewhere, to be shown beside ours.
    pub published: Vec<Published>,
}

/// One number of an `expect` table.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// Which figure of the result.
    pub quantity: Quantity,
    /// The number; finite.
    pub value: f64,
    /// Largest admissible |ours − value|; > 0 or, if written so, 0.
    ///
    /// Half a unit of the last digit written in the file (`38.0` admits 0.05), or what
    /// `{ value = …, tolerance = … }` says.
    pub tolerance: f64,
    /// The number as the file writes it.
    pub text: String,
    /// Its line in the file, from 1.
    pub line: usize,
}

impl Expected {
    /// Whether `ours` agrees with the number to the digits written. NaN and infinity never do.
    ///
    /// The comparison itself may round: a value that lies on the limit up to a few units in the last
    /// place of the numbers compared counts as met.
    #[must_use]
    pub fn is_met_by(&self, ours: f64) -> bool {
        let rounding = 4.0 * f64::EPSILON * (self.value.abs() + self.tolerance);
        (ours - self.value).abs() <= self.tolerance + rounding
    }
}

/// One figure printed elsewhere, shown beside ours; it decides nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// Where it is printed: `GT Table 1`.
    pub source: String,
    /// Which of our figures the printed number really is.
    pub quantity: Quantity,
    /// What it is called there, if that differs: `Area`.
    pub heading: Option<String>,
    /// The printed number; finite.
    pub printed: f64,
    /// The printed number as the file writes it, with all its digits.
    pub text: String,
    /// Half a unit of the last printed digit.
    pub tolerance: f64,
    /// Why ours differs, where it does.
    pub reason: Option<String>,
    /// Its line in the file, from 1.
    pub line: usize,
}

impl Published {
    /// Whether `ours` rounds to the printed number. NaN and infinity never do.
    #[must_use]
    pub fn agrees_with(&self, ours: f64) -> bool {
        let rounding = 4.0 * f64::EPSILON * (self.printed.abs() + self.tolerance);
        (ours - self.printed).abs() <= self.tolerance + rounding
    }
}
