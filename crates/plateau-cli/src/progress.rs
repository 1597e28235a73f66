/// What a caller may watch while experiments run. All methods may be called from several threads.
pub trait Progress: Sync {
    /// Work of `steps` steps begins.
    fn begin(&self, what: &str, steps: u64);
    /// One more step is done.
    fn step(&self);
    /// The work begun last is over.
    fn end(&self);
    /// Whether the work should end as soon as it can, keeping what is done.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Nobody watches.
impl Progress for () {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self) {}
    fn end(&self) {}
}
