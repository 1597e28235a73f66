//! `plateau check`: what a file asks for, and what that costs.

use std::io::Write;
use std::path::PathBuf;

use experiment::{Experiment, Plan, Source};

use crate::costs::costs;
use crate::failure::Failure;
use crate::sources::read_source;
use crate::terminal::{line, tell};

/// `check`: one line for each sound file on stdout.
pub(crate) fn check(files: &[PathBuf], stdout: &mut impl Write) -> Result<(), Failure> {
    let mut sound = true;
    for file in files {
        match read_source(file) {
            Ok(source) => {
                line(stdout, &format!("{}: sound, {}", source.file(), what_it_is(&source)))?;
                for cost in costs(&source) {
                    line(stdout, &format!("  {cost}"))?;
                }
            }
            Err(refusal) => {
                stdout.flush()?;
                tell(&refusal);
                sound = false;
            }
        }
    }
    if sound { Ok(()) } else { Err(Failure::Input) }
}

/// What a file asks for.
fn what_it_is(source: &Source) -> String {
    match source {
        Source::Experiment(plan) => subject(plan),
        Source::Sweep(sweep) => {
            let axes: Vec<String> = sweep
                .axes()
                .iter()
                .filter(|axis| axis.with().is_none())
                .map(|axis| format!("{} of {}", axis.settings().len(), axis.name()))
                .collect();
            format!("a sweep of {} cells ({})", sweep.cells(), axes.join(" × "))
        }
    }
}

fn subject(plan: &Plan) -> String {
    let methods = |count: usize| if count == 1 { "1 method".to_owned() } else { format!("{count} methods") };
    match &plan.experiment {
        Experiment::Patch(patches) => methods(patches.methods.len()),
        Experiment::Film(film) => methods(film.methods.len()),
        Experiment::Helicoid(_) => "a helicoid".to_owned(),
        Experiment::TrapeziumHelicoid(..) => "a helicoid over a trapezium".to_owned(),
        Experiment::Net(_) => "a net of its own".to_owned(),
        Experiment::Curve(curves) => {
            let samples = curves.first().map_or(0, |curve| curve.samples().len());
            match curves.len() {
                1 => format!("a curve at {samples} samples"),
                count => format!("{count} curves at {samples} samples each"),
            }
        }
    }
}
