//! Progress on stderr.

use std::io::IsTerminal;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use plateau::Progress;
use show::Printable;

use crate::interrupt::interrupted;
use crate::terminal::say;

/// Progress of work that lasts, on stderr: a bar on a terminal, a line now and then elsewhere.
pub(crate) struct Bars {
    shown: Shown,
    work: Arc<Mutex<Option<Work>>>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Shown {
    Nothing,
    Bars,
    Lines,
}

/// The work at hand.
struct Work {
    view: View,
    begun: Instant,
}

enum View {
    /// Hidden at first.
    Bar(ProgressBar),
    Lines(Lines),
}

/// What the next line tells, and how long after the beginning it comes.
struct Lines {
    what: String,
    steps: Option<u64>,
    done: u64,
    state: String,
    next: Duration,
}

/// Work that ends sooner shows no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// Nor any line before this; then one each time as much has passed again, at least each [`RARELY`].
const FIRST_LINE: Duration = Duration::from_secs(10);
const RARELY: Duration = Duration::from_secs(60);

/// Between two looks at the work.
const TICK: Duration = Duration::from_millis(200);

impl Bars {
    pub(crate) fn new(quiet: bool) -> Self {
        let shown = match (quiet, std::io::stderr().is_terminal()) {
            (true, _) => Shown::Nothing,
            (false, true) => Shown::Bars,
            (false, false) => Shown::Lines,
        };
        let bars = Self { shown, work: Arc::new(Mutex::new(None)) };
        if bars.shown != Shown::Nothing {
            let work = Arc::downgrade(&bars.work);
            thread::spawn(move || {
                while let Some(work) = work.upgrade() {
                    if let Ok(Some(work)) = work.lock().as_deref_mut() {
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
    fn tick(&mut self) {
        let elapsed = self.begun.elapsed();
        match &mut self.view {
            View::Bar(bar) if elapsed >= PATIENCE => {
                if bar.is_hidden() {
                    bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
                }
                bar.tick();
            }
            View::Bar(_) => {}
            View::Lines(lines) => {
                if let Some(line) = lines.due(elapsed) {
                    say(&line);
                }
            }
        }
    }
}

impl Lines {
    fn new(what: &str, steps: Option<u64>) -> Self {
        Self { what: what.to_owned(), steps, done: 0, state: String::new(), next: FIRST_LINE }
    }

    /// The line of this moment, if it is time for one.
    fn due(&mut self, elapsed: Duration) -> Option<String> {
        if elapsed < self.next {
            return None;
        }
        self.next = elapsed + elapsed.min(RARELY);
        let far = self.steps.map_or_else(String::new, |steps| format!("{} of {steps}, ", self.done));
        let space = if self.state.is_empty() { "" } else { " " };
        Some(format!("{}: {far}{} s so far{space}{}", self.what, elapsed.as_secs(), self.state))
    }
}

/// The time left, from the first step on: before it nothing is known.
fn left(state: &ProgressState, text: &mut dyn std::fmt::Write) {
    if state.pos() > 0 {
        // Text that cannot be written is a bar that cannot be shown.
        let _ = write!(text, ", {:#} left", HumanDuration(state.eta()));
    }
}

/// A bar, hidden.
fn bar(what: &str, steps: Option<u64>) -> ProgressBar {
    let style = ProgressStyle::with_template(match steps {
        Some(_) => "{prefix} {wide_bar} {pos} of {len} {msg}{left}",
        None => "{spinner} {prefix}: {elapsed} so far {msg}",
    });
    let bar = ProgressBar::with_draw_target(steps, ProgressDrawTarget::hidden());
    style
        .map(|style| bar.clone().with_style(style.with_key("left", left)))
        .unwrap_or(bar)
        .with_prefix(Printable(what).to_string())
}

impl Progress for Bars {
    fn begin(&self, what: &str, steps: Option<u64>) {
        let view = match self.shown {
            Shown::Nothing => return,
            Shown::Bars => View::Bar(bar(what, steps)),
            Shown::Lines => View::Lines(Lines::new(what, steps)),
        };
        self.with(|slot| *slot = Some(Work { view, begun: Instant::now() }));
    }

    fn step(&self) {
        self.with(|slot| match slot.as_mut().map(|work| &mut work.view) {
            Some(View::Bar(bar)) => bar.inc(1),
            Some(View::Lines(lines)) => lines.done += 1,
            None => {}
        });
    }

    fn tell(&self, state: &str) {
        self.with(|slot| match slot.as_mut().map(|work| &mut work.view) {
            Some(View::Bar(bar)) => bar.set_message(Printable(state).to_string()),
            Some(View::Lines(lines)) => state.clone_into(&mut lines.state),
            None => {}
        });
    }

    fn end(&self) {
        self.with(|slot| {
            if let Some(Work { view: View::Bar(bar), .. }) = slot.take() {
                bar.finish_and_clear();
            }
        });
    }

    fn cancelled(&self) -> bool {
        interrupted()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_the_more_rarely_the_longer_it_lasts() {
        let mut lines = Lines::new("descending for x", Some(10));
        (lines.done, lines.state) = (3, "(40 least areas)".to_owned());
        let told: Vec<(u64, String)> = (0..=3000)
            .filter_map(|tenth| {
                let elapsed = Duration::from_millis(100 * tenth);
                Some((elapsed.as_secs(), lines.due(elapsed)?))
            })
            .collect();
        let times: Vec<u64> = told.iter().map(|(time, _)| *time).collect();
        assert_eq!(times, [10, 20, 40, 80, 140, 200, 260]);
        assert_eq!(told[1].1, "descending for x: 3 of 10, 20 s so far (40 least areas)");
    }
}
