//! Progress on stderr.

use std::io::IsTerminal;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use plateau::Progress;
use show::Printable;

use crate::interrupt::interrupted;

/// Progress bars on stderr, shown only on a terminal and only for work that lasts.
pub(crate) struct Bars {
    shown: bool,
    work: Arc<Mutex<Option<Work>>>,
}

/// The work at hand; its bar is hidden at first.
struct Work {
    bar: ProgressBar,
    begun: Instant,
}

/// Work that ends sooner is not shown.
const PATIENCE: Duration = Duration::from_millis(500);

/// Between two looks at the work.
const TICK: Duration = Duration::from_millis(200);

impl Bars {
    pub(crate) fn new(quiet: bool) -> Self {
        let bars =
            Self { shown: !quiet && std::io::stderr().is_terminal(), work: Arc::new(Mutex::new(None)) };
        if bars.shown {
            let work = Arc::downgrade(&bars.work);
            thread::spawn(move || {
                while let Some(work) = work.upgrade() {
                    if let Ok(Some(work)) = work.lock().as_deref() {
                        work.tick();
                    }
                    drop(work);
                    thread::sleep(TICK);
                }
            });
        }
        bars
    }

    fn with(&self, act: impl FnOnce(&mut Option<Work>)) {
        if let Ok(mut work) = self.work.lock() {
            act(&mut work);
        }
    }
}

impl Work {
    fn tick(&self) {
        if self.begun.elapsed() >= PATIENCE {
            if self.bar.is_hidden() {
                self.bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
            }
            self.bar.tick();
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
        let bar = ProgressBar::with_draw_target(steps, ProgressDrawTarget::hidden());
        let bar = style
            .map(|style| bar.clone().with_style(style.with_key("left", left)))
            .unwrap_or(bar)
            .with_prefix(Printable(what).to_string());
        self.with(|slot| *slot = Some(Work { bar, begun: Instant::now() }));
    }

    fn step(&self) {
        if self.shown {
            self.with(|slot| {
                if let Some(Work { bar, .. }) = slot {
                    bar.inc(1);
                }
            });
        }
    }

    fn tell(&self, state: &str) {
        if self.shown {
            self.with(|slot| {
                if let Some(Work { bar, .. }) = slot {
                    bar.set_message(Printable(state).to_string());
                }
            });
        }
    }

    fn end(&self) {
        self.with(|slot| {
            if let Some(Work { bar, .. }) = slot.take() {
                bar.finish_and_clear();
            }
        });
    }

    fn cancelled(&self) -> bool {
        interrupted()
    }
}
