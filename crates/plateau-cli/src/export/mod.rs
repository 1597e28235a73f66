//! Meshes and surfaces as files for other programs, one format a file.

mod colour;
pub(crate) mod csv;
pub(crate) mod deformation;
mod glb;
mod name;
mod obj;
mod ply;
mod single;
mod spline;
mod step;
mod stl;
mod vtu;

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use surfaces::Mesh;
use thiserror::Error;

use crate::{DeliverError, Destination, Format};
use plateau::{Family, MAX_COORDINATE, Surface};
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
    /// Writes the whole file, as it comes.
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()>;

    /// What the file does not hold of the mesh, if that is more than rounding relative to the size.
    fn form(&self, _: &Subject<'_>) -> Option<SurfaceForm> {
        None
    }
}

/// How a file holds its surface, where that takes saying: by a formula instead of a mesh, or with less than all digits.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceForm {
    /// No point of the file's surface is farther from the point of the patch with the same parameters: the largest
    /// distance measured, times 1.25. None if the surface is the patch itself. Of meshes: no vertex is farther.
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
    if let Some(reason) = overflow(subject.mesh) {
        return Err(refused(reason));
    }
    put(&|out| exporter.write(subject, out))?;
    Ok(exporter.form(subject))
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

/// What a mesh file holds of its mesh cannot be told from nothing if a number is not finite: coordinates near the end of double
/// precision overflow in normals and curvatures.
fn overflow(mesh: &Mesh) -> Option<String> {
    let vectors = mesh.points.iter().chain(&mesh.normals).flat_map(|p| [p.x, p.y, p.z]);
    let curvatures = mesh.mean_curvature.iter().chain(&mesh.gauss_curvature).flatten().copied();
    let is_finite = vectors.chain(curvatures).all(f64::is_finite);
    let largest = mesh.points.iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0, |m: f64, x| m.max(x.abs()));
    (!is_finite).then(|| {
        format!(
            "points, normals or curvatures of its mesh are beyond double precision, with coordinates up to {largest:.1e}: \
             scale its control points to at most {MAX_COORDINATE:.0e}"
        )
    })
}
