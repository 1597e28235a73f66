//! First derivatives of functions sampled at the points of a rule.

use std::ops::Range;

use bases::{GaussLegendre, Matrix};
use surfaces::{Domain, Patch, Point, TensorPatch, TriangleBasis};

use crate::EnergyError;

/// The derivatives ∂uφ_k, ∂vφ_k of scalar functions φ_k at the points of a quadrature rule: all that energies of first
/// order need to know of the functions.
///
/// The functions need not be those of a net: any linear combinations serve ([`Self::combined`]), for example an
/// orthonormal basis of the interior ones.
#[derive(Debug, Clone, PartialEq)]
pub struct TangentSamples {
    parameters: Vec<[f64; 2]>,
    weights: Vec<f64>,
    u: Matrix,
    v: Matrix,
}

impl TangentSamples {
    /// Samples at `parameters` with the given weights; `u` and `v` are (points × functions).
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the sizes do not agree.
    pub fn new(
        parameters: Vec<[f64; 2]>,
        weights: Vec<f64>,
        u: Matrix,
        v: Matrix,
    ) -> Result<Self, EnergyError> {
        let points = parameters.len();
        for (what, expected, found) in [
            ("weights of sampled functions", points, weights.len()),
            ("rows of sampled u-derivatives", points, u.rows()),
            ("rows of sampled v-derivatives", points, v.rows()),
            ("columns of sampled v-derivatives", u.cols(), v.cols()),
        ] {
            if expected != found {
                return Err(EnergyError::Shape { what, expected, found });
            }
        }
        Ok(Self { parameters, weights, u, v })
    }

    /// The functions of a triangular net of degree `degree`, in its order, at the rule of `points`² points of the square
    /// collapsed onto the triangle (u = s, v = (1 − s) t): exact for polynomials of total degree 2 · points − 2.
    ///
    /// In batches of whole lines of constant u, some hundred points each, so that large rules need no large tables.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a degree or a rule that is not offered.
    pub fn of_triangle(degree: usize, points: usize) -> Result<impl Iterator<Item = Self>, EnergyError> {
        let basis = TriangleBasis::new(degree)?;
        let rule = Collapsed::new(points)?;
        let count = basis.count();
        let mut table = vec![0.0; 3 * count];
        Ok(batches(points).map(move |lines| {
            let mut batch = Self::empty(lines.len() * points, count);
            for (p, (u, v, weight)) in lines.flat_map(|a| rule.line(a)).enumerate() {
                basis.evaluate_into(u, v, 1, &mut table);
                batch.parameters.push([u, v]);
                batch.weights.push(weight);
                batch.u.row_mut(p).copy_from_slice(&table[count..2 * count]);
                batch.v.row_mut(p).copy_from_slice(&table[2 * count..]);
            }
            batch
        }))
    }

    /// The functions of a tensor patch, row by row of its net, at the product rule of `points`² points, in batches of
    /// whole lines of constant u.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a rule that is not offered.
    pub fn of_tensor(patch: &TensorPatch, points: usize) -> Result<impl Iterator<Item = Self>, EnergyError> {
        let unit = GaussLegendre::new(points)?;
        let Domain::Rectangle { u, v } = patch.domain() else {
            unreachable!("tensor patches live on rectangles")
        };
        let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
        let v_tables: Vec<Vec<Matrix>> = patch
            .products()
            .iter()
            .map(|product| rule_v.iter().map(|(v, _)| product.v.evaluate(v, 1)).collect())
            .collect();
        let (rows, cols) = (patch.net().rows(), patch.net().cols());
        Ok(batches(points).map(move |lines| {
            let mut batch = Self::empty(lines.len() * points, rows * cols);
            for a in lines {
                let u = rule_u.node(a);
                let start = batch.parameters.len();
                batch.parameters.extend(rule_v.iter().map(|(v, _)| [u, v]));
                batch.weights.extend(rule_v.iter().map(|(_, w)| rule_u.weight(a) * w));
                for (product, v_tables) in patch.products().iter().zip(&v_tables) {
                    let f = product.u.evaluate(u, 1);
                    for (b, g) in v_tables.iter().enumerate() {
                        let (du, dv) = (batch.u.row_mut(start + b), batch.v.row_mut(start + b));
                        for i in 0..rows {
                            for j in 0..cols {
                                du[i * cols + j] += f[(1, i)] * g[(0, j)];
                                dv[i * cols + j] += f[(0, i)] * g[(1, j)];
                            }
                        }
                    }
                }
            }
            batch
        }))
    }

