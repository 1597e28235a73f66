//! Bending energy of the chart: the bending-energy method of GT Table 1.

use crate::DensityTerm;

pub(crate) const TERMS: [DensityTerm; 3] = [
    DensityTerm { coefficient: 1.0, u: (2, 2), v: (0, 0) },
    DensityTerm { coefficient: 1.0, u: (0, 0), v: (2, 2) },
    DensityTerm { coefficient: 2.0, u: (1, 1), v: (1, 1) },
];
