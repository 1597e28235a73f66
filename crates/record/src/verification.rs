//! A result computed again and compared.

use std::path::Path;

use serde::Serialize;
use serde_json::Value;
use thiserror::Error;

use crate::export::{Named, rehearse};
use crate::folder::surface_file;
use crate::result_reader::{check_schema, check_size, contents, required};
use crate::{ExportError, Manifest, Origin, ReadError, ResultFile};
use experiment::{Finished, Options, Plan, Refusal, run};
use plateau::{Arithmetic, MethodError, Progress};

mod compare;
mod difference;
mod mode;
mod report;

pub use difference::{Difference, Level, Verified};

use compare::{bits, figures};

/// What came of computing a result again.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Verification {
    /// The title of the experiment.
    pub title: String,
    /// How closely the two were compared.
    #[serde(flatten)]
    pub level: Level,
    /// One entry per method, or one for the curve; and one for the record around them.
    pub entries: Vec<Verified>,
}

/// Why a result cannot be computed again.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// It is not a result, or an early one that does not hold its experiment.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// This program does not take its experiment.
    #[error("the experiment in it is refused by this version:\n{}", .0.render(false))]
    Refused(Box<Refusal>),
    /// The curve of a curve experiment, of which every result has one.
    #[error("the experiment in it cannot be computed: {0}")]
    Failed(#[from] MethodError),
    /// The caller wanted no more.
    #[error("interrupted")]
    Interrupted,
}

impl Verification {
    /// Whether the two agree as closely as they were compared.
    pub fn agrees(&self) -> bool {
        self.entries.iter().all(|entry| entry.differences.is_empty())
    }
}

/// Runs the experiment of a `result.json` again, with its seed and arithmetic, and compares.
///
/// # Errors
/// [`VerifyError`], if there is nothing to compare; a difference is none.
pub fn verify(path: &Path, progress: &dyn Progress) -> Result<Verification, VerifyError> {
    verify_text(&result_text(path)?, progress)
}

/// The text of a `result.json`, at most 64 MiB, of a file or of what another program writes into a pipe.
///
/// # Errors
/// [`ReadError`] for what cannot be read, or holds more than a result does.
pub fn result_text(path: &Path) -> Result<Vec<u8>, ReadError> {
    contents(path)
}

/// As [`verify`], of the text of a result.
///
/// # Errors
/// As [`verify`].
pub fn verify_text(text: &[u8], progress: &dyn Progress) -> Result<Verification, VerifyError> {
    let json = |source| ReadError::Json { place: String::new(), source };
    check_size(text)?;
    let mut stored: Value = serde_json::from_slice(text).map_err(json)?;
    check_schema(stored.get("schema").and_then(Value::as_str).map(str::to_owned))?;
    let manifest = required(stored.get_mut("manifest").map(Value::take), "manifest")?;
    let manifest: Manifest = serde_json::from_value(manifest)
        .map_err(|source| ReadError::Json { place: "`manifest`: ".into(), source })?;
    let plan = Plan::parse(&manifest.file, &manifest.experiment)
        .map_err(|refusal| VerifyError::Refused(Box::new(refusal)))?;
    let because = manifest.origin.differences(&Origin::here());
    let options = Options { seed: Some(manifest.seed), arithmetic: arithmetic(&manifest) };
    let finished = run(&plan, options, progress)?;
    if progress.cancelled() {
        return Err(VerifyError::Interrupted);
    }
    let computed = serde_json::to_value(record(&plan, &finished, stored.get("unwritten"))).map_err(json)?;
    let level = if because.is_empty() { Level::Bits } else { Level::Figures { because } };
    let mut entries = entries(&mut stored, computed, &level);
    if !manifest.is_intact() {
        let difference = Difference {
            key: "manifest.sha256".into(),
            stored: Some(manifest.sha256.clone()),
            computed: Some(Manifest::new(&plan, options).sha256),
        };
        let (name, differences) = ("manifest".into(), vec![difference]);
        entries.push(Verified { name, compared: 1, differences, differs_in_bits_only: false, slides: false });
    }
    Ok(Verification { title: plan.title.clone(), level, entries })
}

/// The arithmetic of the result; where this processor does not have it, the one it has.
fn arithmetic(manifest: &Manifest) -> Arithmetic {
    let lacks_fma = !Origin::here().cpu_features.iter().any(|feature| feature == "fma");
    if manifest.arithmetic == Arithmetic::Fma && lacks_fma { Arithmetic::Auto } else { manifest.arithmetic }
}

