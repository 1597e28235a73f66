//! Triangular patches over three boundary polygons (TRI, COONS).

use energy::{DenseForm, Functional, MetricForm, ReferenceTriangle};
use solve::{Partition, solve_partitioned};
use surfaces::{TriangleMask, TriangleNet, TrianglePatch, discrete_coons_triangle};

use crate::{
    Interior, Method, MethodError, Progress, SolveFigures, Solved, Surface, TriangleBoundary,
    TriangleInterior, least_area_triangle_raised,
};

/// Runs one method over three sides.
pub(crate) fn solve(
    method: &Method,
    interior: TriangleInterior,
    sides: &TriangleBoundary,
    at_hand: &[&Solved],
    progress: &dyn Progress,
) -> Result<Solved, MethodError> {
    let own = sides.net()?;
    let net = own.raised(method.raise())?;
    let extremal = |functional, domain, steps| -> Result<Solved, MethodError> {
        let (patch, figures) = extremal(net.clone(), functional, domain, steps)?;
        Ok(Solved::triangle(patch, Interior::Extremal(functional, Some(figures))))
    };
    let constructed = |patch, figures| Solved::triangle(patch, Interior::Constructed(Some(figures)));
    match interior {
        TriangleInterior::LeastArea { tolerance } => {
            let starts = at_hand_of(&net, at_hand)?;
            progress.begin(&format!("least area of {}", method.name()), None);
            let found = least_area_triangle_raised(&own, method.raise(), &starts, tolerance, progress);
            progress.end();
            let (patch, found) = found?;
            Ok(Solved::triangle(patch, Interior::LeastArea(Box::new(found))))
        }
        TriangleInterior::Extremal { energy, domain } => extremal(energy, domain, 0),
        TriangleInterior::MetricCorrections { steps, domain } => {
            extremal(Functional::Dirichlet, domain, steps)
        }
        TriangleInterior::Mask(mask) => {
            by_mask(&net, mask).map(|(patch, figures)| constructed(patch, figures))
        }
        TriangleInterior::DiscreteCoons => {
            let [ab, bc, ca] = net.boundary();
            let patch = TrianglePatch::new(discrete_coons_triangle(&ab, &bc, &ca)?)?;
            Ok(constructed(patch, SolveFigures::EXPLICIT))
        }
    }
}

/// The patches at hand, raised to the degree of `net`; those of a higher one are left out.
fn at_hand_of(net: &TriangleNet, at_hand: &[&Solved]) -> Result<Vec<TrianglePatch>, MethodError> {
    let mut patches = Vec::new();
    for solved in at_hand {
        if let Surface::Triangle(patch) = solved.surface()
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
    functional: Functional,
    domain: ReferenceTriangle,
    metric_steps: usize,
) -> Result<(TrianglePatch, SolveFigures), MethodError> {
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

fn by_mask(net: &TriangleNet, mask: TriangleMask) -> Result<(TrianglePatch, SolveFigures), MethodError> {
    if mask.is_singular(net.degree()) {
        return Err(MethodError::SingularMask { degree: net.degree() });
    }
    let solved = super::mask::solve(&mask.system(net)?, net.fixed(), &net.coordinates());
    let (coordinates, figures) = match mask {
        TriangleMask::Symmetric(alpha) => solved.map_err(|error| error.of_mask(alpha, net.degree()))?,
        TriangleMask::Dirichlet | TriangleMask::Coons => solved?,
    };
    Ok((TrianglePatch::new(net.with_coordinates(&coordinates)?)?, figures))
}
