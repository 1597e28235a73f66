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

/// What the shape parameters of a family may be searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SearchEnergy {
    /// An energy of the patch.
    Energy(Energy),
    /// (D − A)/A of the patch, 0 exactly for conformal charts: no energy of an interior, because charts of one surface differ in it.
    Conformality,
}

impl SearchEnergy {
    /// Each with its word, the energies first.
    pub const NAMED: [(&'static str, Self); Energy::NAMED.len() + 1] = {
        let mut named = [("conformality", Self::Conformality); Energy::NAMED.len() + 1];
        let mut k = 0;
        while k < Energy::NAMED.len() {
            named[k] = (Energy::NAMED[k].0, Self::Energy(Energy::NAMED[k].1));
            k += 1;
        }
        named
    };
}

impl From<Energy> for SearchEnergy {
    fn from(energy: Energy) -> Self {
        Self::Energy(energy)
    }
}
