//! The folders of all shards, read into one table.

use std::path::{Path, PathBuf};

use record::{Origin, RESULT_FILE, ReadError};
use thiserror::Error;

use crate::merged::{Kept, Lack, Merged};
use crate::outline::{CellEntry, OUTLINE_FILE, Outline};
use crate::stored::{Found, Stored, found};

/// Why there is nothing to merge.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MergeError {
    /// No folder was named.
    #[error("no folder was named")]
    NoFolder,
    /// A folder that no sweep was run into.
    #[error("{}: {why}; name the folder of a sweep, as `plateau run SWEEP.toml` makes it below --out", folder.display())]
    NoSweep {
        /// The folder.
        folder: PathBuf,
        /// What it is instead.
        why: &'static str,
    },
    /// A folder whose outline is damaged.
    #[error(
        "{}: {source}; name the folder of a sweep, as `plateau run SWEEP.toml` makes it below --out",
        folder.join(OUTLINE_FILE).display()
    )]
    Outline {
        /// The folder.
        folder: PathBuf,
        /// What is wrong with it.
        source: ReadError,
    },
    /// Folders of different sweeps.
    #[error("{} and {} are of different sweeps, or of different versions of one", first.display(), second.display())]
    Different {
        /// The folder named first.
        first: PathBuf,
        /// The one that does not go with it.
        second: PathBuf,
    },
}

/// Reads the folders of a sweep's shards into one table. A cell that several of them have is taken once; a cell that none has whole
/// is missing, which the table says. The table does not depend on the order of the folders, nor on which of them has which cells.
///
/// # Errors
/// [`MergeError`], if the folders are not of one sweep.
pub fn merge(folders: &[PathBuf]) -> Result<Merged, MergeError> {
    let read = |folder: &PathBuf| {
        if let Some(why) = no_sweep(folder) {
            return Err(MergeError::NoSweep { folder: folder.clone(), why });
        }
        Outline::read(folder).map_err(|source| MergeError::Outline { folder: folder.clone(), source })
    };
    let first = folders.first().ok_or(MergeError::NoFolder)?;
    let outline = read(first)?;
    for second in &folders[1..] {
        if read(second)? != outline {
            return Err(MergeError::Different { first: first.clone(), second: second.clone() });
        }
    }
    let (mut kept, mut missing, mut differing) = (Vec::new(), Vec::new(), Vec::new());
    let mut origins: Vec<Origin> = Vec::new();
    for (index, cell) in outline.cells.iter().enumerate() {
        match best(cell, folders) {
            Best::Kept { stored, folder, differs } => {
                if differs {
                    differing.push(cell.name.clone());
                }
                if !origins.contains(&stored.origin) {
                    origins.push(stored.origin.clone());
                }
                kept.push(Kept { index, stored: *stored, folder: folder.to_owned() });
            }
            Best::None(why) => missing.push(Lack { name: cell.name.clone(), why }),
        }
    }
    Ok(Merged { outline, kept, missing, differing, origins: origins.len() })
}

/// Why a folder is not that of a sweep, if there is no outline in it.
fn no_sweep(folder: &Path) -> Option<&'static str> {
    if folder.join(OUTLINE_FILE).exists() {
        return None;
    }
    Some(if !folder.exists() {
        "there is no such folder, and no sweep.json in it"
    } else if !folder.is_dir() {
        "is a file: no folder with a sweep.json in it"
    } else if folder.join(RESULT_FILE).exists() {
        "holds the result of one experiment, which needs no merging; there is no sweep.json in it"
    } else {
        "there is no sweep.json in it"
    })
}

/// What the folders have of a cell together.
enum Best<'a> {
    Kept {
        stored: Box<Stored>,
        folder: &'a Path,
        differs: bool,
    },
    /// Nothing, or why what is there is not taken.
    None(Option<String>),
}

fn best<'a>(cell: &CellEntry, folders: &'a [PathBuf]) -> Best<'a> {
    let (mut whole, mut why): (Vec<(Box<Stored>, &Path)>, Option<String>) = (Vec::new(), None);
    for folder in folders {
        match found(cell, folder) {
            Found::Nothing => {}
            Found::Torn(reason) => why = Some(why.map_or(reason.clone(), |other| other.min(reason))),
            Found::Whole(stored) => whole.push((stored, folder)),
        }
    }
    let differs = whole.iter().skip(1).any(|(stored, _)| !stored.agrees(&whole[0].0));
    let least = whole.into_iter().min_by_key(|(stored, _)| stored.rank());
    match least {
        Some((stored, folder)) => Best::Kept { stored, folder, differs },
        None => Best::None(why),
    }
}
