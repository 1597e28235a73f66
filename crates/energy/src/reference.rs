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

/// Over the equilateral triangle of area ½ the inverse metric of (u, v) is `c [1 −½; −½ 1]` with c = 2/√3.
const C: f64 = 1.154_700_538_379_251_5;
const C2: f64 = 4.0 / 3.0;

const fn term(coefficient: f64, u: (usize, usize), v: (usize, usize)) -> DensityTerm {
    DensityTerm { coefficient, u, v }
}

/// `(E − F + G)/√3`.
const DIRICHLET: [DensityTerm; 4] = [
    term(C / 2.0, (1, 1), (0, 0)),
    term(C / 2.0, (0, 0), (1, 1)),
    term(-C / 4.0, (1, 0), (0, 1)),
    term(-C / 4.0, (0, 1), (1, 0)),
];

/// `4/3 ‖x_uu − x_uv + x_vv‖²`.
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

/// `4/3 (‖x_uu‖² + ‖x_vv‖² + 5/2 ‖x_uv‖² − 2 x_uu·x_uv − 2 x_uv·x_vv + ½ x_uu·x_vv)`, the squared norm of the second derivatives.
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

/// `‖x_uv‖² + ‖x_uu − x_uv‖² + ‖x_vv − x_uv‖²`: the mixed derivative along the two sides of each corner.
const COONS: [DensityTerm; 7] = [
    term(3.0, (1, 1), (1, 1)),
    term(1.0, (2, 2), (0, 0)),
    term(1.0, (0, 0), (2, 2)),
    term(-1.0, (2, 1), (0, 1)),
    term(-1.0, (1, 2), (1, 0)),
    term(-1.0, (1, 0), (1, 2)),
    term(-1.0, (0, 1), (2, 1)),
];

impl ReferenceTriangle {
    /// The terms of the density of `functional` over this triangle, in derivatives by u and v; symmetric together.
    ///
    /// The Coons functional is no energy of a metric: over the equilateral triangle it is the sum over the three corners.
    pub fn terms(self, functional: Functional) -> &'static [DensityTerm] {
        match (self, functional) {
            (Self::Right, functional) => functional.terms(),
            (Self::Equilateral, Functional::Dirichlet) => &DIRICHLET,
            (Self::Equilateral, Functional::Laplacian) => &LAPLACIAN,
            (Self::Equilateral, Functional::Bending) => &BENDING,
            (Self::Equilateral, Functional::Coons) => &COONS,
        }
    }
}
