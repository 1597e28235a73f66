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
}
