//! Curves from files: one format a file, each a function from text to curves with names and places.

mod dxf;
mod error;
mod file;
mod kind;
mod limits;
mod obj;
mod shape;
mod step;
mod table;
mod text;
mod trim;

pub use error::CurveFileError;
pub use file::{CurveFile, FileCurve};
pub use kind::Kind;
pub use shape::Shape;
pub(crate) use trim::halved;

use crate::Sentence;

/// Reads the curves of a file. What it is follows from its content, and from `name` (`rim.obj`; `-` says nothing) where the
/// content leaves it open. Coordinates are the file's own: no unit is converted.
///
/// # Errors
/// [`CurveFileError`], with the line where one is at fault. The file itself is not named in it.
pub fn read_curves(bytes: &[u8], name: &str) -> Result<CurveFile, CurveFileError> {
    limits::size(bytes)?;
    let kind = Kind::of(bytes, name)?;
    let (text, recoded) = text::decode(bytes)?;
    let mut file = match kind {
        Kind::Obj => obj::read(&text),
        Kind::Table => table::read(&text),
        Kind::Step => step::read(&text),
        Kind::Dxf => dxf::read(&text),
    }?;
    file.notes.extend(recoded.map(Sentence::from));
    Ok(file)
}
