use std::fmt::Display;
use std::io;

use crate::terminal::say;

/// Why a command ends with a status other than 0.
pub(crate) enum Failure {
    /// Bad usage or bad input, already told on stderr: status 2.
    Input,
    /// It ran, but something is not as it should be; already told on stderr: status 1.
    Result,
    /// Ctrl-C: what was done is written; status 130.
    Interrupted,
    /// The output could not be written.
    Output(io::Error),
}

impl Failure {
    /// Bad input, which is told on stderr: what is at fault, and why.
    pub(crate) fn of_input(what: impl Display, why: impl Display) -> Self {
        say(&format!("error: {what}: {why}"));
        Self::Input
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}
