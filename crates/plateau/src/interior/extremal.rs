//! The extremal of a quadratic energy with the boundary net fixed.

use bases::{Basis, Matrix};
use energy::{Functional, MetricForm, QuadraticForm};
use solve::{Partition, Samples, Separable, solve_partitioned};
use surfaces::{Net, Product, TensorPatch};

use super::bubbles;
use crate::{FixedShape, MethodError, SolveFigures, SolverChoice};

/// Degree from which the separable solver is both faster than a dense one and more accurate.
const SEPARABLE_FROM: usize = 7;

/// Whether the automatic choice is the separable solver, where it applies.
pub(crate) fn prefers_separable(net: &Net) -> bool {
    let (m, n) = net.degrees();
    m.max(n) >= SEPARABLE_FROM
}

/// Degree from which extremals are solved for in bubbles: those whose variables separate by then in the families themselves, with
/// twice the digits of a dense system, and the others.
const BUBBLES_FROM: (usize, usize) = (21, 10);

/// Whether the automatic choice is the solver in bubbles.
fn prefers_bubbles(net: &Net, separates: bool) -> bool {
    let (m, n) = net.degrees();
    m.min(n) >= 2 && m.max(n) >= if separates { BUBBLES_FROM.0 } else { BUBBLES_FROM.1 }
}

/// Steps of the metric correction (TRI Prop. 5) from the Dirichlet extremal: each the extremal of the Dirichlet energy in the metric of
/// the patch before.
pub(crate) fn corrected(
    patch: &TensorPatch,
    steps: usize,
    solver: SolverChoice,
    shape: Option<&FixedShape>,
) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let (mut solved, mut figures) = solve(patch, Functional::Dirichlet, solver, shape)?;
    for _ in 0..steps {
        let metric = MetricForm::of_tensor(&solved, &solved)?;
        (solved, figures) = by_matrix(patch, metric.form.matrix())?;
        figures.metric = Some(metric.energy(&solved.net().coordinates()));
    }
    Ok((solved, figures))
}

/// `patch` with its free control points at the extremal of `functional`: `Q_ff p = −Q_fb P_b` for x, y, z; `shape` is that of its functions.
pub(crate) fn solve(
    patch: &TensorPatch,
    functional: Functional,
    solver: SolverChoice,
    shape: Option<&FixedShape>,
) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let net = patch.net();
    let separates = functional == Functional::Dirichlet && patch.products().len() == 1;
    let separated = match solver {
        SolverChoice::Auto => separates && prefers_separable(net),
        SolverChoice::Dense => false,
        SolverChoice::Separable => true,
    };
    if prefers_bubbles(net, separates) && solver != SolverChoice::Dense {
        return bubbles::extremal(patch, functional, shape);
    }
    if let ([product], true) = (patch.products(), separated) {
        return by_separation(patch, product);
    }
    let matrix = QuadraticForm::of(functional, patch)?.matrix();
    by_matrix(patch, &matrix).map_err(|error| {
        let MethodError::Solve(error) = error else { return error };
        if functional == Functional::Dirichlet && patch.products().len() == 1 {
            // The dense solver asked for by name where the separable one would do: its own error says so.
            return error.into();
        }
        let (m, n) = net.degrees();
        MethodError::of_system(error, m.max(n))
    })
}

/// The extremal of the form Q given as a dense matrix over all points.
fn by_matrix(patch: &TensorPatch, matrix: &Matrix) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let net = patch.net();
    let partition = Partition::new(net.fixed());
    let solution = solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &net.coordinates())?;
    let figures = SolveFigures::dense(matrix, &partition, &solution)?;
    Ok((patch.with_net(net.with_coordinates(&solution.x)?)?, figures))
}

/// The Dirichlet extremal of one product of families, both directions diagonalised.
fn by_separation(patch: &TensorPatch, product: &Product) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let net = patch.net();
    let (m, n) = net.degrees();
    let interior = |degree: usize| (1..degree).collect::<Vec<_>>();
    let (u, v) = (samples(product.u.as_ref())?, samples(product.v.as_ref())?);
    let solution = Separable::new(&u, &v, &interior(m), &interior(n))?.solve(&net.coordinates())?;
    let figures = SolveFigures {
        solver: "separable",
        residual: solution.residual,
        condition: solution.condition,
        basis_condition: Some(solution.basis_condition),
        certified: None,
        left_out: None,
        metric: None,
    };
    Ok((patch.with_net(net.with_coordinates(&solution.x)?)?, figures))
}

fn samples(basis: &dyn Basis) -> Result<Samples, MethodError> {
    let functions = basis.count();
    let samples = bases::Samples::new(basis, bases::Samples::points_for(functions), 1)?;
    Ok(Samples {
        points: samples.nodes().len(),
        functions,
        weights: samples.weights().to_vec(),
        values: samples.order(0).as_slice().to_vec(),
        derivatives: samples.order(1).as_slice().to_vec(),
    })
}
