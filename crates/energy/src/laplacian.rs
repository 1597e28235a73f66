//! Laplacian defect (GT (6.4)): zero exactly for harmonic charts; its extremal is the quasi-harmonic patch.

use crate::DensityTerm;

pub(crate) const TERMS: [DensityTerm; 4] = [
    DensityTerm { coefficient: 1.0, u: (2, 2), v: (0, 0) },
    DensityTerm { coefficient: 1.0, u: (0, 0), v: (2, 2) },
    DensityTerm { coefficient: 1.0, u: (2, 0), v: (0, 2) },
    DensityTerm { coefficient: 1.0, u: (0, 2), v: (2, 0) },
];
