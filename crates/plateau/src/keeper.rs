use crate::SearchRun;

/// Where runs of searches that have ended are kept, so that work that was interrupted can go on. All methods may be called
/// from several threads.
///
/// A run that is given back must be the one that was kept, bit for bit: then a result does not depend on what was kept. Its value
/// is computed again before it is believed.
pub trait Keeper: Sync {
    /// Run number `run` of the search of method number `method`, if it was kept.
    fn run(&self, method: usize, run: usize) -> Option<SearchRun>;
    /// The run that was given back is not one that this search can have made: it is run again.
    fn refuse(&self, _method: usize, _run: usize) {}
    /// A run has ended.
    fn keep(&self, method: usize, run: &SearchRun);
    /// An iteration of some run has ended: called often, to be cheap.
    fn tick(&self) {}
    /// All runs of a search have ended.
    fn search_ended(&self) {}
}

/// Nothing is kept.
impl Keeper for () {
    fn run(&self, _: usize, _: usize) -> Option<SearchRun> {
        None
    }
    fn keep(&self, _: usize, _: &SearchRun) {}
}
