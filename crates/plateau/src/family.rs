//! The functions a surface is made of.

use bases::BasisFamily;
use surfaces::ShapedFamily;

/// The enum and the list of its variants, which none can be left out of, with what `result.json` calls them.
macro_rules! families {
    ($($(#[$meaning:meta])* $variant:ident = $patch:expr, $basis:ident;)*) => {
        /// A kind of surface by the functions that weigh its control points.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Family {
            $($(#[$meaning])* $variant,)*
            /// A family of tensor patches with shape parameters.
            Shaped(ShapedFamily),
        }

        impl Family {
            /// Every family.
            pub fn all() -> impl Iterator<Item = Self> {
                [$(Self::$variant),*].into_iter().chain(ShapedFamily::ALL.into_iter().map(Self::Shaped))
            }

            /// `patch` and `basis` as `result.json` writes them.
            #[must_use]
            pub fn names(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$variant => ($patch, BasisFamily::$basis.name()),)*
                    Self::Shaped(family) => family.names(),
                }
            }

            /// The names of its shape parameters, those in u before those in v.
            #[must_use]
            pub fn parameters(self) -> &'static [&'static str] {
                match self {
                    $(Self::$variant => &[],)*
                    Self::Shaped(family) => family.parameters(),
                }
            }
        }
    };
}

families! {
    /// Tensor products of Bernstein polynomials.
    Bernstein = ShapedFamily::TENSOR, Bernstein;
    /// Bernstein polynomials of a triangle.
    Triangle = "triangle", Bernstein;
    /// Algebraic–hyperbolic–trigonometric functions of order 6 in both directions (AHT).
    Aht = ShapedFamily::TENSOR, Aht;
    /// Degree 1 in u, algebraic–trigonometric functions of order 6 in v (AT).
    At = ShapedFamily::TENSOR, At;
    /// Tensor products of Bernstein polynomials on faces that share edges.
    Complex = "complex", Bernstein;
}

impl Family {
    /// The family with these names.
    #[must_use]
    pub fn named(patch: &str, basis: &str) -> Option<Self> {
        Self::all().find(|family| family.names() == (patch, basis))
    }
}
