use crate::{Arithmetic, Keeper, Progress, Search, Solved};

/// What a method may use besides its boundary, and who watches it.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct Context<'a> {
    /// How shape parameters are searched.
    pub search: Search,
    /// The seed of searches.
    pub seed: u64,
    /// Which arithmetic evaluates the energy in searches.
    pub arithmetic: Arithmetic,
    /// Subdivisions of each side of the mesh that the largest curvature is taken from.
    pub mesh: usize,
    /// The number under which the keeper knows the method.
    pub index: usize,
    /// What other methods found over the same boundary: no least area ends above these.
    pub at_hand: &'a [&'a Solved],
    /// Where runs of searches that have ended are kept.
    pub keeper: &'a dyn Keeper,
    /// Who watches.
    pub progress: &'a dyn Progress,
}

impl Context<'_> {
    /// Searches as in GT §5 from this seed, a mesh of 48 subdivisions; nobody watches, nothing is kept.
    pub fn new(seed: u64) -> Self {
        Self {
            search: Search::default(),
            seed,
            arithmetic: Arithmetic::default(),
            mesh: 48,
            index: 0,
            at_hand: &[],
            keeper: &(),
            progress: &(),
        }
    }
}
