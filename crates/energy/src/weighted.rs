//! The metric Dirichlet energy (TRI Prop. 4 and 5): the step of the metric correction.

use bases::Matrix;
use surfaces::{Domain, Jet, Patch, TensorPatch};

use crate::product::{add_upper_product, mirrored};
use crate::{DenseForm, EnergyError, Integral, TangentSamples};

/// `D^g(x) = ∫ (G0 E − 2 F0 F + E0 G)/√(E0 G0 − F0²)` as a form of the net of x, with g = (E0, F0, G0) the first fundamental
/// form of a fixed chart.
///
/// Positive semidefinite, positive definite on the interior of a net. For every chart x over the same domain
/// `D^g(x) ≥ 2 · area(x)`, with equality exactly if x is conformal to g, as the chart that g was taken from is: hence the
/// extremal with the border of a patch has no larger area than the patch itself ("metric correction", TRI §7), and rests
/// where the area is stationary. One or two steps gain nearly all; the rest moves points along the surface and
/// comes linearly, by 1 to 3 percent a step.
#[derive(Debug, Clone, PartialEq)]
pub struct MetricForm {
    /// The form.
    pub form: DenseForm,
    /// Points of the rule in each direction.
    pub points: usize,
    /// How far the last doubling of the rule moved an entry, relative to the largest one.
    pub error: f64,
    /// Whether that fell below [`METRIC_TOLERANCE`] before the largest rule was reached.
    pub settled: bool,
    /// The form by the rule of half as many points.
    coarser: DenseForm,
}

/// Relative change of the entries of a [`MetricForm`] at which the rule is no longer doubled.
pub const METRIC_TOLERANCE: f64 = 1e-10;

/// The rule is not doubled beyond this many points in each direction.
const LARGEST_RULE: usize = 192;

impl MetricForm {
    /// The form of D^g for triangular nets of degree `degree`, g taken from `metric`, by collapsed Gauss rules
    /// doubled from degree + 2 points until the entries settle.
    ///
    /// # Errors
    /// [`EnergyError::Domain`] if `metric` does not live on the triangle, [`EnergyError::Singular`] where
    /// E0 G0 − F0² = 0 at a point of a rule, [`EnergyError::Basis`] for a degree that is not offered.
    pub fn of_triangle(metric: &dyn Patch, degree: usize) -> Result<Self, EnergyError> {
        if metric.domain() != Domain::Triangle {
            return Err(EnergyError::Domain { expected: Domain::Triangle, found: metric.domain() });
        }
        Self::settle(degree + 2, |points| {
            assemble(TangentSamples::of_triangle(degree, points)?, |batch| {
                batch.parameters().iter().map(|&[u, v]| metric.jet(u, v)).collect()
            })
        })
    }

    /// The form of D^g for nets of the families of `patch`, g taken from `metric`, by product Gauss rules doubled until
    /// the entries settle. The net of `patch` plays no part.
    ///
    /// # Errors
    /// [`EnergyError::Domain`] if the two do not live on the same rectangle, [`EnergyError::Singular`] where
    /// E0 G0 − F0² = 0 at a point of a rule.
    pub fn of_tensor(metric: &dyn Patch, patch: &TensorPatch) -> Result<Self, EnergyError> {
        if metric.domain() != patch.domain() {
            return Err(EnergyError::Domain { expected: patch.domain(), found: metric.domain() });
        }
        let (m, n) = patch.net().degrees();
        Self::settle(m.max(n) + 4, |points| {
            assemble(TangentSamples::of_tensor(patch, points)?, |batch| {
                // Lines of constant u, the same v on each: a grid.
                let us: Vec<f64> = batch.parameters().iter().step_by(points).map(|[u, _]| *u).collect();
                let vs: Vec<f64> = batch.parameters()[..points].iter().map(|[_, v]| *v).collect();
                metric.jets(&us, &vs)
            })
        })
    }

    /// D^g of the net with these coordinates, length²; its error is what the last doubling of the rule moved it by, and the rounding
    /// of a sum over all entries.
    ///
    /// # Panics
    /// If `coordinates` is not 3 × points of the net long.
    #[track_caller]
    #[must_use]
    pub fn energy(&self, coordinates: &[f64]) -> Integral {
        let value = self.form.value(coordinates);
        let moved = (value - self.coarser.value(coordinates)).abs();
        let rounding = f64::EPSILON * self.form.magnitude(coordinates);
        Integral { value, error: moved + rounding, points: self.points, settled: self.settled }
    }

    fn settle(
        first: usize,
        matrix: impl Fn(usize) -> Result<Matrix, EnergyError>,
    ) -> Result<Self, EnergyError> {
        let mut points = first;
        let mut last = matrix(points)?;
        loop {
            points *= 2;
            let next = matrix(points)?;
            let change = next.as_slice().iter().zip(last.as_slice()).map(|(a, b)| (a - b).abs());
            let error = change.fold(0.0, f64::max) / next.max_abs();
            let settled = error <= METRIC_TOLERANCE;
            if settled || 2 * points > LARGEST_RULE {
                let (form, coarser) = (DenseForm::new(next)?, DenseForm::new(last)?);
                return Ok(Self { form, points, error, settled, coarser });
            }
            last = next;
        }
    }
}

/// `Σ w (∂uφ, ∂vφ)ᵀ [G0 −F0; −F0 E0] (∂uφ, ∂vφ) / √(E0 G0 − F0²)`.
fn assemble(
    batches: impl Iterator<Item = TangentSamples>,
    metric: impl Fn(&TangentSamples) -> Vec<Jet>,
) -> Result<Matrix, EnergyError> {
    let mut upper = Matrix::zeros(0, 0);
    for batch in batches {
        let (points, functions) = (batch.points(), batch.functions());
        if upper.rows() == 0 {
            upper = Matrix::zeros(functions, functions);
        }
        let mut right = Matrix::zeros(2 * points, functions);
        for (p, (jet, &[u, v])) in metric(&batch).iter().zip(batch.parameters()).enumerate() {
            if jet.normal().is_none() {
                return Err(EnergyError::Singular { u, v });
            }
            let scale = batch.weights()[p] / jet.area_density();
            let form = jet.first_form();
            let (e, f, g) = (scale * form.e, scale * form.f, scale * form.g);
            let derivatives = || batch.u().row(p).iter().zip(batch.v().row(p));
            right.row_mut(p).iter_mut().zip(derivatives()).for_each(|(r, (du, dv))| *r = g * du - f * dv);
            let below = right.row_mut(points + p).iter_mut();
            below.zip(derivatives()).for_each(|(r, (du, dv))| *r = e * dv - f * du);
        }
        add_upper_product(&mut upper, &batch.stacked(), &right);
    }
    Ok(mirrored(upper))
}
