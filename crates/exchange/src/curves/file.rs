use super::{CurveFileError, Kind, Shape};
use crate::{LengthUnit, Sentence};

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
    /// Of a polyline that several lines of the file make together: the indices of the points where one ends and the next begins. None where
    /// each is a single segment.
    pub joints: Vec<usize>,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveFile {
    /// What kind of file it is.
    pub kind: Kind,
    /// Its curves, in the order of the file; at least one.
    pub curves: Vec<FileCurve>,
    /// What its numbers are, where it says so.
    pub unit: Option<LengthUnit>,
    /// Sentences a user should see: what was passed over, what was assumed, the unit of length.
    pub notes: Vec<Sentence>,
}

impl CurveFile {
    /// The curves of another file beside these. No number is converted: files of which one states no unit are in that of the other.
    ///
    /// # Errors
    /// [`CurveFileError::File`] for files in two units.
    pub fn with(mut self, other: Self) -> Result<Self, CurveFileError> {
        if let (Some(one), Some(two)) = (self.unit, other.unit)
            && one != two
        {
            return Err(CurveFileError::File(format!(
                "one file is in {} and another in {}: write them in one unit, for numbers are not converted",
                one.plural(),
                two.plural()
            )));
        }
        self.unit = self.unit.or(other.unit);
        self.curves.extend(other.curves);
        self.notes.extend(other.notes);
        Ok(self)
    }

    /// The same with each line of the file a curve by itself.
    #[must_use]
    pub fn parted(mut self) -> Self {
        self.curves = self.curves.into_iter().flat_map(FileCurve::parts).collect();
        self
    }
}

impl FileCurve {
    /// Its name, or its line where it has none.
    pub(crate) fn called(&self) -> String {
        if self.name.is_empty() { format!("the curve of line {}", self.line) } else { self.name.clone() }
    }

    /// The lines it is made of.
    fn parts(self) -> Vec<Self> {
        let Shape::Polyline(points) = &self.shape else { return vec![self] };
        let mut cuts = vec![0];
        cuts.extend(&self.joints);
        cuts.push(points.len() - 1);
        let part = |ends: &[usize]| Self {
            shape: Shape::Polyline(points[ends[0]..=ends[1]].to_vec()),
            joints: Vec::new(),
            ..self.clone()
        };
        cuts.windows(2).map(part).collect()
    }
}
