//! The net a method begins with.

use surfaces::{Net, discrete_coons, rectangular_mask};

use super::{harmonic, mask};
use crate::{Boundary, MethodError, SolveFigures, TensorInterior};

/// The net of a method: whole, with the figures of its construction, or with an interior yet to be solved for.
pub(crate) fn construct(
    interior: TensorInterior,
    raise: usize,
    boundary: &Boundary,
) -> Result<(Net, Option<SolveFigures>), MethodError> {
    let raised = || -> Result<Net, MethodError> { Ok(boundary_net(boundary)?.raised(raise)) };
    match interior {
        TensorInterior::Extremal { .. }
        | TensorInterior::MetricCorrections { .. }
        | TensorInterior::LeastArea { .. } => Ok((raised()?, None)),
        TensorInterior::Harmonic => {
            let (net, figures) = harmonic::net(boundary)?;
            Ok((net, Some(figures)))
        }
        TensorInterior::Mask { alpha } => {
            let (net, figures) = by_mask(alpha, &raised()?)?;
            Ok((net, Some(figures)))
        }
        TensorInterior::DiscreteCoons => {
            let net = raised()?;
            let [u0, u1, v0, v1] = net.boundary();
            Ok((discrete_coons(&u0, &u1, &v0, &v1)?.with_all_fixed(), Some(SolveFigures::EXPLICIT)))
        }
    }
}

/// The net whose interior points are combinations of their neighbours, with corner weight `alpha`.
fn by_mask(alpha: f64, net: &Net) -> Result<(Net, SolveFigures), MethodError> {
    let system = rectangular_mask(alpha, net)?;
    let (m, n) = net.degrees();
    let (coordinates, figures) = mask::solve(&system, net.fixed(), &net.coordinates())
        .map_err(|error| error.of_mask(alpha, m.max(n)))?;
    Ok((net.with_coordinates(&coordinates)?.with_all_fixed(), figures))
}

/// The net with its boundary fixed.
pub(crate) fn boundary_net(boundary: &Boundary) -> Result<Net, MethodError> {
    match boundary {
        Boundary::Tensor(sides) => Ok(sides.net()?),
        Boundary::Opposite(_) | Boundary::Triangle(_) => {
            Err(MethodError::Sides { needs: "four sides", given: boundary.sides() })
        }
    }
}
