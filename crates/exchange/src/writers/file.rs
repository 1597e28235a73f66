//! A surface as a file, in any of the formats.

use std::io::{self, Write};

use plateau::{Family, MAX_COORDINATE, Surface};
use surfaces::{Complex, Mesh};
use thiserror::Error;

use super::cells::CellFile;
use super::format::{Format, Holds};
use super::shell::ShellFile;
use super::step::StepFile;
use super::subject::{Export, Subject, SurfaceForm};

/// A format cannot hold a surface: why, and what to do.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct Unfit(pub String);

/// A surface ready to be written in one format.
pub struct SurfaceFile<'a> {
    subject: Subject<'a>,
    content: Content<'a>,
}

enum Content<'a> {
    Mesh(&'static dyn Export),
    Cells(Box<CellFile>),
    Step(Box<StepFile>),
    Shell(Box<ShellFile<'a>>),
}

impl<'a> SurfaceFile<'a> {
    /// The file of `surface` in `format`; `tolerance` is a share of the size and bounds the distance of a fitted surface from
    /// the patch.
    ///
    /// # Errors
    /// [`Unfit`] if the format cannot hold the surface within the tolerance.
    pub fn new(
        format: Format,
        subject: Subject<'a>,
        (surface, family): (&'a Surface, Family),
        tolerance: f64,
    ) -> Result<Self, Unfit> {
        if let Surface::Complex(complex) = surface {
            return Self::of_complex(format, subject, complex);
        }
        let content = match format.holds() {
            Holds::Mesh(export) => Content::of_mesh(export, subject.mesh)?,
            Holds::Cells => {
                Content::Cells(Box::new(CellFile::new(surface, family, tolerance).map_err(unfit)?))
            }
            Holds::Faces => {
                Content::Step(Box::new(StepFile::new(surface, family, tolerance).map_err(unfit)?))
            }
        };
        Ok(Self { subject, content })
    }

    /// The file of a complex, of which the subject has a mesh; STEP holds it exactly, its faces sewn by their edges, and so do Bézier cells,
    /// which have points in common.
    ///
    /// # Errors
    /// [`Unfit`] if the format cannot hold it.
    pub fn of_complex(format: Format, subject: Subject<'a>, complex: &'a Complex) -> Result<Self, Unfit> {
        let content = match format.holds() {
            Holds::Mesh(export) => Content::of_mesh(export, subject.mesh)?,
            Holds::Cells => Content::Cells(Box::new(CellFile::of_complex(complex).map_err(unfit)?)),
            Holds::Faces => Content::Shell(Box::new(ShellFile::new(complex).map_err(unfit)?)),
        };
        Ok(Self { subject, content })
    }

    /// How the file holds the surface, where that takes saying.
    pub fn form(&self) -> Option<SurfaceForm> {
        match &self.content {
            Content::Mesh(format) => format.form(&self.subject),
            Content::Cells(file) => {
                Some(SurfaceForm { deviation: file.deviation(), description: file.description().to_owned() })
            }
            Content::Step(file) => {
                Some(SurfaceForm { deviation: file.deviation(), description: file.description() })
            }
            Content::Shell(file) => Some(SurfaceForm { deviation: None, description: file.description() }),
        }
    }

    /// Writes the file.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidData`](io::ErrorKind::InvalidData), with the reason in words, for what the format cannot hold; else what
    /// `out` says.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.content {
            Content::Mesh(format) => format.write(&self.subject, out),
            Content::Cells(file) => file.write(out),
            Content::Step(file) => file.write(self.subject.name, self.subject.unit.unwrap_or_default(), out),
            Content::Shell(file) => file.write(self.subject.name, self.subject.unit.unwrap_or_default(), out),
        }
    }
}

fn unfit(error: impl std::error::Error) -> Unfit {
    Unfit(error.to_string())
}

impl Content<'_> {
    fn of_mesh(export: &'static dyn Export, mesh: &Mesh) -> Result<Self, Unfit> {
        overflow(mesh).map_or(Ok(Self::Mesh(export)), |reason| Err(Unfit(reason)))
    }
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
