//! `plateau check`: what a file asks for, and what that costs.

use std::io::Write;
use std::path::PathBuf;

use crate::failure::Failure;
use crate::sources::read_source;
use crate::terminal::{line, tell};

/// `check`: one line for each sound file on stdout.
pub(crate) fn check(files: &[PathBuf], stdout: &mut impl Write) -> Result<(), Failure> {
    let mut sound = true;
    for file in files {
        match read_source(file) {
            Ok(source) => {
                line(stdout, &format!("{}: sound, {}", source.file(), source.summary()))?;
                for cost in source.costs() {
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