/// The record as it would be delivered without the files that `unwritten` names, nothing written.
fn record(plan: &Plan, finished: &Finished, unwritten: Option<&Value>) -> ResultFile {
    let unwritten = unwritten.and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let mut record = ResultFile::new(plan, finished);
    let names =
        crate::file_name::file_names(finished.results.methods().iter().map(|method| method.name.as_str()));
    for (k, (method, name)) in finished.results.methods().iter().zip(&names).enumerate() {
        let Ok(done) = &method.outcome else { continue };
        for &format in &plan.output.formats {
            let (surface, family) = (done.solved.surface(), done.solved.family());
            let named = Named { name: &method.name, surface, family, mesh: &done.mesh };
            let file = surface_file(name, format);
            if unwritten.iter().any(|name| name.as_str() == Some(&file)) {
                continue;
            }
            match rehearse(format, named, plan.output.step) {
                Ok(form) => record.add_file(Some(k), file, form),
                Err(ExportError::Refused { .. } | ExportError::Failed(_)) => record.add_unwritten(&file),
            }
        }
    }
    record
}

/// Both records taken apart and compared.
fn entries(stored: &mut Value, mut computed: Value, level: &Level) -> Vec<Verified> {
    let mut entries = Vec::new();
    let [theirs, ours] = [&mut *stored, &mut computed].map(|record| {
        let methods = record.get_mut("methods").map(Value::take);
        methods.and_then(|methods| methods.as_array().cloned())
    });
    let (theirs, ours) = (theirs.unwrap_or_default(), ours.unwrap_or_default());
    for k in 0..theirs.len().max(ours.len()) {
        let [theirs, ours] = [&theirs, &ours].map(|methods| methods.get(k).unwrap_or(&Value::Null));
        let name = |method: &Value| method.get("name").and_then(Value::as_str).map(str::to_owned);
        let name = name(ours).or(name(theirs)).unwrap_or_else(|| format!("methods[{k}]"));
        let mut entry = compared(name, theirs, ours, level, figures);
        if *level != Level::Bits && theirs.pointer("/area_extremal/mode").is_some() {
            entry.compared += 1;
            entry.differences.extend(mode::contradiction(theirs));
        }
        entries.push(entry);
    }
    let [theirs, ours] = [&mut *stored, &mut computed].map(|r| r.get_mut("curve").map(Value::take));
    if theirs.is_some() || ours.is_some() {
        let [theirs, ours] = [theirs, ours].map(Option::unwrap_or_default);
        entries.push(compared("curve".into(), &theirs, &ours, level, compare::curve));
    }
    let [theirs, ours] =
        [&mut *stored, &mut computed].map(|record| match record.get_mut("curves").map(Value::take) {
            Some(Value::Array(curves)) => curves,
            Some(other) => vec![other],
            None => Vec::new(),
        });
    for k in 0..theirs.len().max(ours.len()) {
        let [theirs, ours] = [&theirs, &ours].map(|curves| curves.get(k).unwrap_or(&Value::Null));
        entries.push(compared(format!("curve {}", k + 1), theirs, ours, level, compare::curve));
    }
    for record in [&mut *stored, &mut computed] {
        if let Some(record) = record.as_object_mut() {
            // The manifest has been used up; what was written and what could not be says nothing of the numbers.
            record.retain(|key, _| {
                !["manifest", "methods", "curve", "curves", "files", "unwritten"].contains(&key.as_str())
            });
            if *level != Level::Bits {
                record.retain(|key, _| ["title", "seed"].contains(&key.as_str()));
            }
        }
    }
    entries.push(bits(stored, &computed).named("record".into(), false));
    entries
}

/// One entry on the level asked for; where bits differ, whether the figures do, too.
fn compared(
    name: String,
    stored: &Value,
    computed: &Value,
    level: &Level,
    figures: fn(&Value, &Value) -> compare::Comparison,
) -> Verified {
    match level {
        Level::Figures { .. } => figures(stored, computed).named(name, false),
        Level::Bits => {
            let bits = bits(stored, computed);
            let figures = (!bits.agrees()).then(|| figures(stored, computed));
            let only = figures.as_ref().is_some_and(compare::Comparison::agrees);
            let slides = figures.is_some_and(|figures| figures.slides);
            Verified { slides, ..bits.named(name, only) }
        }
    }
}
