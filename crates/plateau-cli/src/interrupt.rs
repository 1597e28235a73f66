//! Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::command::say;

/// Set by Ctrl-C: the work at hand ends as soon as it can.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Whether the user wants an end.
pub(crate) fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// First Ctrl-C: end cleanly. Second: end at once.
pub(crate) fn listen() {
    let handler = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        say(&format!("warning: Ctrl-C will end the program at once: {error}"));
    }
}
