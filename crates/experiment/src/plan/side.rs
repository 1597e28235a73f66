//! A side of a boundary as it stands in a file.

use std::ops::Range;

use surfaces::Point;

use crate::text::PointList;

/// One list of points with its key.
pub(super) struct Side {
    pub(super) name: &'static str,
    pub(super) span: Range<usize>,
    pub(super) list: PointList,
}

impl Side {
    pub(super) fn points(&self) -> Vec<Point> {
        self.list.points.iter().map(|point| Point::from(*point.get_ref())).collect()
    }
}
