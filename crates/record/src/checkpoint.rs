//! The finished runs of searches, kept on disk while an experiment lasts.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::manifest::sha256;
use crate::{Manifest, atomic};
use plateau::{Keeper, SearchRun};

mod record;

use record::RunRecord;

/// The name of the file in the folder of an experiment.
pub const CHECKPOINT_FILE: &str = "checkpoint";

/// The version of the layout.
const SCHEMA: &str = "plateau-checkpoint/2";

/// Largest size in bytes of a checkpoint that is read.
const LARGEST_FILE: u64 = 1 << 30;

/// Writing takes at most this share of the time: large checkpoints are written less often than the interval says.
const SHARE_OF_TIME: u32 = 20;

/// The finished runs of an experiment's searches, and the file they are kept in.
///
/// The file is written, whole or not at all, once a run has ended and `interval` has passed since it was written last, or
/// since the experiment began: short searches never write. Once there is a file, written or loaded, it is completed when a
/// search ends. It belongs to one manifest; a run taken from it has the bits it was stored with.
#[derive(Debug)]
pub struct Checkpoint {
    path: PathBuf,
    manifest: Manifest,
    interval: Duration,
    unwritten: AtomicBool,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    /// By index of the method and of the run.
    runs: BTreeMap<(usize, usize), SearchRun>,
    due: Instant,
    /// Whether there is a file of this experiment, with some of the runs or all.
    written: bool,
    problem: Option<io::Error>,
    /// How many runs of the file were not believed.
    refused: usize,
}

/// Why a checkpoint is not used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The file system.
    #[error("it cannot be read: {0}")]
    Io(#[from] io::Error),
    /// Cut off, changed, or something else altogether.
    #[error("it is damaged: {0}")]
    Damaged(String),
    /// Another experiment, seed or program.
    #[error("it was written with another {}", .0.join(", "))]
    Foreign(Vec<&'static str>),
}

#[derive(Serialize, Deserialize)]
struct Record {
    schema: String,
    manifest: Manifest,
    runs: Vec<RunRecord>,
}

impl Checkpoint {
    /// A checkpoint in `folder`, with no runs; what is on disk is left alone until the first write.
    pub fn new(folder: &Path, manifest: Manifest, interval: Duration) -> Self {
        let state = State {
            runs: BTreeMap::new(),
            due: Instant::now() + interval,
            written: false,
            problem: None,
            refused: 0,
        };
        Self {
            path: folder.join(CHECKPOINT_FILE),
            manifest,
            interval,
            unwritten: AtomicBool::new(false),
            state: Mutex::new(state),
        }
    }

    /// Takes the runs of the file, if there is one; how many they are.
    ///
    /// # Errors
    /// [`CheckpointError`]; the checkpoint then has no runs.
    pub fn load(&self) -> Result<usize, CheckpointError> {
        match fs::symlink_metadata(&self.path) {
            Ok(found) if found.is_file() => {}
            Ok(_) => return Err(CheckpointError::Damaged("it is not a regular file".into())),
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(0),
            Err(error) => return Err(error.into()),
        }
        let mut bytes = Vec::new();
        fs::File::open(&self.path)?.take(LARGEST_FILE).read_to_end(&mut bytes)?;
        let record = parse(&bytes).map_err(CheckpointError::Damaged)?;
        let differences = record.manifest.differences(&self.manifest);
        if !differences.is_empty() {
            return Err(CheckpointError::Foreign(differences));
        }
        let runs: Option<BTreeMap<_, _>> = record.runs.iter().map(RunRecord::run).collect();
        let runs = runs.ok_or_else(|| {
            CheckpointError::Damaged("it holds a run that this program cannot have made".into())
        })?;
        let count = runs.len();
        let mut state = self.lock();
        (state.runs, state.written) = (runs, true);
        Ok(count)
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many finished runs there are.
    pub fn runs(&self) -> usize {
        self.lock().runs.len()
    }

    /// Writes the file now, if there are runs that are not in it.
    ///
    /// # Errors
    /// What the file system says; the old file is then untouched.
    pub fn flush(&self) -> io::Result<()> {
        if self.unwritten.load(Ordering::Relaxed) { self.write(&mut self.lock()) } else { Ok(()) }
    }

    /// Why the file could not be written, if it could not: the experiment goes on without.
    pub fn problem(&self) -> Option<String> {
        self.lock().problem.as_ref().map(ToString::to_string)
    }

    /// How many runs of the file are not what the searches find, and were run again.
    pub fn refused(&self) -> usize {
        self.lock().refused
    }

    /// Removes the file, if there is one: the experiment is done. What is no regular file was put there by others and stays.
    ///
    /// # Errors
    /// What the file system says.
    pub fn remove(&self) -> io::Result<()> {
        if atomic::regular(&self.path).is_none() {
            return Ok(());
        }
        match fs::remove_file(&self.path) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        }
    }

    fn write_if_due(&self, state: &mut State) {
        if self.unwritten.load(Ordering::Relaxed) && Instant::now() >= state.due {
            state.problem = self.write(state).err();
        }
    }

    fn write(&self, state: &mut State) -> io::Result<()> {
        let start = Instant::now();
        let runs = state.runs.iter().map(|(&(method, _), run)| RunRecord::new(method, run)).collect();
        let record = Record { schema: SCHEMA.to_owned(), manifest: self.manifest.clone(), runs };
        let outcome = serde_json::to_string(&record).map_err(io::Error::other).and_then(|body| {
            let hash = sha256(&body);
            atomic::write(&self.path, |out| write!(out, "{hash}\n{body}\n"))
        });
        let end = Instant::now();
        state.due = end + self.interval.max(SHARE_OF_TIME * (end - start));
        if outcome.is_ok() {
            self.unwritten.store(false, Ordering::Relaxed);
            state.written = true;
        }
        outcome
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // A panic elsewhere leaves whole runs behind.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Keeper for Checkpoint {
    fn run(&self, method: usize, run: usize) -> Option<SearchRun> {
        self.lock().runs.get(&(method, run)).cloned()
    }

    fn refuse(&self, method: usize, run: usize) {
        let mut state = self.lock();
        state.runs.remove(&(method, run));
        state.refused += 1;
    }

    fn keep(&self, method: usize, run: &SearchRun) {
        let mut state = self.lock();
        state.runs.insert((method, run.index()), run.clone());
        self.unwritten.store(true, Ordering::Relaxed);
        self.write_if_due(&mut state);
    }

    /// Writes the file if that is due.
    fn tick(&self) {
        if !self.unwritten.load(Ordering::Relaxed) {
            return;
        }
        // Whoever holds the lock writes if that is due.
        if let Ok(mut state) = self.state.try_lock() {
            self.write_if_due(&mut state);
        }
    }

    /// It may be long until the next iteration of another search: where there is a file already, it is completed at once.
    fn search_ended(&self) {
        let mut state = self.lock();
        if self.unwritten.load(Ordering::Relaxed) && state.written {
            state.due = Instant::now();
        }
        self.write_if_due(&mut state);
    }
}

/// The first line holds the hash of the second: nothing of a damaged file is believed.
fn parse(bytes: &[u8]) -> Result<Record, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "it is not text")?;
    let (hash, body) = text.split_once('\n').ok_or("it is cut off")?;
    let body = body.strip_suffix('\n').ok_or("it is cut off")?;
    if sha256(body) != hash {
        return Err("its hash is not the one it states".into());
    }
    let record: Record = serde_json::from_str(body).map_err(|error| error.to_string())?;
    if record.schema == SCHEMA { Ok(record) } else { Err(format!("its layout is {:?}", record.schema)) }
}
