//! The table of a sweep: every cell with the figures of its methods.

use std::collections::BTreeMap;
use std::path::PathBuf;

use plateau::Quantity;
use serde_json::{Map, Value};

use crate::figures::value;
use crate::outline::{CellEntry, Outline};
use crate::stored::Stored;

/// The cells of a sweep that are there, and which are not.
#[derive(Clone, Debug)]
pub struct Merged {
    pub(crate) outline: Outline,
    pub(crate) kept: Vec<Kept>,
    pub(crate) missing: Vec<Lack>,
    /// Cells of which there are copies with other numbers.
    pub(crate) differing: Vec<String>,
    /// How many programs and processors computed them.
    pub(crate) origins: usize,
}

/// A cell that is there.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    /// Its number among the cells of the sweep.
    pub(crate) index: usize,
    pub(crate) stored: Stored,
    /// The folder of the sweep in which it lies.
    pub(crate) folder: PathBuf,
}

/// A cell that is not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Lack {
    pub(crate) name: String,
    /// Why what is there is not its result; none if nothing is there.
    pub(crate) why: Option<String>,
}

impl Merged {
    /// Whether every cell is there once.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty() && self.differing.is_empty()
    }

    /// How many cells are there, and how many there should be.
    #[must_use]
    pub fn counts(&self) -> (usize, usize) {
        (self.kept.len(), self.outline.cells.len())
    }

    /// What a reader must know, a sentence each: which cells are missing, torn or contradicted.
    #[must_use]
    pub fn faults(&self) -> Vec<String> {
        let missing = self.missing.iter().map(|Lack { name, why }| match why {
            Some(why) => format!("torn: {name}: {why}"),
            None => format!("missing: {name}"),
        });
        let differing = self.differing.iter().map(|name| {
            format!("contradicted: {name}: the folders have results with different numbers of it; delete all but one")
        });
        missing.chain(differing).collect()
    }

    /// What may matter to a reader though nothing is wrong, a sentence each.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let unwritten = self.kept.iter().filter(|kept| !kept.stored.unwritten.is_empty()).count();
        let missed = self.kept.iter().filter(|kept| !kept.stored.missed.is_empty()).count();
        let mut notes = Vec::new();
        if self.origins > 1 {
            notes.push(format!(
                "the cells were computed by {} different programs or processors: their last digits may differ",
                self.origins
            ));
        }
        if unwritten > 0 {
            notes.push(format!("{unwritten} cells lack files that were asked for, not figures"));
        }
        if missed > 0 {
            notes.push(format!("in {missed} cells a number was not what the file expects"));
        }
        notes
    }

    pub(crate) fn cell(&self, kept: &Kept) -> &CellEntry {
        &self.outline.cells[kept.index]
    }

    /// Where the figure that is compared stands in a record.
    pub(crate) fn key(&self) -> &'static str {
        let meant = |quantity: &&Quantity| quantity.name() == self.outline.figure;
        Quantity::ALL.iter().find(meant).map_or("area", |quantity| quantity.key())
    }

    /// What the searches of all cells minimise scales as this power of a length; none if they differ.
    pub(crate) fn searched_power(&self) -> Option<i32> {
        let mut powers = self.kept.iter().filter_map(|kept| kept.stored.searched);
        let first = powers.next()?;
        powers.all(|power| power == first).then_some(first)
    }

    /// Every method of every cell that is there, in the order of the cells.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&Kept, &Map<String, Value>)> + Clone {
        self.kept.iter().flat_map(|kept| kept.stored.methods.iter().map(move |method| (kept, method)))
    }

    /// The places of the values of all directions but the last, which tell panels apart.
    pub(crate) fn panel(&self, kept: &Kept) -> Vec<usize> {
        let directions = self.outline.directions();
        let outer = directions.split_last().map_or(&[][..], |(_, outer)| outer);
        outer.iter().map(|&axis| self.cell(kept).at[axis]).collect()
    }

    /// What the cells have in common whose figures are compared: the panel, and where that is over boundaries, the place on its axis.
    pub(crate) fn comparable(&self, kept: &Kept) -> Vec<usize> {
        let mut places = self.panel(kept);
        if self.outline.is_of_boundaries() {
            places.extend(self.outline.directions().last().map(|&last| self.cell(kept).at[last]));
        }
        places
    }

    /// The least value of the compared figure among all that are compared.
    pub(crate) fn least(&self) -> BTreeMap<Vec<usize>, f64> {
        let mut least = BTreeMap::new();
        for (kept, method) in self.rows() {
            if let Some(found) = value(method, self.key()) {
                let so_far = least.entry(self.comparable(kept)).or_insert(found);
                *so_far = so_far.min(found);
            }
        }
        least
    }
}
