use crate::{Jet, Point};

/// The parameter domain of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Domain {
    /// `[u.0, u.1] × [v.0, v.1]`.
    Rectangle {
        /// Range of u.
        u: (f64, f64),
        /// Range of v.
        v: (f64, f64),
    },
    /// `u, v ≥ 0, u + v ≤ 1`.
    Triangle,
}

/// A smooth parametric surface over a [`Domain`].
pub trait Patch: Send + Sync {
    /// Where the parameters range.
    fn domain(&self) -> Domain;

    /// Position and derivatives to second order at (u, v).
    fn jet(&self, u: f64, v: f64) -> Jet;

    /// The jets on the grid `us × vs`, all v of the first u first. Patches with separated variables do this
    /// faster than point by point.
    fn jets(&self, us: &[f64], vs: &[f64]) -> Vec<Jet> {
        us.iter().flat_map(|&u| vs.iter().map(move |&v| (u, v))).map(|(u, v)| self.jet(u, v)).collect()
    }

    /// The points at scattered parameters (u, v), in their order: those of [`Self::point`], bit for bit. Patches on nets allocate
    /// nothing for each of them.
    fn points_at(&self, parameters: &[[f64; 2]]) -> Vec<Point> {
        parameters.iter().map(|&[u, v]| self.point(u, v)).collect()
    }

    /// The jets at scattered parameters (u, v), in their order: those of [`Self::jet`], bit for bit.
    fn jets_at(&self, parameters: &[[f64; 2]]) -> Vec<Jet> {
        parameters.iter().map(|&[u, v]| self.jet(u, v)).collect()
    }

    /// How many terms are summed for each jet of a grid: what bounds the work of a quadrature. 1 where the variables separate,
    /// so that a jet of a grid costs little.
    fn terms(&self) -> usize {
        1
    }

    /// The point at (u, v).
    fn point(&self, u: f64, v: f64) -> Point {
        self.jet(u, v).point
    }
}
