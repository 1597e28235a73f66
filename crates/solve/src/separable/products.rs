//! Quadratic energies of sums of products of functions, minimised by conjugate gradients in functions that nearly diagonalise
//! them.

use super::direction::Direction;
use crate::memory::zeros;
use crate::{Place, SolveError, check, condition, eigen_symmetric};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

/// Functions of one parameter and their derivatives, sampled at the points of a quadrature rule.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledFunctions {
    /// Number of functions.
    pub functions: usize,
    /// Derivatives of order 0, 1, …: `points × functions` each, row-major.
    pub orders: Vec<Vec<f64>>,
}

/// Orders of derivatives in u and v.
type Orders = (usize, usize);

/// One term `coefficient · ∫ ∂_u^{u.0} ∂_v^{v.0} S · ∂_u^{u.1} ∂_v^{v.1} S` of an energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProductTerm {
    /// Factor of the product.
    pub coefficient: f64,
    /// Orders of the u-derivatives of the first and the second factor.
    pub u: (usize, usize),
    /// Orders of the v-derivatives of the first and the second factor.
    pub v: (usize, usize),
}

/// The minimum of a quadratic energy over `S = F + Σ_s Σ_ij x_ij f_{s,i}(u) g_{s,j}(v)`, F fixed, for large families: O(n³) a step.
///
/// The matrix `Σ c (f_sᵀ f_r) ⊗ (g_sᵀ g_r)` is never formed. In each direction the mean of the families is made orthonormal (QR of
/// the weighted samples) and its highest derivatives in the energy are diagonalised (singular values); there the diagonal of
/// the matrix is nearly all of it. Of one product it *is* the matrix for the Dirichlet energy and the Coons functional, and all
/// but a tenth of it for bending and the Laplacian, whose `∫ x_uu x_vv = ∫ x_uv²` where functions vanish on the border. So
/// conjugate gradients with the diagonal as preconditioner end at rounding after 1 to 15 steps, whatever the degree: measured to
/// degree 64, also for the two products of TB–Coons patches.
///
/// Give functions that are well conditioned when scaled to length 1, such as Lobatto polynomials: what a family's own
/// condition takes from the samples is not given back.
#[derive(Debug)]
pub struct ProductSystem {
    u: Side,
    v: Side,
    terms: Vec<ProductTerm>,
    operator: Vec<Kronecker>,
    diagonal: Mat<f64>,
}

/// The minimum found.
#[derive(Debug, Clone, PartialEq)]
pub struct ProductSolution {
    /// The coefficients x: `functions in u × functions in v × 3`, row-major.
    pub x: Vec<f64>,
    /// The defect of the equations over `‖x‖ n ε`, in units in which the diagonal is 1: about 1 is rounding, never above 30.
    pub residual: f64,
    /// The ratio of the extreme eigenvalues met, in those units: near 1, and what the *surface* may lose.
    pub condition: f64,
    /// Steps of the coordinate that took most.
    pub steps: usize,
}

/// The families of one direction, in the functions that diagonalise.
#[derive(Debug)]
struct Side {
    roots: Vec<f64>,
    /// √w times the derivatives of each family: `families[s][r]` is points × functions.
    families: Vec<Vec<Mat<f64>>>,
    /// The coefficients of the diagonalising functions in those given.
    back: Mat<f64>,
}

/// `coefficient · left ⊗ right`.
#[derive(Debug)]
struct Kronecker {
    coefficient: f64,
    left: Mat<f64>,
    right: Mat<f64>,
}

/// Steps after which conjugate gradients are given up.
const MOST_STEPS: usize = 200;

