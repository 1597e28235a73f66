//! Where a file goes that a person named: what stands there decides how it is written.

use std::fs::{self, File, Metadata};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::atomic::{self, folder_of};

/// Most symbolic links that are followed one after another, as Linux does.
const MOST_LINKS: usize = 40;

/// A place for a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Destination {
    named: PathBuf,
    kind: Kind,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Kind {
    /// A regular file, or nothing as yet: there is a whole file there, the old one or the new one, at any time.
    File(PathBuf),
    /// A pipe, a terminal, another device or an open file of this process: it cannot be replaced, only written to.
    Stream(PathBuf),
}

impl Destination {
    /// The place that a person named, at the end of all symbolic links.
    ///
    /// # Errors
    /// [`ErrorKind::IsADirectory`] for a folder; else what the file system says.
    pub fn named(path: &Path) -> io::Result<Self> {
        let named = path.to_owned();
        let mut path = named.clone();
        for _ in 0..=MOST_LINKS {
            let folder = folder_of(&path);
            // Links to open files lead to names that need not exist, or not to the same file any more.
            if lists_open_files(folder) {
                return Ok(Self { named, kind: Kind::Stream(path) });
            }
            let kind = match fs::symlink_metadata(&path) {
                Ok(found) if found.is_symlink() => {
                    path = folder.join(fs::read_link(&path)?);
                    continue;
                }
                Ok(found) if found.is_dir() => return Err(ErrorKind::IsADirectory.into()),
                Ok(found) if !found.is_file() => Kind::Stream(path),
                Ok(_) => Kind::File(path),
                Err(error) if error.kind() == ErrorKind::NotFound => Kind::File(path),
                Err(error) => return Err(error),
            };
            return Ok(Self { named, kind });
        }
        Err(io::Error::other("its symbolic links lead to one another"))
    }

    /// A file in a folder of this program: whatever stands there under this name is replaced, links are not followed.
    pub fn own(path: PathBuf) -> Self {
        Self { named: path.clone(), kind: Kind::File(path) }
    }

    /// The path as it was named.
    pub fn path(&self) -> &Path {
        &self.named
    }

    /// Whether what is written goes to a reader at once, who has it from then on.
    pub fn is_stream(&self) -> bool {
        matches!(self.kind, Kind::Stream(_))
    }

    /// Whether writing here would replace `input`, under whatever name.
    pub fn replaces(&self, input: &Path) -> bool {
        let Kind::File(path) = &self.kind else { return false };
        match (fs::metadata(path), fs::metadata(input)) {
            (Ok(output), Ok(found)) => is_same((path, &output), (input, &found)),
            (Ok(_) | Err(_), Ok(_) | Err(_)) => false,
        }
    }

    /// Whether writing here would replace the file that is open as `input`, where the system says which file that is.
    pub fn replaces_open(&self, input: &File) -> bool {
        matches!(self.kind, Kind::File(_)) && self.is_open_as(input)
    }

    /// Whether what is open as `file` stands here, under whatever name, where the system says so.
    pub fn is_open_as(&self, file: &File) -> bool {
        let (Kind::File(path) | Kind::Stream(path)) = &self.kind;
        match (fs::metadata(path), file.metadata()) {
            (Ok(here), Ok(open)) => is_same_open(&here, &open),
            (Ok(_) | Err(_), Ok(_) | Err(_)) => false,
        }
    }

    /// Writes what `fill` writes: a file whole or not at all, a stream as it comes.
    ///
    /// # Errors
    /// What the file system says, or `fill`.
    pub(crate) fn write(&self, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        match &self.kind {
            Kind::File(path) => atomic::write(path, fill),
            Kind::Stream(path) => {
                // An open file may hold something already: it is added to.
                let mut out = BufWriter::new(File::options().append(true).open(path)?);
                fill(&mut out)?;
                out.flush()
            }
        }
    }
}

/// Whether the names in a folder stand for the open files of a process, as `/dev/stdout` does at the end of its links.
fn lists_open_files(folder: &Path) -> bool {
    cfg!(unix)
        && fs::canonicalize(folder)
            .is_ok_and(|folder| folder.starts_with("/proc") || folder == Path::new("/dev/fd"))
}

#[cfg(unix)]
fn is_same((_, a): (&Path, &Metadata), (_, b): (&Path, &Metadata)) -> bool {
    is_same_open(a, b)
}

#[cfg(unix)]
fn is_same_open(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn is_same_open(_: &Metadata, _: &Metadata) -> bool {
    false
}

#[cfg(not(unix))]
fn is_same((a, _): (&Path, &Metadata), (b, _): (&Path, &Metadata)) -> bool {
    fs::canonicalize(a).ok().zip(fs::canonicalize(b).ok()).is_some_and(|(a, b)| a == b)
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    use super::*;

    fn mode(path: &Path) -> u32 {
        fs::symlink_metadata(path).unwrap().permissions().mode() & 0o777
    }

    fn put(path: &Path, text: &str) {
        Destination::named(path).unwrap().write(|out| out.write_all(text.as_bytes())).unwrap();
    }

    #[test]
    fn links_are_followed_and_modes_kept() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("deep")).unwrap();
        fs::write(at("deep/target"), "old").unwrap();
        fs::set_permissions(at("deep/target"), fs::Permissions::from_mode(0o600)).unwrap();
        symlink("deep/target", at("link")).unwrap();
        symlink("link", at("link-to-link")).unwrap();
        put(&at("link-to-link"), "new");
        assert_eq!(fs::read_to_string(at("deep/target")).unwrap(), "new");
        assert_eq!(mode(&at("deep/target")), 0o600);
        assert!(fs::symlink_metadata(at("link")).unwrap().is_symlink());
        // A link may lead to what is not there as yet, or in a circle.
        symlink("deep/made", at("dangling")).unwrap();
        put(&at("dangling"), "made");
        assert_eq!(fs::read_to_string(at("deep/made")).unwrap(), "made");
        symlink("b", at("a")).unwrap();
        symlink("a", at("b")).unwrap();
        assert!(Destination::named(&at("a")).is_err());
        assert_eq!(Destination::named(&at("deep")).unwrap_err().kind(), ErrorKind::IsADirectory);
    }

    #[test]
    fn pipes_and_devices_are_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let read = std::thread::scope(|scope| {
            let reader = scope.spawn(|| fs::read_to_string(&pipe).unwrap());
            put(&pipe, "through");
            reader.join().unwrap()
        });
        assert_eq!(read, "through");
        put(Path::new("/dev/null"), "gone");
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
        assert!(Destination::named(Path::new("/dev/stdout")).unwrap().is_stream());
    }

    #[test]
    fn a_file_is_known_by_any_of_its_names() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("input"), "x").unwrap();
        symlink("input", at("link")).unwrap();
        fs::hard_link(at("input"), at("hard")).unwrap();
        fs::write(at("other"), "x").unwrap();
        for (name, same) in
            [("input", true), ("link", true), ("hard", true), ("other", false), ("none", false)]
        {
            assert_eq!(Destination::named(&at(name)).unwrap().replaces(&at("input")), same, "{name}");
        }
    }
}
