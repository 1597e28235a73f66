//! Patches over a fixed boundary net.

use plateau::{Boundary, Method, Search};

/// Patches over one boundary, one row of the table per method.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchExperiment {
    /// The fixed control points.
    pub boundary: Boundary,
    /// At least one; names are unique.
    pub methods: Vec<Method>,
    /// How shape parameters are searched, for the methods with [`Functions::Searched`](plateau::Functions::Searched).
    pub search: Search,
}