impl ProductSystem {
    /// The energy with these terms of the products `products[s] = [f_s, g_s]`, sampled at rules with these weights. Every f has as
    /// many functions as the others, every g too; the terms together are symmetric.
    ///
    /// # Errors
    /// [`SolveError::NotPositiveDefinite`] if the functions depend on each other or the energy does not determine them;
    /// [`SolveError::WrongShape`], [`SolveError::NotFinite`], [`SolveError::NotPositiveWeight`], [`SolveError::TooLarge`],
    /// [`SolveError::OutOfMemory`], [`SolveError::NoConvergence`].
    pub fn new(
        weights: [&[f64]; 2],
        products: &[[SampledFunctions; 2]],
        terms: &[ProductTerm],
    ) -> Result<Self, SolveError> {
        let highest = |orders: fn(&ProductTerm) -> (usize, usize)| {
            terms.iter().map(orders).map(|(a, b)| a.max(b)).max().unwrap_or(0)
        };
        let of = |k: usize| products.iter().map(|product| &product[k]).collect::<Vec<_>>();
        let u = Side::new(weights[0], &of(0), highest(|term| term.u))?;
        let v = Side::new(weights[1], &of(1), highest(|term| term.v))?;
        let (rows, cols) = (u.back.nrows(), v.back.nrows());
        // One allocation that may fail stands for those of the operator.
        let size = check::product(
            "size of the operator",
            terms.len() * products.len().pow(2),
            rows * rows + cols * cols,
        )?;
        drop(zeros(size)?);
        let mut operator = Vec::new();
        for term in terms {
            // ⟨(Σ_s f_s g_s), (Σ_r f_r g_r)⟩ expanded: a product for every pair of families.
            for s in 0..products.len() {
                for r in 0..products.len() {
                    operator.push(Kronecker {
                        coefficient: term.coefficient,
                        left: u.families[s][term.u.0].transpose() * &u.families[r][term.u.1],
                        right: v.families[s][term.v.0].transpose() * &v.families[r][term.v.1],
                    });
                }
            }
        }
        let entry = |i: usize, j: usize| {
            operator.iter().map(|k| k.coefficient * k.left[(i, i)] * k.right[(j, j)]).sum::<f64>()
        };
        // The diagonal is the preconditioner: an entry that is not positive already says that the energy is not positive definite.
        let diagonal = Mat::from_fn(rows, cols, entry);
        let negative =
            |j: usize| diagonal.col(j).iter().position(|d| *d <= 0.0 || !d.is_finite()).map(|i| (i, j));
        if let Some((i, j)) = (0..cols).find_map(negative) {
            let pivot = Some(i * cols + j);
            return Err(SolveError::NotPositiveDefinite { order: rows * cols, pivot, condition: None });
        }
        Ok(Self { u, v, terms: terms.to_vec(), operator, diagonal })
    }

    /// Number of unknowns of each coordinate.
    pub fn free(&self) -> usize {
        self.diagonal.nrows() * self.diagonal.ncols()
    }

    /// The minimum over what is fixed: `fixed(a, b)` is `∂_u^a ∂_v^b F` at the points of the rules, `points in u × points in v × 3`,
    /// row-major. It is asked for the second factors of the terms.
    ///
    /// # Errors
    /// [`SolveError::NotPositiveDefinite`] if a direction of no or negative energy is met, [`SolveError::Residual`] where the steps
    /// end above rounding, [`SolveError::WrongShape`], [`SolveError::NotFinite`].
    pub fn solve(&self, fixed: impl Fn(usize, usize) -> Vec<f64>) -> Result<ProductSolution, SolveError> {
        let (rows, cols) = (self.diagonal.nrows(), self.diagonal.ncols());
        let mut x = zeros(3 * self.free())?;
        let (mut condition, mut steps) = (1.0f64, 0);
        let (mut defect, mut size) = (0.0f64, 0.0f64);
        for (d, rhs) in self.right_hand_sides(fixed)?.iter().enumerate() {
            let found = self.conjugate_gradients(rhs)?;
            condition = condition.max(found.condition()?);
            steps = steps.max(found.curvatures.len());
            // The defect is formed anew: the one that conjugate gradients carry along drifts away from b − A x.
            let mut left = rhs.clone();
            self.subtract_product(&found.x, &mut left);
            for j in 0..cols {
                for i in 0..rows {
                    // In units in which the diagonal is 1: D^(−1/2) of the defect, D^(1/2) of x.
                    defect += left[(i, j)].powi(2) / self.diagonal[(i, j)];
                    size += found.x[(i, j)].powi(2) * self.diagonal[(i, j)];
                }
            }
            let given = &self.u.back * &found.x * self.v.back.transpose();
            for i in 0..rows {
                for j in 0..cols {
                    x[3 * (i * cols + j) + d] = given[(i, j)];
                }
            }
        }
        check::finite(Place::Solution, 3, &x)?;
        let unit = size.sqrt() * rows.max(cols) as f64 * f64::EPSILON;
        let residual = if defect == 0.0 { 0.0 } else { defect.sqrt() / unit };
        Ok(ProductSolution { x, residual: condition::accepted(self.free(), residual)?, condition, steps })
    }

