//! What an extremal or a search minimises.

use energy::Functional;

/// An energy of a patch (spec §2): a quadratic one, or the area.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Energy {
    /// A quadratic energy.
    Quadratic(Functional),
    /// ∫√(EG − F²).
    Area,
}

impl Energy {
    /// ½∫(E + G).
    pub const DIRICHLET: Self = Self::Quadratic(Functional::Dirichlet);
    /// ∫‖x_uu + x_vv‖².
    pub const LAPLACIAN: Self = Self::Quadratic(Functional::Laplacian);

    /// Every energy with its word, the quadratic ones first.
    pub const NAMED: [(&'static str, Self); Functional::ALL.len() + 1] = {
        let mut named = [("area", Self::Area); Functional::ALL.len() + 1];
        let mut k = 0;
        while k < Functional::ALL.len() {
            named[k] = (Functional::ALL[k].name(), Self::Quadratic(Functional::ALL[k]));
            k += 1;
        }
        named
    };
}
