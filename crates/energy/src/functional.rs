//! The quadratic energies of a patch: one table of them.

use surfaces::Jet;

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

/// The enum, the list of its variants, which none can be left out of, and their words.
macro_rules! functionals {
    ($($(#[$meaning:meta])* $variant:ident = $word:literal;)*) => {
        /// The quadratic energies of a patch; each integrates a sum of products of two partial derivatives.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Functional {
            $($(#[$meaning])* $variant,)*
        }

        impl Functional {
            /// Every one of them.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$variant),*];

            /// Its word.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $word,)*
                }
            }
        }
    };
}

functionals! {
    /// `½ ∫ ‖S_u‖² + ‖S_v‖²`, length² (GT (3.3)): never below the area, and equal to it exactly for conformal charts.
    Dirichlet = "dirichlet";
    /// `∫ ‖S_uu + S_vv‖²`, the Laplacian defect (GT (6.4)): zero exactly for harmonic charts; its extremal is the quasi-harmonic patch.
    Laplacian = "laplacian";
    /// `∫ ‖S_uu‖² + 2‖S_uv‖² + ‖S_vv‖²`, the bending energy of a linear plate: the bending-energy method of GT Table 1.
    Bending = "bending";
    /// `∫ ‖S_uv‖²`, the Coons functional (COONS (1), (4)): its extremals among all charts are the bilinearly blended Coons patches.
    Coons = "coons";
}

/// Over the equilateral triangle of area ½ the inverse metric of (u, v) is `c [1 −½; −½ 1]` with c = 2/√3.
const C: f64 = 1.154_700_538_379_251_5;
const C2: f64 = 4.0 / 3.0;

const fn term(coefficient: f64, u: (usize, usize), v: (usize, usize)) -> DensityTerm {
    DensityTerm { coefficient, u, v }
}

impl Functional {
    /// The terms of the density.
    #[must_use]
    pub const fn terms(self) -> &'static [DensityTerm] {
        const DIRICHLET: [DensityTerm; 2] = [term(0.5, (1, 1), (0, 0)), term(0.5, (0, 0), (1, 1))];
        const LAPLACIAN: [DensityTerm; 4] = [
            term(1.0, (2, 2), (0, 0)),
            term(1.0, (0, 0), (2, 2)),
            term(1.0, (2, 0), (0, 2)),
            term(1.0, (0, 2), (2, 0)),
        ];
        const BENDING: [DensityTerm; 3] =
            [term(1.0, (2, 2), (0, 0)), term(1.0, (0, 0), (2, 2)), term(2.0, (1, 1), (1, 1))];
        const COONS: [DensityTerm; 1] = [term(1.0, (1, 1), (1, 1))];
        match self {
            Self::Dirichlet => &DIRICHLET,
            Self::Laplacian => &LAPLACIAN,
            Self::Bending => &BENDING,
            Self::Coons => &COONS,
        }
    }

    /// The terms of the density over the equilateral triangle of area ½, on which u and v are barycentric.
    pub(crate) const fn equilateral_terms(self) -> &'static [DensityTerm] {
        // `(E − F + G)/√3`.
        const DIRICHLET: [DensityTerm; 4] = [
            term(C / 2.0, (1, 1), (0, 0)),
            term(C / 2.0, (0, 0), (1, 1)),
            term(-C / 4.0, (1, 0), (0, 1)),
            term(-C / 4.0, (0, 1), (1, 0)),
        ];

        // `4/3 ‖x_uu − x_uv + x_vv‖²`.
        const LAPLACIAN: [DensityTerm; 9] = [
            term(C2, (2, 2), (0, 0)),
            term(C2, (1, 1), (1, 1)),
            term(C2, (0, 0), (2, 2)),
            term(-C2, (2, 1), (0, 1)),
            term(-C2, (1, 2), (1, 0)),
            term(C2, (2, 0), (0, 2)),
            term(C2, (0, 2), (2, 0)),
            term(-C2, (1, 0), (1, 2)),
            term(-C2, (0, 1), (2, 1)),
        ];

        // `4/3 (‖x_uu‖² + ‖x_vv‖² + 5/2 ‖x_uv‖² − 2 x_uu·x_uv − 2 x_uv·x_vv + ½ x_uu·x_vv)`, the squared norm of the second derivatives.
        const BENDING: [DensityTerm; 9] = [
            term(C2, (2, 2), (0, 0)),
            term(C2, (0, 0), (2, 2)),
            term(2.5 * C2, (1, 1), (1, 1)),
            term(-C2, (2, 1), (0, 1)),
            term(-C2, (1, 2), (1, 0)),
            term(-C2, (1, 0), (1, 2)),
            term(-C2, (0, 1), (2, 1)),
            term(C2 / 4.0, (2, 0), (0, 2)),
            term(C2 / 4.0, (0, 2), (2, 0)),
        ];

        // `‖x_uv‖² + ‖x_uu − x_uv‖² + ‖x_vv − x_uv‖²`: the mixed derivative along the two sides of each corner.
        const COONS: [DensityTerm; 7] = [
            term(3.0, (1, 1), (1, 1)),
            term(1.0, (2, 2), (0, 0)),
            term(1.0, (0, 0), (2, 2)),
            term(-1.0, (2, 1), (0, 1)),
            term(-1.0, (1, 2), (1, 0)),
            term(-1.0, (1, 0), (1, 2)),
            term(-1.0, (0, 1), (2, 1)),
        ];
        match self {
            Self::Dirichlet => &DIRICHLET,
            Self::Laplacian => &LAPLACIAN,
            Self::Bending => &BENDING,
            Self::Coons => &COONS,
        }
    }

    /// The density at a point of a patch.
    #[must_use]
    pub fn density(self, jet: &Jet) -> f64 {
        let term = |term: &DensityTerm| {
            let (s, t) = (jet.derivative(term.u.0, term.v.0), jet.derivative(term.u.1, term.v.1));
            term.coefficient * s.dot(t)
        };
        self.terms().iter().map(term).sum()
    }

    /// The highest order of derivative in one variable that the density holds.
    pub fn order(self) -> usize {
        self.terms().iter().map(|t| t.u.0.max(t.u.1).max(t.v.0).max(t.v.1)).max().unwrap_or(0)
    }
}
