//! The control net of least area with its border fixed.

mod space;

use energy::{EnergyError, Integral, NormalVariation};
use solve::{NewtonEnd, NewtonParams, SmoothFunction, newton, smallest_relative_eigenvalue};
use surfaces::{TensorPatch, TrianglePatch};

use super::MethodError;
use space::{Area, Product, Space, Sums, Triangle};

/// What is known of a net of least area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaExtremal {
    /// The area, with the error the rule was found to make (unit: length²).
    pub area: Integral,
    /// The area of the Dirichlet extremal it was reached from.
    pub start: f64,
    /// The norm of the gradient of the area over √area, in displacements of unit Dirichlet norm `∫ |∇ψ|²` (over the
    /// parameters); dimensionless.
    pub gradient: f64,
    /// Newton steps tried, over all rules.
    pub iterations: usize,
    /// Evaluations of the area with its gradient, over all rules.
    pub evaluations: usize,
    /// Why the last iteration ended.
    pub end: NewtonEnd,
    /// The smallest value of `∫ (|∇f|² + 2 K f²) dA / ∫ |∇f|² dA` over displacements f N along the unit normal, f one of the
    /// functions of the net that vanish on the border: the second variation of the area. Dimensionless, at most 1; positive
    /// for a stable minimum, negative for a saddle. An upper bound of its value over all f. None if no point is free,
    /// or where the surface found has no normal.
    pub second_variation: Option<f64>,
}

/// The gradient that counts as 0, relative to √area.
const GRADIENT_TOLERANCE: f64 = 1e-10;

/// Relative change of the area under a doubled rule at which the rule is accepted.
const RULE_TOLERANCE: f64 = 1e-10;

/// The rule begins with this many points more than the degree.
const FIRST_RULE: usize = 6;

/// The rule is not doubled beyond this many points in each direction.
const LARGEST_RULE: usize = 128;

/// The first trust region in units of √area.
const FIRST_RADIUS: f64 = 0.25;

/// The patch of least area on the border of `patch`, among the nets of its families: from the Dirichlet extremal by
/// trust-region Newton steps. The free points of `patch` play no part.
///
/// # Errors
/// [`MethodError::Energy`] with [`EnergyError::Singular`] if the Dirichlet extremal has parallel tangents at a point of
/// the rule, [`MethodError::Solve`] if the functions depend on each other to working precision.
pub(super) fn minimise(patch: &TensorPatch) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    let (m, n) = patch.net().degrees();
    let points = m.max(n) + FIRST_RULE;
    if patch.products().len() == 1 {
        minimise_in(&Product::new(patch)?, patch, points)
    } else {
        minimise_in(&Sums::new(patch, points)?, patch, points)
    }
}

/// The triangular patch of least area on the border of `patch`: as [`minimise`].
///
/// # Errors
/// As [`minimise`].
pub(super) fn minimise_triangle(
    patch: &TrianglePatch,
) -> Result<(TrianglePatch, AreaExtremal), MethodError> {
    let points = patch.net().degree() + FIRST_RULE;
    minimise_in(&Triangle::new(patch.net(), points)?, patch, points)
}

fn minimise_in<S: Space>(
    space: &S,
    patch: &S::Patch,
    mut points: usize,
) -> Result<(S::Patch, AreaExtremal), MethodError> {
    let projection = space.area(patch, points)?.dirichlet_projection();
    let mut patch = space.moved(patch, &projection.iter().map(|c| -c).collect::<Vec<_>>())?;
    let (mut iterations, mut evaluations, mut first) = (0, 0, None);
    loop {
        let area = space.area(&patch, points)?;
        let mut gradient = vec![0.0; area.unknowns()];
        let start = area.value_and_gradient(&vec![0.0; area.unknowns()], &mut gradient)?;
        let first = *first.get_or_insert(start);
        let unit = start.sqrt();
        let params = NewtonParams::new(GRADIENT_TOLERANCE * unit, FIRST_RADIUS * unit);
        let report = newton(&mut Variable(&area), &vec![0.0; area.unknowns()], params)?;
        iterations += report.iterations;
        evaluations += report.evaluations + 1;
        patch = space.moved(&patch, &report.x)?;
        let finer = space.area(&patch, 2 * points)?;
        let value = finer.value_and_gradient(&vec![0.0; area.unknowns()], &mut gradient)?;
        evaluations += 1;
        let gradient = gradient.iter().map(|g| g * g).sum::<f64>().sqrt() / value.sqrt();
        let error = (value - report.value).abs() + 64.0 * f64::EPSILON * value;
        let settled = error <= RULE_TOLERANCE * value && gradient <= report.gradient_norm / unit + GRADIENT_TOLERANCE;
        points *= 2;
        if settled || 2 * points > LARGEST_RULE {
            let second_variation = match space.variation(&patch, points / 2) {
                Ok(variation) => smallest(&variation)?,
                Err(MethodError::Energy(EnergyError::Singular { .. })) => None,
                Err(error) => return Err(error),
            };
            let area = Integral { value, error, points, settled };
            let end = report.end;
            let found =
                AreaExtremal { area, start: first, gradient, iterations, evaluations, end, second_variation };
            return Ok((patch, found));
        }
    }
}

/// The smallest eigenvalue of the second variation against the Dirichlet product of the surface.
fn smallest(variation: &NormalVariation) -> Result<Option<f64>, MethodError> {
    let n = variation.gradient.rows();
    let (curvature, gradient) = (variation.curvature.as_slice(), variation.gradient.as_slice());
    Ok(smallest_relative_eigenvalue(n, curvature, gradient)?.map(|smallest| 1.0 + smallest))
}

/// The area as Newton's method asks for it: a point where it has no gradient lies outside of its domain.
struct Variable<'a>(&'a Area);

impl SmoothFunction for Variable<'_> {
    fn unknowns(&self) -> usize {
        self.0.unknowns()
    }

    fn value_and_gradient(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self.0.value_and_gradient(x, gradient).unwrap_or(f64::NAN)
    }

    fn hessian(&mut self, x: &[f64], hessian: &mut [f64]) {
        if self.0.hessian(x, hessian).is_err() {
            hessian.fill(f64::NAN);
        }
    }
}
