use super::Side;

/// A side on the way round a loop or a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Walk {
    /// Index of the side.
    pub side: usize,
    /// Whether it is walked from its beginning to its end.
    pub forward: bool,
}

/// How the sides hang together.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// One loop or two; the first begins with the first curve of the file.
    Loops(Vec<Vec<Walk>>),
    /// A graph, three or more sides meeting in some vertices, and its faces.
    Faces(Vec<Vec<Walk>>),
}

/// A loop by the names of its first sides.
pub(super) fn named(sides: &[Side], walks: &[Walk]) -> String {
    let names: Vec<&str> = walks.iter().take(4).map(|walk| sides[walk.side].name.as_str()).collect();
    format!("{}{}", names.join(" "), if walks.len() > 4 { " …" } else { "" })
}
