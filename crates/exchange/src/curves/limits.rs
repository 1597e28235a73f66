//! How much of a file is kept. Every limit is counted before anything beyond it is stored.

use super::CurveFileError;

/// Largest size in bytes of a file that is read.
pub(super) const MOST_BYTES: usize = 16 << 20;
/// Most curves of a file.
pub(super) const MOST_CURVES: usize = 10_000;
/// Most points of all curves of a file, and most vertices of an OBJ file.
pub(super) const MOST_POINTS: usize = 400_000;
/// Most bytes of a name.
pub(super) const LONGEST_NAME: usize = 256;
/// Most instances of a STEP file, entities and properties of a DXF file.
pub(super) const MOST_RECORDS: usize = 400_000;
/// Largest absolute value of a coordinate.
pub(super) const LARGEST_COORDINATE: f64 = 1e60;

/// Refuses what is too large.
pub(super) fn size(bytes: &[u8]) -> Result<(), CurveFileError> {
    if bytes.len() > MOST_BYTES {
        return Err(CurveFileError::TooLarge { most: MOST_BYTES >> 20 });
    }
    Ok(())
}

/// Counts one more of `what`, at most `most`.
pub(super) fn count(
    counter: &mut usize,
    more: usize,
    most: usize,
    what: &'static str,
    line: usize,
) -> Result<(), CurveFileError> {
    *counter += more;
    if *counter > most {
        return Err(CurveFileError::at(
            line,
            format!("here the {what} become more than {most}, the most that are read"),
        ));
    }
    Ok(())
}

/// A name, cut where it is too long, without characters that control a terminal.
pub(super) fn name(text: &str) -> String {
    let mut name = String::new();
    for c in text.trim().chars() {
        if name.len() + c.len_utf8() > LONGEST_NAME {
            name.push('…');
            break;
        }
        name.push(if c.is_control() { ' ' } else { c });
    }
    name
}
