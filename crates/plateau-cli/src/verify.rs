//! `verify`: results computed again and compared.

use std::io::Write;
use std::path::Path;

use record::{Level, Verification, VerifyError, result_text, verify_text};
use show::{Printable, width_of_names};

use crate::bars::Bars;
use crate::command::VerifyArguments;
use crate::failure::Failure;
use crate::interrupt::{listen, reading};
use crate::outlet::Outlet;
use crate::terminal::{line, say, tell};
use crate::threads::start_threads;

/// Most differences of a method that are printed.
const SHOWN: usize = 5;

/// Verifies every file; the worst outcome is the status, whoever listens.
pub(crate) fn results(arguments: &VerifyArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    start_threads(arguments.threads)?;
    listen();
    let mut outlet = Outlet::new(stdout);
    let outcome = verified(arguments, &mut outlet);
    outlet.conclude(outcome)
}

fn verified(arguments: &VerifyArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let bars = Bars::new(arguments.quiet);
    let (mut readable, mut equal) = (true, true);
    for (k, path) in arguments.results.iter().enumerate() {
        let text = reading(|| result_text(path));
        match text.map_err(VerifyError::from).and_then(|text| verify_text(&text, &bars)) {
            Ok(verification) => {
                equal &= verification.agrees();
                if arguments.json {
                    json(path, &verification, stdout)?;
                } else {
                    if k > 0 {
                        writeln!(stdout)?;
                    }
                    report(path, &verification, stdout)?;
                }
                stdout.flush()?;
            }
            Err(VerifyError::Interrupted) => {
                say(&format!("interrupted: {k} of {} results verified", arguments.results.len()));
                return Err(Failure::Interrupted);
            }
            Err(VerifyError::Refused(refusal)) => {
                say(&format!("error: {}: the experiment in it is refused by this version:", path.display()));
                tell(&refusal);
                readable = false;
            }
            Err(error) => {
                say(&format!("error: {}: {error}", path.display()));
                readable = false;
            }
        }
    }
    match (readable, equal) {
        (true, true) => Ok(()),
        (true, false) => Err(Failure::Result),
        (false, _) => Err(Failure::Input),
    }
}

fn json(path: &Path, verification: &Verification, stdout: &mut impl Write) -> Result<(), Failure> {
    let mut value = serde_json::to_value(verification).map_err(std::io::Error::other)?;
    value["schema"] = "plateau-verification/1".into();
    value["result"] = path.to_string_lossy().into();
    value["equal"] = verification.agrees().into();
    serde_json::to_writer_pretty(&mut *stdout, &value).map_err(std::io::Error::other)?;
    Ok(writeln!(stdout)?)
}

/// Words as a list that begins a sentence.
fn list(words: &[&str]) -> String {
    match words.split_last() {
        Some((last, [])) if !last.ends_with('s') => format!("{last} here is"),
        Some((last, [])) => format!("{last} here are"),
        Some((last, rest)) => format!("{} and {last} here are", rest.join(", ")),
        None => String::new(),
    }
}

fn report(path: &Path, verification: &Verification, stdout: &mut impl Write) -> Result<(), Failure> {
    line(stdout, &format!("{}: {}", path.display(), verification.title))?;
    match &verification.level {
        Level::Bits => {
            writeln!(stdout, "compared bit for bit: this program and this kind of processor wrote it")?
        }
        Level::Figures { because } => {
            let (tolerance, searched) = (Level::TOLERANCE, Level::SEARCHED);
            writeln!(
                stdout,
                "{} not what it was written with: figures and nets are compared within {tolerance:e}, those a search led to \
                 within {searched:e}",
                list(because)
            )?
        }
    }
    let width = width_of_names(verification.entries.iter().map(|entry| entry.name.as_str()));
    let word = if verification.level == Level::Bits { "equal" } else { "agrees" };
    for entry in &verification.entries {
        let (name, all) = (Printable(&entry.name).fitted(width), entry.compared);
        let values = if all == 1 { "1 value".into() } else { format!("{all} values") };
        match entry.differences.len() {
            0 => writeln!(stdout, "  {name}  {word}, {values}")?,
            differing => writeln!(stdout, "  {name}  DIFFERS in {differing} of {values}")?,
        }
        if entry.slides {
            let only = if verification.level == Level::Bits {
                ""
            } else {
                ": its area was compared, and what does not depend on them"
            };
            writeln!(
                stdout,
                "      its points are not determined, for the area is all but constant where they move{only}"
            )?;
        }
        for difference in entry.differences.iter().take(SHOWN) {
            let said = |value: &Option<String>| value.clone().unwrap_or_else(|| "nothing".into());
            let (stored, computed) = (said(&difference.stored), said(&difference.computed));
            line(
                stdout,
                &format!("      {}: the file has {stored}, computed is {computed}", difference.key),
            )?;
        }
        if entry.differs_in_bits_only {
            let (tolerance, searched) = (Level::TOLERANCE, Level::SEARCHED);
            writeln!(
                stdout,
                "      its figures and nets agree within {tolerance:e} ({searched:e} after a search)"
            )?;
        }
        if let Some(more @ 1..) = entry.differences.len().checked_sub(SHOWN) {
            writeln!(stdout, "      and {more} more")?;
        }
    }
    Ok(())
}
