//! One `[[method]]` under check.

use plateau::{Energy, ReferenceTriangle, SearchEnergy, ShapedFamily, TriangleMask};
use serde_spanned::Spanned;

use super::boundary::{Kind, Sides};
use crate::keys::method::{
    BASIS, BOUND, CONSTRUCTION, Construction, DOMAIN, ENERGY, LAYERS, MASK, METRIC_STEPS, PATCH, RAISE,
    SEARCH, SEARCH_ENERGY, SHAPE, SOLVER, Searched, Solver, TOLERANCE,
};
use crate::text::{Given, Table};

/// One method under check: its keys, read.
pub(super) struct Draft<'t> {
    pub(super) table: Table<'t>,
    pub(super) sides: &'t Sides,
    pub(super) patch: Given<Option<ShapedFamily>>,
    pub(super) basis: Given<Option<ShapedFamily>>,
    pub(super) shape: Given<Vec<Spanned<f64>>>,
    pub(super) search: Given<Searched>,
    pub(super) energy: Given<Energy>,
    pub(super) raise: Given<usize>,
    pub(super) domain: Given<ReferenceTriangle>,
    pub(super) metric_steps: Given<usize>,
    pub(super) mask: Given<TriangleMask>,
    pub(super) construction: Given<Construction>,
    pub(super) search_energy: Given<SearchEnergy>,
    pub(super) solver: Given<Solver>,
    pub(super) tolerance: Given<f64>,
    pub(super) bound: Given<bool>,
    pub(super) layers: Given<usize>,
}

impl<'t> Draft<'t> {
    pub(super) fn new(table: Table<'t>, sides: &'t Sides) -> Self {
        Self {
            sides,
            patch: table.take(&PATCH),
            basis: table.take(&BASIS),
            shape: table.take(&SHAPE),
            search: table.take(&SEARCH),
            energy: table.take(&ENERGY),
            raise: table.take(&RAISE),
            domain: table.take(&DOMAIN),
            metric_steps: table.take(&METRIC_STEPS),
            mask: table.take(&MASK),
            construction: table.take(&CONSTRUCTION),
            search_energy: table.take(&SEARCH_ENERGY),
            solver: table.take(&SOLVER),
            tolerance: table.take(&TOLERANCE),
            bound: table.take(&BOUND),
            layers: table.take(&LAYERS),
            table,
        }
    }

    pub(super) fn is_triangle(&self) -> bool {
        self.sides.kind == Some(Kind::Triangle)
    }

    /// The blend that the file asks for, if it does.
    pub(super) fn blend(&self) -> Option<ShapedFamily> {
        self.patch.value().copied().flatten()
    }
}
