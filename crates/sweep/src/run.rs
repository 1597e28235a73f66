//! Running the cells of a shard.

use std::collections::VecDeque;
use std::io::ErrorKind;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use experiment::{Plan, run_kept};
use plateau::Progress;
use record::{
    Checkpoint, DeliverError, Destination, Manifest, deliver_watched, earlier, own_contents, prepare,
    write_text,
};

use crate::order::Order;
use crate::outline::{OUTLINE_FILE, Outline};

/// Most cells whose faults are told one by one.
const MOST_TOLD: usize = 20;

/// What became of the cells of a shard.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Tally {
    /// Run, and written.
    pub done: usize,
    /// Not run: their results were there already.
    pub kept: usize,
    /// Among both, cells in which a method failed, an expected number was missed or a file could not be made; and those that could
    /// not be kept at all.
    pub unsound: Vec<String>,
    /// Left to other processes, which were at work on them.
    pub elsewhere: Vec<String>,
    /// Not run, because an end was wanted.
    pub left: usize,
}

impl Tally {
    /// Whether every cell of the shard is there and as it should be.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.unsound.is_empty() && self.elsewhere.is_empty() && self.left == 0
    }
}

/// Runs the cells of a shard, each into an ordinary folder of results, written whole or not at all; a cell whose result is there
/// already, of the same experiment, seed and program, is kept. No two processes run the same cell at the same time. A cell that
/// fails takes none of the others with it; `tell` hears why. If `progress` wants an end, the cells at work are given up and what
/// their searches found is kept.
///
/// # Errors
/// [`DeliverError`], if the folder of the sweep cannot be written to: nothing was run.
pub fn run(
    order: &Order<'_>,
    progress: &dyn Progress,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<Tally, DeliverError> {
    outline(order)?;
    let cells: VecDeque<usize> = order.shard.cells(order.sweep.cells()).collect();
    progress.begin(&format!("cells of {}", order.sweep.stem()), Some(cells.len() as u64));
    let work = Work {
        order,
        progress,
        tell,
        folder: order.folder(),
        open: Mutex::new(Open { cells, again: Vec::new(), tally: Tally::default(), told: 0 }),
    };
    // The engine's own threads are others: these wait for them, or work alone on what is too small to share.
    thread::scope(|scope| {
        for _ in 1..order.threads {
            scope.spawn(|| work.all());
        }
        work.all();
    });
    work.once_more();
    progress.end();
    let mut open = work.open.into_inner().unwrap_or_else(PoisonError::into_inner);
    open.tally.unsound.sort();
    if open.told > MOST_TOLD {
        tell(&format!("{} more cells are not as they should be", open.told - MOST_TOLD));
    }
    Ok(open.tally)
}

/// Writes the outline of the sweep, unless it is there: all shards write the same.
fn outline(order: &Order<'_>) -> Result<(), DeliverError> {
    let path = order.folder().join(OUTLINE_FILE);
    let failed = |source| DeliverError { path: path.clone(), source };
    let text = Outline::of(order.sweep, order.options)
        .map_err(|refusal| failed(std::io::Error::other(refusal.to_string())))?
        .to_json()
        .map_err(|error| failed(std::io::Error::other(error)))?;
    if own_contents(&path).is_ok_and(|bytes| bytes == text.as_bytes()) {
        return Ok(());
    }
    write_text(&text, &Destination::own(path))
}

/// The work on a shard, shared by its threads.
struct Work<'a> {
    order: &'a Order<'a>,
    progress: &'a dyn Progress,
    tell: &'a (dyn Fn(&str) + Sync),
    folder: std::path::PathBuf,
    open: Mutex<Open>,
}

struct Open {
    cells: VecDeque<usize>,
    /// Cells that others were at work on.
    again: Vec<usize>,
    tally: Tally,
    /// How many faults there were to tell.
    told: usize,
}

/// What became of a cell.
enum Outcome {
    Done {
        sound: bool,
    },
    Kept {
        sound: bool,
    },
    /// Nothing of it could be kept.
    Lost,
    Elsewhere,
    Interrupted,
}

