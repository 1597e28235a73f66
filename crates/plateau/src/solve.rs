//! Runs one method.

use surfaces::{Mesh, Point, TensorPatch};

use crate::excess::estimated;
use crate::interior::{boundary_net, construct, extremal, triangle};
use crate::method::patch_of;
use crate::search::search;
use crate::slender::gain_of_cutting;
use crate::{
    AreaExtremal, Boundary, BoundaryFigures, Context, Done, Energy, Family, Figures, Fill, Filling,
    FixedShape, Functional, Functions, Interior, Loop, Method, MethodError, Progress, SolveFigures, Solved,
    Surface, TensorBoundary, TensorInterior, Warning, least_area_from, least_area_raised, lower_bound_of_net,
    memory, trust,
};

/// A surface that loses more than this share of its size to cancellation is not one.
const WORST_CANCELLATION: f64 = 1e-3;

/// The patch of a method over a boundary, with its figures.
///
/// All is computed relative to a point of the boundary ([`anchor`](surfaces::anchor)) and moved there in the end: how far from the
/// origin the boundary lies changes no figure, and its control points are those given, bit for bit (unless `raise` makes others).
///
/// # Errors
/// [`MethodError`] says why there is none.
pub fn solve(boundary: &Boundary, method: &Method, context: &Context<'_>) -> Result<Done, MethodError> {
    if context.progress.cancelled() {
        return Err(MethodError::Interrupted);
    }
    if let Some(limit) = method.degree_limit() {
        limit.admits(boundary.degrees(), method.raise())?;
    }
    memory::holds(memory::of_method(method, boundary.degrees()))?;
    if let (Boundary::Tensor(sides), Some(fill)) = (boundary, layered(method)) {
        return around_corners(sides, method, fill.with_mesh_in_all(context.mesh), context);
    }
    let given = boundary;
    let (boundary, origin) = boundary.anchored();
    let near = |solved: &&Solved| (*solved).clone().moved(-origin);
    let at_hand = context.at_hand.iter().map(near).collect::<Result<Vec<Solved>, MethodError>>()?;
    let at_hand: Vec<&Solved> = at_hand.iter().collect();
    let solved = solved(&boundary, method, &Context { at_hand: &at_hand, ..*context })?;
    let cancellation = solved.surface().cancellation();
    if cancellation > WORST_CANCELLATION {
        return Err(MethodError::Cancellation { degrees: solved.surface().degrees(), share: cancellation });
    }
    let mut mesh = solved.surface().mesh(context.mesh)?;
    context.progress.begin(&format!("figures of {}", method.name()), None);
    let figures = figures(&solved, &mesh, origin);
    context.progress.end();
    let figures = figures?;
    let boundary = match solved.surface() {
        Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
        Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_) => None,
    };
    let mut warnings = trust::warnings(&solved, &figures, &context.search);
    let estimate =
        estimated((solved.surface(), solved.family(), solved.area()), &mut warnings, context.progress)?;
    warnings.extend(of_cutting(method, &solved, context.progress)?);
    let solved = solved.moved(origin)?;
    mesh.points.iter_mut().for_each(|p| *p += origin);
    let bound = match (solved.surface(), method.filling()) {
        (
            Surface::Tensor(patch),
            Filling::Tensor { interior: TensorInterior::LeastArea { bound: true, .. }, .. },
        ) => {
            let bound = lower_bound_of_net(&boundary_net(given)?, patch.net());
            bound.map_err(|why| warnings.push(Warning::NoBound(why))).ok()
        }
        (Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_), _) => None,
    };
    Ok(Done { solved, mesh, figures, boundary, closed_form: None, film: None, estimate, bound, warnings })
}

/// How a method fills four sides with layers of smaller patches around corners, if it does.
fn layered(method: &Method) -> Option<Fill> {
    match method.filling() {
        Filling::Tensor {
            interior: TensorInterior::LeastArea { tolerance, bound, layers: layers @ 1.. },
            ..
        } => Some(Fill::default().with_tolerance(*tolerance).with_bound(*bound).with_layers(*layers)),
        Filling::Tensor { .. } | Filling::Triangle(_) => None,
    }
}

/// The surface of several patches over four sides, the same as over the loop that they make.
fn around_corners(
    sides: &TensorBoundary,
    method: &Method,
    fill: Fill,
    context: &Context<'_>,
) -> Result<Done, MethodError> {
    let [u0, u1, v0, v1] = sides.sides().clone();
    let back = |side: Vec<Point>| side.into_iter().rev().collect();
    let around = Loop::sides(vec![u0, v1, back(u1), back(v0)])?;
    let (m, n) = sides.degrees();
    context.progress.begin(&format!("least area of {}", method.name()), None);
    let film = fill.with_degree(m.max(n) + method.raise()).loops(&[around], context.progress);
    context.progress.end();
    Ok(film?.into_done())
}

