//! The second variation of the area under normal displacements.

use bases::Matrix;
use surfaces::Jet;

use crate::product::{add_upper_product, mirrored};
use crate::{EnergyError, TangentSamples};

/// The second variation of the area of a surface under displacements f N along its unit normal, f vanishing on the border:
/// `d²/dt² A(x + t f N) = ∫ (|∇f|² + 2 K f²) dA` at t = 0, with ∇ and dA of the surface and K its Gauss curvature, as two
/// forms in the coefficients of N scalar functions.
///
/// Displacements along a stationary surface change its area not at all, so these tell all: the surface is a strict minimum
/// among its neighbours if the smallest eigenvalue σ of `gradient + curvature` against `gradient` is positive, not a
/// minimum if it is negative. σ is dimensionless, at most 1 (exactly 1 for plane pieces), and depends on neither
/// scale nor parametrisation; over finitely many functions it is found too large, not too small.
#[derive(Debug, Clone, PartialEq)]
pub struct NormalVariation {
    /// `∫ ∇ψ_k · ∇ψ_l dA`: N², symmetric, positive definite if the ψ are independent.
    pub gradient: Matrix,
    /// `∫ 2 K ψ_k ψ_l dA`: N², symmetric; negative semidefinite on minimal surfaces.
    pub curvature: Matrix,
}

impl NormalVariation {
    /// The forms in `functions` functions, 0: to be added to.
    pub fn zero(functions: usize) -> Self {
        let zeros = Matrix::zeros(functions, functions);
        Self { gradient: zeros.clone(), curvature: zeros }
    }

    /// Adds the part at the points of `samples`, where the functions have the values `values` (points × functions) and
    /// the surface the jets `jets`.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the sizes do not agree, [`EnergyError::Singular`] where a jet has no normal.
    pub fn add(
        &mut self,
        samples: &TangentSamples,
        values: &Matrix,
        jets: &[Jet],
    ) -> Result<(), EnergyError> {
        let (points, functions) = (samples.points(), samples.functions());
        for (what, expected, found) in [
            ("functions of a normal variation", self.gradient.rows(), functions),
            ("jets at sampled points", points, jets.len()),
            ("rows of sampled values", points, values.rows()),
            ("columns of sampled values", functions, values.cols()),
        ] {
            if expected != found {
                return Err(EnergyError::Shape { what, expected, found });
            }
        }
        let mut slopes = Matrix::zeros(2 * points, functions);
        let mut curved = Matrix::zeros(points, functions);
        for (p, (jet, &[u, v])) in jets.iter().zip(samples.parameters()).enumerate() {
            let curvature = jet.gauss_curvature().ok_or(EnergyError::Singular { u, v })?;
            let (form, density, weight) = (jet.first_form(), jet.area_density(), samples.weights()[p]);
            let scale = weight / density;
            let derivatives = || samples.u().row(p).iter().zip(samples.v().row(p));
            let by_u = derivatives().map(|(du, dv)| scale * (form.g * du - form.f * dv));
            slopes.row_mut(p).iter_mut().zip(by_u).for_each(|(out, slope)| *out = slope);
            let by_v = derivatives().map(|(du, dv)| scale * (form.e * dv - form.f * du));
            slopes.row_mut(points + p).iter_mut().zip(by_v).for_each(|(out, slope)| *out = slope);
            let factor = 2.0 * curvature * weight * density;
            curved.row_mut(p).iter_mut().zip(values.row(p)).for_each(|(out, value)| *out = factor * value);
        }
        add_upper_product(&mut self.gradient, &samples.stacked(), &slopes);
        add_upper_product(&mut self.curvature, values, &curved);
        self.gradient = mirrored(std::mem::replace(&mut self.gradient, Matrix::zeros(0, 0)));
        self.curvature = mirrored(std::mem::replace(&mut self.curvature, Matrix::zeros(0, 0)));
        Ok(())
    }
}
