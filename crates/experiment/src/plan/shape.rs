//! Shape parameters: given, searched, or none.

use bases::BasisError;
use plateau::{CurveBasis, Energy, Family, FixedShape, MethodError, SearchEnergy, SearchMode, ShapedFamily};
use serde_spanned::Spanned;

use super::built::built;
use super::draft::Draft;
use crate::keys::method::Searched;
use crate::keys::shape::needed;
use crate::text::{Given, Table};

/// What a method says of its shape parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// Its functions have none.
    None,
    /// They are given.
    Fixed(FixedShape),
    /// They are searched.
    Search(SearchMode),
}

impl Draft<'_> {
    pub(super) fn shape(&self, family: Family) -> Option<Shape> {
        let mode = match &self.search {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(searched) => match searched.get_ref() {
                Searched::Not => None,
                Searched::AsSuits => Some(self.suitable()),
                Searched::By(mode) => Some(*mode),
            },
        };
        match family {
            Family::Shaped(family) => self.shape_of(family, mode),
            Family::Bernstein | Family::Triangle | Family::Aht | Family::At | Family::Complex => {
                self.no_shape(mode)
            }
        }
    }

    /// A swarm where a shape costs a linear system; descents alone, a hundredth of the shapes, where it costs a least area, or a gap.
    fn suitable(&self) -> SearchMode {
        match (self.energy.value(), self.search_energy.value()) {
            (Some(Energy::Area), _) | (_, Some(SearchEnergy::Conformality)) => SearchMode::Polish,
            (Some(Energy::Quadratic(_)) | None, Some(SearchEnergy::Energy(_)) | None) => {
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

    fn shape_of(&self, family: ShapedFamily, mode: Option<SearchMode>) -> Option<Shape> {
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
            (Given::Sound(shape), None) => fixed_shape(&self.table, family, shape).map(Shape::Fixed),
            (Given::Absent, None) => {
                self.table.missing("shape", &format!("{}, or find them by search = true", needed(family)));
                None
            }
        }
    }
}

/// The shape of a family with these parameters.
pub(super) fn fixed_shape(
    table: &Table<'_>,
    family: ShapedFamily,
    numbers: &Spanned<Vec<Spanned<f64>>>,
) -> Option<FixedShape> {
    let values: Vec<f64> = numbers.get_ref().iter().map(|number| *number.get_ref()).collect();
    if let Some((pair, BasisError::Dependent)) = family.fault(&values) {
        dependent(table, &numbers.get_ref()[pair.clone()], pair.start / pair.len());
        return None;
    }
    let made = FixedShape::new(family, values);
    made.map_err(|error| {
        let (from, to) = family.range();
        table.faults().inadmissible(
            numbers.span(),
            format!("`shape` of {}: {error}", table.name()),
            format!("{} numbers in [{from}, {to}]", family.parameters().len()),
            format!("give {}", family.parameters().join(", ")),
        );
    })
    .ok()
}

/// The basis of a curve with these shape parameters.
pub(super) fn basis_of_curve(table: &Table<'_>, numbers: &Spanned<Vec<Spanned<f64>>>) -> Option<CurveBasis> {
    let values: Vec<f64> = numbers.get_ref().iter().map(|number| *number.get_ref()).collect();
    let made = CurveBasis::gt(values.try_into().ok()?);
    if let Err(MethodError::Basis(BasisError::Dependent)) = made {
        dependent(table, numbers.get_ref(), 0);
        return None;
    }
    built(table, numbers.span(), made)
}

/// Reports that the `k`-th pair of shape parameters makes no basis.
fn dependent(table: &Table<'_>, pair: &[Spanned<f64>], k: usize) {
    let which = ["first", "second"][k.min(1)];
    table.faults().inadmissible(
        pair[0].span().start..pair[pair.len() - 1].span().end,
        format!("a pair of shape parameters of {} is (0, 0)", table.name()),
        format!("both of the {which} pair are zero"),
        "make one of the two positive: at (0, 0) the GT functions are linearly dependent",
    );
}
