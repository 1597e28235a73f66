//! Watching a search, and ending it early.

use std::ops::ControlFlow;

/// What an [`Observer`] sees: the state of one run after an iteration.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Progress<'a> {
    /// Index of the run within its search.
    pub run: usize,
    /// Iterations done; 0 after the initialisation.
    pub iteration: usize,
    /// Iterations allowed.
    pub iterations: usize,
    /// Best value so far, `+∞` while nothing finite was found.
    pub best_value: f64,
    /// Where the best value lies; `None` while nothing finite was found.
    pub best_point: Option<&'a [f64]>,
    /// Objective evaluations of this run so far.
    pub evaluations: u64,
    /// How many of them were NaN.
    pub nan_evaluations: u64,
}

/// Called once per iteration of every run, iteration 0 (the initialisation) included.
///
/// Runs of one search are parallel, hence `&self` and `Sync`: keep state in atomics or behind a
/// lock. [`ControlFlow::Break`] ends the run that was shown, with the result so far; to end a whole
/// search, break every run. What an observer sees of one run does not depend on the threads, the
/// order in which it sees different runs does. Implemented for closures
/// `Fn(&Progress) -> ControlFlow<()>` and for `()`, which looks away.
pub trait Observer: Sync {
    /// Looks at the state after an iteration.
    fn observe(&self, progress: &Progress<'_>) -> ControlFlow<()>;
}

impl<F: Fn(&Progress<'_>) -> ControlFlow<()> + Sync> Observer for F {
    fn observe(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        self(progress)
    }
}

impl Observer for () {
    fn observe(&self, _: &Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
