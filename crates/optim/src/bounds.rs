//! The box of admissible points.

use thiserror::Error;

/// The box `lower ≤ x ≤ upper`, with a non-empty interior.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

/// The largest magnitude of a bound: products of box widths and coefficients then stay finite.
pub const MAX_BOUND: f64 = 1e150;

/// Why two lists of numbers are no box, or a point does not lie in one.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BoundsError {
    /// The box has no component.
    #[error("the box has dimension 0; give at least one pair of bounds")]
    Empty,
    /// The two sides differ in length.
    #[error("{lower} lower but {upper} upper bounds; give one of each per component")]
    Lengths {
        /// Number of lower bounds.
        lower: usize,
        /// Number of upper bounds.
        upper: usize,
    },
    /// A bound is NaN, infinite, or beyond [`MAX_BOUND`].
    #[error(
        "the {side} bound of component {index} is {value:?}; it must be finite and at most 1e150 in magnitude"
    )]
    NotFinite {
        /// `"lower"` or `"upper"`.
        side: &'static str,
        /// The component.
        index: usize,
        /// The bound.
        value: f64,
    },
    /// A side is empty or a single number.
    #[error("component {index} has lower bound {lower:?}, not below its upper bound {upper:?}")]
    Order {
        /// The component.
        index: usize,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// A point has the wrong number of components.
    #[error("the point has {found} components, the box {expected}")]
    Dimension {
        /// The dimension of the box.
        expected: usize,
        /// The length of the point.
        found: usize,
    },
    /// A point lies outside the box, or is NaN.
    #[error("component {index} of the point is {value:?}, outside [{lower:?}, {upper:?}]")]
    Outside {
        /// The component.
        index: usize,
        /// Its value.
        value: f64,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
}

impl Bounds {
    /// The box between `lower` and `upper`.
    ///
    /// # Errors
    /// The sides must have the same positive length, finite numbers of magnitude at most
    /// [`MAX_BOUND`], and `lower[i] < upper[i]` for every `i`.
    pub fn new(lower: Vec<f64>, upper: Vec<f64>) -> Result<Self, BoundsError> {
        if lower.len() != upper.len() {
            return Err(BoundsError::Lengths { lower: lower.len(), upper: upper.len() });
        }
        if lower.is_empty() {
            return Err(BoundsError::Empty);
        }
        for (side, values) in [("lower", &lower), ("upper", &upper)] {
            if let Some(index) = values.iter().position(|b| b.is_nan() || b.abs() > MAX_BOUND) {
                let value = values[index];
                return Err(BoundsError::NotFinite { side, index, value });
            }
        }
        if let Some(index) = (0..lower.len()).find(|&i| lower[i] >= upper[i]) {
            return Err(BoundsError::Order { index, lower: lower[index], upper: upper[index] });
        }
        Ok(Self { lower, upper })
    }

    /// The cube `[lower, upper]^dimension`.
    ///
    /// # Errors
    /// As [`Bounds::new`].
    pub fn cube(dimension: usize, lower: f64, upper: f64) -> Result<Self, BoundsError> {
        Self::new(vec![lower; dimension], vec![upper; dimension])
    }

    /// Number of components.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.lower.len()
    }

    /// The lower bounds.
    #[must_use]
    pub fn lower(&self) -> &[f64] {
        &self.lower
    }

    /// The upper bounds.
    #[must_use]
    pub fn upper(&self) -> &[f64] {
        &self.upper
    }

    /// `upper[index] − lower[index]`, positive.
    ///
    /// # Panics
    /// If `index` is not below the dimension.
    #[must_use]
    pub fn width(&self, index: usize) -> f64 {
        self.upper[index] - self.lower[index]
    }

    /// Whether `point` has the right length and lies in the box; a NaN does not.
    #[must_use]
    pub fn contains(&self, point: &[f64]) -> bool {
        self.check(point).is_ok()
    }

    /// As [`Bounds::contains`], naming the first component at fault.
    ///
    /// # Errors
    /// [`BoundsError::Dimension`] or [`BoundsError::Outside`].
    pub fn check(&self, point: &[f64]) -> Result<(), BoundsError> {
        if point.len() != self.dimension() {
            return Err(BoundsError::Dimension { expected: self.dimension(), found: point.len() });
        }
        for (index, &value) in point.iter().enumerate() {
            let (lower, upper) = (self.lower[index], self.upper[index]);
            if !(lower <= value && value <= upper) {
                return Err(BoundsError::Outside { index, value, lower, upper });
            }
        }
        Ok(())
    }

    /// The point at fraction `t ∈ [0, 1]` of component `index`, inside the box in spite of rounding.
    pub(crate) fn at(&self, index: usize, t: f64) -> f64 {
        (self.lower[index] + t * self.width(index)).min(self.upper[index])
    }
}
