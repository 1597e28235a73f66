//! The bytes of a `result.json`, and why they cannot be read.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use thiserror::Error;

use crate::SCHEMA;
use crate::atomic::regular;
use crate::result::Unfit;
use crate::result_size::{Excess, MAX_TABLES, MAX_VALUES, excess};

/// Largest size in bytes of a result file.
const LARGEST_FILE: u64 = 64 * 1024 * 1024;

/// Why a result could not be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file system.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// Too large to be one.
    #[error("is larger than {} MiB, the most that is read of a result", LARGEST_FILE >> 20)]
    TooLarge,
    /// More than fits into a reasonable amount of memory.
    #[error("holds more than {most} {what}, the most that is read of a result")]
    TooMuch {
        /// The limit.
        most: usize,
        /// What there is too much of.
        what: &'static str,
    },
    /// A folder.
    #[error("is a folder: name the result.json in it")]
    Folder,
    /// No JSON, or a value of the wrong kind.
    #[error("{place}{source}; this should be a result.json of `plateau run`")]
    Json {
        /// The key and a colon, or nothing.
        place: String,
        /// What was found, and what was expected.
        source: serde_json::Error,
    },
    /// Another layout.
    #[error("`schema` is {found:?}, this program reads {SCHEMA:?}")]
    Schema {
        /// What the file says.
        found: String,
    },
    /// A key that is needed.
    #[error("`{key}` is missing: results of early versions lack it; run the experiment again to have it")]
    Missing {
        /// The key, from the root.
        key: String,
    },
    /// A value that does not fit.
    #[error("`{key}`: {why}")]
    Unfit {
        /// The key, from the root.
        key: String,
        /// What is wrong with it.
        why: String,
    },
}

impl From<Unfit> for ReadError {
    fn from(unfit: Unfit) -> Self {
        match unfit {
            Unfit::Missing(key) => Self::Missing { key },
            Unfit::Value { key, why } => Self::Unfit { key, why },
        }
    }
}

/// The bytes of a result in a folder of this program. What is no regular file there is none of ours: a pipe would keep its
/// reader waiting.
///
/// # Errors
/// [`ReadError`]: what the file system says, or that it is too large to be one.
pub fn own_contents(path: &Path) -> Result<Vec<u8>, ReadError> {
    match regular(path) {
        Some(_) => contents(path),
        None => Err(io::Error::from(ErrorKind::NotFound).into()),
    }
}

/// The bytes of a file that may be a result, or of a pipe, where a person named one.
pub(crate) fn contents(path: &Path) -> Result<Vec<u8>, ReadError> {
    if path.is_dir() {
        return Err(ReadError::Folder);
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(LARGEST_FILE + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(ReadError::TooLarge);
    }
    check_size(&bytes)?;
    Ok(bytes)
}

/// Refuses a text that would take many times its length, before it is parsed.
pub(crate) fn check_size(bytes: &[u8]) -> Result<(), ReadError> {
    match excess(bytes) {
        None => Ok(()),
        Some(Excess::Values) => Err(ReadError::TooMuch { most: MAX_VALUES, what: "values" }),
        Some(Excess::Tables) => Err(ReadError::TooMuch { most: MAX_TABLES, what: "tables" }),
    }
}

pub(crate) fn check_schema(found: Option<String>) -> Result<(), ReadError> {
    let found = required(found, "schema")?;
    if found == SCHEMA { Ok(()) } else { Err(ReadError::Schema { found: found.chars().take(80).collect() }) }
}

pub(crate) fn required<T>(value: Option<T>, key: &str) -> Result<T, ReadError> {
    value.ok_or_else(|| ReadError::Missing { key: key.into() })
}
