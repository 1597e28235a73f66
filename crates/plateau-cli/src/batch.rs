//! `run`: every experiment in turn, its table on stdout, its folder written before the next one starts.

use std::io::Write;
use std::time::Duration;

use experiment::{Finished, Options, Plan, Source, run_kept};
use plateau::{Progress, counted};
use record::{Checkpoint, Manifest, deliver_watched, earlier, folder, prepare};
use show::table;
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
    let (out, folder) = (&arguments.out, folder(plan, &arguments.out));
    let _claim = match prepare(plan, out) {
        Ok(claim) => claim,
        Err(error) => {
            say(&format!(
                "error: {}: not run, for its result could not be written: {error}; --out names another folder",
                plan.file
            ));
            return Ok(Outcome::Unsound);
        }
    };
    let interval = Duration::from_secs_f64(arguments.checkpoint_every);
    let checkpoint = Checkpoint::new(&folder, Manifest::new(plan, options), interval);
    if arguments.resume {
        if let Some(earlier) = earlier(plan, options, out) {
            forget(&checkpoint);
            return repeat(plan, &earlier, arguments, stdout);
        }
        take(plan, &checkpoint);
    }
    let finished = match run_kept(plan, options, bars, &checkpoint) {
        Ok(finished) => finished,
        Err(error) => {
            say(&format!("error: {}: {error}", plan.file));
            // Only if there is nothing in it.
            let _ = std::fs::remove_dir(&folder);
            return Ok(Outcome::Unsound);
        }
    };
    if let refused @ 1.. = checkpoint.refused() {
        let runs = counted(refused, "finished search run");
        say(&format!(
            "warning: {}: not what the search finds, so run again: {runs}",
            checkpoint.path().display()
        ));
    }
    // A folder is only replaced by a whole experiment.
    if finished.results.was_interrupted() {
        let kept = kept(plan, &checkpoint);
        let _ = std::fs::remove_dir(&folder);
        return Ok(Outcome::Interrupted(kept));
    }
    if let Some(problem) = checkpoint.problem() {
        say(&format!("warning: {}: finished runs could not be kept: {problem}", checkpoint.path().display()));
    }
    conclude(plan, &finished, &checkpoint, arguments, bars, stdout)
}

/// Shows and writes what was found; what was computed is kept even where neither can be done.
fn conclude(
    plan: &Plan,
    finished: &Finished,
    checkpoint: &Checkpoint,
    arguments: &RunArguments,
    bars: &Bars,
    stdout: &mut impl Write,
) -> Result<Outcome, Failure> {
    let json = arguments.json;
    let mut sound = if json {
        expectations(plan, finished, &mut std::io::sink())?
    } else {
        write!(stdout, "{}", table(&finished.results, room()))?;
        expectations(plan, finished, stdout)?
    };
    bars.begin(&format!("files of {}", plan.stem), None);
    let delivered = deliver_watched(plan, finished, &arguments.out, bars);
    bars.end();
    match delivered {
        Ok(delivered) if interrupted() && !delivered.record.unwritten().is_empty() => {
            // The search need not be repeated for the files that are missing.
            let _ = checkpoint.flush();
            let (folder, missing) = (delivered.folder.display(), delivered.record.unwritten().len());
            let files = if missing == 1 { "1 file is" } else { &format!("{missing} files are") };
            return Ok(Outcome::Interrupted(format!("; {folder}/result.json is written, {files} not")));
        }
        Ok(delivered) => {
            if json {
                write!(stdout, "{}", delivered.record.to_json().map_err(std::io::Error::other)?)?;
            } else {
                for note in &delivered.notes {
                    line(stdout, note)?;
                }
                line(stdout, &format!("written to {}", delivered.folder.display()))?;
            }
            for refusal in &delivered.refusals {
                say(&format!("error: {refusal}"));
                sound = false;
            }
            forget(checkpoint);
        }
        Err(error) => {
            say(&format!("error: {}: the result cannot be written: {error}", plan.file));
            // It is all there is of the work now.
            let _ = checkpoint.flush();
            return Ok(Outcome::Unsound);
        }
    }
    stdout.flush()?;
    Ok(Outcome::of(sound && finished.results.failures().next().is_none()))
}

/// An experiment whose result is there already.
fn repeat(
    plan: &Plan,
    earlier: &record::Earlier,
    arguments: &RunArguments,
    stdout: &mut impl Write,
) -> Result<Outcome, Failure> {
    let folder = folder(plan, &arguments.out);
    if arguments.json {
        write!(stdout, "{}", earlier.json)?;
    } else {
        line(stdout, &plan.title)?;
        line(stdout, &format!("not run again: its result is in {}", folder.display()))?;
    }
    stdout.flush()?;
    let (missed, failed) = (earlier.missed, earlier.failed);
    if missed + failed > 0 {
        say(&format!("{}: {missed} expected numbers missed, {failed} methods failed", plan.file));
    }
    Ok(Outcome::of(missed + failed == 0))
}

/// Takes what an interrupted run left behind.
fn take(plan: &Plan, checkpoint: &Checkpoint) {
    match checkpoint.load() {
        Ok(0) => {}
        Ok(runs) => say(&format!(
            "{}: {} taken from {}",
            plan.file,
            counted(runs, "finished search run"),
            checkpoint.path().display()
        )),
        Err(error) => say(&format!("warning: {} is ignored: {error}", checkpoint.path().display())),
    }
}

/// Keeps what is done of an interrupted experiment; what that is, in words.
fn kept(plan: &Plan, checkpoint: &Checkpoint) -> String {
    let runs = checkpoint.runs();
    match checkpoint.flush() {
        _ if runs == 0 => String::new(),
        Ok(()) => format!(", {} of {} kept", counted(runs, "finished search run"), plan.file),
        Err(error) => {
            format!(", {} of {} could not be kept: {error}", counted(runs, "finished search run"), plan.file)
        }
    }
}

/// Removes the checkpoint of an experiment that is done.
fn forget(checkpoint: &Checkpoint) {
    if let Err(error) = checkpoint.remove() {
        say(&format!(
            "warning: {} is not needed any more and could not be removed: {error}",
            checkpoint.path().display()
        ));
    }
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
