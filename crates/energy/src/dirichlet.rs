//! Dirichlet energy (GT (3.3)): never below the area, and equal to it exactly for conformal charts.

use crate::DensityTerm;

pub(crate) const TERMS: [DensityTerm; 2] = [
    DensityTerm { coefficient: 0.5, u: (1, 1), v: (0, 0) },
    DensityTerm { coefficient: 0.5, u: (0, 0), v: (1, 1) },
];
