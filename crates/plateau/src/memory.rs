//! Memory that a method is about to take: asked for beforehand, so that its lack is an error and not the end of the program.

use crate::{
    Displacement, Filling, Functions, Method, MethodError, SolverChoice, TensorInterior, TriangleInterior,
};

/// Tables, meshes of pictures and stacks beside the arrays that are counted.
const BESIDE: usize = 16 << 20;

/// Bytes of the tables of one function of a blend: values and both derivatives at the points of the finest rules, which are all kept.
const SAMPLES: usize = 3 * 8 * 70_000;

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
    let (m, n) = (m + method.raise(), n + method.raise());
    match method.filling() {
        Filling::Tensor { functions, interior: TensorInterior::LeastArea { .. } } if functions.is_blend() => {
            let points = (m + 1) * (n + 1);
            of_least_area(points).saturating_add(points.saturating_mul(SAMPLES))
        }
        // Only the first displacement must be found; each other asks for itself.
        Filling::Tensor { functions: Functions::Bernstein, interior: TensorInterior::LeastArea { .. } }
            if m.max(n) > Displacement::WHOLE =>
        {
            of_displacement((m.min(Displacement::LOWEST), n.min(Displacement::LOWEST)))
        }
        Filling::Tensor { interior, .. } => {
            of_tensor(*interior, (m + 1) * (n + 1), m.saturating_sub(1) * n.saturating_sub(1))
        }
        Filling::Triangle(interior) => {
            of_triangle(*interior, (n + 1) * (n + 2) / 2, n.saturating_sub(1) * n.saturating_sub(2) / 2)
        }
    }
}

/// Bytes of a square matrix.
fn square(order: usize) -> usize {
    8usize.saturating_mul(order.saturating_mul(order))
}

/// Bytes of a least area: the Hessian in three coordinates, its copy with a shift, its factor.
fn of_least_area(free: usize) -> usize {
    square(3 * free).saturating_mul(4)
}

/// Bytes of a least area among displacements of these degrees.
pub(crate) fn of_displacement((m, n): (usize, usize)) -> usize {
    of_least_area(m.saturating_sub(1) * n.saturating_sub(1))
}

/// Bytes of a least area over so many faces of a degree: the Hessian of each in three coordinates, and its factor.
pub(crate) fn of_faces(degree: usize, faces: usize) -> usize {
    square(3 * degree.saturating_sub(1).pow(2)).saturating_mul(faces).saturating_mul(2)
}

/// Bytes of the estimate of a least area over so many faces, `at_corners` of them at odd corners: the last of its surfaces has four degrees
/// more, and four layers, each of two faces more at a corner.
pub(crate) fn of_estimate(degree: usize, faces: usize, at_corners: usize) -> usize {
    of_faces(degree + 4, faces + 8 * at_corners)
}

/// Bytes of a dense extremal: its forms, the block of the free points, its copy in units, its factor, and those of the proof.
fn of_dense(forms: usize, points: usize, free: usize) -> usize {
    square(points).saturating_mul(forms).saturating_add(square(free).saturating_mul(6))
}

/// Bytes of the system of a mask, or of one solved for direction by direction.
fn of_sparse(points: usize) -> usize {
    points.saturating_mul(4096)
}

/// Bytes of a net that is given by a formula, and of the few copies that are made of it.
fn of_formula(points: usize) -> usize {
    points.saturating_mul(256)
}

fn of_tensor(interior: TensorInterior, points: usize, free: usize) -> usize {
    match interior {
        TensorInterior::LeastArea { .. } => of_least_area(free),
        TensorInterior::Extremal { solver: SolverChoice::Dense, .. } => of_dense(2, points, free),
        TensorInterior::Extremal { solver: SolverChoice::Auto | SolverChoice::Separable, .. }
        | TensorInterior::Mask { .. } => of_sparse(points),
        TensorInterior::MetricCorrections { .. } => of_dense(5, points, free),
        TensorInterior::Harmonic => square(points).saturating_mul(6),
        TensorInterior::DiscreteCoons => of_formula(points),
    }
}

fn of_triangle(interior: TriangleInterior, points: usize, free: usize) -> usize {
    match interior {
        TriangleInterior::LeastArea { .. } => of_least_area(free),
        TriangleInterior::Extremal { .. } => of_dense(2, points, free),
        TriangleInterior::MetricCorrections { .. } => of_dense(5, points, free),
        TriangleInterior::Mask(_) => of_sparse(points),
        TriangleInterior::DiscreteCoons => of_formula(points),
    }
}

/// Bytes of a mesh with `subdivisions` steps of each parameter.
pub(crate) fn of_mesh(subdivisions: usize) -> usize {
    let rows = subdivisions.saturating_add(1);
    rows.saturating_mul(rows).saturating_mul(VERTEX)
}
