use surfaces::Deviation;

use super::Way;
use super::blueprint::Blueprint;

/// Quadrilaterals of a boundary, laid out.
pub(super) struct Quads {
    pub(super) blueprint: Blueprint,
    pub(super) way: Way,
    pub(super) corners: usize,
    pub(super) deviation: Deviation,
}
