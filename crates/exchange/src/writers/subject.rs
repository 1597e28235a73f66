//! What the writers of meshes share.

use std::io::{self, Write};

use surfaces::Mesh;

use crate::LengthUnit;

/// What a file is written of.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// A name for the object.
    pub name: &'a str,
    /// The mesh of the patch.
    pub mesh: &'a Mesh,
    /// Colours of its vertices, for the formats that have colours; none for a plain surface.
    pub colours: Option<Colours<'a>>,
    /// What its numbers are, where that is known: STEP says so, and millimetres where it is not; glTF, which is in metres, is scaled by it.
    pub unit: Option<LengthUnit>,
}

/// Colours of the vertices of a mesh by their mean curvature.
#[derive(Debug, Clone, Copy)]
pub struct Colours<'a> {
    /// One a vertex: red, green and blue of sRGB.
    pub of_vertices: &'a [[u8; 3]],
    /// The |H| at which the colours are full.
    pub full: f64,
}

/// One file format of meshes.
pub(super) trait Export: Sync {
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
