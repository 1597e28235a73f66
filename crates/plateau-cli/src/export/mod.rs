//! Meshes and surfaces as files for other programs, one format a file.

mod colour;
pub(crate) mod csv;
pub(crate) mod deformation;
mod glb;
mod obj;
mod ply;
mod stl;
mod vtu;

use std::io::{self, Write};

use surfaces::Mesh;

use crate::Format;

/// What an exporter may draw from.
pub(crate) struct Subject<'a> {
    /// A name for the object.
    pub(crate) name: &'a str,
    /// The mesh of the patch.
    pub(crate) mesh: &'a Mesh,
}

/// One file format.
pub(crate) trait Export {
    /// Writes the whole file.
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()>;
}

/// The exporter of a format; none for formats this version does not write.
pub(crate) fn exporter(format: Format) -> Option<&'static dyn Export> {
    match format {
        Format::Obj => Some(&obj::Obj),
        Format::Ply => Some(&ply::Ply),
        Format::Stl => Some(&stl::Stl),
        Format::Glb => Some(&glb::Glb),
        Format::Vtu => Some(&vtu::Vtu),
        Format::Step => None,
    }
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
