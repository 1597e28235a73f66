use crate::{bending, coons, dirichlet, laplacian};

/// One term `coefficient · ∂_u^{u.0} ∂_v^{v.0} S · ∂_u^{u.1} ∂_v^{v.1} S` of an energy density.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DensityTerm {
    /// Factor of the product.
    pub coefficient: f64,
    /// Orders of the u-derivatives of the first and the second factor.
    pub u: (usize, usize),
    /// Orders of the v-derivatives of the first and the second factor.
    pub v: (usize, usize),
}

/// The quadratic energies of a patch; each integrates a sum of products of two partial derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Functional {
    /// `½ ∫ ‖S_u‖² + ‖S_v‖²`, length².
    Dirichlet,
    /// `∫ ‖S_uu + S_vv‖²`, the Laplacian defect.
    Laplacian,
    /// `∫ ‖S_uu‖² + 2‖S_uv‖² + ‖S_vv‖²`, the bending energy of a linear plate.
    Bending,
    /// `∫ ‖S_uv‖²`, whose extremals are the Coons patches.
    Coons,
}

impl Functional {
    /// The terms of the density.
    pub fn terms(self) -> &'static [DensityTerm] {
        match self {
            Self::Dirichlet => &dirichlet::TERMS,
            Self::Laplacian => &laplacian::TERMS,
            Self::Bending => &bending::TERMS,
            Self::Coons => &coons::TERMS,
        }
    }

    /// The highest order of derivative in one variable that the density holds.
    pub fn order(self) -> usize {
        self.terms().iter().map(|t| t.u.0.max(t.u.1).max(t.v.0).max(t.v.1)).max().unwrap_or(0)
    }
}