impl Work<'_> {
    fn lock(&self) -> MutexGuard<'_, Open> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes cells until there are none, or an end is wanted.
    fn all(&self) {
        loop {
            let mut open = self.lock();
            if self.progress.cancelled() {
                open.tally.left += open.cells.len();
                open.cells.clear();
            }
            let Some(index) = open.cells.pop_front() else { return };
            drop(open);
            let outcome = self.cell(index);
            if matches!(outcome, Outcome::Elsewhere) {
                self.lock().again.push(index);
            } else {
                self.count(index, &outcome);
            }
        }
    }

    /// Looks again at the cells that others had.
    fn once_more(&self) {
        let again = std::mem::take(&mut self.lock().again);
        for index in again {
            let outcome = if self.progress.cancelled() { Outcome::Interrupted } else { self.cell(index) };
            self.count(index, &outcome);
        }
    }

    fn count(&self, index: usize, outcome: &Outcome) {
        self.progress.step();
        let name = || self.order.sweep.cell(index).name;
        let tally = &mut self.lock().tally;
        let sound = match outcome {
            Outcome::Done { sound } => {
                tally.done += 1;
                *sound
            }
            Outcome::Kept { sound } => {
                tally.kept += 1;
                *sound
            }
            Outcome::Lost => false,
            Outcome::Elsewhere => {
                tally.elsewhere.push(name());
                true
            }
            Outcome::Interrupted => {
                tally.left += 1;
                true
            }
        };
        if !sound {
            tally.unsound.push(name());
        }
    }

    fn tell(&self, plan: &Plan, what: &str) {
        let told = {
            let mut open = self.lock();
            open.told += 1;
            open.told
        };
        if told <= MOST_TOLD {
            (self.tell)(&format!("{}: {what}", plan.stem));
        }
    }

    fn cell(&self, index: usize) -> Outcome {
        let plan = match self.order.sweep.plan(index) {
            Ok(plan) => plan,
            Err(refusal) => {
                (self.tell)(&refusal.to_string());
                return Outcome::Lost;
            }
        };
        if let Some(kept) = self.kept(&plan) {
            return kept;
        }
        let _claim = match prepare(&plan, &self.folder) {
            Ok(claim) => claim,
            Err(error) if error.source.kind() == ErrorKind::ResourceBusy => return Outcome::Elsewhere,
            Err(error) => {
                self.tell(&plan, &format!("not run, for its result could not be written: {error}"));
                return Outcome::Lost;
            }
        };
        // Another process may have ended it before the claim.
        match self.kept(&plan) {
            Some(kept) => kept,
            None => self.computed(&plan),
        }
    }

    /// The result that is there already.
    fn kept(&self, plan: &Plan) -> Option<Outcome> {
        let earlier = earlier(plan, self.order.options, &self.folder)?;
        let sound = earlier.missed + earlier.failed == 0;
        if !sound {
            let (missed, failed) = (earlier.missed, earlier.failed);
            self.tell(plan, &format!("{missed} expected numbers missed, {failed} methods failed"));
        }
        Some(Outcome::Kept { sound })
    }

    fn computed(&self, plan: &Plan) -> Outcome {
        let Order { options, interval, .. } = *self.order;
        let folder = record::folder(plan, &self.folder);
        let checkpoint = Checkpoint::new(&folder, Manifest::new(plan, options), interval);
        if let Err(error) = checkpoint.load() {
            self.tell(plan, &format!("{} is ignored: {error}", checkpoint.path().display()));
        }
        let watch = Watch(self.progress);
        let finished = match run_kept(plan, options, &watch, &checkpoint) {
            Ok(finished) => finished,
            Err(error) => {
                self.tell(plan, &error.to_string());
                empty(&folder);
                return Outcome::Lost;
            }
        };
        if finished.results.was_interrupted() {
            self.flush(plan, &checkpoint);
            empty(&folder);
            return Outcome::Interrupted;
        }
        let delivered = match deliver_watched(plan, &finished, &self.folder, &watch) {
            Ok(delivered) => delivered,
            Err(error) => {
                self.tell(plan, &format!("the result cannot be written: {error}"));
                // It is all there is of the work now.
                self.flush(plan, &checkpoint);
                return Outcome::Lost;
            }
        };
        if self.progress.cancelled() && !delivered.record.unwritten().is_empty() {
            self.flush(plan, &checkpoint);
            return Outcome::Interrupted;
        }
        if let Err(error) = checkpoint.remove() {
            self.tell(
                plan,
                &format!(
                    "{} is not needed any more and could not be removed: {error}",
                    checkpoint.path().display()
                ),
            );
        }
        for refusal in &delivered.refusals {
            self.tell(plan, &refusal.to_string());
        }
        let missed = finished.missed().len();
        let failed = finished.results.failures().count();
        if missed + failed > 0 {
            self.tell(plan, &format!("{missed} expected numbers missed, {failed} methods failed"));
        }
        Outcome::Done { sound: missed + failed == 0 && delivered.refusals.is_empty() }
    }

    /// Keeps the runs of searches that have ended.
    fn flush(&self, plan: &Plan, checkpoint: &Checkpoint) {
        if let Err(error) = checkpoint.flush() {
            self.tell(plan, &format!("finished search runs could not be kept: {error}"));
        }
    }
}

/// Removes a folder if there is nothing in it.
fn empty(folder: &Path) {
    let _ = std::fs::remove_dir(folder);
}

/// The bar is that of the cells; from inside of one only the wish to end is passed on.
struct Watch<'a>(&'a dyn Progress);

impl Progress for Watch<'_> {
    fn begin(&self, _: &str, _: Option<u64>) {}

    fn step(&self) {}

    fn end(&self) {}

    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
