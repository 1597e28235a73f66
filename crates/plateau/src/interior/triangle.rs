//! Triangular patches over three boundary polygons (TRI, COONS).

use energy::{DenseForm, MetricForm, ReferenceTriangle};
use solve::{Partition, solve_partitioned};
use surfaces::{TriangleMask, TriangleNet, TrianglePatch, discrete_coons_triangle};

use super::mask;
use crate::{
    AreaExtremal, Energy, Interior, Mask, Method, MethodError, Progress, SolveFigures, Solved, Surface,
    TriangleBoundary, least_area_triangle_raised,
};

/// Runs one method over three sides.
pub(crate) fn solve(
    method: &Method,
    sides: &TriangleBoundary,
    at_hand: &[&Solved],
    progress: &dyn Progress,
) -> Result<(TrianglePatch, Option<SolveFigures>, Option<AreaExtremal>), MethodError> {
    let own = sides.net()?;
    let net = own.raised(method.raise)?;
    let (patch, figures) = match method.interior {
        Interior::Extremal { energy: Energy::Area, .. } => {
            let starts = at_hand_of(&net, at_hand)?;
            progress.begin(&format!("least area of {}", method.name), None);
            let found = least_area_triangle_raised(&own, method.raise, &starts, method.tolerance, progress);
            progress.end();
            let (patch, found) = found?;
            return Ok((patch, None, Some(found)));
        }
        Interior::Extremal { energy, metric_steps } => extremal(net, energy, method.domain, metric_steps)?,
        Interior::Mask(mask) => by_mask(&net, mask)?,
        Interior::DiscreteCoons => {
            let [ab, bc, ca] = net.boundary();
            (TrianglePatch::new(discrete_coons_triangle(&ab, &bc, &ca)?)?, SolveFigures::EXPLICIT)
        }
        Interior::Harmonic => return Err(MethodError::Unavailable { what: "a harmonic triangular net" }),
    };
    Ok((patch, Some(figures), None))
}

/// The patches at hand, raised to the degree of `net`; those of a higher one are left out.
fn at_hand_of(net: &TriangleNet, at_hand: &[&Solved]) -> Result<Vec<TrianglePatch>, MethodError> {
    let mut patches = Vec::new();
    for solved in at_hand {
        if let Surface::Triangle(patch) = &solved.surface
            && let Some(raise) = net.degree().checked_sub(patch.net().degree())
        {
            patches.push(TrianglePatch::new(patch.net().raised(raise)?)?);
        }
    }
    Ok(patches)
}

/// The extremal of a quadratic energy, then the metric correction (TRI Prop. 5): each step the extremal of the Dirichlet
/// energy in the metric of the patch before.
fn extremal(
    net: TriangleNet,
    energy: Energy,
    domain: ReferenceTriangle,
    metric_steps: usize,
) -> Result<(TrianglePatch, SolveFigures), MethodError> {
    let functional = energy.functional().ok_or(MethodError::Unavailable { what: "the area here" })?;
    let (mut patch, mut figures) =
        minimise(&DenseForm::of_triangle_over(domain, functional, net.degree())?, &net)?;
    for _ in 0..metric_steps {
        let metric = MetricForm::of_triangle(&patch, net.degree())?;
        (patch, figures) = minimise(&metric.form, &net)?;
        figures.metric = Some(metric.energy(&patch.net().coordinates()));
    }
    Ok((patch, figures))
}

/// The net of least energy with its fixed points as they are.
fn minimise(form: &DenseForm, net: &TriangleNet) -> Result<(TrianglePatch, SolveFigures), MethodError> {
    let partition = Partition::new(net.fixed());
    let matrix = form.matrix();
    let solution = solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &net.coordinates())
        .map_err(|error| MethodError::of_system(error, net.degree()))?;
    let figures = SolveFigures::dense(matrix, &partition, &solution)?;
    Ok((TrianglePatch::new(net.with_coordinates(&solution.x)?)?, figures))
}

fn by_mask(net: &TriangleNet, mask: Mask) -> Result<(TrianglePatch, SolveFigures), MethodError> {
    let stencil = match mask {
        Mask::Alpha(alpha) => TriangleMask::Symmetric(alpha),
        Mask::Dirichlet => TriangleMask::Dirichlet,
        Mask::Coons => TriangleMask::Coons,
    };
    if stencil.is_singular(net.degree()) {
        return Err(MethodError::SingularMask { degree: net.degree() });
    }
    let solved = mask::solve(&stencil.system(net)?, net.fixed(), &net.coordinates());
    let (coordinates, figures) = match mask {
        Mask::Alpha(alpha) => solved.map_err(|error| error.of_mask(alpha, net.degree()))?,
        Mask::Dirichlet | Mask::Coons => solved?,
    };
    Ok((TrianglePatch::new(net.with_coordinates(&coordinates)?)?, figures))
}
