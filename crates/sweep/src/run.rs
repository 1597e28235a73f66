//! Running the cells of a shard.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use experiment::{Finished, Plan};
use plateau::Progress;
use record::{
    DeliverError, Destination, Interruption, Keeping, Kept, Listener, Remark, own_contents, run_and_keep,
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
        let Order { options, interval, .. } = *self.order;
        let keeping = Keeping { options, out: &self.folder, interval, resume: true };
        let kept =
            run_and_keep(&plan, &keeping, &Watch(self.progress), &mut Remarks { work: self, plan: &plan });
        match kept {
            Kept::Earlier(earlier) => Outcome::Kept { sound: self.meets(&plan, earlier.shortfall()) },
            Kept::Interrupted(interruption) => {
                if let Interruption::Searching(_, Some(error)) = interruption {
                    self.tell(&plan, &format!("finished search runs could not be kept: {error}"));
                }
                Outcome::Interrupted
            }
            Kept::Lost(loss) if loss.is_elsewhere() => Outcome::Elsewhere,
            Kept::Lost(loss) => {
                self.tell(&plan, &loss.to_string());
                Outcome::Lost
            }
            Kept::Done(done) => {
                let (finished, delivered) = *done;
                for refusal in &delivered.refusals {
                    self.tell(&plan, &refusal.to_string());
                }
                let sound = self.meets(&plan, finished.shortfall()) && delivered.refusals.is_empty();
                Outcome::Done { sound }
            }
        }
    }

    /// Whether nothing is short of what a cell expects; what is, is told.
    fn meets(&self, plan: &Plan, shortfall: Option<String>) -> bool {
        if let Some(shortfall) = &shortfall {
            self.tell(plan, shortfall);
        }
        shortfall.is_none()
    }
}

/// Passes on what is amiss with a cell; its figures are read where its folder is merged.
struct Remarks<'a> {
    work: &'a Work<'a>,
    plan: &'a Plan,
}

impl Listener for Remarks<'_> {
    fn finished(&mut self, _: &Finished) {}

    fn remark(&mut self, remark: &Remark) {
        if remark.is_warning() {
            self.work.tell(self.plan, &remark.to_string());
        }
    }
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
