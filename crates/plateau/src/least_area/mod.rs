//! The control net of least area with its border fixed.

mod reason;
mod space;
#[cfg(test)]
mod tests;

use std::ops::ControlFlow;

use energy::{EnergyError, Integral, NormalVariation};
use solve::{NewtonEnd, NewtonParams, NewtonReport, SmoothFunction, newton, smallest_relative_eigenvalue};
use surfaces::{TensorPatch, TrianglePatch};

use crate::{MethodError, Progress};
use space::{Area, Product, Space, Sums, Triangle};

/// What is known of a net of least area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaExtremal {
    /// The area, with the error the rule was found to make (unit: length²).
    pub area: Integral,
    /// The area of the Dirichlet extremal it was reached from.
    pub start: f64,
    /// The norm of the gradient of the area over √area, in displacements of unit Dirichlet norm `∫ |∇ψ|²` (over the
    /// parameters), by the rule it was minimised with; dimensionless.
    pub gradient: f64,
    /// The same by the doubled rule: much larger only where the surface is all but singular between the points of
    /// the rule.
    pub finer_gradient: f64,
    /// Newton steps (points at which a Hessian was formed), over all rules.
    pub iterations: usize,
    /// Evaluations of the area with its gradient, over all rules.
    pub evaluations: usize,
    /// Why the last iteration ended.
    pub end: NewtonEnd,
    /// The smallest value of `∫ (|∇f|² + 2 K f²) dA / ∫ |∇f|² dA` over displacements f N along the unit normal, f one of the
    /// functions of the net that vanish on the border: the second variation of the area. Dimensionless, at most 1 where K ≤ 0; positive
    /// for a stable minimum, negative for a saddle. An upper bound of its value over all f. None if no point is free,
    /// or where the surface found has no normal.
    pub second_variation: Option<f64>,
}

/// The gradient that counts as 0, relative to √area.
const GRADIENT_TOLERANCE: f64 = 1e-10;

/// Relative change of the area under a doubled rule at which the rule is accepted, if the gradient agrees too; a tenth of the
/// tolerance where that is more.
const RULE_TOLERANCE: f64 = 1e-10;

/// The rule begins with this many points more than one and a half times the degree.
const FIRST_RULE: usize = 8;

/// The rule is not doubled beyond this many points in each direction.
const LARGEST_RULE: usize = 192;

/// The first trust region in units of √area.
const FIRST_RADIUS: f64 = 0.25;

/// What the square of the distance to the Dirichlet extremal, in the Dirichlet norm, counts at first beside the area: one
/// after the other, each from the minimum of the one before. Moving points along the surface hardly changes the area;
/// this leads into the valley of all the nets of nearly least area where it is closest, and within 10⁻⁵ of it.
const PULLS: [f64; 2] = [0.03, 1e-3];

/// Steps with each of them, where the least area is wanted to many digits; half of them where few will do.
const PULLED_STEPS: usize = 8;

/// A tolerance from which few digits are wanted.
const COARSE: f64 = 1e-8;

/// The patch of least area on the border of `patch`, among the nets of its families: from the Dirichlet extremal by
/// trust-region Newton steps. The free points of `patch` play no part. `tolerance` is the relative decrease of the area that
/// counts as none: along the valley of nets that differ by moving points along the surface there is no other end. `progress`
/// hears of every Newton step.
///
/// # Errors
/// [`MethodError::Energy`] with [`EnergyError::Singular`] if the Dirichlet extremal has parallel tangents at a point of
/// the rule, [`MethodError::Solve`] if the functions depend on each other to working precision,
/// [`MethodError::Interrupted`] if `progress` cancels.
pub fn least_area(
    patch: &TensorPatch,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    let (m, n) = patch.net().degrees();
    let points = 3 * m.max(n) / 2 + FIRST_RULE;
    if patch.products().len() == 1 {
        minimise_in(&Product::new(patch)?, patch, points, tolerance, progress)
    } else {
        minimise_in(&Sums::new(patch, points)?, patch, points, tolerance, progress)
    }
}

/// The triangular patch of least area on the border of `patch`: as [`least_area`].
///
/// # Errors
/// As [`least_area`].
pub fn least_area_triangle(
    patch: &TrianglePatch,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TrianglePatch, AreaExtremal), MethodError> {
    let points = 3 * patch.net().degree() / 2 + FIRST_RULE;
    minimise_in(&Triangle::new(patch.net(), points)?, patch, points, tolerance, progress)
}

