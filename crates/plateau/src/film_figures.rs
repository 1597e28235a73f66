use surfaces::{Complex, Deviation};

use crate::{Seams, Way};

/// What is known of a surface over loops or a graph beside what any surface has.
#[derive(Debug, Clone)]
pub struct FilmFigures {
    names: Vec<String>,
    way: Way,
    rim: Deviation,
    seams: Seams,
    one_by_one: Option<f64>,
}

impl FilmFigures {
    /// Of a complex with one name for each vertex.
    pub(crate) fn new(
        complex: &Complex,
        names: Vec<String>,
        way: Way,
        rim: Deviation,
        (seams, one_by_one): (Seams, Option<f64>),
    ) -> Self {
        assert_eq!(names.len(), complex.vertices(), "one name a vertex");
        Self { names, way, rim, seams, one_by_one }
    }

    /// The names of the vertices of its complex.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// How the boundary was cut.
    #[must_use]
    pub fn way(&self) -> Way {
        self.way
    }

    /// How far its rim is from the curves that were given.
    #[must_use]
    pub fn rim(&self) -> &Deviation {
        &self.rim
    }

    /// How the patches meet.
    #[must_use]
    pub fn seams(&self) -> &Seams {
        &self.seams
    }

    /// For two loops and the least area: the area of the two surfaces that span each by itself.
    #[must_use]
    pub fn one_by_one(&self) -> Option<f64> {
        self.one_by_one
    }
}
