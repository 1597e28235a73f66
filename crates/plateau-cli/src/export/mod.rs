//! Meshes and surfaces as files for other programs, one format a file.

mod colour;
pub(crate) mod csv;
pub(crate) mod deformation;
mod glb;
mod obj;
mod ply;
mod spline;
mod step;
mod stl;
mod vtu;

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use surfaces::{Mesh, Point};
use thiserror::Error;

use crate::{DeliverError, Destination, Format};
use plateau::{Family, Surface};
use step::StepFile;

/// Largest distance of a fitted surface from the patch where none is asked for, as a share of the size.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// What an exporter may draw from.
pub(crate) struct Subject<'a> {
    /// A name for the object.
    pub(crate) name: &'a str,
    /// The mesh of the patch.
    pub(crate) mesh: &'a Mesh,
}

/// One file format of meshes.
pub(crate) trait Export {
    /// Writes the whole file.
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()>;
}

/// How a file holds a surface that its format holds by a formula, not by a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceForm {
    /// No point of the file's surface is farther from the point of the patch with the same parameters: the largest
    /// distance measured, times 1.25. None if the surface is the patch itself.
    pub deviation: Option<f64>,
    /// The same in words, with degree and segments.
    pub description: String,
}

/// Why a file was not written.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The format cannot hold this surface.
    #[error("{}: not written: {reason}", path.display())]
    Refused {
        /// The file.
        path: std::path::PathBuf,
        /// Why, and what to do.
        reason: String,
    },
    /// The file system.
    #[error(transparent)]
    Failed(#[from] DeliverError),
}

/// Writes one file. `tolerance` is a share of the size and bounds the distance of a fitted surface from
/// the patch. For formats that hold the surface by a formula, what they hold.
///
/// # Errors
/// [`ExportError::Refused`] if the format cannot hold the surface, within the tolerance; else what the file system says.
pub(crate) fn write(
    format: Format,
    subject: &Subject<'_>,
    (surface, family): (&Surface, Family),
    tolerance: f64,
    to: &Destination,
) -> Result<Option<SurfaceForm>, ExportError> {
    encode(format, subject, (surface, family), tolerance, to.path(), &|fill| to.write(fill))
}

/// As [`write`], but nothing is written: what the file would hold.
pub(crate) fn rehearse(
    format: Format,
    subject: &Subject<'_>,
    solved: (&Surface, Family),
    tolerance: f64,
) -> Result<Option<SurfaceForm>, ExportError> {
    encode(format, subject, solved, tolerance, Path::new(""), &|fill| fill(&mut io::sink()))
}

type Fill<'a> = &'a dyn Fn(&mut dyn Write) -> io::Result<()>;

fn encode(
    format: Format,
    subject: &Subject<'_>,
    (surface, family): (&Surface, Family),
    tolerance: f64,
    path: &Path,
    place: &dyn Fn(Fill<'_>) -> io::Result<()>,
) -> Result<Option<SurfaceForm>, ExportError> {
    let refused = |reason: String| -> ExportError { ExportError::Refused { path: path.to_owned(), reason } };
    let put = |fill: Fill<'_>| {
        place(fill).map_err(|source| match source.kind() {
            // The writers say so of what their format cannot hold.
            ErrorKind::InvalidData => refused(source.to_string()),
            _ => DeliverError { path: path.to_owned(), source }.into(),
        })
    };
    let exporter: &dyn Export = match format {
        Format::Obj => &obj::Obj,
        Format::Ply => &ply::Ply,
        Format::Stl => &stl::Stl,
        Format::Glb => &glb::Glb,
        Format::Vtu => &vtu::Vtu,
        Format::Step => {
            let file =
                StepFile::new(surface, family, tolerance).map_err(|error| refused(error.to_string()))?;
            put(&|out| file.write(subject.name, out))?;
            return Ok(Some(SurfaceForm { deviation: file.deviation(), description: file.description() }));
        }
    };
    put(&|out| exporter.write(subject, out))?;
    Ok(None)
}

/// Whether single precision holds points: none overflows, and the box around them keeps its size.
fn fits_single(points: &[Point]) -> bool {
    const HALF_OF_THE_DIGITS: f64 = 4096.0;
    let extent = diagonal(points.iter().map(|&p| p.into()));
    let largest = points.iter().flat_map(|&p| <[f64; 3]>::from(p)).fold(0.0, |m: f64, x| m.max(x.abs()));
    largest <= f64::from(f32::MAX)
        && (extent == 0.0 || extent >= HALF_OF_THE_DIGITS * f64::from(f32::MIN_POSITIVE))
}

/// The diagonal of the least box around points.
pub(crate) fn diagonal(points: impl Iterator<Item = [f64; 3]>) -> f64 {
    let [low, high] = extent(points);
    (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt()
}

/// The least box around points: its least and its greatest corner.
fn extent(points: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))]
    })
}

/// Names come from the experiment file and may hold anything; a line break would be read as data.
fn one_line(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
