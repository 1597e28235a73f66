mod factor;
mod lanes;
mod path;
mod table;

pub use path::Path;

use crate::{Cholesky, Place, SolveError, check};
use lanes::{ValueAndGradient, Values};
pub(crate) use path::Engine;
use std::cell::Cell;
use table::Tables;

/// A square matrix whose entries are quadratic polynomials in two parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct PolynomialMatrix {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns, equal to the rows.
    pub cols: usize,
    /// The coefficient matrices (row-major) of 1, θ₁, θ₂, θ₁², θ₁θ₂, θ₂².
    pub coefficients: [Vec<f64>; 6],
}

/// One product `coefficient · L(α) ⊗ R(β)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// The factor of the product.
    pub coefficient: f64,
    /// Index of L among the matrices of the first direction.
    pub left: usize,
    /// Index of R among the matrices of the second direction.
    pub right: usize,
}

/// An energy `Σ_d X_dᵀ Q(α, β) X_d` of an `m × n` net with `Q = Σ_t coefficient_t · L_t(α₁, α₂) ⊗ R_t(β₁, β₂)`,
/// and the values at which some of the net is held.
///
/// `Q` must be symmetric for all parameters; its single terms need not be. The unknown of net point (i, j) is
/// `i·n + j`.
#[derive(Debug, Clone, PartialEq)]
pub struct ParametricProblem {
    /// Matrices of the first direction, all `m × m`.
    pub left: Vec<PolynomialMatrix>,
    /// Matrices of the second direction, all `n × n`.
    pub right: Vec<PolynomialMatrix>,
    /// The products that add up to `Q`.
    pub terms: Vec<Term>,
    /// Free rows of the net, increasing; free are the points whose row *and* column are.
    pub free_left: Vec<usize>,
    /// Free columns of the net, increasing.
    pub free_right: Vec<usize>,
    /// The net, `m·n × 3`, row-major; what stands at free points is not read.
    pub values: Vec<f64>,
}

/// The minimiser at one point of the parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct ParametricSolution {
    /// The whole net, `m·n × 3`: fixed points as given, free points solved for.
    pub x: Vec<f64>,
    /// The minimum `Σ_d X_dᵀ Q X_d`.
    pub energy: f64,
    /// Residual of `Q_ff p = −b`, see [`Solution::residual`](crate::Solution::residual).
    pub residual: f64,
    /// Condition of `Q_ff`, see [`Solution::condition`](crate::Solution::condition).
    pub condition: f64,
}

/// The reduced energy `J(α, β) = min_p Σ_d X_dᵀ Q(α, β) X_d` of a [`ParametricProblem`] (spec §2, GT §5).
///
/// The fixed values are contracted once: each entry of `b = Q_fb P_b` and `c = P_bᵀ Q_bb P_b` becomes a form xᵀ B y in
/// the monomials of α and β, so that an evaluation is a few polynomials and one small factorisation: no
/// quadrature, no allocation. Relative accuracy of J is about `n ε` times the condition of `Q_ff`, in practice
/// far better; for nets with more than about ten points a side take
/// [`SeparableParametric`](crate::SeparableParametric), which forms no Gram matrix.
///
/// A point's bits depend on the [`Path`] alone, not on how many points are evaluated together or where in the
/// batch it stands.
///
/// ```
/// use solve::{Parametric, ParametricProblem, PolynomialMatrix, Term};
///
/// // Three points on a line, stiffness θ₁ of the first spring and θ₂ of the second; the middle is free.
/// let zero = vec![0.0; 9];
/// let first = vec![1.0, -1.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0];
/// let second = vec![0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, -1.0, 1.0];
/// let springs = [zero.clone(), first, second, zero.clone(), zero.clone(), zero];
/// let one = [vec![1.0], vec![0.0], vec![0.0], vec![0.0], vec![0.0], vec![0.0]];
/// let parametric = Parametric::new(&ParametricProblem {
///     left: vec![PolynomialMatrix { rows: 3, cols: 3, coefficients: springs }],
///     right: vec![PolynomialMatrix { rows: 1, cols: 1, coefficients: one }],
///     terms: vec![Term { coefficient: 1.0, left: 0, right: 0 }],
///     free_left: vec![1],
///     free_right: vec![0],
///     values: vec![0.0, 0.0, 0.0, f64::NAN, f64::NAN, f64::NAN, 4.0, 0.0, 0.0],
/// })?;
///
/// // Two springs in series: J = 4² θ₁θ₂ / (θ₁ + θ₂).
/// let mut gradient = [0.0; 4];
/// let j = parametric.value_and_gradient(&[1.0, 3.0, 0.0, 0.0], &mut gradient);
/// assert!((j - 12.0).abs() < 1e-14 && (gradient[0] - 9.0).abs() < 1e-14);
/// assert_eq!(parametric.solve(&[1.0, 3.0, 0.0, 0.0])?.x[3], 3.0);
/// # Ok::<(), solve::SolveError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Parametric {
    tables: Tables,
    engine: Engine,
    values: Vec<f64>,
    free: Vec<usize>,
}

