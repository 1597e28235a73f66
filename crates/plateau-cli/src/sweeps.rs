//! Sweeps: `run` of the cells of a shard, `merge` of the folders of all.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;
use std::time::Duration;

use experiment::{Options, Source, Sweep};
use sweep::{Merged, Order, Shard, merge, run, shard};

use crate::bars::Bars;
use crate::command::{MergeArguments, RunArguments};
use crate::failure::Failure;
use crate::interrupt::interrupted;
use crate::outcome::Outcome;
use crate::outlet::room;
use crate::terminal::{line, say};

/// Most cells that are told one by one.
const MOST_TOLD: usize = 20;

/// The shard of the sweeps among the files, and who said so is told. A file without a sweep is never shared out.
pub(crate) fn shard_of(sources: &[Source], arguments: &RunArguments) -> Result<Shard, Failure> {
    let plain = sources.iter().find_map(|source| match source {
        Source::Experiment(plan) => Some(&plan.file),
        Source::Sweep(_) => None,
    });
    let variable = |name: &str| std::env::var(name).ok();
    if let Some(file) = plain {
        if arguments.shard.is_some() {
            say(&format!("error: --shard shares out the cells of a sweep, and {file} has no [sweep]"));
            return Err(Failure::Input);
        }
        let scheduler =
            ["SLURM_ARRAY_TASK_ID", "HQ_TASK_ID"].into_iter().find(|name| variable(name).is_some());
        if let Some(name) = scheduler {
            say(&format!("note: {file} has no [sweep]: all of it is run, whatever {name} says"));
        }
    }
    if sources.iter().all(|source| matches!(source, Source::Experiment(_))) {
        return Ok(Shard::WHOLE);
    }
    match shard(arguments.shard, variable) {
        Ok((shard, None)) => Ok(shard),
        Ok((shard, Some(name))) => {
            say(&format!("shard {shard}, by {name}"));
            Ok(shard)
        }
        Err(error) => {
            say(&format!("error: {error}"));
            Err(Failure::Input)
        }
    }
}

/// Runs the cells of a shard; of a whole sweep the table follows.
pub(crate) fn cells(
    sweep: &Sweep,
    shard: Shard,
    options: Options,
    arguments: &RunArguments,
    bars: &Bars,
    stdout: &mut impl Write,
) -> Result<Outcome, Failure> {
    let threads = arguments.threads.map(usize::from);
    let threads = threads.unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
    let interval = Duration::from_secs_f64(arguments.checkpoint_every);
    let order = Order { options, threads, interval, ..Order::new(sweep, shard, &arguments.out) };
    let folder = order.folder();
    let tally = match run(&order, bars, &|what| say(&format!("{}: {what}", sweep.file()))) {
        Ok(tally) => tally,
        Err(error) => {
            say(&format!("error: {}: not run, for its results could not be written: {error}", sweep.file()));
            return Ok(Outcome::Unsound);
        }
    };
    if interrupted() && tally.left > 0 {
        return Ok(Outcome::Interrupted(format!("; {} cells of {} are left", tally.left, sweep.file())));
    }
    for name in tally.elsewhere.iter().take(MOST_TOLD) {
        say(&format!("{}: {name}: another run is at work on it", sweep.file()));
    }
    let share = if shard.is_whole() { String::new() } else { format!("shard {shard}, ") };
    let summary = format!(
        "{}: {share}{} {} run, {} there already, in {}",
        sweep.stem(),
        tally.done,
        if tally.done == 1 { "cell" } else { "cells" },
        tally.kept,
        folder.display()
    );
    let mut sound = tally.is_sound();
    if shard.is_whole() {
        sound &= merged(std::slice::from_ref(&folder), &folder, arguments.json, stdout)?;
    }
    if !arguments.json {
        line(stdout, &summary)?;
    }
    stdout.flush()?;
    Ok(Outcome::of(sound))
}

/// `merge`.
pub(crate) fn merge_folders(arguments: &MergeArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let out = arguments.out.as_ref().or(arguments.folders.first());
    let out = out.cloned().unwrap_or_default();
    if merged(&arguments.folders, &out, arguments.json, stdout)? { Ok(()) } else { Err(Failure::Result) }
}

/// Merges folders, shows and writes the table; whether all of it is there.
fn merged(folders: &[PathBuf], out: &Path, json: bool, stdout: &mut impl Write) -> Result<bool, Failure> {
    let merged = merge(folders).map_err(|error| {
        say(&format!("error: {error}"));
        Failure::Input
    })?;
    if json {
        write!(stdout, "{}", merged.to_json().map_err(std::io::Error::other)?)?;
    } else {
        write!(stdout, "{}", merged.table(room()))?;
    }
    tell(&merged);
    if let Err(error) = merged.write(out) {
        say(&format!("error: the table cannot be written: {error}"));
        return Ok(false);
    }
    if !json {
        line(
            stdout,
            &format!("merged.csv, merged.json, plots.svg and index.html written to {}", out.display()),
        )?;
    }
    Ok(merged.is_whole())
}

fn tell(merged: &Merged) {
    let faults = merged.faults();
    for fault in faults.iter().take(MOST_TOLD) {
        say(fault);
    }
    if faults.len() > MOST_TOLD {
        say(&format!("and {} more cells", faults.len() - MOST_TOLD));
    }
    if !faults.is_empty() {
        let (there, all) = merged.counts();
        say(&format!(
            "{there} of {all} cells are there; run the sweep again to have the others, those that are there are kept"
        ));
    }
    for note in merged.notes() {
        say(&format!("note: {note}"));
    }
}
