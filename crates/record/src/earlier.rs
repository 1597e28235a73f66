//! The result of an experiment that was run before.

use std::collections::BTreeSet;
use std::path::Path;

use serde::Deserialize;

use crate::file_name::file_names;
use crate::folder::{RESULT_FILE, folder, folder_name, is_file_of_experiment, surface_file};
use crate::result_reader::own_contents;
use crate::{Manifest, SCHEMA};
use exchange::Format;
use experiment::{Options, Plan, shortfall, stem};

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

impl Earlier {
    /// What is not as the file wants it, in words; none if all is.
    #[must_use]
    pub fn shortfall(&self) -> Option<String> {
        shortfall(self.missed, self.failed)
    }
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
    schema: String,
    #[serde(default)]
    methods: Vec<Named>,
    #[serde(default)]
    files: Vec<FileEntry>,
    manifest: Manifest,
}

#[derive(Deserialize)]
struct Named {
    name: String,
    #[serde(default)]
    files: Vec<FileEntry>,
}

/// The files beside the record in the folder of `plan` that were written with it: those that it names and that this program
/// names so. A record of another experiment, or one that was tampered with, speaks for none.
pub(crate) fn files_of(plan: &Plan, folder: &Path) -> BTreeSet<String> {
    listing(folder)
        .filter(|record| record.schema == SCHEMA && record.manifest.is_intact())
        .filter(|record| folder_name(&stem(&record.manifest.file)) == folder_name(&plan.stem))
        .map(|record| {
            let names = file_names(record.methods.iter().map(|method| method.name.as_str()));
            let of_methods = record.methods.iter().zip(&names).flat_map(|(method, name)| {
                let own = |file: &&FileEntry| Format::ALL.iter().any(|f| file.file == surface_file(name, *f));
                method.files.iter().filter(own)
            });
            let own = |file: &&FileEntry| is_file_of_experiment(&file.file);
            of_methods.chain(record.files.iter().filter(own)).map(|entry| entry.file.clone()).collect()
        })
        .unwrap_or_default()
}

fn listing(folder: &Path) -> Option<Listing> {
    serde_json::from_slice(&own_contents(&folder.join(RESULT_FILE)).ok()?).ok()
}

/// What `out` holds of `plan`: a result with the manifest this program would write, all files it names beside it.
/// Anything else is none: the experiment is to be run.
pub fn earlier(plan: &Plan, options: Options, out: &Path) -> Option<Earlier> {
    let folder = folder(plan, out);
    let json = String::from_utf8(own_contents(&folder.join(RESULT_FILE)).ok()?).ok()?;
    let record: Record = serde_json::from_str(&json).ok()?;
    let same = record.schema == SCHEMA && record.manifest == Manifest::new(plan, options);
    let mut files = record.methods.iter().flat_map(|method| &method.files).chain(&record.files);
    let whole = record.unwritten.is_empty() && files.all(|entry| folder.join(&entry.file).is_file());
    let failed = record.methods.iter().filter(|method| method.error.is_some()).count();
    (same && whole).then_some(Earlier { json, failed, missed: record.missed.len() })
}
