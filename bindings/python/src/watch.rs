//! Computations that Python may interrupt and other threads of Python do not wait for.

use std::panic::resume_unwind;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use plateau::Progress;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::ThreadPool;

/// How often Python is asked for signals, and told of progress.
const TICK: Duration = Duration::from_millis(50);

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
/// raises ends the work, too.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    told: Option<&Py<PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> PyResult<T> {
    let pool = pool()?;
    let watch = Watch::default();
    py.detach(|| {
        thread::scope(|scope| {
            let (ended, ends) = mpsc::channel::<()>();
            let worker = scope.spawn(|| {
                let found = pool.install(|| work(&watch));
                drop(ended);
                found
            });
            let mut raised = None;
            while ends.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                if raised.is_none()
                    && let Err(error) = Python::attach(|py| tick(py, &watch, told))
                {
                    watch.cancelled.store(true, Ordering::Relaxed);
                    raised = Some(error);
                }
            }
            let found = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            raised.map_or(Ok(found), Err)
        })
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

/// The threads that compute: of this process, for those of another do not live on in its forks.
fn pool() -> PyResult<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    match &*pool {
        Some((process, pool)) if *process == process::id() => Ok(pool.clone()),
        Some(_) | None => {
            let made = rayon::ThreadPoolBuilder::new().build();
            let made = Arc::new(made.map_err(|error| PyRuntimeError::new_err(error.to_string()))?);
            if let Some((_, other)) = pool.replace((process::id(), made.clone())) {
                // To end threads that are not there would wait for ever.
                std::mem::forget(other);
            }
            Ok(made)
        }
    }
}
