//! Progress on stderr.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use plateau::Progress;

use crate::interrupt::interrupted;

/// Progress bars on stderr, shown only on a terminal and only for work that lasts.
pub(crate) struct Bars {
    shown: bool,
    bar: Mutex<Option<ProgressBar>>,
}

impl Bars {
    pub(crate) fn new(quiet: bool) -> Self {
        Self { shown: !quiet && std::io::stderr().is_terminal(), bar: Mutex::new(None) }
    }

    fn with(&self, act: impl FnOnce(&mut Option<ProgressBar>)) {
        if let Ok(mut bar) = self.bar.lock() {
            act(&mut bar);
        }
    }
}

/// The time left, from the first step on: before it nothing is known.
fn left(state: &ProgressState, text: &mut dyn std::fmt::Write) {
    if state.pos() > 0 {
        // Text that cannot be written is a bar that cannot be shown.
        let _ = write!(text, ", {:#} left", HumanDuration(state.eta()));
    }
}

impl Progress for Bars {
    fn begin(&self, what: &str, steps: Option<u64>) {
        if !self.shown {
            return;
        }
        let style = ProgressStyle::with_template(match steps {
            Some(_) => "{prefix} {wide_bar} {pos} of {len} {msg}{left}",
            None => "{spinner} {prefix}: {elapsed} so far {msg}",
        });
        let bar = ProgressBar::with_draw_target(steps, ProgressDrawTarget::stderr_with_hz(10));
        let bar = style
            .map(|style| bar.clone().with_style(style.with_key("left", left)))
            .unwrap_or(bar)
            .with_prefix(what.to_owned());
        bar.enable_steady_tick(Duration::from_millis(200));
        self.with(|slot| *slot = Some(bar));
    }

    fn step(&self) {
        if self.shown {
            self.with(|slot| {
                if let Some(bar) = slot {
                    bar.inc(1);
                }
            });
        }
    }

    fn tell(&self, state: &str) {
        if self.shown {
            self.with(|slot| {
                if let Some(bar) = slot {
                    bar.set_message(state.to_owned());
                }
            });
        }
    }

    fn end(&self) {
        self.with(|slot| {
            if let Some(bar) = slot.take() {
                bar.finish_and_clear();
            }
        });
    }

    fn cancelled(&self) -> bool {
        interrupted()
    }
}
