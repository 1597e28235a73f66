//! `verify`: results computed again and compared.

use std::io::Write;

use record::{VerifyError, result_text, verify_text};

use crate::bars::Bars;
use crate::command::VerifyArguments;
use crate::failure::Failure;
use crate::interrupt::{listen, waiting};
use crate::outlet::Outlet;
use crate::terminal::{say, tell};
use crate::threads::start_threads;

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
        let text = waiting(|| result_text(path));
        match text.map_err(VerifyError::from).and_then(|text| verify_text(&text, &bars)) {
            Ok(verification) => {
                equal &= verification.agrees();
                if arguments.json {
                    write!(stdout, "{}", verification.to_json(path).map_err(std::io::Error::other)?)?;
                } else {
                    if k > 0 {
                        writeln!(stdout)?;
                    }
                    write!(stdout, "{}", verification.report(path))?;
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
