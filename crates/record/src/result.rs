//! `result.json`, the record of an experiment for other programs.

use serde::{Deserialize, Serialize};

use crate::{Manifest, SCHEMA};
use exchange::SurfaceForm;
use experiment::{Finished, Missed, Plan};
use plateau::MethodResult;

mod curve;
mod extremal;
mod faces;
mod figures;
mod file;
mod head;
mod method;
mod mode;
mod net;
mod number;
mod pieces;
mod proof;
mod search;
mod surface;
mod unfit;

use curve::CurveEntry;
use file::FileEntry;
pub(crate) use head::Head;
use method::MethodEntry;
pub(crate) use mode::ModeEntry;
use number::finite;
pub(crate) use surface::SurfaceEntry;
pub(crate) use unfit::Unfit;

/// The whole file. Numbers are written with all their digits; keys without a meaning are left out, and no number
/// that is not finite ever appears.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ResultFile {
    schema: String,
    title: String,
    seed: u64,
    methods: Vec<MethodEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<CurveEntry>,
    /// Of several shapes, instead of `curve`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    curves: Vec<CurveEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
    /// The numbers of the file that were not met.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    missed: Vec<MissedEntry>,
    /// Files beside the record that belong to no method.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    files: Vec<FileEntry>,
    /// Files that were asked for and are not there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    unwritten: Vec<String>,
    manifest: Manifest,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct MissedEntry {
    method: String,
    quantity: String,
    expected: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    found: Option<f64>,
}

impl ResultFile {
    /// The record of an experiment: the plan and what came of it.
    pub fn new(plan: &Plan, finished: &Finished) -> Self {
        let results = &finished.results;
        let methods = results.methods().iter().map(MethodEntry::of).collect();
        Self {
            schema: SCHEMA.to_owned(),
            title: results.title().to_owned(),
            seed: finished.seed,
            methods,
            curve: match results.curves() {
                [curve] => Some(CurveEntry::new(curve)),
                _ => None,
            },
            curves: match results.curves() {
                [_] => Vec::new(),
                curves => curves.iter().map(CurveEntry::new).collect(),
            },
            warnings: results.remarks().iter().map(ToString::to_string).collect(),
            missed: finished.missed().into_iter().map(missed_entry).collect(),
            files: Vec::new(),
            unwritten: Vec::new(),
            manifest: Manifest::of(plan, finished),
        }
    }

    /// Records a file written for method `k` of the record, or for the experiment as a whole.
    pub(crate) fn add_file(&mut self, k: Option<usize>, file: String, form: Option<SurfaceForm>) {
        let (deviation, description) = form.map_or((None, None), |f| (f.deviation, Some(f.description)));
        let entry = FileEntry { file, deviation, description };
        match k {
            None => self.files.push(entry),
            Some(k) => self.methods[k].files.push(entry),
        }
    }

    /// The files written beside the record.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        let of_methods = self.methods.iter().flat_map(|method| &method.files);
        of_methods.chain(&self.files).map(|entry| entry.file.as_str())
    }

    /// Files that were asked for and are not there.
    pub fn unwritten(&self) -> &[String] {
        &self.unwritten
    }

    /// Records a file that was asked for and could not be written.
    pub(crate) fn add_unwritten(&mut self, file: &str) {
        self.unwritten.push(file.to_owned());
    }

    /// The record in the bytes of a `result.json` of this program: what was written, value for value.
    ///
    /// # Errors
    /// [`ReadError`](crate::ReadError), if it is none.
    pub fn parse(bytes: &[u8]) -> Result<Self, crate::ReadError> {
        crate::result_reader::check_size(bytes)?;
        let record: Self = serde_json::from_slice(bytes)
            .map_err(|source| crate::ReadError::Json { place: String::new(), source })?;
        crate::result_reader::check_schema(Some(record.schema.clone()))?;
        Ok(record)
    }

    /// The text of the file: indented JSON with a final line break.
    ///
    /// # Errors
    /// Never in fact: every part of the record has a JSON form.
    pub fn to_json(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }
}

/// What `result.json` says of one method, as JSON.
///
/// # Errors
/// Never in fact: every part of a record has a JSON form.
pub fn method_record(result: &MethodResult) -> serde_json::Result<String> {
    serde_json::to_string(&MethodEntry::of(result))
}

fn missed_entry(missed: Missed) -> MissedEntry {
    MissedEntry {
        method: missed.method,
        quantity: missed.expected.quantity.to_string(),
        expected: missed.expected.text,
        found: missed.ours.and_then(finite),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Keys of results that were written by others, in an order of their own.
    #[test]
    fn keys_of_complexes_are_read_and_written() {
        let method = serde_json::json!({
            "name": "Least area", "patch": "complex", "basis": "bernstein", "area": 2.5, "coons_functional": 3.0,
            "metric_dirichlet": 2.6, "rim_deviation": 1e-9, "kink": { "max": 0.1, "rms": -0.0 }, "jacobian_ratio": 0.25,
            "area_estimate": 1e-4, "lower_bound": 2.4, "spanned_one_by_one": 5.0,
            "faces": [{ "vertices": ["a", "b", "c", "d"], "net": [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.1]], [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]] }],
        });
        let entry: MethodEntry = serde_json::from_value(method.clone()).unwrap();
        assert!(entry.surface.faces.is_some() && entry.kink.is_some());
        assert_eq!(serde_json::to_value(&entry).unwrap(), method);
        let failed = serde_json::json!({ "name": "x", "error": "y" });
        let entry: MethodEntry = serde_json::from_value(failed.clone()).unwrap();
        assert_eq!(entry.head.error.as_deref(), Some("y"));
        assert_eq!(serde_json::to_value(&entry).unwrap(), failed);
    }
}
