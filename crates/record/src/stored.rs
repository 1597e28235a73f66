//! The surfaces of a `result.json`, bit for bit.

use std::path::Path;

use exchange::{Format, LengthUnit, StepForm, SurfaceForm};
use experiment::Plan;
use plateau::{Family, MethodResult, Surface};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use surfaces::Mesh;

use crate::export::{self, Named};
use crate::file_name::file_names;
use crate::result::{Head, SurfaceEntry};
use crate::result_reader::{check_schema, check_size, contents, required};
use crate::{Destination, ExportError, Manifest, ReadError};

/// The surfaces of a result.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct StoredResult {
    /// The title of the experiment.
    pub title: String,
    /// Its methods, in the order of the file.
    pub methods: Vec<StoredMethod>,
    /// What its numbers are, if its experiment says so.
    pub unit: Option<LengthUnit>,
}

/// A method of a result.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct StoredMethod {
    /// The name of the row.
    pub name: String,
    /// A name for files of it, distinct from those of the other methods.
    pub file_name: String,
    /// Its surface and what that is made of, or the error with which the method failed.
    pub surface: Result<(Surface, Family), String>,
}

/// The keys of a record that are read before its methods; each of these by its own [`Head`] and [`SurfaceEntry`], so that other
/// versions may write whatever else they know.
#[derive(Deserialize)]
struct Cover {
    schema: Option<String>,
    title: Option<String>,
    methods: Option<Vec<Value>>,
    manifest: Option<Value>,
}

/// What the experiment in a manifest says of the unit of its numbers; none where this version cannot read either.
fn unit(manifest: Option<Value>) -> Option<LengthUnit> {
    let manifest: Manifest = serde_json::from_value(manifest?).ok()?;
    Plan::parse(&manifest.file, &manifest.experiment).ok()?.output.step.unit
}

impl StoredResult {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ReadError`]; the file itself is not named in it.
    pub fn read(path: &Path) -> Result<Self, ReadError> {
        Self::parse(&contents(path)?)
    }

    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn parse(bytes: &[u8]) -> Result<Self, ReadError> {
        check_size(bytes)?;
        let cover: Cover = serde_json::from_slice(bytes)
            .map_err(|source| ReadError::Json { place: String::new(), source })?;
        check_schema(cover.schema)?;
        let title = required(cover.title, "title")?;
        let mut methods = Vec::new();
        for (k, entry) in required(cover.methods, "methods")?.into_iter().enumerate() {
            methods.push(method(entry, &format!("methods[{k}]"))?);
        }
        let files = file_names(methods.iter().map(|(name, _)| name.as_str()));
        let stored = methods.into_iter().zip(files);
        let stored =
            stored.map(|((name, surface), file_name)| StoredMethod { name, file_name, surface }).collect();
        Ok(Self { title, methods: stored, unit: unit(cover.manifest) })
    }
}

/// A surface and what it is made of, or the error with which its method failed.
type Made = Result<(Surface, Family), String>;

/// The name of a method and what it made.
pub(crate) fn method(entry: Value, place: &str) -> Result<(String, Made), ReadError> {
    let key = |name: &str| format!("{place}.{name}");
    let head: Head = typed(&entry, place)?;
    let name = required(head.name, &key("name"))?;
    if let Some(error) = head.error {
        return Ok((name, Err(error)));
    }
    let (patch, basis) = (required(head.patch, &key("patch"))?, required(head.basis, &key("basis"))?);
    let family = Family::named(&patch, &basis).ok_or_else(|| {
        let known: Vec<String> = Family::all()
            .map(|family| format!("{:?} with {:?}", family.names().0, family.names().1))
            .collect();
        let why = format!("{patch:?} with basis {basis:?} is not known; surfaces are {}", known.join(", "));
        ReadError::Unfit { key: key("patch"), why }
    })?;
    let surface = typed::<SurfaceEntry>(&entry, place)?.surface(family, place)?;
    Ok((name, Ok((surface, family))))
}

/// What is read of an entry; an error says at which key within it.
fn typed<T: DeserializeOwned>(entry: &Value, place: &str) -> Result<T, ReadError> {
    serde_path_to_error::deserialize(entry).map_err(|error| {
        let within = error.path().to_string();
        let place = if within == "." { place.to_owned() } else { format!("{place}.{within}") };
        ReadError::Json { place: format!("`{place}`: "), source: error.into_inner() }
    })
}

impl StoredMethod {
    /// A method that was just run, as it would be read back.
    #[must_use]
    pub fn of(result: &MethodResult) -> Self {
        let surface =
            result.outcome.as_ref().map(|done| (done.solved.surface().clone(), done.solved.family()));
        let file_name = file_names(std::iter::once(result.name.as_str())).swap_remove(0);
        Self { name: result.name.clone(), file_name, surface: surface.map_err(ToString::to_string) }
    }

    /// Writes the surface as a file, whole or not at all: a mesh with `subdivisions` per side, or, for formats that hold a
    /// surface by a formula, that within `tolerance` times its size. In the latter case, what the file holds.
    ///
    /// # Errors
    /// [`ExportError::Refused`] if the method failed or the format cannot hold the surface, else the file system's.
    pub fn export(
        &self,
        format: Format,
        subdivisions: usize,
        step: impl Into<StepForm>,
        to: &Destination,
    ) -> Result<Option<SurfaceForm>, ExportError> {
        let (surface, family) = self.surface.as_ref().map_err(|error| ExportError::Refused {
            path: to.path().to_owned(),
            reason: format!("the method failed: {error}"),
        })?;
        let mesh = if format.holds_a_mesh() {
            surface.mesh(subdivisions).map_err(|error| ExportError::Refused {
                path: to.path().to_owned(),
                reason: error.to_string(),
            })?
        } else {
            Mesh::default()
        };
        export::write(
            format,
            Named { name: &self.name, surface, family: *family, mesh: &mesh },
            step.into(),
            to,
        )
    }
}
