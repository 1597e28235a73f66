//! The boundaries of a folder.

use std::fs;
use std::path::{Path, PathBuf};

use serde_spanned::Spanned;

use super::segment::segments;
use crate::plan::text_of;
use crate::text::Faults;
use plateau::counted;

/// Most files of a folder, and most bytes of all of them.
const MOST_FILES: usize = 10_000;
const MOST_BYTES: usize = 64 * 1024 * 1024;

/// The tables that make a boundary.
const TABLES: [&str; 4] = ["boundary", "curve", "face", "vertex"];

/// A boundary from another file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    /// Its file without folders and extension.
    pub(super) name: String,
    /// Its file.
    pub(super) file: String,
    /// That file.
    pub(super) text: String,
}

/// Whether a table belongs to the boundary.
pub(super) fn is_of_boundary(table: &str) -> bool {
    TABLES.contains(&table)
}

/// The boundaries of all experiment files in a folder, by their names in alphabetical order.
pub(super) fn frames(faults: &Faults<'_>, named: &Spanned<String>, folder: &Path) -> Option<Vec<Frame>> {
    let path = folder.join(named.get_ref());
    let refuse = |message: String, help: &str| {
        faults.inadmissible(named.span(), message, "this folder", help);
        None
    };
    let files = match files(&path) {
        Ok(files) => files,
        Err(error) => {
            let message = format!("the folder {} cannot be read: {error}", path.display());
            return refuse(message, "name a folder of experiment files, seen from that of this file");
        }
    };
    if files.is_empty() {
        let message = format!("the folder {} holds no experiment file", path.display());
        return refuse(
            message,
            "put experiment files into it (*.toml): their boundaries are the values of the axis",
        );
    }
    if files.len() > MOST_FILES {
        let found = counted(files.len(), "experiment file");
        return refuse(format!("the folder holds {found}"), "take at most 10000");
    }
    let (mut frames, mut bytes) = (Vec::with_capacity(files.len()), 0);
    for file in files {
        let text = match text_of(&file) {
            Ok(text) => text,
            Err(refusal) => {
                let why =
                    refusal.diagnostics().first().map_or(String::new(), |first| first.message().to_owned());
                return refuse(why, "every *.toml in the folder of an axis is an experiment file");
            }
        };
        bytes += text.len();
        if bytes > MOST_BYTES {
            return refuse(
                "the files of the folder are more than 64 MiB together".to_owned(),
                "take fewer files",
            );
        }
        if !segments(&text).iter().any(|segment| is_of_boundary(&segment.table)) {
            let message = format!("{}: there is no [boundary] in it", file.display());
            return refuse(message, "give every file of the folder a boundary, with a header of its own");
        }
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        frames.push(Frame { name, file: file.display().to_string(), text });
    }
    Some(frames)
}

/// The experiment files of a folder, in the order of their names.
fn files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "toml") && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}
