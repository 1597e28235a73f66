//! The figures of a patch that tables show: one table of them, which the columns of all others follow from.

use super::column::Column;
use super::standing::UNMOVED;
use plateau::{Done, Notation, Quantity};

/// Where a figure is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// On the terminal and on the page.
    Everywhere,
    /// On the page alone, which has the room.
    Page,
    /// On both, where a method minimised it.
    Minimised,
}

/// Which number of a figure.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Shows {
    Value(Quantity),
    /// The error of the area.
    AreaError,
}

/// A figure as tables show it.
pub(crate) struct Figure {
    /// What it shows.
    pub(crate) shows: Shows,
    /// The heading of its column.
    pub(crate) heading: &'static str,
    /// The line below the heading; if empty, the unit.
    pub(crate) beneath: &'static str,
    /// How it is written.
    pub(crate) form: Notation,
    /// Beside a patch of size 1 (the root of its Dirichlet energy), this much is rounding, and what is written instead.
    pub(crate) rounding: (f64, &'static str),
    /// Whether it is zero but for rounding on a surface with a closed form: then the exponent is what there is to read.
    pub(crate) vanishes_if_exact: bool,
    /// What stands in place of a value that does not exist.
    pub(crate) missing: &'static str,
    pub(crate) place: Place,
    /// See [`Column::rank`].
    pub(crate) rank: u8,
}

/// What most figures are, which exist only for some patches; the others say what differs.
const fn plain(quantity: Quantity) -> Figure {
    Figure {
        shows: Shows::Value(quantity),
        heading: "",
        beneath: "",
        form: Notation::Order,
        rounding: (0.0, "0"),
        vanishes_if_exact: false,
        missing: "",
        place: Place::Everywhere,
        rank: 0,
    }
}

/// The rank of an energy that was minimised.
const MINIMISED: u8 = 1;

/// All of them, in the order of the columns.
pub(crate) const FIGURES: [Figure; 16] = [
    Figure { heading: "area A", form: Notation::Decimals(7), ..plain(Quantity::Area) },
    Figure { shows: Shows::AreaError, heading: "± of A", rank: 3, ..plain(Quantity::Area) },
    Figure { heading: "Dirichlet D", form: Notation::Decimals(7), rank: 4, ..plain(Quantity::Dirichlet) },
    Figure {
        heading: "∫‖ΔS‖²",
        form: Notation::Decimals(7),
        place: Place::Page,
        vanishes_if_exact: true,
        rank: 9,
        ..plain(Quantity::LaplacianDefect)
    },
    Figure {
        heading: "bending",
        form: Notation::Decimals(7),
        vanishes_if_exact: true,
        place: Place::Minimised,
        rank: 9,
        ..plain(Quantity::Bending)
    },
    Figure {
        heading: "∫‖S_uv‖²",
        form: Notation::Decimals(7),
        vanishes_if_exact: true,
        rank: 9,
        ..plain(Quantity::CoonsFunctional)
    },
    Figure { heading: "D^g", form: Notation::Decimals(7), rank: 5, ..plain(Quantity::MetricDirichlet) },
    Figure { heading: "deviation", ..plain(Quantity::Deviation) },
    Figure {
        heading: "boundary",
        beneath: "moved by",
        form: Notation::Decimals(4),
        rounding: (UNMOVED, "0"),
        rank: 5,
        ..plain(Quantity::BoundaryDeviation)
    },
    Figure { heading: "rim", beneath: "moved by", rank: 6, ..plain(Quantity::RimDeviation) },
    Figure {
        heading: "kink",
        beneath: "degrees",
        form: Notation::Degrees(2),
        rank: 6,
        ..plain(Quantity::Kink)
    },
    Figure {
        heading: "each loop",
        beneath: "by itself",
        form: Notation::Decimals(7),
        rank: 6,
        ..plain(Quantity::SpannedOneByOne)
    },
    Figure {
        heading: "(D−A)/A",
        form: Notation::Percent(4),
        vanishes_if_exact: true,
        rank: 7,
        ..plain(Quantity::ConformalityGap)
    },
    Figure {
        heading: "max |H|",
        form: Notation::Decimals(5),
        rounding: (1e-6, "0.00000"),
        missing: "singular",
        vanishes_if_exact: true,
        rank: 8,
        ..plain(Quantity::MeanCurvatureMax)
    },
    Figure {
        heading: "rms H",
        form: Notation::Decimals(5),
        rounding: (1e-6, "0.00000"),
        place: Place::Page,
        vanishes_if_exact: true,
        rank: 9,
        ..plain(Quantity::MeanCurvatureRms)
    },
    Figure { heading: "bound of D", form: Notation::Decimals(7), rank: 9, ..plain(Quantity::HarmonicBound) },
];

impl Shows {
    /// Where it stands in a method's entry of `result.json`.
    fn key(self) -> &'static str {
        match self {
            Self::Value(quantity) => quantity.key(),
            Self::AreaError => "area_error",
        }
    }

    /// It scales as this power of a length, if that is always the same.
    fn power(self) -> Option<i32> {
        match self {
            Self::Value(quantity) => quantity.power(),
            Self::AreaError => Quantity::Area.power(),
        }
    }

    fn of(self, done: &Done) -> Option<f64> {
        match self {
            Self::Value(quantity) => quantity.of(done).map(|measured| measured.value),
            Self::AreaError => Quantity::Area.of(done).and_then(|measured| measured.error),
        }
    }
}

impl Figure {
    /// Its column.
    pub(crate) fn column(&self) -> Column {
        let beneath = if self.beneath.is_empty() { unit(self.shows.power()) } else { self.beneath };
        Column { key: self.shows.key(), rank: self.rank, ..Column::number(self.heading, beneath) }
    }

    /// Whether it is the energy whose extremal one of the patches is: then its column is there.
    pub(crate) fn is_minimised_by(&self, done: &[Option<&Done>]) -> bool {
        let Shows::Value(quantity) = self.shows else { return false };
        done.iter().flatten().any(|done| done.solved.minimised().map(Quantity::of_energy) == Some(quantity))
    }

    /// Its column among patches; what one of them minimised is left out late.
    pub(crate) fn column_among(&self, done: &[Option<&Done>]) -> Column {
        let column = self.column();
        let rank = if self.is_minimised_by(done) { column.rank.min(MINIMISED) } else { column.rank };
        Column { rank, ..column }
    }

    /// The figure of a patch in words; empty where there is none. `is_exact`: the experiment is of surfaces with a closed form.
    pub(crate) fn cell(&self, done: &Done, is_exact: bool) -> String {
        let Some(value) = self.shows.of(done) else { return self.missing.into() };
        let unit = done.figures.dirichlet.value.sqrt().powi(self.shows.power().unwrap_or(0));
        if is_exact && self.vanishes_if_exact && value.abs() < 1e-6 * unit {
            return Notation::Order.of(value);
        }
        let (rounding, nothing) = self.rounding;
        if rounding > 0.0 && value.abs() <= rounding * unit { nothing.into() } else { self.form.of(value) }
    }
}

/// The unit of what scales as this power of a length.
fn unit(power: Option<i32>) -> &'static str {
    match power {
        Some(-1) => "1/length",
        Some(1) => "length",
        Some(2) => "length²",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use plateau::Energy;

    use super::*;

    #[test]
    fn every_energy_has_a_column() {
        for (name, energy) in Energy::NAMED {
            let shows = |figure: &&Figure| matches!(figure.shows, Shows::Value(q) if q == Quantity::of_energy(energy));
            assert!(FIGURES.iter().any(|figure| shows(&figure)), "{name} has no column of its value");
        }
    }
}
