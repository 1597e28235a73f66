//! Standard output that may fail without stopping the work.

use std::io::{self, ErrorKind, Write};

use console::Term;
use show::WIDTH;

use crate::failure::Failure;
use crate::terminal::say;

/// Passes on what is written until that fails once; from then on everything is dropped, for results are kept on disk and
/// not to be lost because nobody listens.
pub(crate) struct Outlet<'a, W: Write> {
    inner: &'a mut W,
    error: Option<io::Error>,
}

impl<'a, W: Write> Outlet<'a, W> {
    pub(crate) fn new(inner: &'a mut W) -> Self {
        Self { inner, error: None }
    }

    /// What comes of the work and of the output together: a failure of the work is the graver one.
    pub(crate) fn conclude(mut self, outcome: Result<(), Failure>) -> Result<(), Failure> {
        self.flush()?;
        match (outcome, self.error) {
            (outcome, None) => outcome,
            (Ok(()), Some(error)) => Err(error.into()),
            (Err(failure), Some(error)) => {
                if error.kind() != ErrorKind::BrokenPipe {
                    say(&format!("error: the output cannot be written: {error}"));
                }
                Err(failure)
            }
        }
    }
}

impl<W: Write> Write for Outlet<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.error.is_none() {
            self.error = self.inner.write_all(bytes).err();
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.error.is_none() {
            self.error = self.inner.flush().err();
        }
        Ok(())
    }
}

/// The columns of the terminal, or what `COLUMNS` says; [`WIDTH`] where stdout is no terminal.
pub(crate) fn room() -> usize {
    let said = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
    let terminal = || Term::stdout().size_checked().map(|(_, columns)| usize::from(columns));
    said.or_else(terminal).unwrap_or(WIDTH)
}
