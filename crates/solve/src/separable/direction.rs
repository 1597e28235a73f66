use super::Samples;
use crate::error::from_svd;
use crate::memory::{filled, scratch};
use crate::{Place, SolveError, check};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::qr::no_pivoting::factor as qr;
use faer::linalg::svd::{self, ComputeSvdVectors};
use faer::linalg::{matmul::matmul, triangular_solve};
use faer::{Accum, Mat, MatRef, Par, Spec};

/// Householder vectors are applied one by one: at these sizes blocks cost more than they save.
const BLOCK: usize = 1;

/// One direction of a net: its functions, free ones first, made orthonormal, and the form of their
/// derivatives diagonalised.
///
/// With A = √w φ and A' = √w φ' (points × functions), `A = Q R` and, on the free functions, `D = A'_f R_ff⁻¹ = U Σ Vᵀ`.
/// The free functions times `R_ff⁻¹ V` are orthonormal with derivatives orthogonal and of square length λ = Σ². Against
/// these, every function has the products of values `E = Vᵀ R_f` and of derivatives `F = (D V)ᵀ A'`. No Gram matrix is
/// formed, so that only the square root of its condition is lost.
pub(super) struct Direction {
    pub(super) free: usize,
    /// Functions of the columns: the free ones, then the fixed ones, each increasing.
    pub(super) order: Vec<usize>,
    pub(super) roots: Vec<f64>,
    /// A and A'.
    pub(super) values: Mat<f64>,
    pub(super) derivatives: Mat<f64>,
    /// R of all functions: `min(points, functions) × functions`, zero below the diagonal.
    pub(super) triangle: Mat<f64>,
    pub(super) rotation: Mat<f64>,
    pub(super) eigenvalues: Vec<f64>,
    pub(super) of_values: Mat<f64>,
    pub(super) of_derivatives: Mat<f64>,
    householder: Mat<f64>,
    coefficients: Mat<f64>,
    orthonormal: Mat<f64>,
    singular: Diag<f64>,
    diagonal: Mat<f64>,
    memory: MemBuffer,
}

impl std::fmt::Debug for Direction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Direction")
            .field("free", &self.free)
            .field("order", &self.order)
            .field("eigenvalues", &self.eigenvalues)
            .finish_non_exhaustive()
    }
}

impl Direction {
    /// Space for samples of this shape; `fill` and `factor` make it a direction.
    pub(super) fn new(
        points: usize,
        functions: usize,
        weights: &[f64],
        free: &[usize],
    ) -> Result<Self, SolveError> {
        check::limit("number of sample points", points, check::LARGEST_DENSE_ORDER)?;
        check::limit("number of functions", functions, check::LARGEST_DENSE_ORDER)?;
        check::length("number of weights", points, weights.len())?;
        check::finite(Place::Matrix, 1, weights)?;
        check::indices("free functions", free, functions)?;
        if let Some(index) = weights.iter().position(|w| *w <= 0.0) {
            return Err(SolveError::NotPositiveWeight { index });
        }
        if points < free.len() {
            let what = "number of sample points, at least the free functions";
            return Err(SolveError::WrongShape { what, expected: free.len(), found: points });
        }
        let mut order = free.to_vec();
        order.extend((0..functions).filter(|i| free.binary_search(i).is_err()));
        let (f, size) = (free.len(), points.min(functions));
        let thin = (ComputeSvdVectors::No, ComputeSvdVectors::Thin);
        let request = qr::qr_in_place_scratch::<f64>(points, functions, BLOCK, Par::Seq, Spec::default())
            .or(svd::svd_scratch::<f64>(points, f, thin.0, thin.1, Par::Seq, Spec::default()));
        // One allocation that may fail stands for the matrices below, none of which is larger.
        drop(filled(check::product("number of samples", points, functions)?.saturating_mul(8), 0u8)?);
        Ok(Self {
            free: f,
            order,
            roots: weights.iter().map(|w| w.sqrt()).collect(),
            values: Mat::zeros(points, functions),
            derivatives: Mat::zeros(points, functions),
            triangle: Mat::zeros(size, functions),
            rotation: Mat::zeros(f, f),
            eigenvalues: vec![0.0; f],
            of_values: Mat::zeros(f, functions),
            of_derivatives: Mat::zeros(f, functions),
            householder: Mat::zeros(points, functions),
            coefficients: Mat::zeros(BLOCK, size),
            orthonormal: Mat::zeros(points, f),
            singular: Diag::zeros(f),
            diagonal: Mat::zeros(points, f),
            memory: scratch(request)?,
        })
    }

