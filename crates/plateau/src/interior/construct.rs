//! The net a method begins with, and the patch on it.

use surfaces::{Net, TensorPatch, discrete_coons, rectangular_mask, tb_coons};

use super::{harmonic, mask};
use crate::{Basis, Boundary, Interior, Mask, Method, MethodError, Patch, SolveFigures};

/// The net of a method: whole, with the figures of its construction, or with an interior yet to be solved for.
pub(crate) fn construct(
    method: &Method,
    boundary: &Boundary,
) -> Result<(Net, Option<SolveFigures>), MethodError> {
    if method.interior == Interior::Harmonic {
        let (net, figures) = harmonic::net(boundary)?;
        return Ok((net, Some(figures)));
    }
    let net = boundary_net(boundary)?.raised(method.raise);
    let alpha = match method.interior {
        Interior::Mask(Mask::Alpha(alpha)) => alpha,
        Interior::DiscreteCoons => {
            let [u0, u1, v0, v1] = net.boundary();
            return Ok((discrete_coons(&u0, &u1, &v0, &v1)?.with_all_fixed(), Some(SolveFigures::EXPLICIT)));
        }
        Interior::Mask(_) => return Err(MethodError::Unavailable { what: "this mask for tensor nets" }),
        Interior::Extremal { .. } | Interior::Harmonic => return Ok((net, None)),
    };
    let system = rectangular_mask(alpha, &net)?;
    let (m, n) = net.degrees();
    let (coordinates, figures) = mask::solve(&system, net.fixed(), &net.coordinates())
        .map_err(|error| error.of_mask(alpha, m.max(n)))?;
    Ok((net.with_coordinates(&coordinates)?.with_all_fixed(), Some(figures)))
}

/// The net with its boundary fixed.
pub(crate) fn boundary_net(boundary: &Boundary) -> Result<Net, MethodError> {
    match boundary {
        Boundary::Tensor(sides) => Ok(sides.net()?),
        Boundary::Opposite(_) | Boundary::Triangle(_) => {
            Err(MethodError::Unavailable { what: "this kind of boundary" })
        }
    }
}

/// The patch of a method on a net, its interior not yet solved for.
pub(crate) fn with_shape(
    net: Net,
    method: &Method,
    shape: Option<[f64; 4]>,
) -> Result<TensorPatch, MethodError> {
    Ok(match (method.patch, method.basis, shape) {
        (Patch::TbCoons, _, Some(shape)) => tb_coons(net, shape)?,
        (_, Basis::Gt, Some(shape)) => TensorPatch::gt(net, shape)?,
        _ => TensorPatch::bernstein(net)?,
    })
}
