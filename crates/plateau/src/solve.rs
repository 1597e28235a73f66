//! Runs one method.

use crate::interior::{construct, extremal, triangle, with_shape};
use crate::search::search;
use crate::{
    Basis, Boundary, BoundaryFigures, Context, Done, Energy, Family, Figures, Method, MethodError, Patch,
    Shape, Solved, Surface, least_area, trust,
};

/// A surface that loses more than this share of its size to cancellation is not one.
const WORST_CANCELLATION: f64 = 1e-3;

/// The patch of a method over a boundary, with its figures.
///
/// # Errors
/// [`MethodError`] says why there is none.
pub fn solve(boundary: &Boundary, method: &Method, context: &Context<'_>) -> Result<Done, MethodError> {
    if context.progress.cancelled() {
        return Err(MethodError::Interrupted);
    }
    let solved = solved(boundary, method, context)?;
    let cancellation = solved.surface.cancellation();
    if cancellation > WORST_CANCELLATION {
        return Err(MethodError::Cancellation { degrees: solved.surface.degrees(), share: cancellation });
    }
    context.progress.begin(&format!("figures of {}", method.name), None);
    let mesh = solved.surface.mesh(context.mesh);
    let figures = Figures::of(solved.surface.patch(), &mesh);
    context.progress.end();
    let figures = figures?;
    let boundary = match &solved.surface {
        Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
        Surface::Triangle(_) | Surface::Pieces(_) => None,
    };
    let warnings = trust::warnings(&solved, &figures, &context.search);
    Ok(Done { solved, mesh, figures, boundary, closed_form: None, warnings })
}

/// The patch of a method.
fn solved(boundary: &Boundary, method: &Method, context: &Context<'_>) -> Result<Solved, MethodError> {
    let minimised = method.extremal_energy();
    if let Boundary::Triangle(sides) = boundary {
        let (patch, solve, area) = triangle::solve(method, sides, context.progress)?;
        let (surface, family) = (Surface::Triangle(patch), Family::Triangle);
        return Ok(Solved { surface, family, minimised, shape: None, solve, area, search: None });
    }
    let (net, construction) = construct(method, boundary)?;
    let (shape, search) = match method.shape {
        Shape::None => (None, None),
        Shape::Fixed(shape) => (Some(shape), None),
        Shape::Search(mode) => {
            let outcome = search(&net, method, mode, context)?;
            (Some(outcome.shape), Some(outcome))
        }
    };
    let patch = with_shape(net, method, shape)?;
    let (patch, solve, area) = match construction {
        Some(figures) => (patch, Some(figures), None),
        None if minimised == Some(Energy::Area) => {
            context.progress.begin(&format!("least area of {}", method.name), None);
            let found = least_area(&patch, method.tolerance, context.progress);
            context.progress.end();
            let (patch, found) = found?;
            (patch, None, Some(found))
        }
        None => {
            let (patch, figures) = extremal::solve(&patch, method, shape)?;
            (patch, Some(figures), None)
        }
    };
    let family = match (method.patch, method.basis) {
        (Patch::TbCoons, _) => Family::TbCoons,
        (_, Basis::Gt) => Family::Gt,
        _ => Family::Bernstein,
    };
    Ok(Solved { surface: Surface::Tensor(patch), family, minimised, shape, solve, area, search })
}
