//! The result of an experiment that was run before.

use std::path::Path;

use serde::Deserialize;

use crate::result_reader::contents;
use crate::{Manifest, Options, Plan, SCHEMA};

/// A whole result in the folder of an experiment: another run would write the same bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Earlier {
    /// The text of `result.json`.
    pub json: String,
    /// How many methods failed.
    pub failed: usize,
    /// How many expected numbers were missed.
    pub missed: usize,
}

#[derive(Deserialize)]
struct Record {
    schema: String,
    methods: Vec<Entry>,
    #[serde(default)]
    files: Vec<FileEntry>,
    #[serde(default)]
    missed: Vec<serde_json::Value>,
    #[serde(default)]
    unwritten: Vec<String>,
    manifest: Manifest,
}

#[derive(Deserialize)]
struct Entry {
    error: Option<String>,
    #[serde(default)]
    files: Vec<FileEntry>,
}

#[derive(Deserialize)]
struct FileEntry {
    file: String,
}

/// As much of a record as says which files were written with it.
#[derive(Deserialize)]
struct Listing {
    #[serde(default)]
    methods: Vec<Entry>,
    #[serde(default)]
    files: Vec<FileEntry>,
}

/// The files that the result in `folder` names beside itself; none if there is no result.
pub(crate) fn files_of(folder: &Path) -> Vec<String> {
    let Ok(json) = contents(&folder.join("result.json")) else { return Vec::new() };
    let Ok(listing) = serde_json::from_slice::<Listing>(&json) else { return Vec::new() };
    let of_methods = listing.methods.into_iter().flat_map(|method| method.files);
    let names = of_methods.chain(listing.files).map(|entry| entry.file);
    // What leads out of the folder is no file of this program.
    names.filter(|name| Path::new(name).file_name().is_some_and(|plain| plain == name.as_str())).collect()
}

/// What `out` holds of `plan`: a result with the manifest this program would write, all files it names beside it.
/// Anything else is none: the experiment is to be run.
pub fn earlier(plan: &Plan, options: Options, out: &Path) -> Option<Earlier> {
    let folder = out.join(&plan.stem);
    let json = String::from_utf8(contents(&folder.join("result.json")).ok()?).ok()?;
    let record: Record = serde_json::from_str(&json).ok()?;
    let same = record.schema == SCHEMA && record.manifest == Manifest::new(plan, options);
    let mut files = record.methods.iter().flat_map(|method| &method.files).chain(&record.files);
    let whole = record.unwritten.is_empty() && files.all(|entry| folder.join(&entry.file).is_file());
    let failed = record.methods.iter().filter(|method| method.error.is_some()).count();
    (same && whole).then_some(Earlier { json, failed, missed: record.missed.len() })
}