    pub(super) fn of_samples(samples: &Samples, free: &[usize]) -> Result<Self, SolveError> {
        let Samples { points, functions, ref weights, ref values, ref derivatives } = *samples;
        let mut direction = Self::new(points, functions, weights, free)?;
        check::length("number of values", points * functions, values.len())?;
        check::length("number of derivatives", points * functions, derivatives.len())?;
        check::finite(Place::Matrix, functions.max(1), values)?;
        check::finite(Place::Matrix, functions.max(1), derivatives)?;
        direction.fill(|k| (values[k], derivatives[k]));
        direction.factor()?;
        Ok(direction)
    }

    /// Sets A and A' from values and derivatives by their index in `points × functions`.
    pub(super) fn fill(&mut self, sample: impl Fn(usize) -> (f64, f64)) {
        let functions = self.order.len();
        for (column, &function) in self.order.iter().enumerate() {
            for (point, root) in self.roots.iter().enumerate() {
                let (value, derivative) = sample(point * functions + function);
                self.values[(point, column)] = root * value;
                self.derivatives[(point, column)] = root * derivative;
            }
        }
    }

    pub(super) fn factor(&mut self) -> Result<(), SolveError> {
        let (f, size, functions) = (self.free, self.triangle.nrows(), self.order.len());
        if size > 0 {
            self.householder.copy_from(&self.values);
            qr::qr_in_place(
                self.householder.as_mut(),
                self.coefficients.as_mut(),
                Par::Seq,
                MemStack::new(&mut self.memory),
                Spec::default(),
            );
        }
        // R stands above the diagonal; below it are the Householder vectors, which are not wanted: `triangle` keeps its zeros there.
        for j in 0..functions {
            for i in 0..size.min(j + 1) {
                self.triangle[(i, j)] = self.householder[(i, j)];
            }
        }
        if f == 0 {
            return Ok(());
        }
        // The free functions come first, so R_ff is the leading block of R and k counts them.
        for k in 0..f {
            // The part of a free function that those before it do not span, against its size.
            let length = (0..=k).map(|i| self.triangle[(i, k)].powi(2)).sum::<f64>().sqrt();
            let pivot = self.triangle[(k, k)].abs();
            if pivot <= f as f64 * f64::EPSILON * length || !length.is_finite() {
                return Err(SolveError::NotPositiveDefinite { order: f, pivot: Some(k), condition: None });
            }
        }
        // Dᵀ = R_ff⁻ᵀ A'_fᵀ.
        self.orthonormal.copy_from(self.derivatives.subcols(0, f));
        triangular_solve::solve_lower_triangular_in_place(
            self.triangle.submatrix(0, 0, f, f).transpose(),
            self.orthonormal.as_mut().transpose_mut(),
            Par::Seq,
        );
        if (0..f).any(|j| self.orthonormal.col(j).iter().any(|a| !a.is_finite())) {
            return Err(SolveError::NotPositiveDefinite { order: f, pivot: None, condition: None });
        }
        // V and Σ alone: the singular values of D are the square roots of λ, where DᵀD would lose half of their digits.
        svd::svd(
            self.orthonormal.as_ref(),
            self.singular.as_mut(),
            None,
            Some(self.rotation.as_mut()),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        )
        .map_err(|error| from_svd(error, f))?;
        for (eigenvalue, sigma) in self.eigenvalues.iter_mut().zip(self.singular.column_vector().iter()) {
            *eigenvalue = sigma * sigma;
        }
        product(&mut self.of_values, self.rotation.transpose(), self.triangle.subrows(0, f));
        product(&mut self.diagonal, self.orthonormal.as_ref(), self.rotation.as_ref());
        // Over all functions: on the free ones this is Σ² Vᵀ R_ff, on the fixed ones it couples them to what is held.
        product(&mut self.of_derivatives, self.diagonal.transpose(), self.derivatives.as_ref());
        Ok(())
    }

    /// Estimate of the condition of the free functions: the ratio of the extreme diagonal entries of R.
    pub(super) fn basis_condition(&self) -> f64 {
        let pivots = || (0..self.free).map(|k| self.triangle[(k, k)].abs());
        if self.free == 0 {
            1.0
        } else {
            pivots().fold(0.0, f64::max) / pivots().fold(f64::INFINITY, f64::min)
        }
    }

    /// `x ← R_ff⁻¹ V x`: from the diagonal basis back to the coefficients of the free functions.
    pub(super) fn back(&self, x: &mut Mat<f64>, rotated: &mut Mat<f64>) {
        product(rotated, self.rotation.as_ref(), x.as_ref());
        triangular_solve::solve_upper_triangular_in_place(
            self.triangle.submatrix(0, 0, self.free, self.free),
            rotated.as_mut(),
            Par::Seq,
        );
        std::mem::swap(x, rotated);
    }
}

pub(super) fn product(out: &mut Mat<f64>, left: MatRef<'_, f64>, right: MatRef<'_, f64>) {
    matmul(out.as_mut(), Accum::Replace, left, right, 1.0, Par::Seq);
}
