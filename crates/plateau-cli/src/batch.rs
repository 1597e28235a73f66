//! `run`: every experiment in turn, its table on stdout, its folder written before the next one starts.

use std::io::Write;
use std::time::Duration;

use experiment::{Finished, Options, Plan, Source};
use record::{Earlier, Keeping, Kept, Listener, Loss, Remark, folder, run_and_keep};
use show::{Printable, table};
use sweep::Shard;

use crate::bars::Bars;
use crate::command::RunArguments;
use crate::failure::Failure;
use crate::interrupt::{interrupted, listen};
use crate::outcome::Outcome;
use crate::outlet::{Outlet, room};
use crate::sources::{distinct_stems, read_sources};
use crate::sweeps;
use crate::terminal::{line, say};
use crate::threads::start_threads;

/// Runs the files; a failure of one experiment loses none of the others, nor does one of stdout.
pub(crate) fn run(arguments: &RunArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let sources = read_sources(&arguments.files)?;
    distinct_stems(&sources, &arguments.out)?;
    let shard = sweeps::shard_of(&sources, arguments)?;
    start_threads(arguments.threads)?;
    listen();
    let mut outlet = Outlet::new(stdout);
    let outcome = experiments(&sources, shard, arguments, &mut outlet);
    outlet.conclude(outcome)
}

fn experiments(
    sources: &[Source],
    shard: Shard,
    arguments: &RunArguments,
    stdout: &mut impl Write,
) -> Result<(), Failure> {
    let bars = Bars::new(arguments.quiet);
    let options = Options { seed: arguments.seed, arithmetic: arguments.arithmetic.into() };
    let mut sound = true;
    for (k, source) in sources.iter().enumerate() {
        if k > 0 && !arguments.json {
            writeln!(stdout)?;
        }
        let outcome = match source {
            Source::Experiment(plan) => experiment(plan, options, arguments, &bars, stdout)?,
            Source::Sweep(sweep) => sweeps::cells(sweep, shard, options, arguments, &bars, stdout)?,
        };
        sound &= match outcome {
            Outcome::Sound => true,
            Outcome::Unsound => false,
            Outcome::Interrupted(kept) => {
                say(&told_of_interrupt(k, sources, &kept));
                return Err(Failure::Interrupted);
            }
        };
        if interrupted() && k + 1 < sources.len() {
            say(&told_of_interrupt(k + 1, sources, ""));
            return Err(Failure::Interrupted);
        }
    }
    if sound { Ok(()) } else { Err(Failure::Result) }
}

fn told_of_interrupt(done: usize, sources: &[Source], kept: &str) -> String {
    format!(
        "interrupted: {done} of {} experiments done and written{kept}; to go on, add --resume to the same command",
        sources.len()
    )
}

fn experiment(
    plan: &Plan,
    options: Options,
    arguments: &RunArguments,
    bars: &Bars,
    stdout: &mut impl Write,
) -> Result<Outcome, Failure> {
    let interval = Duration::from_secs_f64(arguments.checkpoint_every);
    let keeping = Keeping { options, out: &arguments.out, interval, resume: arguments.resume };
    let mut watcher = Watcher { plan, json: arguments.json, stdout, output: Ok(()) };
    let kept = run_and_keep(plan, &keeping, bars, &mut watcher);
    let Watcher { stdout, output, .. } = watcher;
    output?;
    let sound = match kept {
        Kept::Earlier(earlier) => repeat(plan, &earlier, arguments, stdout)?,
        Kept::Interrupted(interruption) => {
            return Ok(Outcome::Interrupted(interruption.told(&plan.file)));
        }
        Kept::Lost(loss) => {
            let hint = if matches!(loss, Loss::Unprepared(_)) { "; --out names another folder" } else { "" };
            say(&format!("error: {}: {loss}{hint}", plan.file));
            return Ok(Outcome::Unsound);
        }
        Kept::Done(done) => {
            let (finished, delivered) = *done;
            if arguments.json {
                write!(stdout, "{}", delivered.record.to_json().map_err(std::io::Error::other)?)?;
            } else {
                for note in &delivered.notes {
                    line(stdout, note)?;
                }
                line(stdout, &format!("written to {}", delivered.folder.display()))?;
            }
            for refusal in &delivered.refusals {
                say(&format!("error: {refusal}"));
            }
            finished.shortfall().is_none() && delivered.refusals.is_empty()
        }
    };
    stdout.flush()?;
    Ok(Outcome::of(sound))
}

/// Shows what is found before it is written: it is seen even where it cannot be kept.
struct Watcher<'a, W: Write> {
    plan: &'a Plan,
    json: bool,
    stdout: &'a mut W,
    output: std::io::Result<()>,
}

impl<W: Write> Listener for Watcher<'_, W> {
    fn finished(&mut self, finished: &Finished) {
        self.output = if self.json {
            expectations(self.plan, finished, &mut std::io::sink())
        } else {
            write!(self.stdout, "{}", table(&finished.results, room()))
                .and_then(|()| expectations(self.plan, finished, self.stdout))
        };
    }

    fn remark(&mut self, remark: &Remark) {
        if remark.is_warning() {
            say(&format!("warning: {remark}"));
        } else {
            say(&format!("{}: {remark}", self.plan.file));
        }
    }
}

/// An experiment whose result is there already; whether it is as it should be.
fn repeat(
    plan: &Plan,
    earlier: &Earlier,
    arguments: &RunArguments,
    stdout: &mut impl Write,
) -> std::io::Result<bool> {
    if arguments.json {
        write!(stdout, "{}", earlier.json)?;
    } else {
        writeln!(stdout, "{}", Printable(&plan.title).cut(Printable::TITLE))?;
        let folder = folder(plan, &arguments.out);
        line(stdout, &format!("not run again: its result is in {}", folder.display()))?;
    }
    let shortfall = earlier.shortfall();
    if let Some(shortfall) = &shortfall {
        say(&format!("{}: {shortfall}", plan.file));
    }
    Ok(shortfall.is_none())
}

/// `reproduce`: the published tables; nothing is written to disk.
pub(crate) fn reproduce(json: bool, quiet: bool, stdout: &mut impl Write) -> Result<(), Failure> {
    listen();
    let reproduction = record::reproduce(Options::default(), &Bars::new(quiet));
    if interrupted() {
        return Err(Failure::Interrupted);
    }
    if json {
        write!(stdout, "{}", reproduction.to_json().map_err(std::io::Error::other)?)?;
    } else {
        write!(stdout, "{}", reproduction.table())?;
    }
    if reproduction.is_sound() { Ok(()) } else { Err(Failure::Result) }
}

/// Tells which expected numbers are met.
fn expectations(plan: &Plan, finished: &Finished, stdout: &mut impl Write) -> std::io::Result<()> {
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
    Ok(())
}
