//! What is to be run, and how.

use std::path::{Path, PathBuf};
use std::time::Duration;

use experiment::{Options, Sweep};
use record::folder_of;

use crate::shard::Shard;

/// The cells of a shard, to be run into the folder of their sweep.
#[derive(Clone, Copy, Debug)]
pub struct Order<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// The cells of it that are run.
    pub shard: Shard,
    /// Seed and arithmetic instead of the file's own.
    pub options: Options,
    /// Cells that are run at the same time, at least one. Results do not depend on it.
    pub threads: usize,
    /// The least time between two checkpoints of the searches of a cell.
    pub interval: Duration,
    /// The folder below which that of the sweep lies.
    pub out: &'a Path,
}

impl<'a> Order<'a> {
    /// The shard of a sweep, its results below `out`; one cell after the other.
    #[must_use]
    pub fn new(sweep: &'a Sweep, shard: Shard, out: &'a Path) -> Self {
        let (options, interval) = (Options::default(), Duration::from_secs(1));
        Self { sweep, shard, options, threads: 1, interval, out }
    }

    /// The folder of the sweep, in which every cell has one.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        folder_of(&self.sweep.stem(), self.out)
    }
}
