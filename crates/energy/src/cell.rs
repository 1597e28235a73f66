//! The area of a surface of cells to second order, in the values at their nodes.

use std::fmt::Debug;

use bases::Matrix;
use surfaces::Point;

use crate::EnergyError;
use crate::area_hessian::Density;

/// How a node may move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Freedom {
    /// Not at all: no unknown.
    Fixed,
    /// Along this direction: one unknown.
    Along(Point),
    /// Anywhere: three unknowns, x, y, z.
    Free,
}

impl Freedom {
    /// The directions of its unknowns.
    pub fn directions(&self) -> &[Point] {
        const AXES: [Point; 3] =
            [Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0), Point::new(0.0, 0.0, 1.0)];
        match self {
            Self::Fixed => &[],
            Self::Along(direction) => std::slice::from_ref(direction),
            Self::Free => &AXES,
        }
    }
}

/// The functions ψ_k of the nodes of one cell at the points p of a quadrature rule over its parameters: what the area of
/// `x = Σ_k X_k ψ_k` and its derivatives are summed from.
///
/// Sums over the points are weighted by the rule; forms are symmetric matrices over the unknowns of the nodes, node after
/// node, in the order of [`Freedom::directions`].
pub trait Cell: Debug + Send + Sync {
    /// Number of nodes.
    fn nodes(&self) -> usize;

    /// The weights w_p of the rule.
    fn weights(&self) -> &[f64];

    /// The parameters (u, v) of the points of the rule.
    fn parameters(&self) -> Vec<[f64; 2]>;

    /// `(x_u, x_v)` at the points.
    fn tangents(&self, x: &[Point]) -> Vec<[Point; 2]>;

    /// `Σ_p ∂uψ_k a_p + ∂vψ_k b_p` for every node k, given (a_p, b_p): the transpose of [`Self::tangents`], no weights.
    fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point>;

    /// `Σ_p a ∂uψ_k ∂uψ_l + b (∂uψ_k ∂vψ_l + ∂vψ_k ∂uψ_l) + c ∂vψ_k ∂vψ_l` over the nodes wanted, given (a, b, c) at
    /// every point, no weights.
    fn stiffness(&self, wanted: &[bool], forms: &[[f64; 3]]) -> Matrix;

    /// `Σ_p a ψ_k ψ_l` over the nodes wanted, given a at every point, no weights.
    fn mass(&self, wanted: &[bool], factors: &[f64]) -> Matrix;

    /// The second derivatives of the area of the surface with these tangents.
    ///
    /// # Errors
    /// [`EnergyError::Singular`] where the tangents are parallel at a point of the rule.
    fn hessian(&self, freedoms: &[Freedom], tangents: &[[Point; 2]]) -> Result<Matrix, EnergyError> {
        let mut hessian = Matrix::zeros(0, 0);
        self.hessian_into(freedoms, tangents, &mut hessian)?;
        Ok(hessian)
    }

    /// [`Self::hessian`], written over `hessian`, whose memory serves again if it has the same size.
    ///
    /// # Errors
    /// As [`Self::hessian`]; what `hessian` holds is then of no use.
    fn hessian_into(
        &self,
        freedoms: &[Freedom],
        tangents: &[[Point; 2]],
        hessian: &mut Matrix,
    ) -> Result<(), EnergyError>;

    /// The area of the surface with these tangents; its derivative is [`Self::area_gradient`]. Points where the tangents
    /// are parallel add nothing.
    fn area(&self, tangents: &[[Point; 2]]) -> f64 {
        // By lines of a few points, so that rounding grows like the root of their number at most.
        let parts = tangents.chunks(LINE).zip(self.weights().chunks(LINE));
        parts
            .map(|(line, weights)| {
                line.iter().zip(weights).map(|([u, v], w)| w * u.cross(*v).norm()).sum::<f64>()
            })
            .sum()
    }

    /// The derivative of the area by every node.
    ///
    /// # Errors
    /// As [`Self::hessian`].
    fn area_gradient(&self, tangents: &[[Point; 2]]) -> Result<Vec<Point>, EnergyError> {
        let mut slopes = Vec::with_capacity(tangents.len());
        for (p, (&[x_u, x_v], &w)) in tangents.iter().zip(self.weights()).enumerate() {
            let (_, by_u, by_v) = Density::slope(x_u, x_v).ok_or_else(|| self.singular(p))?;
            slopes.push([by_u * w, by_v * w]);
        }
        Ok(self.adjoint(&slopes))
    }

    /// The Dirichlet product in the metric of the surface with these tangents:
    /// `∫ (G ∂uψ_k ∂uψ_l − F (∂uψ_k ∂vψ_l + ∂vψ_k ∂uψ_l) + E ∂vψ_k ∂vψ_l)/√(EG − F²)`; positive semidefinite.
    ///
    /// # Errors
    /// As [`Self::hessian`].
    fn metric(&self, wanted: &[bool], tangents: &[[Point; 2]]) -> Result<Matrix, EnergyError> {
        Ok(self.stiffness(wanted, &self.metric_forms(tangents)?))
    }

    /// The coefficients of [`Self::metric`] at the points, weighted.
    ///
    /// # Errors
    /// As [`Self::hessian`].
    fn metric_forms(&self, tangents: &[[Point; 2]]) -> Result<Vec<[f64; 3]>, EnergyError> {
        let points = tangents.iter().zip(self.weights()).enumerate();
        points
            .map(|(p, (&[x_u, x_v], &w))| {
                let (density, _, _) = Density::slope(x_u, x_v).ok_or_else(|| self.singular(p))?;
                let scale = w / density;
                Ok([scale * x_v.dot(x_v), -scale * x_u.dot(x_v), scale * x_u.dot(x_u)])
            })
            .collect()
    }

    /// That the surface is singular at point `p` of the rule.
    fn singular(&self, p: usize) -> EnergyError {
        let [u, v] = self.parameters()[p];
        EnergyError::Singular { u, v }
    }
}

/// Points summed before their sum is added to that of others.
const LINE: usize = 32;

/// The first unknown of every node, and how many there are.
pub(crate) fn numbered(counts: impl Iterator<Item = usize>) -> (Vec<usize>, usize) {
    let (mut first, mut size) = (Vec::new(), 0);
    for count in counts {
        first.push(size);
        size += count;
    }
    (first, size)
}
