//! The area over any sampled functions.

use surfaces::Point;

use crate::area_hessian::Density;
use crate::{AreaExpansion, EnergyError, TangentSamples};

/// The area of `x + Σ_k c_k ψ_k` as a function of the vectors c_k ∈ ℝ³, laid out one after the other, for functions ψ known
/// by their samples: value, gradient and Hessian. O(q² N²) a Hessian of N functions at q² points.
#[derive(Debug, Clone)]
pub struct SampledArea {
    batches: Vec<(TangentSamples, Vec<[Point; 2]>)>,
    functions: usize,
}

impl SampledArea {
    /// The area around the surface with the given tangents at the points of each batch of samples.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if a batch has another number of tangents than of points, or of functions than the first.
    pub fn new(batches: Vec<(TangentSamples, Vec<[Point; 2]>)>) -> Result<Self, EnergyError> {
        let functions = batches.first().map_or(0, |(samples, _)| samples.functions());
        for (samples, tangents) in &batches {
            for (what, expected, found) in [
                ("tangents at sampled points", samples.points(), tangents.len()),
                ("functions of a batch of samples", functions, samples.functions()),
            ] {
                if expected != found {
                    return Err(EnergyError::Shape { what, expected, found });
                }
            }
        }
        Ok(Self { batches, functions })
    }

    /// Number of unknowns, 3N.
    pub fn unknowns(&self) -> usize {
        3 * self.functions
    }

    /// The area at `c`; fills `gradient`.
    ///
    /// # Errors
    /// [`EnergyError::Singular`] where x_u and x_v are parallel at a point of the rule.
    ///
    /// # Panics
    /// If `c` or `gradient` does not hold 3N numbers.
    #[track_caller]
    pub fn value_and_gradient(&self, c: &[f64], gradient: &mut [f64]) -> Result<f64, EnergyError> {
        assert_eq!(gradient.len(), self.unknowns(), "length of a gradient");
        gradient.fill(0.0);
        let mut area = 0.0;
        for (samples, base) in &self.batches {
            // Each batch has a sum of its own: shorter sums round less.
            let mut part = 0.0;
            for (p, [x_u, x_v]) in moved(samples, base, c).into_iter().enumerate() {
                let [u, v] = samples.parameters()[p];
                let (value, by_u, by_v) = Density::slope(x_u, x_v).ok_or(EnergyError::Singular { u, v })?;
                let w = samples.weights()[p];
                part += w * value;
                let derivatives = samples.u().row(p).iter().zip(samples.v().row(p));
                for (out, (du, dv)) in gradient.chunks_exact_mut(3).zip(derivatives) {
                    let slope: [f64; 3] = (by_u * (w * du) + by_v * (w * dv)).into();
                    out.iter_mut().zip(slope).for_each(|(g, s)| *g += s);
                }
            }
            area += part;
        }
        Ok(area)
    }

    /// Fills `hessian`, (3N)², with the second derivatives of the area at `c`: symmetric bit for bit.
    ///
    /// # Errors
    /// As [`Self::value_and_gradient`].
    ///
    /// # Panics
    /// If `c` does not hold 3N numbers or `hessian` the square of that.
    #[track_caller]
    pub fn hessian(&self, c: &[f64], hessian: &mut [f64]) -> Result<(), EnergyError> {
        let mut sum = AreaExpansion::zero(self.functions);
        for (samples, base) in &self.batches {
            sum.add(samples, &moved(samples, base, c))?;
        }
        hessian.copy_from_slice(sum.hessian.as_slice());
        Ok(())
    }

    /// `∫ ∇x · ∇ψ_k`, 3N numbers: if the ψ are orthonormal against this product, minus that leads from x to the Dirichlet
    /// extremal.
    pub fn dirichlet_projection(&self) -> Vec<f64> {
        let mut sums = vec![Point::ZERO; self.functions];
        for (samples, base) in &self.batches {
            for (p, &[x_u, x_v]) in base.iter().enumerate() {
                let w = samples.weights()[p];
                let derivatives = samples.u().row(p).iter().zip(samples.v().row(p));
                for (sum, (du, dv)) in sums.iter_mut().zip(derivatives) {
                    *sum += x_u * (w * du) + x_v * (w * dv);
                }
            }
        }
        sums.into_iter().flat_map(<[f64; 3]>::from).collect()
    }

    /// The samples, batch by batch.
    pub fn samples(&self) -> impl Iterator<Item = &TangentSamples> {
        self.batches.iter().map(|(samples, _)| samples)
    }
}

fn moved(samples: &TangentSamples, base: &[[Point; 2]], c: &[f64]) -> Vec<[Point; 2]> {
    assert_eq!(c.len(), 3 * samples.functions(), "length of the coefficients");
    let mut tangents = base.to_vec();
    for (p, [x_u, x_v]) in tangents.iter_mut().enumerate() {
        let derivatives = samples.u().row(p).iter().zip(samples.v().row(p));
        for (c, (du, dv)) in c.chunks_exact(3).zip(derivatives) {
            let c = Point::new(c[0], c[1], c[2]);
            *x_u += c * *du;
            *x_v += c * *dv;
        }
    }
    tangents
}