    /// Tables of zeros to be filled, parameters and weights to be appended.
    fn empty(points: usize, functions: usize) -> Self {
        Self {
            parameters: Vec::with_capacity(points),
            weights: Vec::with_capacity(points),
            u: Matrix::zeros(points, functions),
            v: Matrix::zeros(points, functions),
        }
    }

    /// The functions `Σ_k φ_k map[k, l]`: `map` is (functions of these samples) × (functions of the result).
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the rows of `map` are not as many as the functions.
    pub fn combined(&self, map: &Matrix) -> Result<Self, EnergyError> {
        if map.rows() != self.functions() {
            return Err(EnergyError::Shape {
                what: "rows of a map of sampled functions",
                expected: self.functions(),
                found: map.rows(),
            });
        }
        Ok(Self { u: self.u.times(map), v: self.v.times(map), ..self.clone() })
    }

    /// The functions whose entry in `wanted` is true, in their order; functions beyond its end are dropped.
    pub fn selected(&self, wanted: &[bool]) -> Self {
        let kept: Vec<usize> = (0..self.functions()).filter(|&k| wanted.get(k) == Some(&true)).collect();
        let select = |m: &Matrix| Matrix::from_fn(m.rows(), kept.len(), |p, l| m[(p, kept[l])]);
        Self {
            parameters: self.parameters.clone(),
            weights: self.weights.clone(),
            u: select(&self.u),
            v: select(&self.v),
        }
    }

    /// The tangents `(x_u, x_v) = Σ_k P_k (∂uφ_k, ∂vφ_k)` at the points of the rule.
    ///
    /// # Panics
    /// If there are not as many points as functions.
    #[track_caller]
    pub fn tangents(&self, net: &[Point]) -> Vec<[Point; 2]> {
        assert_eq!(net.len(), self.functions(), "points of the net");
        let sum = |row: &[f64]| net.iter().zip(row).fold(Point::ZERO, |sum, (&p, &b)| sum + p * b);
        (0..self.points()).map(|p| [sum(self.u.row(p)), sum(self.v.row(p))]).collect()
    }

    /// The u-derivatives above the v-derivatives: 2 · points × functions.
    pub(crate) fn stacked(&self) -> Matrix {
        let points = self.points();
        let mut both = Matrix::zeros(2 * points, self.functions());
        let (above, below) = both.as_mut_slice().split_at_mut(points * self.functions());
        above.copy_from_slice(self.u.as_slice());
        below.copy_from_slice(self.v.as_slice());
        both
    }

    /// Number of points of the rule.
    pub fn points(&self) -> usize {
        self.parameters.len()
    }

    /// Number of functions.
    pub fn functions(&self) -> usize {
        self.u.cols()
    }

    /// Parameters (u, v) of the points.
    pub fn parameters(&self) -> &[[f64; 2]] {
        &self.parameters
    }

    /// Weights of the points.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// ∂uφ_k: points × functions.
    pub fn u(&self) -> &Matrix {
        &self.u
    }

    /// ∂vφ_k: points × functions.
    pub fn v(&self) -> &Matrix {
        &self.v
    }
}

/// The lines of a rule in groups of about [`BATCH`] points.
fn batches(points: usize) -> impl Iterator<Item = Range<usize>> {
    let lines = (BATCH / points).max(1);
    (0..points).step_by(lines).map(move |first| first..points.min(first + lines))
}

/// Points of a batch: enough to keep the sums of products in registers, few enough to keep their tables in cache.
const BATCH: usize = 256;

/// The product Gauss rule of the square collapsed onto the triangle.
pub(crate) struct Collapsed {
    unit: GaussLegendre,
}

impl Collapsed {
    pub(crate) fn new(points: usize) -> Result<Self, EnergyError> {
        Ok(Self { unit: GaussLegendre::new(points)? })
    }

    /// The points (u, v, weight) with the a-th value of u.
    pub(crate) fn line(&self, a: usize) -> Vec<(f64, f64, f64)> {
        let (s, weight) = (self.unit.node(a), self.unit.weight(a));
        self.unit.iter().map(|(t, w)| (s, (1.0 - s) * t, weight * (1.0 - s) * w)).collect()
    }

    pub(crate) fn lines(&self) -> impl Iterator<Item = Vec<(f64, f64, f64)>> + '_ {
        (0..self.unit.points()).map(|a| self.line(a))
    }
}
