//! `run`: every experiment in turn, its table on stdout, its folder written before the next one starts.

use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use plateau::{Finished, Options, Plan, Progress, deliver, table};

use crate::command::{self, Failure, RunArguments, say};

/// Set by Ctrl-C: the work at hand ends as soon as it can.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Runs the files; a failure of one experiment loses none of the others.
pub(crate) fn run(arguments: &RunArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let plans = command::read_plans(&arguments.files)?;
    command::distinct_stems(&plans, &arguments.out)?;
    if let Some(threads) = arguments.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global();
        if let Err(error) = pool {
            say(&format!("error: {threads} threads cannot be started: {error}"));
            return Err(Failure::Input);
        }
    }
    listen();
    let bars = Bars::new(arguments.quiet);
    let options = Options { seed: arguments.seed, arithmetic: arguments.arithmetic.into() };
    let mut sound = true;
    for (k, plan) in plans.iter().enumerate() {
        if k > 0 && !arguments.json {
            writeln!(stdout)?;
        }
        sound &= experiment(plan, options, arguments, &bars, stdout)?;
        if INTERRUPTED.load(Ordering::Relaxed) {
            say("interrupted: what is printed above is done and written; the rest was not run");
            return Err(Failure::Interrupted);
        }
    }
    if sound { Ok(()) } else { Err(Failure::Result) }
}

/// One experiment; whether all of it succeeded and met what its file expects.
fn experiment(
    plan: &Plan,
    options: Options,
    arguments: &RunArguments,
    bars: &Bars,
    stdout: &mut impl Write,
) -> Result<bool, Failure> {
    let finished = match plateau::run(plan, options, bars) {
        Ok(finished) => finished,
        Err(error) => {
            say(&format!("error: {}: {error}", plan.file));
            return Ok(false);
        }
    };
    if !arguments.json {
        write!(stdout, "{}", table(&finished))?;
    }
    // A folder is only replaced by a whole experiment.
    if INTERRUPTED.load(Ordering::Relaxed) {
        return Ok(false);
    }
    let json = arguments.json;
    let mut sound = if json {
        expectations(plan, &finished, &mut std::io::sink())?
    } else {
        expectations(plan, &finished, stdout)?
    };
    bars.begin(&format!("files of {}", plan.stem), None);
    let delivered = deliver(plan, &finished, &arguments.out);
    bars.end();
    match delivered {
        Ok(delivered) => {
            if json {
                write!(stdout, "{}", delivered.record.to_json().map_err(std::io::Error::other)?)?;
            } else {
                for note in &delivered.notes {
                    writeln!(stdout, "{note}")?;
                }
                writeln!(stdout, "written to {}", delivered.folder.display())?;
            }
            for refusal in &delivered.refusals {
                say(&format!("error: {refusal}"));
                sound = false;
            }
        }
        Err(error) => {
            say(&format!("error: the result cannot be written: {error}"));
            return Ok(false);
        }
    }
    stdout.flush()?;
    Ok(sound && finished.failures().next().is_none())
}

/// `reproduce`: the published tables; nothing is written to disk.
pub(crate) fn reproduce(json: bool, quiet: bool, stdout: &mut impl Write) -> Result<(), Failure> {
    listen();
    let reproduction = plateau::reproduce(Options::default(), &Bars::new(quiet));
    if INTERRUPTED.load(Ordering::Relaxed) {
        return Err(Failure::Interrupted);
    }
    if json {
        write!(stdout, "{}", reproduction.to_json().map_err(std::io::Error::other)?)?;
    } else {
        write!(stdout, "{}", reproduction.table())?;
    }
    if reproduction.is_sound() { Ok(()) } else { Err(Failure::Result) }
}

fn expectations(plan: &Plan, finished: &Finished, stdout: &mut impl Write) -> Result<bool, Failure> {
    let (expected, missed) = (finished.expected(), finished.missed());
    if expected > 0 {
        writeln!(stdout, "expected numbers: {} of {expected} met", expected - missed.len())?;
    }
    for miss in &missed {
        let ours = miss.ours.map_or("there is no such figure".into(), |ours| format!("found {ours}"));
        say(&format!(
            "{}:{}: {}: {} = {} expected, {ours}",
            plan.file, miss.expected.line, miss.method, miss.expected.quantity, miss.expected.text
        ));
    }
    Ok(missed.is_empty())
}

/// First Ctrl-C: end cleanly. Second: end at once.
fn listen() {
    let handler = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        say(&format!("warning: Ctrl-C will end the program at once: {error}"));
    }
}

/// Progress bars on stderr, shown only on a terminal and only for work that lasts.
struct Bars {
    shown: bool,
    bar: Mutex<Option<ProgressBar>>,
}

impl Bars {
    fn new(quiet: bool) -> Self {
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
        INTERRUPTED.load(Ordering::Relaxed)
    }
}