/// What a patch of least area over a slender border would gain by being cut.
fn of_cutting(
    method: &Method,
    solved: &Solved,
    progress: &dyn Progress,
) -> Result<Option<Warning>, MethodError> {
    let (
        Filling::Tensor {
            functions: Functions::Bernstein,
            interior: TensorInterior::LeastArea { tolerance, .. },
        },
        Surface::Tensor(patch),
        Some(found),
    ) = (method.filling(), solved.surface(), solved.area())
    else {
        return Ok(None);
    };
    progress.begin(&format!("least area of {}, cut across", method.name()), None);
    let slender = gain_of_cutting(patch.net(), found, *tolerance, progress);
    progress.end();
    Ok(slender?.map(|slender| Warning::Slender { ratio: slender.ratio, cut: slender.cut }))
}

/// The figures of a patch that lies `origin` away from where its boundary was given; of what was minimised, whatever it was.
fn figures(solved: &Solved, mesh: &Mesh, origin: Point) -> Result<Figures, MethodError> {
    let patches: Vec<&dyn surfaces::Patch> = solved.surface().patch().into_iter().collect();
    let figures = Figures::of_moved(&patches, mesh, origin.norm())?;
    Ok(match solved.minimised() {
        Some(Energy::Quadratic(functional)) => figures.with_minimised(functional, &patches)?,
        Some(Energy::Area) | None => figures,
    })
}

/// The patch of least area on the border of `patch`, not above those at hand.
fn of_least_area(
    boundary: &Boundary,
    raise: usize,
    patch: &TensorPatch,
    shape: Option<&FixedShape>,
    tolerance: f64,
    context: &Context<'_>,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    let (m, n) = patch.net().degrees();
    let family = shape.map_or(Family::Bernstein, |shape| Family::Shaped(shape.family()));
    let mut starts = Vec::new();
    for solved in context.at_hand {
        let Surface::Tensor(other) = solved.surface() else { continue };
        let (k, l) = other.net().degrees();
        let has_functions = solved.family() == family && solved.shape() == shape.map(FixedShape::parameters);
        if !has_functions || k > m || n.checked_sub(l) != Some(m - k) {
            continue;
        }
        match shape {
            None => starts.push(TensorPatch::bernstein(other.net().raised(m - k))?),
            Some(_) if k == m => starts.push(patch.with_net(other.net().clone())?),
            Some(_) => {}
        }
    }
    match shape {
        None => least_area_raised(&boundary_net(boundary)?, raise, &starts, tolerance, context.progress),
        Some(_) => least_area_from(patch, &starts, tolerance, context.progress),
    }
}

/// The patch of a method.
fn solved(boundary: &Boundary, method: &Method, context: &Context<'_>) -> Result<Solved, MethodError> {
    match (method.filling(), boundary) {
        (Filling::Triangle(interior), Boundary::Triangle(sides)) => {
            triangle::solve(method, *interior, sides, context.at_hand, context.progress)
        }
        (Filling::Triangle(_), Boundary::Tensor(_) | Boundary::Opposite(_)) => {
            Err(MethodError::Sides { needs: "three sides", given: boundary.sides() })
        }
        (Filling::Tensor { functions, interior }, _) => {
            of_tensor(boundary, method, functions, *interior, context)
        }
    }
}

/// The tensor patch of a method.
fn of_tensor(
    boundary: &Boundary,
    method: &Method,
    functions: &Functions,
    interior: TensorInterior,
    context: &Context<'_>,
) -> Result<Solved, MethodError> {
    let (net, construction) = construct(interior, method.raise(), boundary)?;
    let (shape, search) = match functions {
        Functions::Bernstein => (None, None),
        Functions::Shaped(shape) => (Some(shape.clone()), None),
        Functions::Searched { family, mode, energy } => {
            let outcome = search(&net, method.name(), (*family, *energy), interior, *mode, context)?;
            (Some(FixedShape::new(*family, outcome.shape().to_vec())?), Some(outcome))
        }
    };
    let shape = shape.as_ref();
    let patch = patch_of(net, shape)?;
    let extremal_of = |functional, (patch, figures): (TensorPatch, SolveFigures)| {
        (patch, Interior::Extremal(functional, Some(figures)))
    };
    let (patch, interior) = match interior {
        TensorInterior::Extremal { energy, solver } => {
            extremal_of(energy, extremal::solve(&patch, energy, solver, shape)?)
        }
        TensorInterior::MetricCorrections { steps, solver } => {
            extremal_of(Functional::Dirichlet, extremal::corrected(&patch, steps, solver, shape)?)
        }
        TensorInterior::LeastArea { tolerance, .. } => {
            context.progress.begin(&format!("least area of {}", method.name()), None);
            let found = of_least_area(boundary, method.raise(), &patch, shape, tolerance, context);
            context.progress.end();
            let (patch, found) = found?;
            (patch, Interior::LeastArea(Box::new(found)))
        }
        TensorInterior::Mask { .. } | TensorInterior::DiscreteCoons | TensorInterior::Harmonic => {
            (patch, Interior::Constructed(construction))
        }
    };
    Ok(Solved::tensor(patch, shape, interior).searched(search))
}
