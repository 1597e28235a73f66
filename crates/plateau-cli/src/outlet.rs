//! Standard output that may fail without stopping the work.

use std::io::{self, Write};

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

    /// The first failure, if there was one.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.flush()?;
        self.error.map_or(Ok(()), Err)
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
