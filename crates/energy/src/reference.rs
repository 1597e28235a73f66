//! The plane triangle over which a triangular patch is a chart.

use crate::{DensityTerm, Functional};

/// Over which plane triangle of area ½ the derivatives of an energy are taken.
///
/// Which triangle it is decides what a quadratic energy is: the Dirichlet energy of the papers is that over the right triangle
/// with the corner C = (0, 0) between the legs u and v, so that its extremal depends on which corner of a boundary comes last. Over the
/// equilateral triangle no corner is apart: the extremals turn with the corners.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum ReferenceTriangle {
    /// `u, v ≥ 0, u + v ≤ 1` with orthonormal u and v (TRI, COONS).
    #[default]
    Right,
    /// The equilateral one, on which u and v are barycentric.
    Equilateral,
}

impl ReferenceTriangle {
    /// The terms of the density of `functional` over this triangle, in derivatives by u and v; symmetric together.
    ///
    /// The Coons functional is no energy of a metric: over the equilateral triangle it is the sum over the three corners.
    pub fn terms(self, functional: Functional) -> &'static [DensityTerm] {
        match self {
            Self::Right => functional.terms(),
            Self::Equilateral => functional.equilateral_terms(),
        }
    }
}
