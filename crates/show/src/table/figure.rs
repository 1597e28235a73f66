//! The figures of a patch that tables show: one table of them, which the columns of all others follow from.

use super::column::Column;
use super::standing::UNMOVED;
use crate::number::Form;
use plateau::{Done, Energy};

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

/// A figure as tables show it.
pub(crate) struct Figure {
    /// Where it stands in a method's entry of `result.json`; a dot leads into an object.
    pub(crate) key: &'static str,
    /// The heading of its column.
    pub(crate) heading: &'static str,
    /// The line below the heading; if empty, the unit.
    pub(crate) beneath: &'static str,
    /// It scales as this power of a length.
    pub(crate) power: i32,
    /// Its value; none where it has no meaning.
    pub(crate) value: fn(&Done) -> Option<f64>,
    /// How it is written.
    pub(crate) form: Form,
    /// Beside a patch of size 1 (the root of its Dirichlet energy), this much is rounding, and what is written instead.
    pub(crate) rounding: (f64, &'static str),
    /// Whether it is zero but for rounding on a surface with a closed form: then the exponent is what there is to read.
    pub(crate) vanishes_if_exact: bool,
    /// What stands in place of a value that does not exist.
    pub(crate) missing: &'static str,
    pub(crate) place: Place,
    /// See [`Column::rank`].
    pub(crate) rank: u8,
    /// The energy that this is the value of: its column is always there for those who minimise it.
    pub(crate) energy: Option<Energy>,
}

/// A figure of no unit that exists only for some patches; the others say what differs.
const PLAIN: Figure = Figure {
    key: "",
    heading: "",
    beneath: "",
    power: 0,
    value: |_| None,
    form: Form::Order,
    rounding: (0.0, "0"),
    vanishes_if_exact: false,
    missing: "",
    place: Place::Everywhere,
    rank: 0,
    energy: None,
};

/// The rank of an energy that was minimised.
const MINIMISED: u8 = 1;

/// All of them, in the order of the columns.
pub(crate) const FIGURES: [Figure; 11] = [
    Figure {
        key: "area",
        heading: "area A",
        power: 2,
        value: |done| Some(done.figures.area.value),
        form: Form::Decimals(7),
        energy: Some(Energy::Area),
        ..PLAIN
    },
    Figure {
        key: "area_error",
        heading: "± of A",
        power: 2,
        value: |done| Some(done.figures.area.error),
        rank: 3,
        ..PLAIN
    },
    Figure {
        key: "dirichlet",
        heading: "Dirichlet D",
        power: 2,
        value: |done| Some(done.figures.dirichlet.value),
        form: Form::Decimals(7),
        rank: 4,
        energy: Some(Energy::Dirichlet),
        ..PLAIN
    },
    Figure {
        key: "laplacian_defect",
        heading: "∫‖ΔS‖²",
        power: 2,
        value: |done| Some(done.figures.laplacian_defect.value),
        form: Form::Decimals(7),
        place: Place::Page,
        vanishes_if_exact: true,
        rank: 9,
        energy: Some(Energy::Laplacian),
        ..PLAIN
    },
    Figure {
        key: "bending",
        heading: "bending",
        power: 2,
        value: |done| Some(done.figures.bending.value),
        form: Form::Decimals(7),
        vanishes_if_exact: true,
        place: Place::Minimised,
        rank: 9,
        energy: Some(Energy::Bending),
        ..PLAIN
    },
    Figure {
        key: "deviation",
        heading: "deviation",
        power: 1,
        value: |done| done.closed_form.map(|form| form.deviation),
        ..PLAIN
    },
    Figure {
        key: "boundary_deviation",
        heading: "boundary",
        beneath: "moved by",
        power: 1,
        value: |done| done.boundary.map(|boundary| boundary.deviation),
        form: Form::Decimals(4),
        rounding: (UNMOVED, "0"),
        rank: 5,
        ..PLAIN
    },
    Figure {
        key: "conformality_gap",
        heading: "(D−A)/A",
        value: |done| done.figures.conformality_gap,
        form: Form::Percent(4),
        vanishes_if_exact: true,
        rank: 7,
        ..PLAIN
    },
    Figure {
        key: "mean_curvature.max_abs",
        heading: "max |H|",
        power: -1,
        value: |done| done.figures.mean_curvature_max,
        form: Form::Decimals(5),
        rounding: (1e-6, "0.00000"),
        missing: "singular",
        vanishes_if_exact: true,
        rank: 8,
        ..PLAIN
    },
    Figure {
        key: "mean_curvature.rms",
        heading: "rms H",
        power: -1,
        value: |done| done.figures.mean_curvature_rms,
        form: Form::Decimals(5),
        rounding: (1e-6, "0.00000"),
        place: Place::Page,
        vanishes_if_exact: true,
        rank: 9,
        ..PLAIN
    },
    Figure {
        key: "harmonic_bound",
        heading: "bound of D",
        power: 2,
        value: |done| done.boundary.map(|boundary| boundary.harmonic_bound),
        form: Form::Decimals(7),
        rank: 9,
        ..PLAIN
    },
];

impl Figure {
    /// Its column.
    pub(crate) fn column(&self) -> Column {
        let beneath = if self.beneath.is_empty() { unit(self.power) } else { self.beneath };
        Column { key: self.key, rank: self.rank, ..Column::number(self.heading, beneath) }
    }

    /// Whether one of the patches is an extremal of this energy.
    pub(crate) fn is_minimised_by(&self, done: &[Option<&Done>]) -> bool {
        self.energy.is_some() && done.iter().flatten().any(|done| done.solved.minimised == self.energy)
    }

    /// Its column among patches; what one of them minimised is left out late.
    pub(crate) fn column_among(&self, done: &[Option<&Done>]) -> Column {
        let column = self.column();
        let rank = if self.is_minimised_by(done) { column.rank.min(MINIMISED) } else { column.rank };
        Column { rank, ..column }
    }

    /// The figure of a patch in words; empty where there is none. `is_exact`: the experiment is of surfaces with a closed form.
    pub(crate) fn cell(&self, done: &Done, is_exact: bool) -> String {
        let Some(value) = (self.value)(done) else { return self.missing.into() };
        let unit = done.figures.dirichlet.value.sqrt().powi(self.power);
        if is_exact && self.vanishes_if_exact && value.abs() < 1e-6 * unit {
            return Form::Order.of(value);
        }
        let (rounding, nothing) = self.rounding;
        if rounding > 0.0 && value.abs() <= rounding * unit { nothing.into() } else { self.form.of(value) }
    }
}

/// The unit of what scales as this power of a length.
fn unit(power: i32) -> &'static str {
    match power {
        -1 => "1/length",
        1 => "length",
        2 => "length²",
        _ => "",
    }
}
