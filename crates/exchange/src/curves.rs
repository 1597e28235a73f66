//! Curves from files: one format a file, each a function from text to curves with names and places.

mod dxf;
mod error;
mod kind;
mod limits;
mod obj;
mod shape;
mod step;
mod table;
mod text;
mod trim;

pub use error::CurveFileError;
pub use kind::Kind;
pub use shape::Shape;
pub(crate) use trim::halved;

/// A curve as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct FileCurve {
    /// What the file calls it, or the group, object or layer it stands in; empty without any.
    pub name: String,
    /// The line on which it begins, from 1.
    pub line: usize,
    /// What it is.
    pub shape: Shape,
    /// Whether its last point is followed by its first one although the file does not say so: a table without sides is a loop.
    pub closes: bool,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveFile {
    /// What kind of file it is.
    pub kind: Kind,
    /// Its curves, in the order of the file; at least one.
    pub curves: Vec<FileCurve>,
    /// Sentences a user should see: what was passed over, what was assumed, the unit of length.
    pub notes: Vec<String>,
}

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
    file.notes.extend(recoded);
    Ok(file)
}
