use surfaces::Deviation;

use crate::{Seams, Way};

/// What is known of a surface over loops or a graph beside what any surface has.
#[derive(Debug, Clone)]
pub struct FilmFigures {
    /// The names of the vertices of its complex.
    pub names: Vec<String>,
    /// How the boundary was cut.
    pub way: Way,
    /// How far its rim is from the curves that were given.
    pub rim: Deviation,
    /// How the patches meet.
    pub seams: Seams,
    /// For two loops and the least area: the area of the two surfaces that span each by itself.
    pub one_by_one: Option<f64>,
}
