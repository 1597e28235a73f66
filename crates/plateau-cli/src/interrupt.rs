//! Ctrl-C, and being asked to end by the system.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

#[cfg(unix)]
use nix::sys::signal::Signal;

use crate::terminal::say;

/// Signals within this time are one wish to end: a terminal that is closed sends several.
const ONE_WISH: Duration = Duration::from_millis(500);

/// Since when an end is wanted: the work at hand ends as soon as it can.
static INTERRUPTED: OnceLock<Instant> = OnceLock::new();

/// Whether another process is waited for: the writer or the reader of a pipe may never come, and nothing is lost by leaving it.
static WAITING: AtomicBool = AtomicBool::new(false);

/// Reads or writes something that may take for ever: an end that is wanted meanwhile comes at once.
pub(crate) fn waiting<T>(act: impl FnOnce() -> T) -> T {
    WAITING.store(true, Ordering::SeqCst);
    if interrupted() {
        std::process::exit(130);
    }
    let done = act();
    WAITING.store(false, Ordering::SeqCst);
    done
}

/// Whether the user wants an end.
pub(crate) fn interrupted() -> bool {
    INTERRUPTED.get().is_some()
}

/// Lets a file that grows beyond the limit of `ulimit -f` be an error of writing that is told, not the end of the program. To be called before
/// any thread is begun.
pub(crate) fn hold_file_sizes() {
    #[cfg(unix)]
    hold(Signal::SIGXFSZ);
}

/// First Ctrl-C, or SIGTERM or SIGHUP: end cleanly. Second: end at once.
pub(crate) fn listen() {
    // Whoever ignores hangups (`nohup`) goes on when the terminal is closed; the listener would hear them nevertheless.
    #[cfg(unix)]
    if ignores_hangups() {
        hold(Signal::SIGHUP);
    }
    let handler = ctrlc::set_handler(|| {
        if INTERRUPTED.get_or_init(Instant::now).elapsed() > ONE_WISH || WAITING.load(Ordering::SeqCst) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        say(&format!("warning: Ctrl-C will end the program at once: {error}"));
    }
}

/// Whether the program was started to outlive its terminal, where the system says so.
#[cfg(unix)]
fn ignores_hangups() -> bool {
    const HANGUP: u64 = 1;
    let ignored = || {
        let status = std::fs::read_to_string("/proc/self/status").ok()?;
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
        u64::from_str_radix(mask.trim(), 16).ok()
    };
    cfg!(target_os = "linux") && ignored().is_some_and(|ignored| ignored & HANGUP != 0)
}

/// Lets a signal reach no thread: this one has it held back, and hands that on to all that it begins.
#[cfg(unix)]
fn hold(signal: Signal) {
    use nix::sys::signal::SigSet;
    let mut held = SigSet::empty();
    held.add(signal);
    if let Err(error) = held.thread_block() {
        say(&format!("warning: {signal} will end the program: {error}"));
    }
}
