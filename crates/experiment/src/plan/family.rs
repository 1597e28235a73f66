//! The family of patches of a method.

use std::ops::Range;

use plateau::{Family, ShapedFamily};

use super::draft::Draft;
use crate::text::Given;

impl Draft<'_> {
    /// The family of patches that `patch`, `basis` and the boundary say.
    pub(super) fn family(&self) -> Option<Family> {
        let blend = match &self.patch {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(_) if self.is_triangle() => return None,
            Given::Sound(patch) => *patch.get_ref(),
        };
        let basis = match &self.basis {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(basis) => Some((*basis.get_ref(), basis.span())),
        };
        if self.is_triangle() {
            return self.family_of_triangle(basis);
        }
        match (blend, basis) {
            (None, None) => Some(Family::Bernstein),
            (None, Some((basis, _))) => Some(basis.map_or(Family::Bernstein, Family::Shaped)),
            (Some(blend), None) => Some(Family::Shaped(blend)),
            (Some(blend), Some((Some(basis), _))) if basis.names().1 == blend.names().1 => {
                Some(Family::Shaped(blend))
            }
            (Some(_), Some((basis, span))) => {
                self.table.faults().clash(
                    (span, "a TB–Coons patch uses both bases"),
                    format!(
                        "{} asks for a TB–Coons patch in {}",
                        self.table.name(),
                        basis.map_or("the Bernstein basis", ShapedFamily::title)
                    ),
                    "leave out `basis`: a TB–Coons patch blends Bernstein and GT functions; for a plain Bézier patch \
                     leave out `patch`",
                );
                None
            }
        }
    }

    fn family_of_triangle(&self, basis: Option<(Option<ShapedFamily>, Range<usize>)>) -> Option<Family> {
        let Some((Some(basis), span)) = basis else { return Some(Family::Triangle) };
        self.table.faults().conflict(
            (span, "not for triangles"),
            (self.sides.header.clone(), "a triangular boundary"),
            format!("{} asks for {} on a triangle", self.table.name(), basis.title()),
            "leave out `basis`: triangular patches are Bernstein–Bézier patches",
        );
        None
    }
}
