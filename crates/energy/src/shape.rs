//! Quadratic energies of patches with shape parameters as polynomials of them.
//!
//! The functions are affine in two coordinates of the shape in each direction ([`ShapedFamily::coordinates`]), so every Gram integral is a quadratic polynomial in them with six
//! constant matrices: assembled once, each shape then costs a few multiply-adds and no quadrature.

use bases::{Matrix, Samples};
use surfaces::{ShapeFactor, ShapedFamily};

use crate::{EnergyError, Functional};

/// A Gram matrix as a polynomial `Σ_p x_p(θ) C_p` with monomials x = (1, θ1, θ2, θ1², θ1θ2, θ2²).
#[derive(Debug, Clone, PartialEq)]
pub struct GramPolynomial {
    /// The six coefficient matrices, in the order of the monomials.
    pub coefficients: [Matrix; 6],
}

/// `coefficient · left ⊗ right`, by position in [`ShapeForm::left`] and [`ShapeForm::right`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeTerm {
    /// Factor of the product.
    pub coefficient: f64,
    /// Which u-factor.
    pub left: usize,
    /// Which v-factor.
    pub right: usize,
}

/// `Q(α) = Σ coefficient · left(α1, α2) ⊗ right(β1, β2)`: the form of a quadratic energy for every shape at once.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeForm {
    /// The distinct u-factors, (m+1)² each.
    pub left: Vec<GramPolynomial>,
    /// The distinct v-factors, (n+1)² each.
    pub right: Vec<GramPolynomial>,
    /// Which products Q is the sum of.
    pub terms: Vec<ShapeTerm>,
}

impl GramPolynomial {
    fn new(f: &Samples, r: usize, g: &Samples, q: usize) -> Self {
        let gram = f.gram(r, g, q);
        let n = gram.rows() / 3;
        let block = |a: usize, b: usize| Matrix::from_fn(n, n, |i, j| gram[(a * n + i, b * n + j)]);
        let both = |a: usize, b: usize| {
            Matrix::from_fn(n, n, |i, j| gram[(a * n + i, b * n + j)] + gram[(b * n + i, a * n + j)])
        };
        let coefficients = [block(0, 0), both(0, 1), both(0, 2), block(1, 1), both(1, 2), block(2, 2)];
        Self { coefficients }
    }

    /// The Gram matrix at shape θ.
    pub fn at(&self, [t1, t2]: [f64; 2]) -> Matrix {
        self.combined([1.0, t1, t2, t1 * t1, t1 * t2, t2 * t2])
    }

    /// Its derivative by θ1 (`k` 0) or θ2 (1) at shape θ.
    pub fn derivative(&self, [t1, t2]: [f64; 2], k: usize) -> Matrix {
        let by = [[0.0, 1.0, 0.0, 2.0 * t1, t2, 0.0], [0.0, 0.0, 1.0, 0.0, t1, 2.0 * t2]];
        self.combined(by[k])
    }

    fn combined(&self, monomials: [f64; 6]) -> Matrix {
        let mut sum = Matrix::zeros(self.coefficients[0].rows(), self.coefficients[0].cols());
        for (c, x) in self.coefficients.iter().zip(monomials) {
            for (s, c) in sum.as_mut_slice().iter_mut().zip(c.as_slice()) {
                *s += x * c;
            }
        }
        sum
    }
}

impl ShapeForm {
    /// The form of `functional` for patches of a family and of bidegree `(m, n)`.
    ///
    /// # Errors
    /// [`EnergyError::Surface`] for degrees that the family does not have, [`EnergyError::Basis`] for those too large.
    pub fn of(
        functional: Functional,
        family: ShapedFamily,
        (m, n): (usize, usize),
    ) -> Result<Self, EnergyError> {
        let order = functional.order();
        let sample = |factor: &ShapeFactor, degree: usize| -> Result<Samples, EnergyError> {
            Ok(Samples::new(factor.affine()?.as_ref(), Samples::points_for(degree + 1), order)?)
        };
        let factors = family.factors((m, n))?;
        let u = factors.iter().map(|[u, _]| sample(u, m)).collect::<Result<Vec<_>, _>>()?;
        let v = factors.iter().map(|[_, v]| sample(v, n)).collect::<Result<Vec<_>, _>>()?;
        let (mut left, mut right) = (Factors::new(&u), Factors::new(&v));
        let mut terms = Vec::new();
        for s in 0..u.len() {
            for r in 0..u.len() {
                for term in functional.terms() {
                    terms.push(ShapeTerm {
                        coefficient: term.coefficient,
                        left: left.index(s, term.u.0, r, term.u.1),
                        right: right.index(s, term.v.0, r, term.v.1),
                    });
                }
            }
        }
        Ok(Self { left: left.grams, right: right.grams, terms })
    }
}

impl ShapeForm {
    /// Q at the [`coordinates`](ShapedFamily::coordinates) of a shape: over all points of the net, row by row; symmetric, positive semidefinite.
    pub fn matrix(&self, [a1, a2, b1, b2]: [f64; ShapedFamily::COORDINATES]) -> Matrix {
        let left: Vec<Matrix> = self.left.iter().map(|gram| gram.at([a1, a2])).collect();
        let right: Vec<Matrix> = self.right.iter().map(|gram| gram.at([b1, b2])).collect();
        self.assembled(&left, &right)
    }

    /// ∂Q by the coordinate of index `k` at the [`coordinates`](ShapedFamily::coordinates) of a shape: symmetric.
    pub fn derivative(&self, [a1, a2, b1, b2]: [f64; ShapedFamily::COORDINATES], k: usize) -> Matrix {
        let of = |grams: &[GramPolynomial], shape: [f64; 2], by: Option<usize>| -> Vec<Matrix> {
            grams
                .iter()
                .map(|gram| by.map_or_else(|| gram.at(shape), |k| gram.derivative(shape, k)))
                .collect()
        };
        let (by_left, by_right) = if k < 2 { (Some(k), None) } else { (None, Some(k - 2)) };
        self.assembled(&of(&self.left, [a1, a2], by_left), &of(&self.right, [b1, b2], by_right))
    }

    fn assembled(&self, left: &[Matrix], right: &[Matrix]) -> Matrix {
        let (rows, cols) = (left[0].rows(), right[0].rows());
        let mut sum = Matrix::zeros(rows * cols, rows * cols);
        for term in &self.terms {
            let (f, g) = (&left[term.left], &right[term.right]);
            for i in 0..rows * cols {
                let (row_f, row_g) = (f.row(i / cols), g.row(i % cols));
                let row = sum.row_mut(i);
                for (j, sum) in row.iter_mut().enumerate() {
                    *sum += term.coefficient * row_f[j / cols] * row_g[j % cols];
                }
            }
        }
        sum
    }
}

/// Gram polynomials made once for each pair of families and orders.
struct Factors<'a> {
    families: &'a [Samples],
    keys: Vec<[usize; 4]>,
    grams: Vec<GramPolynomial>,
}

impl<'a> Factors<'a> {
    fn new(families: &'a [Samples]) -> Self {
        Self { families, keys: Vec::new(), grams: Vec::new() }
    }

    fn index(&mut self, s: usize, r: usize, other: usize, q: usize) -> usize {
        let key = [s, r, other, q];
        self.keys.iter().position(|k| *k == key).unwrap_or_else(|| {
            self.keys.push(key);
            self.grams.push(GramPolynomial::new(&self.families[s], r, &self.families[other], q));
            self.grams.len() - 1
        })
    }
}
