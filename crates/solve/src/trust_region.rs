//! The step of a trust-region method.

use crate::SolveError;
use crate::memory::{filled, scratch, zeros};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor as llt;
use faer::linalg::triangular_solve;
use faer::{MatMut, MatRef, Par, Spec};

/// Minimises `gᵀd + ½ dᵀ(H + floor) d` over balls `‖d‖ ≤ radius`.
///
/// The minimiser solves `(H + λ) d = −g` with H + λ positive semidefinite and λ ≥ floor, with equality unless ‖d‖ = radius;
/// λ is found by Newton's iteration on `1/‖d(λ)‖ = 1/radius` between bounds (Moré and Sorensen, 1983).
pub(crate) struct TrustRegion {
    n: usize,
    hessian: Vec<f64>,
    floor: f64,
    /// The largest absolute value on the diagonal.
    diagonal: f64,
    /// Largest sum of absolute values in a row: a bound of ‖H‖.
    norm: f64,
    /// λ of the last step: where the next search begins.
    last: f64,
    /// L of H + λ, column-major.
    factor: Vec<f64>,
    /// L of H + λ for corrections, once it is known, and whether there is one.
    sides: Vec<f64>,
    sides_known: Option<bool>,
    change: Vec<f64>,
    work: Vec<f64>,
    /// Estimate of the eigenvector of the smallest eigenvalue.
    lowest: Vec<f64>,
    memory: MemBuffer,
}

/// A step with the decrease of the quadratic model it promises.
pub(crate) struct Step<'a> {
    pub(crate) change: &'a [f64],
    pub(crate) decrease: f64,
}

/// The length of a step at the boundary of the region is within this of the radius.
const LENGTH_TOLERANCE: f64 = 0.1;

/// In the hard case: how much of the model's decrease a step may leave.
const HARD_TOLERANCE: f64 = 0.2;

const FACTORISATIONS: usize = 60;

impl TrustRegion {
    pub(crate) fn new(n: usize) -> Result<Self, SolveError> {
        let request = llt::cholesky_in_place_scratch::<f64>(n, Par::Seq, Spec::default());
        Ok(Self {
            n,
            hessian: zeros(n * n)?,
            floor: 0.0,
            diagonal: 0.0,
            norm: 0.0,
            last: 0.0,
            factor: zeros(n * n)?,
            sides: zeros(n * n)?,
            sides_known: None,
            change: zeros(n)?,
            work: zeros(n)?,
            lowest: filled(n, 0.0)?,
            memory: scratch(request)?,
        })
    }

    /// Takes the Hessian of a new point.
    pub(crate) fn begin(&mut self, hessian: &[f64], flat: f64) {
        self.hessian.copy_from_slice(hessian);
        self.sides_known = None;
        let rows = || hessian.chunks_exact(self.n.max(1));
        self.norm = rows().map(|row| row.iter().map(|a| a.abs()).sum()).fold(0.0, f64::max);
        let diagonal = rows().enumerate().map(|(k, row)| row[k].abs()).fold(0.0, f64::max);
        (self.floor, self.diagonal) = (flat * diagonal, diagonal);
    }

    /// Whether H + floor is positive definite.
    pub(crate) fn is_minimum(&mut self) -> bool {
        self.diagonal == 0.0 || self.factored(self.floor)
    }

