//! Files that are either whole or not there.

use std::ffi::OsStr;
use std::fs::{self, File, Metadata, TryLockError};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::Path;

/// How the names of files begin that are not whole yet.
const UNFINISHED: &str = ".plateau-";

/// How many letters and digits follow that, drawn at random.
const DRAWN: usize = 6;

/// Writes `path` by way of a temporary file in the same folder: whoever looks finds the old file or the new one,
/// whole, also after a crash. Missing folders are made. A file that is replaced passes its permissions on.
///
/// # Errors
/// Whatever the file system says; the old file, if any, is then untouched.
pub(crate) fn write(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let folder = folder_of(path);
    fs::create_dir_all(folder)?;
    let mut file = BufWriter::new(unfinished(folder)?);
    fill(&mut file)?;
    let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let Some(old) = regular(path) {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(path)?;
    // The rename itself is durable only once the folder is; elsewhere folders cannot be opened.
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

/// What the file system says of a regular file under its own name. Whatever else stands in a folder of ours was put there by
/// others: to open a pipe is to wait for its other end, and a link leads out of the folder.
pub(crate) fn regular(path: &Path) -> Option<Metadata> {
    fs::symlink_metadata(path).ok().filter(Metadata::is_file)
}

/// A folder that this process alone writes to: other processes that want it are refused, until this is dropped or the
/// process ends, however it ends. Where folders cannot be locked, nobody is.
#[derive(Debug)]
#[must_use = "the folder is anyone's again as soon as this is dropped"]
pub struct Claim(#[allow(dead_code, reason = "held for its lock")] Option<File>);

impl Claim {
    fn of(folder: &Path) -> io::Result<Self> {
        let Ok(handle) = File::open(folder) else { return Ok(Self(None)) };
        match handle.try_lock() {
            Ok(()) => Ok(Self(Some(handle))),
            Err(TryLockError::Error(_)) => Ok(Self(None)),
            Err(TryLockError::WouldBlock) => {
                Err(io::Error::new(ErrorKind::ResourceBusy, "another run is writing to this folder"))
            }
        }
    }
}

/// Makes a folder, claims it, removes from it what killed writers left, and sees whether files can be made in it.
///
/// # Errors
/// Whatever the file system says; [`ErrorKind::ResourceBusy`] if another process has claimed the folder.
pub(crate) fn prepare(folder: &Path) -> io::Result<Claim> {
    fs::create_dir_all(folder)?;
    let claim = Claim::of(folder)?;
    clean(folder)?;
    unfinished(folder)?.close()?;
    Ok(claim)
}

fn clean(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if is_unfinished(&entry.file_name()) && regular(&path).is_some() {
            // A writer that lives holds the lock; a file that stays is harmless.
            if let Ok(file) = File::open(&path)
                && file.try_lock().is_ok()
            {
                // Removed under the lock, so that its writer cannot get that meanwhile.
                let _ = fs::remove_file(&path);
            }
        }
    }
    Ok(())
}

/// Whether [`unfinished`] can have given a file this name.
fn is_unfinished(name: &OsStr) -> bool {
    let drawn = name.to_str().and_then(|name| name.strip_prefix(UNFINISHED));
    drawn.is_some_and(|drawn| drawn.len() == DRAWN && drawn.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

fn unfinished(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(UNFINISHED).rand_bytes(DRAWN);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Temporary files are private; results are as the user's mask wants them.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    loop {
        let file = builder.tempfile_in(folder)?;
        match file.as_file().try_lock() {
            // Somebody who cleans came before the lock, and takes the file for left behind.
            Ok(()) if !file.path().exists() => {}
            Err(TryLockError::WouldBlock) => {}
            // Where the file system has no locks, nothing is ever taken for left behind.
            Ok(()) | Err(TryLockError::Error(_)) => return Ok(file),
        }
    }
}

pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

    use super::*;

    #[test]
    fn cleaning_takes_no_file_from_a_writer() {
        let folder = tempfile::tempdir().unwrap();
        let done = AtomicBool::new(false);
        std::thread::scope(|scope| {
            for _ in 0..2 {
                scope.spawn(|| {
                    while !done.load(Relaxed) {
                        clean(folder.path()).unwrap();
                    }
                });
            }
            // A failure must end the cleaners, too.
            let written: io::Result<Vec<()>> = (0..2000)
                .map(|k| {
                    let file = unfinished(folder.path())?;
                    file.persist(folder.path().join(format!("{}", k % 3)))?;
                    Ok(())
                })
                .collect();
            done.store(true, Relaxed);
            assert!(written.is_ok(), "{written:?}");
        });
    }

    #[test]
    fn cleaning_takes_what_killed_writers_left_and_no_other_file() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let of_others = [
            ".plateau-notes-2026",
            ".plateau-mine.tex",
            ".plateau-a.b.cd",
            ".plateau-1",
            ".plateau-",
            ".plateau-été1",
            "x.plateau-ORQySU",
            ".Plateau-ORQySU",
        ];
        for name in of_others {
            fs::write(at(name), "mine").unwrap();
        }
        fs::create_dir(at(".plateau-folder")).unwrap();
        // As a writer leaves it that is killed: never renamed, never removed.
        let left = unfinished(folder.path()).unwrap().into_temp_path().keep().unwrap();
        clean(folder.path()).unwrap();
        assert!(!left.exists(), "{}", left.display());
        assert!(of_others.iter().all(|name| at(name).exists()) && at(".plateau-folder").is_dir());
    }

    #[test]
    fn a_folder_is_claimed_by_one_at_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let claim = prepare(folder.path()).unwrap();
        assert_eq!(prepare(folder.path()).unwrap_err().kind(), ErrorKind::ResourceBusy);
        drop(claim);
        let _again = prepare(folder.path()).unwrap();
        // Files are written whoever holds the claim.
        write(&folder.path().join("x"), |out| out.write_all(b"x")).unwrap();
    }
}
