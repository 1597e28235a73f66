use super::{Kind, Shape};

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

impl CurveFile {
    /// The curves of another file beside these.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        self.curves.extend(other.curves);
        self.notes.extend(other.notes);
        self
    }
}
