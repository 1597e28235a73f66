//! A cut boundary with the surface over it.

use surfaces::Complex;

use super::Tried;
use crate::{AreaEnd, AreaExtremal, CutBoundary, Seams};

/// A cut boundary with the surface over it.
pub(super) struct Solution {
    pub(super) cut: CutBoundary,
    pub(super) complex: Complex,
    /// The names of its vertices.
    pub(super) names: Vec<String>,
    /// Layers of smaller patches around its corners.
    pub(super) layers: usize,
    pub(super) extremal: Option<AreaExtremal>,
    pub(super) seams: Seams,
}

impl Solution {
    /// The area, where it was minimised.
    pub(super) fn area(&self) -> Option<f64> {
        self.extremal.as_ref().map(|found| found.area.value)
    }

    /// Whether there is no reason to cut in another way: stationary, and even to this ratio.
    pub(super) fn is_sound(&self, ratio: f64) -> bool {
        self.seams.is_even(ratio)
            && self.extremal.as_ref().is_none_or(|found| found.end == AreaEnd::Stationary)
    }

    /// Whether it is to be preferred: it does not fold where the other does, else has less area, or is more even where no
    /// area was minimised.
    pub(super) fn is_better(&self, other: &Self) -> bool {
        match (self.seams.folds(), other.seams.folds(), self.area(), other.area()) {
            (false, true, _, _) => true,
            (true, false, _, _) => false,
            (_, _, Some(ours), Some(theirs)) => ours < theirs,
            (_, _, None, _) | (_, _, _, None) => self.seams.jacobian_ratio > other.seams.jacobian_ratio,
        }
    }

    pub(super) fn tried(&self) -> Tried {
        Tried {
            way: self.cut.way(),
            area: self.area(),
            jacobian_ratio: self.seams.jacobian_ratio,
            folds: self.seams.folds(),
        }
    }
}
