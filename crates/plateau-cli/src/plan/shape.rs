//! Shape parameters: given, searched, or none.

use serde_spanned::Spanned;

use super::check::{Check, Table};
use super::method::Draft;
use super::number::{counted, shown};
use crate::spec::{NumberList, SearchKey};
use plateau::{Basis, SearchMode, Shape};

impl Draft<'_> {
    pub(super) fn shape(&self, check: &mut Check<'_>, basis: Basis) -> Option<Shape> {
        let spec = self.spec;
        let mode = match &spec.search {
            Some(key) => {
                let names = [
                    ("pso", SearchMode::Pso),
                    ("polish", SearchMode::Polish),
                    ("pso-polish", SearchMode::PsoPolish),
                ];
                match key.get_ref() {
                    SearchKey::Truth(true) => Some(SearchMode::PsoPolish),
                    SearchKey::Truth(false) => None,
                    SearchKey::Name(word) => {
                        Some(check.named(&self.table, "search", word, key.span(), &names)?)
                    }
                }
            }
            None => None,
        };
        if basis == Basis::Bernstein {
            let shape_key = spec.shape.as_ref().map(|key| ("shape", key.span()));
            let search_key =
                spec.search.as_ref().filter(|_| mode.is_some()).map(|key| ("search", key.span()));
            let Some((name, span)) = shape_key.or(search_key) else { return Some(Shape::None) };
            self.clash(
                check,
                (span, "nothing to set or search"),
                format!(
                    "{} has a `{name}`, but the Bernstein basis has no shape parameters",
                    self.table.name
                ),
                "write basis = \"gt\", or leave this key out",
            );
            return None;
        }
        match (&spec.shape, mode) {
            (Some(shape), Some(_)) => {
                let search = spec.search.as_ref().map_or(self.table.span.clone(), Spanned::span);
                check.conflict(
                    (search, "searches them"),
                    (shape.span(), "gives the shape parameters"),
                    format!("{} both gives and searches the shape parameters", self.table.name),
                    "keep `shape` for fixed parameters, or `search` to find them",
                );
                None
            }
            (None, Some(mode)) => Some(Shape::Search(mode)),
            (Some(shape), None) => fixed_shape(check, &self.table, shape).map(Shape::Fixed),
            (None, None) => {
                check.missing(
                    &self.table,
                    "shape",
                    "the GT basis needs shape parameters: give shape = [a1, a2, b1, b2], each in [0, 4] (a in u, b in \
                     v), or find them by search = true",
                );
                None
            }
        }
    }
}

/// Four numbers in [0, 4], neither pair both zero.
fn fixed_shape(check: &mut Check<'_>, table: &Table, key: &Spanned<NumberList>) -> Option<[f64; 4]> {
    shape_parameters(check, table, key, "shape = [a1, a2, b1, b2], a in u and b in v")
}

/// `N` shape parameters in [0, 4]; no pair of them is (0, 0).
pub(super) fn shape_parameters<const N: usize>(
    check: &mut Check<'_>,
    table: &Table,
    key: &Spanned<NumberList>,
    form: &str,
) -> Option<[f64; N]> {
    let list = &key.get_ref().0;
    if list.len() != N {
        check.inadmissible(
            key.span(),
            format!("`shape` in {} has {} instead of {N}", table.name, counted(list.len(), "number")),
            counted(list.len(), "number"),
            format!("write {form}"),
        );
        return None;
    }
    let mut shape = [0.0; N];
    let mut sound = true;
    for (k, number) in list.iter().enumerate() {
        shape[k] = number.get_ref().0;
        if !(0.0..=4.0).contains(&shape[k]) {
            check.inadmissible(
                number.span(),
                format!("a shape parameter of {} lies outside [0, 4]: {}", table.name, shown(shape[k])),
                "expected a number in [0, 4]",
                format!("write {form}, each in [0, 4]: outside, the GT functions become negative"),
            );
            sound = false;
        }
    }
    if !sound {
        return None;
    }
    for (k, pair) in list.chunks(2).enumerate() {
        if pair.iter().all(|number| number.get_ref().0 == 0.0) {
            check.inadmissible(
                pair[0].span().start..pair[pair.len() - 1].span().end,
                format!("a pair of shape parameters of {} is (0, 0)", table.name),
                ["both of the first pair are zero", "both of the second pair are zero"][k.min(1)],
                "make one of the two positive: at (0, 0) the GT functions are linearly dependent",
            );
            return None;
        }
    }
    Some(shape)
}
