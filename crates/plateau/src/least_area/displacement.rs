//! Displacements of the Coons patch by which nets of high degree are sought.

use std::fmt;

/// The degrees of displacements, one after the other.
const DEGREES: [usize; 6] = [Displacement::LOWEST, 16, 20, 24, 28, Displacement::LARGEST];

/// How the inside of a net of high degree was sought: as a displacement of lower degrees from the Coons patch of its border.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Its degrees in u and v.
    pub degrees: (usize, usize),
    /// Why it has no higher ones.
    pub end: DisplacementEnd,
}

/// Why a displacement has no higher degree.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum DisplacementEnd {
    /// The next degrees gain less than the tolerance.
    Tolerance,
    /// Rounding of the control points of the next degrees is more than they gain.
    Rounding {
        /// The share of the area that they gain.
        gained: f64,
    },
    /// The next degrees lead to a net that no rule integrates.
    Folds,
    /// There is no memory for the next degrees.
    OutOfMemory {
        /// Bytes that they take.
        bytes: usize,
    },
    /// No higher degree is tried.
    Largest {
        /// The share of the area that the last degrees gained.
        gained: f64,
    },
}

impl Displacement {
    /// The degree to which a net is sought as a whole.
    pub(crate) const WHOLE: usize = 16;

    /// The lowest degree that is tried, up to which control points are brought near the border.
    pub(crate) const LOWEST: usize = 12;

    /// The largest degree that is tried.
    const LARGEST: usize = 32;

    /// The degrees of displacements that are tried for a net of a high degree, at most: its own is the last, if it is none too high.
    pub(crate) fn tried(degree: usize) -> impl Iterator<Item = usize> {
        let whole = (degree <= Self::LARGEST).then_some(degree);
        DEGREES.into_iter().filter(move |&lower| lower < degree).chain(whole)
    }

    /// The degrees of the largest displacement that is tried for a net of these.
    pub(crate) fn largest((m, n): (usize, usize)) -> (usize, usize) {
        (m.min(Self::LARGEST), n.min(Self::LARGEST))
    }

    /// Whether the next degrees gain less than the tolerance.
    #[must_use]
    pub const fn has_converged(&self) -> bool {
        match self.end {
            DisplacementEnd::Tolerance => true,
            DisplacementEnd::Rounding { .. }
            | DisplacementEnd::Folds
            | DisplacementEnd::OutOfMemory { .. }
            | DisplacementEnd::Largest { .. } => false,
        }
    }
}

impl fmt::Display for Displacement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (m, n) = self.degrees;
        write!(f, "inside, the Coons patch is displaced by degree ({m}, {n}): ")?;
        match self.end {
            DisplacementEnd::Tolerance => f.write_str("the next degrees gain less than the tolerance"),
            DisplacementEnd::Rounding { gained } => {
                write!(
                    f,
                    "the next degrees gain {gained:.0e} of the area, no more than the rounding of their control points"
                )
            }
            DisplacementEnd::Folds => f.write_str("the next degrees lead to a net that nearly folds"),
            DisplacementEnd::OutOfMemory { bytes } => {
                write!(
                    f,
                    "the next degrees take about {:.0} MB, which cannot be allocated",
                    bytes as f64 / 1e6
                )
            }
            DisplacementEnd::Largest { gained } => {
                write!(f, "no higher ones are tried, and the last gained {gained:.0e} of the area")
            }
        }
    }
}
