//! What is minimised: values in batches for the swarm, value and gradient together for the polish.

/// A function to minimise, evaluated at many points at once.
///
/// A value may be NaN ("no value here") or `+∞` ("worst of all"); the search counts the former and
/// lets both lose to every finite value. The value of a point must not depend on the other points
/// of its batch nor on the thread that asks: this is what makes a search repeatable bit for bit.
pub trait Objective: Sync {
    /// Number of components of a point.
    fn dimension(&self) -> usize;

    /// Fills `values[i]` with the value at point `i`.
    ///
    /// `points` holds `values.len()` points, row-major, `dimension()` numbers each.
    fn evaluate(&self, points: &[f64], values: &mut [f64]);

    /// The value at one point: a batch of one.
    fn value(&self, point: &[f64]) -> f64 {
        let mut value = [f64::NAN];
        self.evaluate(point, &mut value);
        value[0]
    }
}

impl<O: Objective + ?Sized> Objective for &O {
    fn dimension(&self) -> usize {
        (**self).dimension()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        (**self).evaluate(points, values);
    }
}

/// A differentiable function to minimise, value and gradient in one call.
pub trait Smooth: Sync {
    /// Number of components of a point.
    fn dimension(&self) -> usize;

    /// The value at `point`; `gradient` is filled with the exact gradient there.
    ///
    /// Both slices hold `dimension()` numbers.
    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64;
}

impl<S: Smooth + ?Sized> Smooth for &S {
    fn dimension(&self) -> usize {
        (**self).dimension()
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        (**self).value_and_gradient(point, gradient)
    }
}

/// A closure `|x: &[f64]| -> f64` as an [`Objective`].
#[derive(Clone, Copy, Debug)]
pub struct FnObjective<F> {
    dimension: usize,
    function: F,
}

impl<F: Fn(&[f64]) -> f64 + Sync> FnObjective<F> {
    /// `function(point) -> value` on points of `dimension` components.
    pub const fn new(dimension: usize, function: F) -> Self {
        Self { dimension, function }
    }
}

impl<F: Fn(&[f64]) -> f64 + Sync> Objective for FnObjective<F> {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (point, value) in points.chunks_exact(self.dimension).zip(values) {
            *value = (self.function)(point);
        }
    }
}

/// A closure `|x: &[f64], gradient: &mut [f64]| -> f64` as a [`Smooth`] objective.
#[derive(Clone, Copy, Debug)]
pub struct FnSmooth<F> {
    dimension: usize,
    function: F,
}

impl<F: Fn(&[f64], &mut [f64]) -> f64 + Sync> FnSmooth<F> {
    /// `function(point, gradient) -> value` on points of `dimension` components.
    pub const fn new(dimension: usize, function: F) -> Self {
        Self { dimension, function }
    }
}

impl<F: Fn(&[f64], &mut [f64]) -> f64 + Sync> Smooth for FnSmooth<F> {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        (self.function)(point, gradient)
    }
}
