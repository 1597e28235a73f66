//! Shape parameters: given, searched, or none.

use plateau::{Basis, Energy, SearchMode, Shape};
use serde_spanned::Spanned;

use super::method::Draft;
use crate::keys::method::Searched;
use crate::text::{Given, Table};

impl Draft<'_> {
    pub(super) fn shape(&self, basis: Basis) -> Option<Shape> {
        let mode = match &self.search {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(searched) => match searched.get_ref() {
                Searched::Not => None,
                Searched::AsSuits => Some(self.suitable()),
                Searched::By(mode) => Some(*mode),
            },
        };
        match basis {
            Basis::Bernstein => self.no_shape(mode),
            Basis::Gt => self.shape_of_gt(mode),
        }
    }

    /// A swarm where a shape costs a linear system; descents alone, a hundredth of the shapes, where it costs a least area.
    fn suitable(&self) -> SearchMode {
        match self.energy.value() {
            Some(Energy::Area) => SearchMode::Polish,
            Some(Energy::Dirichlet | Energy::Laplacian | Energy::Bending | Energy::Coons) | None => {
                SearchMode::PsoPolish
            }
        }
    }

    /// The Bernstein basis, which must not have what it cannot use.
    fn no_shape(&self, mode: Option<SearchMode>) -> Option<Shape> {
        let shape = self.shape.span().map(|span| ("shape", span));
        let search = self.search.span().filter(|_| mode.is_some()).map(|span| ("search", span));
        let Some((name, span)) = shape.or(search) else {
            return (!self.shape.is_faulty()).then_some(Shape::None);
        };
        self.table.faults().clash(
            (span, "nothing to set or search"),
            format!("{} has a `{name}`, but the Bernstein basis has no shape parameters", self.table.name()),
            "write basis = \"gt\", or leave this key out",
        );
        None
    }

    fn shape_of_gt(&self, mode: Option<SearchMode>) -> Option<Shape> {
        match (&self.shape, mode) {
            (Given::Sound(shape), Some(_)) => {
                let search = self.search.span().unwrap_or(self.table.span());
                self.table.faults().conflict(
                    (search, "searches them"),
                    (shape.span(), "gives the shape parameters"),
                    format!("{} both gives and searches the shape parameters", self.table.name()),
                    "keep `shape` for fixed parameters, or `search` to find them",
                );
                None
            }
            (Given::Faulty, _) => None,
            (Given::Absent, Some(mode)) => Some(Shape::Search(mode)),
            (Given::Sound(shape), None) => shape_parameters(&self.table, shape).map(Shape::Fixed),
            (Given::Absent, None) => {
                self.table.missing(
                    "shape",
                    "the GT basis needs shape parameters: give shape = [a1, a2, b1, b2], each in [0, 4] (a in u, b in \
                     v), or find them by search = true",
                );
                None
            }
        }
    }
}

/// `N` shape parameters; no pair of them is (0, 0).
pub(super) fn shape_parameters<const N: usize>(
    table: &Table<'_>,
    numbers: &Spanned<Vec<Spanned<f64>>>,
) -> Option<[f64; N]> {
    let numbers = numbers.get_ref();
    for (k, pair) in numbers.chunks(2).enumerate() {
        if pair.iter().all(|number| *number.get_ref() == 0.0) {
            table.faults().inadmissible(
                pair[0].span().start..pair[pair.len() - 1].span().end,
                format!("a pair of shape parameters of {} is (0, 0)", table.name()),
                ["both of the first pair are zero", "both of the second pair are zero"][k.min(1)],
                "make one of the two positive: at (0, 0) the GT functions are linearly dependent",
            );
            return None;
        }
    }
    let values: Vec<f64> = numbers.iter().map(|number| *number.get_ref()).collect();
    values.try_into().ok()
}
