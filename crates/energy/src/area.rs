//! The area of a patch, `∫ √(EG − F²)`.

use bases::GaussLegendre;
use surfaces::{Domain, Patch, Point, TensorPatch};

use crate::EnergyError;

/// An integral over a patch with what is known of its accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// The error believed: how far the last doubling of the rule moved the value, plus rounding.
    pub error: f64,
    /// Points of the last rule in each direction.
    pub points: usize,
    /// Whether the error fell below the tolerance asked for before the largest rule was reached.
    pub settled: bool,
}

/// Relative change of the area at which the rule is no longer doubled.
pub const AREA_TOLERANCE: f64 = 1e-10;

const FIRST_RULE: usize = 8;
const LARGEST_RULE: usize = 512;

/// The area of a patch by Gauss rules of 8², 16², … points until a doubling moves it by no more than 1e-10 of its
/// value, at most 512² points. Unit: length².
///
/// Smooth immersed patches settle at 16 or 32 points with an error far below the one believed; folds, where
/// EG − F² touches zero, converge slowly and are then reported as not settled, with the error that remains.
///
/// # Errors
/// [`EnergyError::Basis`] never in fact: all rules used are offered.
pub fn area(patch: &dyn Patch) -> Result<Integral, EnergyError> {
    integrate(patch, AREA_TOLERANCE, |jet| jet.area_density())
}

/// The integral of any density of the jet over the domain of the patch, by the same doubling to `tolerance`
/// (relative).
///
/// # Errors
/// [`EnergyError::Basis`] never in fact: all rules used are offered.
pub fn integrate(
    patch: &dyn Patch,
    tolerance: f64,
    density: impl Fn(&surfaces::Jet) -> f64,
) -> Result<Integral, EnergyError> {
    let mut points = FIRST_RULE;
    let mut last = by_rule(patch, points, &density)?;
    loop {
        points *= 2;
        let value = by_rule(patch, points, &density)?;
        let error = (value - last).abs() + 64.0 * f64::EPSILON * value.abs();
        let settled = error <= tolerance * value.abs();
        if settled || points >= LARGEST_RULE || !value.is_finite() {
            return Ok(Integral { value, error, points, settled });
        }
        last = value;
    }
}

/// `Σ w · density` over the product rule of `points`² points; over a triangle, the rule of the square collapsed onto it.
fn by_rule(
    patch: &dyn Patch,
    points: usize,
    density: &impl Fn(&surfaces::Jet) -> f64,
) -> Result<f64, EnergyError> {
    let unit = GaussLegendre::new(points)?;
    match patch.domain() {
        Domain::Rectangle { u, v } => {
            let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
            let us: Vec<f64> = rule_u.iter().map(|(t, _)| t).collect();
            let vs: Vec<f64> = rule_v.iter().map(|(t, _)| t).collect();
            let mut sum = 0.0;
            for (a, row) in patch.jets(&us, &vs).chunks_exact(points).enumerate() {
                let line: f64 = row.iter().enumerate().map(|(b, jet)| rule_v.weight(b) * density(jet)).sum();
                sum += rule_u.weight(a) * line;
            }
            Ok(sum)
        }
        Domain::Triangle => {
            let mut sum = 0.0;
            for (s, ws) in unit.iter() {
                let line: f64 = unit.iter().map(|(t, wt)| wt * density(&patch.jet(s, (1.0 - s) * t))).sum();
                sum += ws * (1.0 - s) * line;
            }
            Ok(sum)
        }
    }
}

/// The area of a tensor patch and its gradient with respect to the coordinates of the net, in the layout of
/// `Net::coordinates`, both by the rule that settled the area.
///
/// `d√(EG−F²) = [(G x_u − F x_v) · dx_u + (E x_v − F x_u) · dx_v] / √(EG−F²)`. Where the patch is singular the density
/// has no gradient and that point contributes none.
///
/// # Errors
/// As [`area()`].
pub fn area_with_gradient(patch: &TensorPatch) -> Result<(Integral, Vec<f64>), EnergyError> {
    let integral = area(patch)?;
    let (rows, cols) = (patch.net().rows(), patch.net().cols());
    let Domain::Rectangle { u, v } = patch.domain() else {
        unreachable!("tensor patches live on rectangles")
    };
    let unit = GaussLegendre::new(integral.points)?;
    let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
    let us: Vec<f64> = rule_u.iter().map(|(t, _)| t).collect();
    let vs: Vec<f64> = rule_v.iter().map(|(t, _)| t).collect();
    let jets = patch.jets(&us, &vs);
    let mut gradient = vec![Point::ZERO; rows * cols];
    for product in patch.products() {
        let g_tables: Vec<_> = vs.iter().map(|&v| product.v.evaluate(v, 1)).collect();
        for (a, &u) in us.iter().enumerate() {
            let f = product.u.evaluate(u, 1);
            let mut along_u = vec![Point::ZERO; cols];
            let mut along_v = vec![Point::ZERO; cols];
            for (b, g) in g_tables.iter().enumerate() {
                let jet = &jets[a * vs.len() + b];
                let (form, density) = (jet.first_form(), jet.area_density());
                if density == 0.0 {
                    continue;
                }
                let w = rule_u.weight(a) * rule_v.weight(b) / density;
                let du = (jet.u * form.g - jet.v * form.f) * w;
                let dv = (jet.v * form.e - jet.u * form.f) * w;
                for j in 0..cols {
                    along_u[j] += du * g[(0, j)];
                    along_v[j] += dv * g[(1, j)];
                }
            }
            for i in 0..rows {
                for j in 0..cols {
                    gradient[i * cols + j] += along_u[j] * f[(1, i)] + along_v[j] * f[(0, i)];
                }
            }
        }
    }
    Ok((integral, gradient.into_iter().flat_map(<[f64; 3]>::from).collect()))
}
