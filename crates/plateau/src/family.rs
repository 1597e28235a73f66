//! The functions a surface is made of.

/// A kind of surface by the functions that weigh its control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Tensor products of Bernstein polynomials.
    Bernstein,
    /// Tensor products of generalized trigonometric functions (GT).
    Gt,
    /// The Bernstein–GT Coons blend (GT §7).
    TbCoons,
    /// Bernstein polynomials of a triangle.
    Triangle,
    /// Algebraic–hyperbolic–trigonometric functions of order 6 in both directions (AHT).
    Aht,
    /// Degree 1 in u, algebraic–trigonometric functions of order 6 in v (AT).
    At,
    /// Tensor products of Bernstein polynomials on faces that share edges.
    Complex,
}

impl Family {
    /// Every family.
    pub const ALL: [Self; 7] =
        [Self::Bernstein, Self::Gt, Self::TbCoons, Self::Triangle, Self::Aht, Self::At, Self::Complex];

    /// `patch` and `basis` as `result.json` writes them.
    #[must_use]
    pub fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Bernstein => ("tensor", "bernstein"),
            Self::Gt => ("tensor", "gt"),
            Self::TbCoons => ("tb-coons", "gt"),
            Self::Triangle => ("triangle", "bernstein"),
            Self::Aht => ("tensor", "aht"),
            Self::At => ("tensor", "at"),
            Self::Complex => ("complex", "bernstein"),
        }
    }

    /// The family with these names.
    #[must_use]
    pub fn named(patch: &str, basis: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.names() == (patch, basis))
    }
}
