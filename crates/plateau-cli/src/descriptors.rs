//! Standard input and output as open files, which the system can tell from others.

use std::fs::File;

/// What stdin reads from, where the system says.
#[cfg(unix)]
pub(crate) fn stdin() -> Option<File> {
    use std::os::fd::AsFd;
    std::io::stdin().as_fd().try_clone_to_owned().ok().map(File::from)
}

/// What stdout writes to, where the system says.
#[cfg(unix)]
pub(crate) fn stdout() -> Option<File> {
    use std::os::fd::AsFd;
    std::io::stdout().as_fd().try_clone_to_owned().ok().map(File::from)
}

#[cfg(not(unix))]
pub(crate) fn stdin() -> Option<File> {
    None
}

#[cfg(not(unix))]
pub(crate) fn stdout() -> Option<File> {
    None
}
