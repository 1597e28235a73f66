//! Runs one method.

use surfaces::TensorPatch;

use crate::excess::estimated;
use crate::interior::{boundary_net, construct, extremal, triangle, with_shape};
use crate::search::search;
use crate::{
    AreaExtremal, Basis, Boundary, BoundaryFigures, Context, Done, Energy, Family, Figures, Method,
    MethodError, Patch, Shape, Solved, Surface, Warning, least_area_from, least_area_raised,
    lower_bound_of_net, memory, trust,
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
        limit.admits(boundary.degrees(), method.raise)?;
    }
    memory::holds(memory::of_method(method, boundary.degrees()))?;
    let given = boundary;
    let (boundary, origin) = boundary.anchored();
    let near = |solved: &&Solved| {
        Ok(Solved { surface: solved.surface.clone().moved(-origin)?, ..(*solved).clone() })
    };
    let at_hand = context.at_hand.iter().map(near).collect::<Result<Vec<Solved>, MethodError>>()?;
    let at_hand: Vec<&Solved> = at_hand.iter().collect();
    let mut solved = solved(&boundary, method, &Context { at_hand: &at_hand, ..*context })?;
    let cancellation = solved.surface.cancellation();
    if cancellation > WORST_CANCELLATION {
        return Err(MethodError::Cancellation { degrees: solved.surface.degrees(), share: cancellation });
    }
    let mut mesh = solved.surface.mesh(context.mesh)?;
    context.progress.begin(&format!("figures of {}", method.name), None);
    let figures = figures(&solved, &mesh, origin);
    context.progress.end();
    let figures = figures?;
    let boundary = match &solved.surface {
        Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
        Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_) => None,
    };
    let mut warnings = trust::warnings(&solved, &figures, &context.search);
    let estimate =
        estimated((&solved.surface, solved.family, solved.area.as_ref()), &mut warnings, context.progress)?;
    solved.surface = solved.surface.moved(origin)?;
    mesh.points.iter_mut().for_each(|p| *p += origin);
    let bound = match &solved.surface {
        Surface::Tensor(patch) if method.bound => {
            let bound = lower_bound_of_net(&boundary_net(given)?, patch.net());
            bound.map_err(|why| warnings.push(Warning::NoBound(why))).ok()
        }
        Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_) => None,
    };
    Ok(Done { solved, mesh, figures, boundary, closed_form: None, film: None, estimate, bound, warnings })
}

/// The figures of a patch that lies `origin` away from where its boundary was given; of what was minimised, whatever it was.
fn figures(solved: &Solved, mesh: &surfaces::Mesh, origin: surfaces::Point) -> Result<Figures, MethodError> {
    let patches: Vec<&dyn surfaces::Patch> = solved.surface.patch().into_iter().collect();
    let mut figures = Figures::of_moved(&patches, mesh, origin.norm())?;
    if solved.minimised == Some(Energy::Coons) {
        figures.coons_functional = Some(figures.coons_functional(&patches)?);
    }
    Ok(figures)
}

/// The patch of least area on the border of `patch`, not above those at hand.
fn of_least_area(
    boundary: &Boundary,
    method: &Method,
    patch: &TensorPatch,
    shape: Option<[f64; 4]>,
    context: &Context<'_>,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    let family = family(method);
    let (m, n) = patch.net().degrees();
    let mut starts = Vec::new();
    for solved in context.at_hand {
        let Surface::Tensor(other) = &solved.surface else { continue };
        let (k, l) = other.net().degrees();
        if solved.family != family || solved.shape != shape || k > m || n.checked_sub(l) != Some(m - k) {
            continue;
        }
        match family {
            Family::Bernstein => starts.push(TensorPatch::bernstein(other.net().raised(m - k))?),
            Family::Gt | Family::TbCoons if k == m => starts.push(patch.with_net(other.net().clone())?),
            Family::Gt | Family::TbCoons | Family::Triangle | Family::Aht | Family::At | Family::Complex => {}
        }
    }
    let (tolerance, progress) = (method.tolerance, context.progress);
    match family {
        Family::Bernstein => {
            let net = boundary_net(boundary)?;
            least_area_raised(&net, method.raise, &starts, tolerance, progress)
        }
        Family::Gt | Family::TbCoons | Family::Triangle | Family::Aht | Family::At | Family::Complex => {
            least_area_from(patch, &starts, tolerance, progress)
        }
    }
}

/// The functions a method makes its tensor patch of.
fn family(method: &Method) -> Family {
    match (method.patch, method.basis) {
        (Patch::TbCoons, _) => Family::TbCoons,
        (Patch::Tensor | Patch::Triangle, Basis::Gt) => Family::Gt,
        (Patch::Tensor | Patch::Triangle, Basis::Bernstein) => Family::Bernstein,
    }
}

/// The patch of a method.
fn solved(boundary: &Boundary, method: &Method, context: &Context<'_>) -> Result<Solved, MethodError> {
    let minimised = method.extremal_energy();
    if let Boundary::Triangle(sides) = boundary {
        let (patch, solve, area) = triangle::solve(method, sides, context.at_hand, context.progress)?;
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
            let found = of_least_area(boundary, method, &patch, shape, context);
            context.progress.end();
            let (patch, found) = found?;
            (patch, None, Some(found))
        }
        None => {
            let (patch, figures) = extremal::solve(&patch, method, shape)?;
            (patch, Some(figures), None)
        }
    };
    let family = family(method);
    Ok(Solved { surface: Surface::Tensor(patch), family, minimised, shape, solve, area, search })
}
