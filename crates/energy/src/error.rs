use thiserror::Error;

/// Why an energy could not be assembled.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum EnergyError {
    /// The families of the patch cannot be integrated.
    #[error(transparent)]
    Basis(#[from] bases::BasisError),
    /// The patch or its net is not what the energy is for.
    #[error(transparent)]
    Surface(#[from] surfaces::SurfaceError),
    /// The complex cannot be had at the degree asked for.
    #[error(transparent)]
    Complex(#[from] surfaces::ComplexError),
    /// The chart is singular where the energy needs its normal or its metric.
    #[error(
        "the patch is singular at (u, v) = ({u:?}, {v:?}): x_u and x_v are parallel there (EG − F² = 0), as where it folds over between \
         sides that cross, or where control points are coincident or collinear"
    )]
    Singular {
        /// Parameter u.
        u: f64,
        /// Parameter v.
        v: f64,
    },
    /// A metric is taken from a patch over another domain.
    #[error("the metric must come from a patch over {expected:?}, got one over {found:?}")]
    Domain {
        /// The domain of the nets.
        expected: surfaces::Domain,
        /// The domain of the metric.
        found: surfaces::Domain,
    },
    /// Sizes that belong together disagree.
    #[error("{what}: expected {expected}, got {found}")]
    Shape {
        /// What is counted.
        what: &'static str,
        /// How many are needed.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}
