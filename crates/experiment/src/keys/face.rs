//! `[[face]]` and `[[vertex]]`.

use plateau::MAX_COORDINATE;

use crate::text::{Flag, Key, List, Section, Text, Vector, Ways};

/// Most faces of a boundary.
pub(crate) const MOST_FACES: usize = 200;

/// Most corners of a face.
pub(crate) const MOST_CORNERS: usize = 100;

pub(crate) static VERTICES: Key<List<Text>> = Key::new(
    "vertices",
    List { each: Text::Named, least: 2, most: MOST_CORNERS, example: "[\"a\", \"b\", \"c\"]" },
    "the names of its corners in order round; between two that no curve joins runs a free edge, shared with another face",
)
.required()
.such_as("[\"a\", \"b\", \"c\"]");

pub(crate) static SECTION: Section = Section {
    doc: "a face of the surface, a polygon between vertices of curves",
    keys: &[&VERTICES],
    ways: Ways::Free,
};

/// `[[vertex]]`.
pub(crate) mod vertex {
    use super::*;

    pub(crate) static NAME: Key<Text> =
        Key::new("name", Text::Named, "the name by which faces call it").required().such_as("\"o\"");
    pub(crate) static POINT: Key<Vector> =
        Key::new("point", Vector::up_to(MAX_COORDINATE), "where it is, or where a free one starts")
            .required()
            .such_as("[0.5, 0.5, 0.5]");
    pub(crate) static FIXED: Key<Flag> =
        Key::new("fixed", Flag, "whether it stays there; one in which a curve ends always does").or("false");

    pub(crate) static SECTION: Section = Section {
        doc: "a vertex of faces whose place is wanted",
        keys: &[&NAME, &POINT, &FIXED],
        ways: Ways::Free,
    };
}