    /// The step within `radius`, to about a tenth of it.
    pub(crate) fn step(&mut self, gradient: &[f64], radius: f64) -> Step<'_> {
        let slope = norm(gradient);
        let (mut low, mut high) =
            ((slope / radius - self.norm).max(self.floor), slope / radius + self.norm + self.floor);
        // The unregularised step first: near the end it is the step.
        let mut lambda = low;
        let mut at_floor = true;
        for _ in 0..FACTORISATIONS {
            if !self.factored(lambda) {
                low = low.max(lambda);
                let restart = at_floor && self.last > 1.01 * low && self.last < 0.99 * high;
                lambda = if restart { self.last } else { between(low, high) };
                at_floor = false;
                continue;
            }
            self.change.iter_mut().zip(gradient).for_each(|(d, g)| *d = -g);
            self.solve_lower(Solved::Change);
            self.solve_upper(Solved::Change);
            let length = norm(&self.change);
            let inside = length <= radius * (1.0 + LENGTH_TOLERANCE);
            if inside && (lambda <= self.floor || length >= radius * (1.0 - LENGTH_TOLERANCE)) {
                break;
            }
            if length < radius {
                high = lambda;
                let curvature = self.lowest_curvature();
                low = low.max(lambda - curvature);
                // The hard case: what the step lacks in length is taken along the lowest curvature, which costs least.
                let along: f64 = self.change.iter().zip(&self.lowest).map(|(d, e)| d * e).sum();
                let root = (along * along + radius * radius - length * length).sqrt();
                let extra = if along >= 0.0 { root - along } else { -root - along };
                let quadratic = -dot(gradient, &self.change) + lambda * radius * radius;
                if extra * extra * curvature <= HARD_TOLERANCE * quadratic || high - low <= 1e-12 * high {
                    self.change.iter_mut().zip(&self.lowest).for_each(|(d, e)| *d += extra * e);
                    break;
                }
            } else {
                low = low.max(lambda);
            }
            at_floor = false;
            self.work.copy_from_slice(&self.change);
            self.solve_lower(Solved::Work);
            let ratio = length / norm(&self.work);
            let next = lambda + (length - radius) / radius * ratio * ratio;
            lambda = if next > low && next < high { next } else { between(low, high) };
        }
        self.last = lambda;
        let decrease = self.decrease(gradient);
        Step { change: &self.change, decrease }
    }

    /// `−(H + λ)⁻¹ g` for λ of `sides` times the largest diagonal entry: a step along the directions of larger curvature
    /// alone. None if H + λ is not positive definite.
    pub(crate) fn correction(&mut self, gradient: &[f64], sides: f64) -> Option<&[f64]> {
        let known = match self.sides_known {
            Some(known) => {
                std::mem::swap(&mut self.factor, &mut self.sides);
                known
            }
            None => self.factored(sides * self.diagonal),
        };
        self.sides_known = Some(known);
        self.work.iter_mut().zip(gradient).for_each(|(d, g)| *d = -g);
        if known {
            self.solve_lower(Solved::Work);
            self.solve_upper(Solved::Work);
        }
        std::mem::swap(&mut self.factor, &mut self.sides);
        known.then_some(&self.work)
    }

    fn decrease(&self, gradient: &[f64]) -> f64 {
        let rows = self.hessian.chunks_exact(self.n.max(1));
        let quadratic: f64 = rows.zip(&self.change).map(|(row, d)| d * dot(row, &self.change)).sum();
        -dot(gradient, &self.change) - 0.5 * quadratic
    }

    /// L of H + λ, if that is positive definite.
    fn factored(&mut self, lambda: f64) -> bool {
        let n = self.n;
        self.factor.copy_from_slice(&self.hessian);
        self.factor.iter_mut().step_by(n + 1).for_each(|a| *a += lambda);
        let a = MatMut::from_column_major_slice_mut(&mut self.factor, n, n);
        let stack = MemStack::new(&mut self.memory);
        llt::cholesky_in_place(a, Default::default(), Par::Seq, stack, Spec::default()).is_ok()
            && self.factor.iter().step_by(n + 1).all(|a| a.is_finite())
    }

    fn solve_lower(&mut self, which: Solved) {
        let n = self.n;
        let factor = MatRef::from_column_major_slice(&self.factor, n, n);
        let x = which.of(&mut self.change, &mut self.work, &mut self.lowest);
        let x = MatMut::from_column_major_slice_mut(x, n, 1);
        triangular_solve::solve_lower_triangular_in_place(factor, x, Par::Seq);
    }

    fn solve_upper(&mut self, which: Solved) {
        let n = self.n;
        let factor = MatRef::from_column_major_slice(&self.factor, n, n);
        let x = which.of(&mut self.change, &mut self.work, &mut self.lowest);
        let x = MatMut::from_column_major_slice_mut(x, n, 1);
        triangular_solve::solve_upper_triangular_in_place(factor.transpose(), x, Par::Seq);
    }

    /// The curvature `eᵀ(H + λ) e` of the unit vector `lowest`, after steps of inverse iteration with the factor.
    fn lowest_curvature(&mut self) -> f64 {
        if self.lowest.iter().all(|e| *e == 0.0) {
            // Any vector that no symmetry of the problem keeps out of the lowest eigenspace.
            let entry = |k: usize| 1.0 + ((k * 7919 + 13) % 101) as f64 / 101.0;
            let signed = |k: usize| if (k * k + k / 3).is_multiple_of(2) { entry(k) } else { -entry(k) };
            self.lowest.iter_mut().enumerate().for_each(|(k, e)| *e = signed(k));
        }
        let mut curvature = f64::INFINITY;
        for _ in 0..4 {
            let length = norm(&self.lowest);
            self.lowest.iter_mut().for_each(|e| *e /= length);
            self.work.copy_from_slice(&self.lowest);
            self.solve_lower(Solved::Lowest);
            self.solve_upper(Solved::Lowest);
            let square = dot(&self.lowest, &self.lowest);
            curvature = dot(&self.lowest, &self.work) / square;
        }
        let length = norm(&self.lowest);
        self.lowest.iter_mut().for_each(|e| *e /= length);
        curvature
    }
}

/// Which of its vectors a triangular solve overwrites.
#[derive(Clone, Copy)]
enum Solved {
    Change,
    Work,
    Lowest,
}

impl Solved {
    fn of<'a>(self, change: &'a mut [f64], work: &'a mut [f64], lowest: &'a mut [f64]) -> &'a mut [f64] {
        match self {
            Self::Change => change,
            Self::Work => work,
            Self::Lowest => lowest,
        }
    }
}

fn between(low: f64, high: f64) -> f64 {
    (low * high).sqrt().max(low + 0.01 * (high - low))
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}
