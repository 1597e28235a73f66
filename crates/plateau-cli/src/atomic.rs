//! Files that are either whole or not there.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes `path` by way of a temporary file in the same folder: whoever looks finds the old file or the new one,
/// whole, also after a crash. Missing folders are made.
///
/// # Errors
/// Whatever the file system says; the old file, if any, is then untouched.
pub(crate) fn write(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut file = BufWriter::new(tempfile::Builder::new().prefix(".plateau-").tempfile_in(folder)?);
    fill(&mut file)?;
    let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
    file.as_file().sync_all()?;
    let file = file.persist(path)?;
    allow_others_to_read(&file)?;
    // The rename itself is durable only once the folder is.
    File::open(folder).and_then(|folder| folder.sync_all())
}

#[cfg(unix)]
fn allow_others_to_read(file: &File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    // Temporary files are private; results are not.
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn allow_others_to_read(_: &File) -> io::Result<()> {
    Ok(())
}
