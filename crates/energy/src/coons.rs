//! Coons functional (COONS (1), (4)): its extremals among all charts are the bilinearly blended Coons patches.

use crate::DensityTerm;

pub(crate) const TERMS: [DensityTerm; 1] = [DensityTerm { coefficient: 1.0, u: (1, 1), v: (1, 1) }];
