//! Inner products of functions and their derivatives.

use crate::{Basis, BasisError, GaussLegendre, Matrix};

/// A family sampled with its derivatives at the points of a Gauss rule: what inner products, and solvers that
/// avoid them, are made from.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    nodes: Vec<f64>,
    weights: Vec<f64>,
    orders: Vec<Matrix>,
}

impl Samples {
    /// Samples `basis` with derivatives up to `order` at the `points`-point Gauss rule of its domain.
    ///
    /// # Errors
    /// [`BasisError::Points`] for a rule that is not offered.
    pub fn new(basis: &dyn Basis, points: usize, order: usize) -> Result<Self, BasisError> {
        let (start, end) = basis.domain();
        let rule = GaussLegendre::new(points)?.on(start, end);
        let count = basis.count();
        let mut orders = vec![Matrix::zeros(points, count); order + 1];
        let (mut nodes, mut weights) = (Vec::with_capacity(points), Vec::with_capacity(points));
        for (p, (t, w)) in rule.iter().enumerate() {
            let table = basis.evaluate(t, order);
            for (r, samples) in orders.iter_mut().enumerate() {
                samples.row_mut(p).copy_from_slice(table.row(r));
            }
            nodes.push(t);
            weights.push(w);
        }
        Ok(Self { nodes, weights, orders })
    }

    /// The size of a rule that integrates products of any two functions of `count`-function families of this
    /// crate, or of their derivatives, to rounding.
    ///
    /// Exact for polynomials of the same count; the trigonometric and hyperbolic factors of the other families
    /// vary slowly enough over their whole domain that 16 further points leave an error below 10⁻²⁵.
    pub fn points_for(count: usize) -> usize {
        count + 16
    }

    /// The nodes of the rule, ascending.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// The weights of the rule, positive.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Derivatives of order `r`: entry (p, k) is `φ_k^{(r)}` at node p.
    ///
    /// # Panics
    /// If the family was not sampled to that order.
    pub fn order(&self, r: usize) -> &Matrix {
        &self.orders[r]
    }

    /// `∫ φ_i^{(r)} ψ_j^{(q)}`: φ of `self` by rows, ψ of `other` by columns.
    ///
    /// Symmetric and positive semidefinite for `self == other`, r = q; positive definite for r = 0 if the family is
    /// independent. Its condition grows like 4ⁿ for Bernstein-like families of degree n: read energies from
    /// it, but do not factor it at high degree.
    ///
    /// # Panics
    /// If the two were not sampled by the same rule, or not to these orders.
    #[track_caller]
    pub fn gram(&self, r: usize, other: &Self, q: usize) -> Matrix {
        assert_eq!(self.nodes, other.nodes, "both families must be sampled at the same nodes");
        let (f, g) = (self.order(r), other.order(q));
        let mut gram = Matrix::zeros(f.cols(), g.cols());
        for (p, &w) in self.weights.iter().enumerate() {
            for (i, &a) in f.row(p).iter().enumerate() {
                for (entry, &b) in gram.row_mut(i).iter_mut().zip(g.row(p)) {
                    *entry += w * (a * b);
                }
            }
        }
        gram
    }
}

/// The Gram matrix `∫ φ_i^{(r)} φ_j^{(q)}` of one family over its domain, to rounding.
///
/// # Errors
/// [`BasisError::Points`] if the family is larger than the largest rule.
///
/// ```
/// let linear = bases::Bernstein::new(1)?;
/// let mass = bases::gram(&linear, 0, 0)?;
/// assert!((mass[(0, 1)] - 1.0 / 6.0).abs() < 1e-16);
/// # Ok::<(), bases::BasisError>(())
/// ```
pub fn gram(basis: &dyn Basis, r: usize, q: usize) -> Result<Matrix, BasisError> {
    let samples = Samples::new(basis, Samples::points_for(basis.count()), r.max(q))?;
    Ok(samples.gram(r, &samples, q))
}
