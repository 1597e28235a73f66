//! The functions a surface is made of.

use surfaces::ShapedFamily;

/// A kind of surface by the functions that weigh its control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Tensor products of Bernstein polynomials.
    Bernstein,
    /// A family of tensor patches with shape parameters.
    Shaped(ShapedFamily),
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
    pub fn all() -> impl Iterator<Item = Self> {
        let shaped = ShapedFamily::ALL.into_iter().map(Self::Shaped);
        let others = [Self::Triangle, Self::Aht, Self::At, Self::Complex];
        [Self::Bernstein].into_iter().chain(shaped).chain(others)
    }

    /// The names of its shape parameters, those in u before those in v.
    #[must_use]
    pub fn parameters(self) -> &'static [&'static str] {
        match self {
            Self::Shaped(family) => family.parameters(),
            Self::Bernstein | Self::Triangle | Self::Aht | Self::At | Self::Complex => &[],
        }
    }

    /// `patch` and `basis` as `result.json` writes them.
    #[must_use]
    pub fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Bernstein => ("tensor", "bernstein"),
            Self::Shaped(family) => family.names(),
            Self::Triangle => ("triangle", "bernstein"),
            Self::Aht => ("tensor", "aht"),
            Self::At => ("tensor", "at"),
            Self::Complex => ("complex", "bernstein"),
        }
    }

    /// The family with these names.
    #[must_use]
    pub fn named(patch: &str, basis: &str) -> Option<Self> {
        Self::all().find(|family| family.names() == (patch, basis))
    }
}
