//! Quadratic energies as forms of the control net.

use bases::{Basis, Matrix, Samples};
use surfaces::{Product, TensorPatch};

use crate::{EnergyError, Functional};

/// `coefficient · left ⊗ right`: `left` is (m+1)², for the row index i; `right` is (n+1)², for the column index j.
#[derive(Debug, Clone, PartialEq)]
pub struct KroneckerTerm {
    /// Factor of the product.
    pub coefficient: f64,
    /// The u-factor.
    pub left: Matrix,
    /// The v-factor.
    pub right: Matrix,
}

/// The energy `Σ_d X_dᵀ Q X_d` of a net X with coordinates d = x, y, z, where `Q = Σ coefficient · left ⊗ right`.
///
/// Q is (points)², symmetric as a whole, positive semidefinite for every [`Functional`]; for the Dirichlet energy
/// and the Coons functional it is positive definite on the interior of a net over independent families. It is never
/// formed unless asked for: products with it cost O(n³) for an n × n net.
///
/// Nets are passed as their coordinates, (points × 3) row by row, as `surfaces::Net::coordinates` gives them.
///
/// ```
/// use energy::{Functional, QuadraticForm};
/// use surfaces::{Net, Point, TensorPatch};
/// // The unit square has area, and Dirichlet energy, 1.
/// let corners = [[0., 0., 0.], [0., 1., 0.], [1., 0., 0.], [1., 1., 0.]].map(Point::from);
/// let patch = TensorPatch::bernstein(Net::new(2, 2, corners.to_vec())?)?;
/// let dirichlet = QuadraticForm::of(Functional::Dirichlet, &patch)?;
/// assert!((dirichlet.value(&patch.net().coordinates()) - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QuadraticForm {
    rows: usize,
    cols: usize,
    terms: Vec<KroneckerTerm>,
}

impl QuadraticForm {
    /// The form of `functional` for the families of `patch`; the net of the patch plays no part.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] if a family is too large to be integrated.
    pub fn of(functional: Functional, patch: &TensorPatch) -> Result<Self, EnergyError> {
        let (rows, cols) = (patch.net().rows(), patch.net().cols());
        Self::of_products(functional, patch.products(), rows, cols)
    }

    fn of_products(
        functional: Functional,
        products: &[Product],
        rows: usize,
        cols: usize,
    ) -> Result<Self, EnergyError> {
        let order = functional.order();
        let sample = |basis: &dyn Basis, count| Samples::new(basis, Samples::points_for(count), order);
        let u: Vec<Samples> =
            products.iter().map(|p| sample(p.u.as_ref(), rows)).collect::<Result<_, _>>()?;
        let v: Vec<Samples> =
            products.iter().map(|p| sample(p.v.as_ref(), cols)).collect::<Result<_, _>>()?;
        let mut terms = Vec::with_capacity(products.len().pow(2) * functional.terms().len());
        for s in 0..products.len() {
            for r in 0..products.len() {
                for term in functional.terms() {
                    terms.push(KroneckerTerm {
                        coefficient: term.coefficient,
                        left: u[s].gram(term.u.0, &u[r], term.u.1),
                        right: v[s].gram(term.v.0, &v[r], term.v.1),
                    });
                }
            }
        }
        Ok(Self { rows, cols, terms })
    }

    /// The Kronecker products that Q is the sum of.
    pub fn terms(&self) -> &[KroneckerTerm] {
        &self.terms
    }

    /// The energy of the net `x`: exact for the families but for rounding.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    pub fn value(&self, x: &[f64]) -> f64 {
        self.apply(x).iter().zip(x).map(|(q, x)| q * x).sum()
    }

    /// The gradient `2 Q X` of the energy, in the layout of `x`.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    pub fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let mut gradient = self.apply(x);
        gradient.iter_mut().for_each(|g| *g *= 2.0);
        gradient
    }

    /// `Q X` for the net `x`, in its layout: `Σ coefficient · left X rightᵀ` for each coordinate.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    #[track_caller]
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        let (rows, cols) = (self.rows, self.cols);
        assert_eq!(x.len(), 3 * rows * cols, "coordinates of a {rows} × {cols} net");
        let mut product = vec![0.0; x.len()];
        let mut half = vec![0.0; x.len()];
        for term in &self.terms {
            // half = left X, then product += half rightᵀ.
            half.fill(0.0);
            for i in 0..rows {
                let out = &mut half[3 * i * cols..3 * (i + 1) * cols];
                for (k, &l) in term.left.row(i).iter().enumerate() {
                    for (h, x) in out.iter_mut().zip(&x[3 * k * cols..3 * (k + 1) * cols]) {
                        *h += l * x;
                    }
                }
            }
            for i in 0..rows {
                for j in 0..cols {
                    for (l, &r) in term.right.row(j).iter().enumerate() {
                        for d in 0..3 {
                            product[3 * (i * cols + j) + d] +=
                                term.coefficient * r * half[3 * (i * cols + l) + d];
                        }
                    }
                }
            }
        }
        product
    }

    /// The dense matrix Q: (points)², symmetric, row-major over points `i · (n+1) + j`.
    pub fn matrix(&self) -> Matrix {
        let cols = self.cols;
        let mut matrix = Matrix::zeros(self.rows * cols, self.rows * cols);
        for term in &self.terms {
            for i in 0..self.rows {
                for k in 0..self.rows {
                    let l = term.coefficient * term.left[(i, k)];
                    for j in 0..cols {
                        for m in 0..cols {
                            matrix[(i * cols + j, k * cols + m)] += l * term.right[(j, m)];
                        }
                    }
                }
            }
        }
        matrix
    }
}
