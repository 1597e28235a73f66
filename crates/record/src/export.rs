//! Surfaces as files, whole or not at all.

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use exchange::{Colours, Format, LengthUnit, StepForm, Subject, SurfaceFile, SurfaceForm, Unfit};
use plateau::{Family, Surface};
use show::by_mean_curvature;
use surfaces::{Complex, Mesh};
use thiserror::Error;

use crate::Destination;

/// A result that could not be kept.
#[derive(Debug, Error)]
#[error("{}: {source}", path.display())]
pub struct DeliverError {
    /// The file that could not be written.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

/// Why a file was not written.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The format cannot hold this surface.
    #[error("{}: not written: {reason}", path.display())]
    Refused {
        /// The file.
        path: PathBuf,
        /// Why, and what to do.
        reason: String,
    },
    /// The file system.
    #[error(transparent)]
    Failed(#[from] DeliverError),
}

/// A surface with its name, what it is made of, and its mesh.
#[derive(Clone, Copy)]
pub(crate) struct Named<'a> {
    pub(crate) name: &'a str,
    pub(crate) surface: &'a Surface,
    pub(crate) family: Family,
    pub(crate) mesh: &'a Mesh,
}

/// Writes one file. For formats that hold the surface by a formula, what they hold.
///
/// # Errors
/// [`ExportError::Refused`] if the format cannot hold the surface, within the tolerance; else what the file system says.
pub(crate) fn write(
    format: Format,
    named: Named<'_>,
    step: StepForm,
    to: &Destination,
) -> Result<Option<SurfaceForm>, ExportError> {
    encode(format, named, step, to.path(), &|fill| to.write(fill))
}

/// As [`write`], but nothing is written: what the file would hold.
pub(crate) fn rehearse(
    format: Format,
    named: Named<'_>,
    step: StepForm,
) -> Result<Option<SurfaceForm>, ExportError> {
    encode(format, named, step, Path::new(""), &|fill| fill(&mut io::sink()))
}

/// Writes a complex, of which `mesh` is a mesh, in one format. For formats that hold the surface by a formula, what they hold.
///
/// # Errors
/// [`ExportError::Refused`] if the format cannot hold the surface; else what the file system says.
pub fn export_complex(
    format: Format,
    name: &str,
    (complex, mesh): (&Complex, &Mesh),
    unit: Option<LengthUnit>,
    to: &Destination,
) -> Result<Option<SurfaceForm>, ExportError> {
    let coloured = by_mean_curvature(mesh);
    let subject = Subject { name, mesh, colours: colours(coloured.as_ref()), unit };
    let file = SurfaceFile::of_complex(format, subject, complex);
    placed(file, to.path(), &|fill| to.write(fill))
}

/// Writes a text to its place.
///
/// # Errors
/// What the file system says.
pub fn write_text(text: &str, to: &Destination) -> Result<(), DeliverError> {
    to.write(|out| out.write_all(text.as_bytes()))
        .map_err(|source| DeliverError { path: to.path().to_owned(), source })
}

type Fill<'a> = &'a dyn Fn(&mut dyn Write) -> io::Result<()>;

fn encode(
    format: Format,
    Named { name, surface, family, mesh }: Named<'_>,
    step: StepForm,
    path: &Path,
    place: &dyn Fn(Fill<'_>) -> io::Result<()>,
) -> Result<Option<SurfaceForm>, ExportError> {
    let coloured = by_mean_curvature(mesh);
    let subject = Subject { name, mesh, colours: colours(coloured.as_ref()), unit: step.unit };
    placed(SurfaceFile::new(format, subject, (surface, family), step.tolerance), path, place)
}

fn colours(coloured: Option<&(Vec<[u8; 3]>, f64)>) -> Option<Colours<'_>> {
    coloured.map(|(of_vertices, full)| Colours { of_vertices, full: *full })
}

/// Writes a file that can be made to its place.
fn placed(
    file: Result<SurfaceFile<'_>, Unfit>,
    path: &Path,
    place: &dyn Fn(Fill<'_>) -> io::Result<()>,
) -> Result<Option<SurfaceForm>, ExportError> {
    let refused = |reason: String| -> ExportError { ExportError::Refused { path: path.to_owned(), reason } };
    let file = file.map_err(|unfit| refused(unfit.to_string()))?;
    place(&|out| file.write(out)).map_err(|source| {
        // The writers say so of what their format cannot hold.
        if source.kind() == ErrorKind::InvalidData {
            refused(source.to_string())
        } else {
            DeliverError { path: path.to_owned(), source }.into()
        }
    })?;
    Ok(file.form())
}
