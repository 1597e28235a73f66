//! Memory that a method is about to take: asked for beforehand, so that its lack is an error and not the end of the program.

use crate::{Energy, Interior, Method, MethodError, Patch, SolverChoice};

/// Tables, meshes of pictures and stacks beside the arrays that are counted.
const BESIDE: usize = 16 << 20;

/// Bytes of a vertex of a mesh: point, normal, parameters, curvatures, two triangles.
const VERTEX: usize = 24 + 24 + 16 + 16 + 16 + 24;

/// An error unless `bytes` and something beside them can be allocated.
pub(crate) fn holds(bytes: usize) -> Result<(), MethodError> {
    let bytes = bytes.saturating_add(BESIDE);
    let mut space: Vec<u8> = Vec::new();
    space.try_reserve_exact(bytes).map_err(|_| MethodError::OutOfMemory { bytes })
}

/// Bytes of the largest arrays that `method` takes on a net of these degrees, before it is raised.
pub(crate) fn of_method(method: &Method, (m, n): (usize, usize)) -> usize {
    let (m, n) = (m + method.raise, n + method.raise);
    let (points, free) = match method.patch {
        Patch::Triangle => ((n + 1) * (n + 2) / 2, n.saturating_sub(1) * n.saturating_sub(2) / 2),
        Patch::Tensor | Patch::TbCoons => ((m + 1) * (n + 1), m.saturating_sub(1) * n.saturating_sub(1)),
    };
    let square = |order: usize| 8usize.saturating_mul(order.saturating_mul(order));
    let is_tensor = method.patch != Patch::Triangle;
    match method.interior {
        // The Hessian in three coordinates, its copy with a shift, its factor.
        Interior::Extremal { energy: Energy::Area, .. } => square(3 * free).saturating_mul(4),
        // Solved for direction by direction.
        Interior::Extremal { metric_steps: 0, .. } if is_tensor && method.solver != SolverChoice::Dense => {
            points.saturating_mul(4096)
        }
        // The form, the block of the free points, its copy in units, its factor, and those of the proof.
        Interior::Extremal { metric_steps, .. } => {
            let forms = if metric_steps > 0 { 5 } else { 2 };
            square(points).saturating_mul(forms).saturating_add(square(free).saturating_mul(6))
        }
        Interior::Harmonic => square(points).saturating_mul(6),
        Interior::Mask(_) => points.saturating_mul(4096),
        // Nothing is solved: the net, and the few copies that are made of it.
        Interior::DiscreteCoons => points.saturating_mul(256),
    }
}

/// Bytes of a mesh with `subdivisions` steps of each parameter.
pub(crate) fn of_mesh(subdivisions: usize) -> usize {
    let rows = subdivisions.saturating_add(1);
    rows.saturating_mul(rows).saturating_mul(VERTEX)
}
