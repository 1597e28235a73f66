//! The record of one cell, as far as it is merged.

use std::path::Path;

use experiment::{Experiment, Plan};
use plateau::{Filling, Quantity};
use record::{Manifest, RESULT_FILE, ReadError, SCHEMA, folder_of, own_contents};
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::outline::CellEntry;

/// What fills pages of a method's record and is no figure of it.
const LARGE: [&str; 8] =
    ["net", "faces", "vertices", "pieces", "domain", "search", "lower_bound_proof", "files"];

/// A cell that is whole.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stored {
    /// What `result.json` says of each method, but for its surface; of its search the minimum alone.
    pub(crate) methods: Vec<Map<String, Value>>,
    /// The numbers of the file that were not met.
    pub(crate) missed: Vec<Value>,
    /// Files that were asked for and are not there.
    pub(crate) unwritten: Vec<String>,
    /// The program and the processor.
    pub(crate) origin: record::Origin,
    /// What its searches minimise scales as this power of a length, if there are any and they agree.
    pub(crate) searched: Option<i32>,
}

#[derive(Deserialize)]
struct Record {
    schema: String,
    methods: Vec<Map<String, Value>>,
    #[serde(default)]
    missed: Vec<Value>,
    #[serde(default)]
    unwritten: Vec<String>,
    manifest: Manifest,
}

/// What a folder has of a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Found {
    Nothing,
    /// Something that is not its result, and why.
    Torn(String),
    Whole(Box<Stored>),
}

/// What the folder of a sweep has of a cell.
pub(crate) fn found(cell: &CellEntry, folder: &Path) -> Found {
    let bytes = match own_contents(&folder_of(&cell.name, folder).join(RESULT_FILE)) {
        Ok(bytes) => bytes,
        Err(ReadError::Io(error)) if error.kind() == std::io::ErrorKind::NotFound => return Found::Nothing,
        Err(error) => return Found::Torn(error.to_string()),
    };
    let record: Record = match serde_json::from_slice(&bytes) {
        Ok(record) => record,
        Err(error) => return Found::Torn(format!("its {RESULT_FILE} is damaged: {error}")),
    };
    let of_another = |what: &str| Found::Torn(format!("its {RESULT_FILE} is of another {what}"));
    if record.schema != SCHEMA {
        return of_another("layout");
    }
    if record.manifest.sha256 != cell.sha256 || !record.manifest.is_intact() {
        return of_another("experiment: the sweep was changed since");
    }
    if record.manifest.seed != cell.seed {
        return of_another("seed");
    }
    let mut methods = record.methods;
    for method in &mut methods {
        let minimum = method.get("search").and_then(|search| search.get("minimum")).cloned();
        method.retain(|key, _| !LARGE.contains(&key.as_str()));
        if let Some(minimum) = minimum {
            method.insert("search".into(), json!({ "minimum": minimum }));
        }
    }
    let searched = methods.iter().any(|method| method.contains_key("search"));
    let searched = searched.then(|| searched_power(&record.manifest)).flatten();
    let (missed, unwritten, origin) = (record.missed, record.unwritten, record.manifest.origin);
    Found::Whole(Box::new(Stored { methods, missed, unwritten, origin, searched }))
}

/// What the searches of an experiment minimise scales as this power of a length; none if they differ.
fn searched_power(manifest: &Manifest) -> Option<i32> {
    let plan = Plan::parse(&manifest.file, &manifest.experiment).ok()?;
    let Experiment::Patch(patch) = plan.experiment else { return None };
    let searched = patch.methods.iter().filter_map(|method| match method.filling() {
        Filling::Tensor { functions, .. } => functions.searched(),
        Filling::Triangle(_) => None,
    });
    let mut powers = searched.map(|(_, _, energy)| Quantity::of_search(energy).power());
    let first = powers.next()?;
    first.filter(|_| powers.all(|power| power == first))
}

impl Stored {
    /// Whether the numbers of both are the same, whatever computed them.
    pub(crate) fn agrees(&self, other: &Self) -> bool {
        self.methods == other.methods && self.missed == other.missed
    }

    /// By this the copies of a cell are put into an order that does not depend on where they were found.
    pub(crate) fn rank(&self) -> (usize, String) {
        (self.unwritten.len(), serde_json::to_string(&self.methods).unwrap_or_default())
    }
}
