use std::io;

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

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}
