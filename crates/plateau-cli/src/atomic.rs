//! Files that are either whole or not there.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// How the names of files begin that are not whole yet.
const UNFINISHED: &str = ".plateau-";

/// Writes `path` by way of a temporary file in the same folder: whoever looks finds the old file or the new one,
/// whole, also after a crash. Missing folders are made.
///
/// # Errors
/// Whatever the file system says; the old file, if any, is then untouched.
pub(crate) fn write(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut file = BufWriter::new(unfinished(folder)?);
    fill(&mut file)?;
    let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
    file.as_file().sync_all()?;
    let file = file.persist(path)?;
    allow_others_to_read(&file)?;
    // The rename itself is durable only once the folder is.
    File::open(folder).and_then(|folder| folder.sync_all())
}

/// Makes a folder, removes from it what killed writers left, and sees whether files can be made in it.
///
/// # Errors
/// Whatever the file system says.
pub(crate) fn prepare(folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
            // A writer that lives holds the lock; a file that stays is harmless.
            let path = entry.path();
            if File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
                let _ = fs::remove_file(&path);
            }
        }
    }
    unfinished(folder)?.close()
}

fn unfinished(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let file = tempfile::Builder::new().prefix(UNFINISHED).tempfile_in(folder)?;
    // Where the file system has no locks, nothing is ever taken for left behind.
    let _ = file.as_file().try_lock();
    Ok(file)
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
