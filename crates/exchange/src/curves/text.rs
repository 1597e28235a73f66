//! Bytes as text.

use super::CurveFileError;

/// The text, and a sentence where it was not UTF-8. Names in Latin-1 (Windows-1252 but for its punctuation) and the UTF-16 of
/// spreadsheets are read.
pub(super) fn decode(bytes: &[u8]) -> Result<(String, Option<String>), CurveFileError> {
    if bytes.starts_with(&[0xFF, 0xFE, 0, 0]) || bytes.starts_with(&[0, 0, 0xFE, 0xFF]) {
        return Err(CurveFileError::File("is text in UTF-32: save it as text in UTF-8".into()));
    }
    let wide = match bytes {
        [0xFF, 0xFE, rest @ ..] => Some((rest, u16::from_le_bytes as fn([u8; 2]) -> u16)),
        [0xFE, 0xFF, rest @ ..] => Some((rest, u16::from_be_bytes as fn([u8; 2]) -> u16)),
        _ => None,
    };
    if let Some((rest, unit)) = wide {
        let units: Vec<u16> = rest.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        let text = String::from_utf16(&units).map_err(|_| {
            CurveFileError::File("begins as UTF-16 does, but is not: save it as text in UTF-8".into())
        })?;
        return Ok((text, None));
    }
    let bytes = bytes.strip_prefix(&[0xEF, 0xBB, 0xBF]).unwrap_or(bytes);
    if bytes.contains(&0) {
        return Err(CurveFileError::File(
            "is no text, it holds bytes of value 0: export the curves as OBJ, CSV, STEP or ASCII DXF".into(),
        ));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok((text.to_owned(), None)),
        Err(_) => Ok((
            bytes.iter().map(|&byte| char::from(byte)).collect(),
            Some("the text is not in UTF-8 and was read as Latin-1: names may look different".into()),
        )),
    }
}

/// Lines with their numbers from 1, without what surrounds them.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    // A lone carriage return ends a line, too: files of old programs for the Macintosh.
    let mut number = 0;
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        number += 1;
        let line = match text.find(['\n', '\r']) {
            Some(end) => {
                let after = if text[end..].starts_with("\r\n") { end + 2 } else { end + 1 };
                rest = Some(&text[after..]);
                &text[..end]
            }
            None => {
                rest = None;
                text
            }
        };
        Some((number, line.trim()))
    })
}
