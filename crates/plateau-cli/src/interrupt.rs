//! Ctrl-C, and being asked to end by the system.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::terminal::say;

/// Signals within this time are one wish to end: a terminal that is closed sends several.
const ONE_WISH: Duration = Duration::from_millis(500);

/// Since when an end is wanted: the work at hand ends as soon as it can.
static INTERRUPTED: OnceLock<Instant> = OnceLock::new();

/// Whether a file is being read: a pipe may never end, and nothing is lost by leaving it.
static READING: AtomicBool = AtomicBool::new(false);

/// Reads something that may take for ever: an end that is wanted meanwhile comes at once.
pub(crate) fn reading<T>(read: impl FnOnce() -> T) -> T {
    READING.store(true, Ordering::SeqCst);
    if interrupted() {
        std::process::exit(130);
    }
    let read = read();
    READING.store(false, Ordering::SeqCst);
    read
}

/// Whether the user wants an end.
pub(crate) fn interrupted() -> bool {
    INTERRUPTED.get().is_some()
}

/// First Ctrl-C, or SIGTERM or SIGHUP: end cleanly. Second: end at once.
pub(crate) fn listen() {
    // Whoever ignores hangups (`nohup`) goes on when the terminal is closed; the listener would hear them nevertheless.
    if ignores_hangups() {
        hold_hangups();
    }
    let handler = ctrlc::set_handler(|| {
        if INTERRUPTED.get_or_init(Instant::now).elapsed() > ONE_WISH || READING.load(Ordering::SeqCst) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        say(&format!("warning: Ctrl-C will end the program at once: {error}"));
    }
}

/// Whether the program was started to outlive its terminal, where the system says so.
fn ignores_hangups() -> bool {
    const HANGUP: u64 = 1;
    let ignored = || {
        let status = std::fs::read_to_string("/proc/self/status").ok()?;
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
        u64::from_str_radix(mask.trim(), 16).ok()
    };
    cfg!(target_os = "linux") && ignored().is_some_and(|ignored| ignored & HANGUP != 0)
}

/// Lets hangups reach no thread: this one has them held back, and hands that on to all that it begins.
#[cfg(unix)]
fn hold_hangups() {
    use nix::sys::signal::{SigSet, Signal};
    let mut hangup = SigSet::empty();
    hangup.add(Signal::SIGHUP);
    if let Err(error) = hangup.thread_block() {
        say(&format!("warning: the run will end when its terminal is closed: {error}"));
    }
}

#[cfg(not(unix))]
fn hold_hangups() {}
