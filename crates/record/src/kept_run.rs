//! An experiment run and kept: its whole life, from its folder made ready to the last file in it.

use std::fmt;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::Duration;

use experiment::{Finished, Options, Plan, run_kept};
use plateau::{MethodError, Progress, counted};
use thiserror::Error;

use crate::{
    Checkpoint, CheckpointError, DeliverError, Delivered, Earlier, ExportError, Manifest, deliver_watched,
    earlier, folder, prepare,
};

/// How an experiment is run, and where what comes of it is kept.
#[derive(Clone, Copy, Debug)]
pub struct Keeping<'a> {
    /// Seed and arithmetic instead of the file's own.
    pub options: Options,
    /// The folder below which that of the experiment lies.
    pub out: &'a Path,
    /// The least time between two checkpoints of the searches.
    pub interval: Duration,
    /// Whether a whole result that is there already is kept instead of being computed again, and what an interrupted run left is
    /// taken up.
    pub resume: bool,
}

/// Who hears of an experiment while it is run and kept.
pub trait Listener {
    /// All methods have ended; the files are written after this.
    fn finished(&mut self, finished: &Finished);

    /// Something on the way that a person wants to know.
    fn remark(&mut self, remark: &Remark);
}

/// Something on the way. The sentence begins with the file that it is about and does not name the experiment.
#[derive(Debug)]
#[non_exhaustive]
pub enum Remark {
    /// Runs of searches were taken from what an interrupted run left: how many, and the file.
    Taken(usize, PathBuf),
    /// What an interrupted run left cannot be used.
    Ignored(PathBuf, CheckpointError),
    /// What an interrupted run left is not what the search finds: so many runs are run again.
    RunAgain(usize, PathBuf),
    /// Finished runs could not be kept.
    Unkept(PathBuf, String),
    /// What is needed no more could not be removed.
    Unremoved(PathBuf, io::Error),
}

impl Remark {
    /// Whether something is amiss.
    #[must_use]
    pub fn is_warning(&self) -> bool {
        match self {
            Self::Taken(..) => false,
            Self::Ignored(..) | Self::RunAgain(..) | Self::Unkept(..) | Self::Unremoved(..) => true,
        }
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Taken(count, path) => write!(f, "{} taken from {}", runs(*count), path.display()),
            Self::Ignored(path, error) => write!(f, "{} is ignored: {error}", path.display()),
            Self::RunAgain(count, path) => {
                write!(f, "{}: not what the search finds, so run again: {}", path.display(), runs(*count))
            }
            Self::Unkept(path, why) => {
                write!(f, "{}: finished runs could not be kept: {why}", path.display())
            }
            Self::Unremoved(path, error) => {
                write!(f, "{} is not needed any more and could not be removed: {error}", path.display())
            }
        }
    }
}

/// What became of an experiment.
#[derive(Debug)]
pub enum Kept {
    /// Its result was there already.
    Earlier(Earlier),
    /// Run, and written.
    Done(Box<(Finished, Delivered)>),
    /// Not finished, because an end was wanted.
    Interrupted(Interruption),
    /// Nothing of it could be kept.
    Lost(Loss),
}

/// What is kept of an experiment that was interrupted.
#[derive(Debug)]
#[non_exhaustive]
pub enum Interruption {
    /// In its searches: so many runs had ended; why they could not be kept, if they could not.
    Searching(usize, Option<io::Error>),
    /// Among its files: `result.json` is written in this folder, so many others are not.
    Writing(PathBuf, usize),
}

impl Interruption {
    /// What is kept of the experiment in `file`, as the end of a sentence; nothing if nothing is.
    #[must_use]
    pub fn told(&self, file: &str) -> String {
        match self {
            Self::Searching(0, _) => String::new(),
            Self::Searching(count, None) => format!(", {} of {file} kept", runs(*count)),
            Self::Searching(count, Some(error)) => {
                format!(", {} of {file} could not be kept: {error}", runs(*count))
            }
            Self::Writing(folder, missing) => {
                let are = if *missing == 1 { "is" } else { "are" };
                let files = counted(*missing, "file");
                format!("; {}/result.json is written, {files} {are} not", folder.display())
            }
        }
    }
}

