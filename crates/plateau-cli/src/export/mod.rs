//! Meshes and surfaces as files for other programs, one format a file.

mod obj;

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
        _ => None,
    }
}