thread_local! {
    static WORKSPACE: Cell<Vec<f64>> = const { Cell::new(Vec::new()) };
}

impl Parametric {
    /// Contracts the fixed values. The path is [`Path::detect`].
    ///
    /// # Errors
    /// [`SolveError::WrongShape`], [`SolveError::WrongIndex`], [`SolveError::NotFinite`], [`SolveError::TooLarge`]
    /// (more than 400 free unknowns), [`SolveError::OutOfMemory`].
    pub fn new(problem: &ParametricProblem) -> Result<Self, SolveError> {
        let tables = Tables::new(problem)?;
        let cols = problem.right.first().map_or(0, |matrix| matrix.rows);
        let free = problem
            .free_left
            .iter()
            .flat_map(|&i| problem.free_right.iter().map(move |&j| i * cols + j))
            .collect();
        Ok(Self { tables, engine: Engine::new(Path::detect())?, values: problem.values.clone(), free })
    }

    /// The same system, evaluated on a chosen path.
    ///
    /// # Errors
    /// [`SolveError::PathUnavailable`] if this machine does not have it.
    pub fn with_path(self, path: Path) -> Result<Self, SolveError> {
        Ok(Self { engine: Engine::new(path)?, ..self })
    }

    /// The path that evaluations take.
    pub fn path(&self) -> Path {
        self.engine.path()
    }

    /// Number of free unknowns.
    pub fn free(&self) -> usize {
        self.tables.free
    }

    /// J at each of `points` (α₁, α₂, β₁, β₂) into `out`.
    ///
    /// A point that is not finite, or where `Q_ff` is not positive definite to working precision, gets NaN
    /// without touching its neighbours; [`solve`](Self::solve) says why.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`] unless `points` holds four numbers for each of `out`;
    /// [`SolveError::OutOfMemory`] for the first evaluation of a thread.
    pub fn values(&self, points: &[f64], out: &mut [f64]) -> Result<(), SolveError> {
        check::length("length of the points", 4 * out.len(), points.len())?;
        let (points, _) = points.as_chunks::<4>();
        self.with_workspace(|workspace| {
            self.engine.run_lanes(Values { tables: &self.tables, points, out, workspace });
        })
    }

    /// J at one point, with the bits of [`values`](Self::values); NaN as there, and if there is no memory.
    pub fn value(&self, point: &[f64; 4]) -> f64 {
        let mut out = [f64::NAN];
        let points = std::slice::from_ref(point);
        let run = self.with_workspace(|workspace| {
            self.engine.run_one(Values { tables: &self.tables, points, out: &mut out, workspace });
        });
        run.map_or(f64::NAN, |()| out[0])
    }

    /// J and its gradient by (α₁, α₂, β₁, β₂), from the one minimiser: at a minimum `∂J = Σ_d X_dᵀ (∂Q) X_d`.
    ///
    /// The value has the bits of [`values`](Self::values). Where it is NaN the gradient is too.
    pub fn value_and_gradient(&self, point: &[f64; 4], gradient: &mut [f64; 4]) -> f64 {
        let slopes = &mut *gradient;
        let run = self.with_workspace(|workspace| {
            self.engine.run_one(ValueAndGradient { tables: &self.tables, point, gradient: slopes, workspace })
        });
        run.unwrap_or_else(|_| {
            *gradient = [f64::NAN; 4];
            f64::NAN
        })
    }

    /// Lends this thread's workspace, which grows once to the largest system evaluated and is then reused.
    #[inline]
    fn with_workspace<T>(&self, run: impl FnOnce(&mut [f64]) -> T) -> Result<T, SolveError> {
        // Taken, not borrowed: a kernel that panics or calls itself leaves an empty workspace behind, never a half-used one.
        let mut workspace = WORKSPACE.take();
        let length = lanes::memory(&self.tables);
        if workspace.len() < length {
            workspace = crate::memory::zeros(length)?;
        }
        let result = run(&mut workspace);
        WORKSPACE.set(workspace);
        Ok(result)
    }

    /// The minimiser at one point, with residual and condition.
    ///
    /// # Errors
    /// [`SolveError::NotFinite`] for such parameters; else as [`Cholesky::new`] and [`Cholesky::solve`].
    pub fn solve(&self, point: &[f64; 4]) -> Result<ParametricSolution, SolveError> {
        check::finite(Place::Parameters, 4, point)?;
        // With residual and condition, from sums of another order than the kernels': the same numbers but for the last digits.
        let (matrix, b, c) = self.tables.at(point);
        let cholesky = Cholesky::new(self.tables.free, &matrix)?;
        let rhs: Vec<f64> = b.iter().map(|b| -b).collect();
        let solution = cholesky.solve(3, &rhs)?;
        let energy = c + b.iter().zip(&solution.x).map(|(b, p)| b * p).sum::<f64>();
        let mut x = self.values.clone();
        for (k, &i) in self.free.iter().enumerate() {
            x[3 * i..3 * i + 3].copy_from_slice(&solution.x[3 * k..3 * k + 3]);
        }
        Ok(ParametricSolution { x, energy, residual: solution.residual, condition: solution.condition })
    }
}