    /// `−Σ c ⟨f_s g_s, ∂F⟩` for x, y, z.
    fn right_hand_sides(
        &self,
        fixed: impl Fn(usize, usize) -> Vec<f64>,
    ) -> Result<[Mat<f64>; 3], SolveError> {
        let (rows, cols) = (self.diagonal.nrows(), self.diagonal.ncols());
        let mut rhs: [Mat<f64>; 3] = std::array::from_fn(|_| Mat::zeros(rows, cols));
        let mut asked: Vec<(Orders, [Mat<f64>; 3])> = Vec::new();
        for term in &self.terms {
            let orders = (term.u.1, term.v.1);
            // Terms often ask for the same derivatives of F, which are dear to evaluate.
            let at = match asked.iter().position(|(known, _)| *known == orders) {
                Some(at) => at,
                None => {
                    asked.push((orders, self.weighted(&fixed(orders.0, orders.1))?));
                    asked.len() - 1
                }
            };
            for (rhs, grid) in rhs.iter_mut().zip(&asked[at].1) {
                for (f, g) in self.u.families.iter().zip(&self.v.families) {
                    let half = f[term.u.0].transpose() * grid;
                    let right = g[term.v.0].as_ref();
                    matmul(rhs.as_mut(), Accum::Add, half.as_ref(), right, -term.coefficient, Par::Seq);
                }
            }
        }
        Ok(rhs)
    }

    /// √w √w times a grid of points, by coordinates.
    fn weighted(&self, grid: &[f64]) -> Result<[Mat<f64>; 3], SolveError> {
        let (p, q) = (self.u.roots.len(), self.v.roots.len());
        check::length("number of fixed values", check::product("fixed values", p, 3 * q)?, grid.len())?;
        check::finite(Place::RightHandSide, 3, grid)?;
        let root = |k: usize, l: usize| self.u.roots[k] * self.v.roots[l];
        Ok(std::array::from_fn(|d| Mat::from_fn(p, q, |k, l| root(k, l) * grid[3 * (k * q + l) + d])))
    }
    /// `r ← r − A x`.
    fn subtract_product(&self, x: &Mat<f64>, r: &mut Mat<f64>) {
        for Kronecker { coefficient, left, right } in &self.operator {
            let half = left * x;
            matmul(r.as_mut(), Accum::Add, half.as_ref(), right.transpose(), -coefficient, Par::Seq);
        }
    }

    /// Conjugate gradients with the diagonal as preconditioner, until the defect is rounding or falls no more.
    fn conjugate_gradients(&self, rhs: &Mat<f64>) -> Result<Descent, SolveError> {
        let (rows, cols) = (self.diagonal.nrows(), self.diagonal.ncols());
        let dot = |a: &Mat<f64>, b: &Mat<f64>| {
            (0..cols).map(|j| (0..rows).map(|i| a[(i, j)] * b[(i, j)]).sum::<f64>()).sum::<f64>()
        };
        let scaled = |r: &Mat<f64>| Mat::from_fn(rows, cols, |i, j| r[(i, j)] / self.diagonal[(i, j)]);
        let mut found = Descent { x: Mat::zeros(rows, cols), curvatures: Vec::new(), gains: Vec::new() };
        let mut defect = rhs.clone();
        let mut along = scaled(&defect);
        let mut square = dot(&defect, &along);
        // (r, z) is a square: ε² of the first is a defect of ε of the first.
        let rounding = f64::EPSILON.powi(2) * square;
        while square > rounding && found.curvatures.len() < MOST_STEPS {
            let mut image = Mat::zeros(rows, cols);
            self.subtract_product(&along, &mut image);
            // `subtract_product` from zero leaves −A p: hence the sign, and the + in the step of the defect.
            let curvature = -dot(&along, &image);
            if curvature <= 0.0 || !curvature.is_finite() {
                return Err(SolveError::NotPositiveDefinite {
                    order: rows * cols,
                    pivot: None,
                    condition: None,
                });
            }
            let step = square / curvature;
            found.x += faer::Scale(step) * &along;
            defect += faer::Scale(step) * &image;
            let next = scaled(&defect);
            let after = dot(&defect, &next);
            found.curvatures.push(1.0 / step);
            found.gains.push(after / square);
            along = next + faer::Scale(after / square) * &along;
            square = after;
        }
        Ok(found)
    }
}

