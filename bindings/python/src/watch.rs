//! Computations that Python may interrupt and other threads of Python do not wait for.

use std::panic::resume_unwind;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use plateau::Progress;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::ThreadPool;

/// How often Python is asked for signals, and told of progress.
const TICK: Duration = Duration::from_millis(50);

/// How long work that was asked to end is waited for. It looks at its flag after steps, which may take longer.
const GRACE: Duration = Duration::from_millis(400);

/// How far a computation has come, and whether it should end.
#[derive(Default)]
struct Watch {
    cancelled: AtomicBool,
    state: Mutex<Vec<Work>>,
}

/// Work that has begun.
#[derive(Clone)]
struct Work {
    what: String,
    done: u64,
    of: Option<u64>,
}

impl Watch {
    fn change(&self, change: impl FnOnce(&mut Vec<Work>)) {
        change(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner));
    }
}

impl Progress for Watch {
    fn begin(&self, what: &str, steps: Option<u64>) {
        self.change(|state| state.push(Work { what: what.to_owned(), done: 0, of: steps }));
    }

    fn step(&self) {
        self.change(|state| state.iter_mut().next_back().into_iter().for_each(|work| work.done += 1));
    }

    fn end(&self) {
        self.change(|state| drop(state.pop()));
    }

    fn cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

/// What `work` gives, computed by threads of its own while this one, which Python's signals arrive at, looks out for them. They
/// end the work, and are raised. `told`, if given, is called with (what, steps done, of how many) as the work goes on; what it
/// raises ends the work, too. Work that does not end soon is left to end by itself, which is why it owns what it needs: nobody
/// waits for it, and later work has threads of its own.
pub(crate) fn watched<T: Send + 'static>(
    py: Python<'_>,
    told: Option<&Py<PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send + 'static,
) -> PyResult<T> {
    watched_for(py, told, GRACE, work)
}

/// As [`watched`], for work that leaves something half done if the process ends before it: it is waited for.
pub(crate) fn watched_to_its_end<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Progress) -> T + Send + 'static,
) -> PyResult<T> {
    watched_for(py, None, Duration::MAX, work)
}

fn watched_for<T: Send + 'static>(
    py: Python<'_>,
    told: Option<&Py<PyAny>>,
    grace: Duration,
    work: impl FnOnce(&dyn Progress) -> T + Send + 'static,
) -> PyResult<T> {
    let watch = Arc::new(Watch::default());
    // Not all that takes its time says what it is.
    watch.begin("working", None);
    let (ended, ends) = mpsc::channel::<()>();
    let worker = {
        let (pool, watch) = (pool()?, watch.clone());
        let work = move || {
            let found = pool.install(|| work(&*watch));
            drop(ended);
            found
        };
        thread::Builder::new().spawn(work).map_err(|error| no_threads(&error))?
    };
    py.detach(move || {
        let mut raised: Option<(PyErr, Instant)> = None;
        while ends.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
            match &raised {
                None => {
                    if let Err(error) = Python::attach(|py| tick(py, &watch, told)) {
                        watch.cancelled.store(true, Ordering::Relaxed);
                        raised = Some((error, Instant::now()));
                    }
                }
                Some((_, since)) if since.elapsed() > grace => {
                    leave_pool();
                    break;
                }
                Some(_) => {}
            }
        }
        match raised {
            Some((error, _)) => Err(error),
            None => Ok(worker.join().unwrap_or_else(|panic| resume_unwind(panic))),
        }
    })
}

/// Lets Python see to its signals, and tells what is being done.
fn tick(py: Python<'_>, watch: &Watch, told: Option<&Py<PyAny>>) -> PyResult<()> {
    py.check_signals()?;
    let Some(told) = told else { return Ok(()) };
    let mut work = None;
    watch.change(|state| work = state.last().cloned());
    match work {
        Some(Work { what, done, of }) => told.call1(py, (what, done, of)).map(drop),
        None => Ok(()),
    }
}

/// The threads that compute, and the process they belong to: those of another do not live on in its forks.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

fn pool() -> PyResult<Arc<ThreadPool>> {
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    match &*pool {
        Some((process, pool)) if *process == process::id() => Ok(pool.clone()),
        Some(_) | None => {
            let made = Arc::new(rayon::ThreadPoolBuilder::new().build().map_err(|error| no_threads(&error))?);
            if let Some((_, other)) = pool.replace((process::id(), made.clone())) {
                // To end threads that are not there would wait for ever.
                std::mem::forget(other);
            }
            Ok(made)
        }
    }
}

/// Leaves the threads to the work they are at; they end with it.
fn leave_pool() {
    drop(POOL.lock().unwrap_or_else(PoisonError::into_inner).take());
}

fn no_threads(error: &dyn std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(format!("the system gives no more threads: {error}"))
}
