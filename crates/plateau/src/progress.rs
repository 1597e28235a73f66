/// What a caller may watch while experiments run. All methods may be called from several threads.
pub trait Progress: Sync {
    /// Work begins, of `steps` steps if that is known beforehand.
    fn begin(&self, what: &str, steps: Option<u64>);
    /// One more step is done.
    fn step(&self);
    /// How far the work has come, in a few words: what stands in for an estimate where the steps are not known.
    fn tell(&self, _state: &str) {}
    /// The work begun last is over.
    fn end(&self);
    /// Whether the work should end as soon as it can, keeping what is done.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Nobody watches.
impl Progress for () {
    fn begin(&self, _: &str, _: Option<u64>) {}
    fn step(&self) {}
    fn end(&self) {}
}
