//! Polishing a point to a stationary one: BFGS in a box.

use rayon::prelude::*;
use thiserror::Error;

use crate::bounds::{Bounds, BoundsError};
use crate::descent::Descent;
use crate::objective::Smooth;
use crate::report::Polished;
use crate::stream::{Purpose, Source};

/// Parameters of a projected quasi-Newton descent with exact gradients.
///
/// Each iteration minimises the model `gᵀd + ½ dᵀB d` over the whole box (so it meets and leaves
/// bounds many at a time) and searches along `d` for sufficient decrease; B is updated by BFGS from
/// pairs of positive curvature. Where the value changes by less than 1e-12 of its own or the start's
/// magnitude it may be blurred by rounding; there, steps are judged by the gradient, and of the points
/// reached the one of least residual is reported. All norms are relative to the box, so the result
/// does not depend on the units of the components. A stationary point need not be a minimum, nor a
/// minimum the lowest one.
#[derive(Clone, Debug, PartialEq)]
pub struct Polish {
    /// Stationary means: residual ≤ `tolerance × |value|`, the residual being the largest
    /// `widthᵢ |gᵢ|` over the projected gradient. In `[0, 1]`.
    pub tolerance: f64,
    /// Value and gradient evaluations allowed, 1 to [`MAX_POLISH_EVALUATIONS`].
    pub evaluations: usize,
}

/// The largest dimension a polish accepts: it keeps two dense n × n matrices.
pub const MAX_POLISH_DIMENSION: usize = 1000;
/// The largest evaluation budget of one polish.
pub const MAX_POLISH_EVALUATIONS: usize = 1_000_000;
/// The largest number of random starts.
pub const MAX_STARTS: usize = 1_000_000;

/// Why a polish cannot begin.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PolishError {
    /// A count is zero or too large.
    #[error("{name} is {value}; it must lie between 1 and {limit}")]
    Count {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: usize,
        /// The largest value allowed.
        limit: usize,
    },
    /// The tolerance is NaN or outside `[0, 1]`.
    #[error("tolerance is {0}; it must lie in [0, 1]")]
    Tolerance(f64),
    /// Objective and box disagree.
    #[error(
        "the objective has dimension {objective}, the box {bounds}; give one pair of bounds per component"
    )]
    Dimension {
        /// The dimension of the objective.
        objective: usize,
        /// The dimension of the box.
        bounds: usize,
    },
    /// The start is not a point of the box.
    #[error("the start is not in the box: {0}")]
    Start(#[from] BoundsError),
}

impl Default for Polish {
    /// Tolerance 1e-12, 200 evaluations.
    fn default() -> Self {
        Self { tolerance: 1e-12, evaluations: 200 }
    }
}

impl Polish {
    /// Descends from `start` to a stationary point of the box, as far as rounding allows.
    ///
    /// The value of the result exceeds that of the start by rounding at most (16 ε of its magnitude).
    ///
    /// # Errors
    /// Parameters out of range, dimensions that differ, a start outside the box. A start without a
    /// finite value and gradient is not an error but a [`crate::PolishReason::NotFinite`].
    pub fn run(
        &self,
        objective: &(impl Smooth + ?Sized),
        bounds: &Bounds,
        start: &[f64],
    ) -> Result<Polished, PolishError> {
        self.validate(objective.dimension(), bounds)?;
        bounds.check(start)?;
        Ok(Descent::new(self, objective, bounds, start).finish())
    }

    /// Descends from `starts` uniform random points, in parallel, reported by index.
    ///
    /// Start `i` is drawn from ChaCha8 stream `i` of `seed`: it depends neither on the number of
    /// starts nor on the threads.
    ///
    /// # Errors
    /// As [`Polish::run`], and for `starts` 0 or above [`MAX_STARTS`].
    pub fn run_starts(
        &self,
        objective: &(impl Smooth + ?Sized),
        bounds: &Bounds,
        starts: usize,
        seed: u64,
    ) -> Result<Vec<Polished>, PolishError> {
        self.validate_starts(objective.dimension(), bounds, starts)?;
        let descend = |start| self.descend(objective, bounds, start, seed);
        Ok((0..starts).into_par_iter().map(descend).collect())
    }

    /// Descends from one random point: start `start` of [`Polish::run_starts`], whose report it equals bit for bit.
    ///
    /// # Errors
    /// As [`Polish::run_starts`] of `start + 1` starts.
    pub fn run_start(
        &self,
        objective: &(impl Smooth + ?Sized),
        bounds: &Bounds,
        start: usize,
        seed: u64,
    ) -> Result<Polished, PolishError> {
        self.validate_starts(objective.dimension(), bounds, start.saturating_add(1))?;
        Ok(self.descend(objective, bounds, start, seed))
    }

    fn descend(
        &self,
        objective: &(impl Smooth + ?Sized),
        bounds: &Bounds,
        start: usize,
        seed: u64,
    ) -> Polished {
        let mut stream = Source::new(Purpose::Starts, seed, 0).stream(start);
        let point: Vec<f64> = (0..bounds.dimension()).map(|c| bounds.at(c, stream.uniform())).collect();
        Descent::new(self, objective, bounds, &point).finish()
    }

    /// As [`Polish::validate`], for a number of random starts.
    ///
    /// # Errors
    /// The first parameter at fault.
    pub fn validate_starts(
        &self,
        dimension: usize,
        bounds: &Bounds,
        starts: usize,
    ) -> Result<(), PolishError> {
        self.validate(dimension, bounds)?;
        count("starts", starts, MAX_STARTS)
    }

    /// Whether the parameters lie in their ranges and suit the box, without running anything.
    ///
    /// # Errors
    /// The first parameter at fault; `dimension` is the objective's.
    pub fn validate(&self, dimension: usize, bounds: &Bounds) -> Result<(), PolishError> {
        if dimension != bounds.dimension() {
            return Err(PolishError::Dimension { objective: dimension, bounds: bounds.dimension() });
        }
        count("dimension", dimension, MAX_POLISH_DIMENSION)?;
        count("evaluations", self.evaluations, MAX_POLISH_EVALUATIONS)?;
        if !(0.0..=1.0).contains(&self.tolerance) {
            return Err(PolishError::Tolerance(self.tolerance));
        }
        Ok(())
    }
}

fn count(name: &'static str, value: usize, limit: usize) -> Result<(), PolishError> {
    if (1..=limit).contains(&value) { Ok(()) } else { Err(PolishError::Count { name, value, limit }) }
}