fn minimise_in<S: Space>(
    space: &S,
    patch: &S::Patch,
    mut points: usize,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(S::Patch, AreaExtremal), MethodError> {
    let mut area = space.area(patch, points)?;
    let mut gradient = vec![0.0; area.unknowns()];
    let dirichlet: Vec<f64> = area.dirichlet_projection().iter().map(|c| -c).collect();
    let start = area.value_and_gradient(&dirichlet, &mut gradient)?;
    let unit = start.sqrt();
    // An area to a coarse tolerance leaves a gradient of the order of its root.
    let gradient_tolerance =
        unit * if tolerance < COARSE { GRADIENT_TOLERANCE } else { 0.01 * tolerance.sqrt() };
    let params = NewtonParams {
        value_tolerance: tolerance,
        patience: patience(tolerance),
        ..NewtonParams::new(GRADIENT_TOLERANCE * unit, FIRST_RADIUS * unit)
    };
    let pulled_steps = if tolerance < COARSE { PULLED_STEPS } else { PULLED_STEPS / 2 };
    let (mut iterations, mut evaluations, mut x) = (0, 1, dirichlet.clone());
    for pull in PULLS {
        let mut pulled = Pulled { area: &area, pull, to: &dirichlet, progress };
        let size =
            x.iter().zip(&dirichlet).map(|(x, d)| (x - d).powi(2)).sum::<f64>().sqrt().max(0.01 * unit);
        let loose = NewtonParams { iterations: pulled_steps, ..NewtonParams::new(0.5 * pull * size, unit) };
        let report = uninterrupted(newton(&mut pulled, &x, loose)?)?;
        iterations += report.hessians;
        evaluations += report.evaluations;
        x = report.x;
    }
    let mut patch = space.moved(patch, &vec![0.0; x.len()])?;
    loop {
        let mut free = Pulled { area: &area, pull: 0.0, to: &x, progress };
        let report = uninterrupted(newton(&mut free, &x, params)?)?;
        iterations += report.hessians;
        evaluations += report.evaluations + 1;
        patch = space.moved(&patch, &report.x)?;
        let finer = space.area(&patch, 2 * points)?;
        x = vec![0.0; report.x.len()];
        let value = finer.value_and_gradient(&x, &mut gradient)?;
        let norm = gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
        let error = (value - report.value).abs() + 64.0 * f64::EPSILON * value;
        let settled = error <= RULE_TOLERANCE.max(0.1 * tolerance) * value;
        let confirmed = settled && norm <= report.gradient_norm + gradient_tolerance;
        if confirmed || 4 * points > LARGEST_RULE {
            let second_variation = match space.variation(&patch, &area) {
                Ok(variation) => smallest(&variation)?,
                Err(MethodError::Energy(EnergyError::Singular { .. })) => None,
                Err(error) => return Err(error),
            };
            let found = AreaExtremal {
                area: Integral { value, error, points: 2 * points, settled },
                start,
                gradient: report.gradient_norm / unit,
                finer_gradient: norm / value.sqrt(),
                iterations,
                evaluations,
                end: report.end,
                second_variation,
            };
            return Ok((patch, found));
        }
        area = finer;
        points *= 2;
    }
}

fn uninterrupted(report: NewtonReport) -> Result<NewtonReport, MethodError> {
    if report.end == NewtonEnd::Stopped { Err(MethodError::Interrupted) } else { Ok(report) }
}

/// Steps without a decrease to wait for: 8 where the area is wanted to all digits, 1 at a tolerance of 10⁻⁷ and above.
fn patience(tolerance: f64) -> usize {
    (-13.0 - 2.0 * libm::log10(tolerance)).clamp(1.0, 8.0) as usize
}

/// The smallest eigenvalue of the second variation against the Dirichlet product of the surface.
fn smallest(variation: &NormalVariation) -> Result<Option<f64>, MethodError> {
    let n = variation.gradient.rows();
    let (curvature, gradient) = (variation.curvature.as_slice(), variation.gradient.as_slice());
    Ok(smallest_relative_eigenvalue(n, curvature, gradient)?.map(|smallest| 1.0 + smallest))
}

/// `A(x) + ½ pull |x − to|²` as Newton's method asks for it: a point where the area has no gradient lies outside of its
/// domain.
struct Pulled<'a> {
    area: &'a Area,
    pull: f64,
    to: &'a [f64],
    progress: &'a dyn Progress,
}

impl SmoothFunction for Pulled<'_> {
    fn unknowns(&self) -> usize {
        self.area.unknowns()
    }

    fn value_and_gradient(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let mut value = self.area.value_and_gradient(x, gradient).unwrap_or(f64::NAN);
        for ((g, x), to) in gradient.iter_mut().zip(x).zip(self.to) {
            *g += self.pull * (x - to);
            value += 0.5 * self.pull * (x - to).powi(2);
        }
        value
    }

    fn hessian(&mut self, x: &[f64], hessian: &mut [f64]) {
        if self.area.hessian(x, hessian).is_err() {
            hessian.fill(f64::NAN);
        }
        hessian.iter_mut().step_by(x.len() + 1).for_each(|h| *h += self.pull);
    }

    fn watch(&mut self, reached: &NewtonReport) -> ControlFlow<()> {
        self.progress.step();
        let distance: f64 = reached.x.iter().zip(self.to).map(|(x, to)| (x - to).powi(2)).sum();
        self.progress.tell(&format!(
            "(step {}: area {:.9})",
            reached.iterations,
            reached.value - 0.5 * self.pull * distance
        ));
        if self.progress.cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
