use bases::{Gt, GtParts, Samples};
use solve::{AffineSamples, SeparableParametric};
use surfaces::Net;

use crate::{FixtureError, interior};

/// The GT functions of one degree and shape at a Gauss rule, as [`solve::Separable`] takes them.
///
/// # Errors
/// Those of [`Gt::new`].
pub fn gt_samples(degree: usize, shape: [f64; 2]) -> Result<solve::Samples, FixtureError> {
    let samples = Samples::new(&Gt::new(degree, shape)?, Samples::points_for(degree + 1), 1)?;
    Ok(solve::Samples {
        points: samples.nodes().len(),
        functions: degree + 1,
        weights: samples.weights().to_vec(),
        values: samples.order(0).as_slice().to_vec(),
        derivatives: samples.order(1).as_slice().to_vec(),
    })
}

/// The GT functions of one degree for every shape, as [`SeparableParametric`] takes them.
///
/// # Errors
/// Those of [`GtParts::new`].
pub fn affine_samples(degree: usize) -> Result<AffineSamples, FixtureError> {
    let functions = degree + 1;
    let samples = Samples::new(&GtParts::new(degree)?, Samples::points_for(functions), 1)?;
    let points = samples.nodes().len();
    let split = |order: usize| {
        std::array::from_fn(|part| {
            let row = |p: usize| samples.order(order).row(p)[part * functions..][..functions].iter().copied();
            (0..points).flat_map(row).collect()
        })
    };
    let weights = samples.weights().to_vec();
    Ok(AffineSamples { points, functions, weights, values: split(0), derivatives: split(1) })
}

/// The reduced Dirichlet energy of GT patches over `net` from samples, without Gram matrices.
///
/// # Errors
/// Those of [`affine_samples`] and [`SeparableParametric::new`].
pub fn separable_parametric(net: &Net) -> Result<SeparableParametric, FixtureError> {
    let (m, n) = net.degrees();
    let (u, v) = (affine_samples(m)?, affine_samples(n)?);
    Ok(SeparableParametric::new(u, v, &interior(m), &interior(n), &net.coordinates())?)
}