/// Why nothing of an experiment is kept.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Loss {
    /// Its folder cannot be made ready; it was not run.
    #[error("not run, for its result could not be written: {0}")]
    Unprepared(#[source] DeliverError),
    /// None of its methods could be run.
    #[error(transparent)]
    Unrun(MethodError),
    /// What was found could not be written; finished runs of searches are kept, if those could be.
    #[error("the result cannot be written: {0}")]
    Unwritten(#[source] DeliverError),
}

impl Loss {
    /// Whether another process is at work in the same folder.
    #[must_use]
    pub fn is_elsewhere(&self) -> bool {
        matches!(self, Self::Unprepared(error) if error.source.kind() == ErrorKind::ResourceBusy)
    }
}

/// Runs an experiment and keeps what comes of it. Its folder is made ready and claimed before anything is computed, the runs of its
/// searches are kept while they end, and a folder is replaced only by a whole experiment. If `progress` wants an end, it ends after
/// the step at work.
pub fn run_and_keep(
    plan: &Plan,
    keeping: &Keeping<'_>,
    progress: &dyn Progress,
    listener: &mut dyn Listener,
) -> Kept {
    let there = || keeping.resume.then(|| earlier(plan, keeping.options, keeping.out)).flatten();
    let claim = match prepare(plan, keeping.out) {
        Ok(claim) => claim,
        // What is there can be read where nothing can be written, and while others write beside it.
        Err(error) => return there().map_or(Kept::Lost(Loss::Unprepared(error)), Kept::Earlier),
    };
    let manifest = Manifest::new(plan, keeping.options);
    let checkpoint = Checkpoint::new(&folder(plan, keeping.out), manifest, keeping.interval);
    let kept = match there() {
        Some(earlier) => {
            forget(&checkpoint, listener);
            Kept::Earlier(earlier)
        }
        None => computed(plan, keeping, &checkpoint, progress, listener),
    };
    drop(claim);
    kept
}

/// An experiment whose folder is ready.
fn computed(
    plan: &Plan,
    keeping: &Keeping<'_>,
    checkpoint: &Checkpoint,
    progress: &dyn Progress,
    listener: &mut dyn Listener,
) -> Kept {
    let folder = folder(plan, keeping.out);
    let path = || checkpoint.path().to_owned();
    if keeping.resume {
        match checkpoint.load() {
            Ok(0) => {}
            Ok(runs) => listener.remark(&Remark::Taken(runs, path())),
            Err(error) => listener.remark(&Remark::Ignored(path(), error)),
        }
    }
    let finished = match run_kept(plan, keeping.options, progress, checkpoint) {
        Ok(finished) => finished,
        Err(error) => {
            remove_empty(&folder);
            return Kept::Lost(Loss::Unrun(error));
        }
    };
    if let refused @ 1.. = checkpoint.refused() {
        listener.remark(&Remark::RunAgain(refused, path()));
    }
    if finished.results.was_interrupted() {
        let interruption = Interruption::Searching(checkpoint.runs(), checkpoint.flush().err());
        remove_empty(&folder);
        return Kept::Interrupted(interruption);
    }
    if let Some(problem) = checkpoint.problem() {
        listener.remark(&Remark::Unkept(path(), problem));
    }
    listener.finished(&finished);
    written(plan, keeping, finished, checkpoint, progress, listener)
}

/// What was found, as files.
fn written(
    plan: &Plan,
    keeping: &Keeping<'_>,
    finished: Finished,
    checkpoint: &Checkpoint,
    progress: &dyn Progress,
    listener: &mut dyn Listener,
) -> Kept {
    progress.begin(&format!("files of {}", plan.stem), None);
    let delivered = deliver_watched(plan, &finished, keeping.out, progress);
    progress.end();
    match delivered {
        Ok(delivered) => {
            let missing = delivered.record.unwritten().len();
            if progress.cancelled() && missing > 0 {
                // The search need not be repeated for the files that are missing.
                flush(checkpoint, listener);
                return Kept::Interrupted(Interruption::Writing(delivered.folder, missing));
            }
            if delivered.refusals.iter().any(|why| matches!(why, ExportError::Failed(_))) {
                // Nor for those that another attempt may write.
                flush(checkpoint, listener);
            } else {
                forget(checkpoint, listener);
            }
            Kept::Done(Box::new((finished, delivered)))
        }
        Err(error) => {
            // It is all there is of the work now.
            flush(checkpoint, listener);
            Kept::Lost(Loss::Unwritten(error))
        }
    }
}

/// Keeps the runs of searches that have ended.
fn flush(checkpoint: &Checkpoint, listener: &mut dyn Listener) {
    if let Err(error) = checkpoint.flush() {
        listener.remark(&Remark::Unkept(checkpoint.path().to_owned(), error.to_string()));
    }
}

/// Removes the checkpoint of an experiment that is done.
fn forget(checkpoint: &Checkpoint, listener: &mut dyn Listener) {
    if let Err(error) = checkpoint.remove() {
        listener.remark(&Remark::Unremoved(checkpoint.path().to_owned(), error));
    }
}

/// Removes a folder if there is nothing in it.
fn remove_empty(folder: &Path) {
    let _ = std::fs::remove_dir(folder);
}

fn runs(count: usize) -> String {
    counted(count, "finished search run")
}