impl Side {
    /// Families sampled at a rule, in the functions in which the derivatives of order `highest` of their mean are orthogonal and
    /// its values orthonormal.
    fn new(weights: &[f64], families: &[&SampledFunctions], highest: usize) -> Result<Self, SolveError> {
        let points = weights.len();
        let functions = families.first().map_or(0, |family| family.functions);
        let length = check::product("number of samples", points, functions)?;
        for family in families {
            check::length("number of functions of each family", functions, family.functions)?;
            check::length(
                "number of orders sampled, at least",
                highest + 1,
                family.orders.len().min(highest + 1),
            )?;
            for samples in &family.orders {
                check::length("number of samples", length, samples.len())?;
                check::finite(Place::Matrix, functions.max(1), samples)?;
            }
        }
        let free: Vec<usize> = (0..functions).collect();
        let mut direction = Direction::new(points, functions, weights, &free)?;
        // One preconditioner for all families of a side: for one family it is exact, for two that are near each other nearly so.
        let mean = |order: usize, k: usize| {
            families.iter().map(|family| family.orders[order][k]).sum::<f64>() / families.len() as f64
        };
        // The highest derivatives dominate the energy at high degree: it is these that are made orthogonal beside the values.
        direction.fill(|k| (mean(0, k), mean(highest, k)));
        direction.factor()?;
        let mut back = Mat::identity(functions, functions);
        direction.back(&mut back, &mut Mat::zeros(functions, functions));
        let roots = direction.roots;
        let sampled = |samples: &Vec<f64>| {
            Mat::from_fn(points, functions, |p, k| roots[p] * samples[p * functions + k]) * &back
        };
        let families = families.iter().map(|family| family.orders.iter().map(sampled).collect()).collect();
        Ok(Self { families, back, roots })
    }
}

/// What conjugate gradients found, and the coefficients of their tridiagonal matrix.
struct Descent {
    x: Mat<f64>,
    /// `pᵀAp / rᵀz` of each step.
    curvatures: Vec<f64>,
    /// The quotient of `rᵀz` after and before each step.
    gains: Vec<f64>,
}

impl Descent {
    /// The ratio of the extreme eigenvalues of the tridiagonal matrix of the steps (Lanczos): from below, that of the matrix.
    fn condition(&self) -> Result<f64, SolveError> {
        let n = self.curvatures.len();
        let mut matrix = vec![0.0; n * n];
        for k in 0..n {
            // With steps α and gains β: 1/α_k + β_(k−1)/α_(k−1) on the diagonal, √β_(k−1)/α_(k−1) beside it.
            let before = if k > 0 { self.gains[k - 1] * self.curvatures[k - 1] } else { 0.0 };
            matrix[k * n + k] = self.curvatures[k] + before;
            if k > 0 {
                let beside = self.gains[k - 1].sqrt() * self.curvatures[k - 1];
                (matrix[k * n + k - 1], matrix[(k - 1) * n + k]) = (beside, beside);
            }
        }
        let values = eigen_symmetric(n, &matrix)?.values;
        Ok(match (values.first(), values.last()) {
            (Some(least), Some(largest)) if *least > 0.0 => largest / least,
            (Some(_), _) => f64::INFINITY,
            _ => 1.0,
        })
    }
}
