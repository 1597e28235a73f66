//! The reduced energy J(α) = min over the free points, as the swarm and the polish ask for it.

use bases::{Basis, GtParts};
use energy::ShapedPatch;
use optim::{Objective, Smooth};
use solve::{AffineSamples, Path, SeparableParametric};
use surfaces::Net;

use super::composed::Composed;
use super::least_area::LeastArea;
use super::minima::Minima;
use super::reduced_energy::ReducedEnergy;
use crate::interior::extremal::prefers_separable;
use crate::{Arithmetic, Energy, Method, MethodError, Patch, Progress, SolverChoice};

/// J of a method over a net; the gradient comes with the solve, by the envelope theorem.
pub(super) enum Reduced<'a> {
    /// Polynomials of the shape, contracted with the boundary once: for small nets, any quadratic energy, any blend.
    Parametric(Box<ReducedEnergy>),
    /// Samples of the functions, orthonormalised at every shape: for large nets, where Gram matrices lose digits.
    Separable(Box<SeparableParametric>),
    /// The extremal itself at every shape: for large nets, any quadratic energy, any blend.
    Minima(Box<Minima>),
    /// The least area over the border: a minimisation at every shape.
    Area(Box<LeastArea<'a>>),
    /// Another energy than the one whose extremal is taken.
    Composed(Box<Composed<'a>>),
}

/// Largest degree at which samples made orthonormal keep the digits of J.
const SEPARABLE_TO: usize = 20;

/// Largest degree at which Gram matrices do.
const PARAMETRIC_TO: usize = 12;

impl<'a> Reduced<'a> {
    pub(super) fn new(
        net: &Net,
        method: &Method,
        arithmetic: Arithmetic,
        progress: &'a dyn Progress,
    ) -> Result<Self, MethodError> {
        if let Some(energy) = method.extremal_energy().filter(|&energy| energy != method.search_energy) {
            let (inner, outer) = (energy.functional(), method.search_energy.functional());
            return Ok(Self::Composed(Box::new(Composed::new(net, method, inner, outer, progress)?)));
        }
        let Some(energy) = method.search_energy.functional() else {
            return Ok(Self::Area(Box::new(LeastArea::new(net, method, progress)?)));
        };
        let (m, n) = net.degrees();
        let solved_for = net.fixed().contains(&false);
        let interior = |degree: usize| if solved_for { (1..degree).collect() } else { Vec::new() };
        let splits = method.search_energy == Energy::Dirichlet && method.patch == Patch::Tensor && solved_for;
        let separable = match method.solver {
            SolverChoice::Separable => splits,
            SolverChoice::Auto => splits && prefers_separable(net),
            SolverChoice::Dense | SolverChoice::Sparse => false,
        };
        let is_large = if separable { SEPARABLE_TO } else { PARAMETRIC_TO } < m.max(n);
        if solved_for && is_large && m.min(n) >= 2 {
            return Ok(Self::Minima(Box::new(Minima::new(net, method, energy)?)));
        }
        if separable {
            let (u, v) = (affine_samples(m)?, affine_samples(n)?);
            let system = SeparableParametric::new(u, v, &interior(m), &interior(n), &net.coordinates())?;
            return Ok(Self::Separable(Box::new(system)));
        }
        let kind = if method.patch == Patch::TbCoons { ShapedPatch::TbCoons } else { ShapedPatch::Gt };
        let reduced = ReducedEnergy::new(energy, kind, net)?;
        Ok(Self::Parametric(Box::new(match arithmetic {
            Arithmetic::Auto => reduced,
            Arithmetic::Portable => reduced.with_path(Path::Portable)?,
            Arithmetic::Fma => reduced.with_path(Path::Fma)?,
        })))
    }

    /// How J is evaluated, by name.
    pub(super) fn engine(&self) -> &'static str {
        match self {
            Self::Parametric(_) => "parametric",
            Self::Separable(_) => "separable",
            Self::Minima(_) => "conjugate-gradients",
            Self::Area(_) => "newton",
            Self::Composed(_) => "composed",
        }
    }

    /// The arithmetic it is evaluated in, by name.
    pub(super) fn arithmetic(&self) -> &'static str {
        match self {
            Self::Parametric(parametric) => match parametric.path() {
                Path::Fma => "fma",
                Path::Portable => "portable",
            },
            Self::Separable(_) | Self::Minima(_) | Self::Area(_) | Self::Composed(_) => "native",
        }
    }
}

/// The GT functions of one degree and their derivatives, split into the parts affine in the shape.
fn affine_samples(degree: usize) -> Result<AffineSamples, MethodError> {
    let (parts, functions) = (GtParts::new(degree)?, degree + 1);
    let samples = bases::Samples::new(&parts, bases::Samples::points_for(functions), 1)?;
    let points = samples.nodes().len();
    debug_assert_eq!(parts.count(), 3 * functions);
    let split = |order: usize| {
        std::array::from_fn(|part| {
            let row = |p: usize| samples.order(order).row(p)[part * functions..][..functions].iter().copied();
            (0..points).flat_map(row).collect()
        })
    };
    Ok(AffineSamples {
        points,
        functions,
        weights: samples.weights().to_vec(),
        values: split(0),
        derivatives: split(1),
    })
}

impl Objective for Reduced<'_> {
    fn dimension(&self) -> usize {
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        match self {
            Self::Parametric(reduced) => reduced.evaluate(points, values),
            Self::Separable(system) => {
                // A call that fails as a whole is an evaluation that failed at every point: it is counted and loses.
                if system.values(points, values).is_err() {
                    values.fill(f64::NAN);
                }
            }
            Self::Minima(minima) => minima.evaluate(points, values),
            Self::Area(least) => least.evaluate(points, values),
            Self::Composed(composed) => composed.evaluate(points, values),
        }
    }
}

impl Smooth for Reduced<'_> {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        match self {
            Self::Parametric(reduced) => reduced.value_and_gradient(point, gradient),
            Self::Separable(system) => {
                let (shape, mut by_shape) = (std::array::from_fn(|k| point[k]), [0.0; 4]);
                let value = system.value_and_gradient(&shape, &mut by_shape);
                gradient.copy_from_slice(&by_shape);
                value
            }
            Self::Minima(minima) => minima.value_and_gradient(point, gradient),
            Self::Area(least) => least.value_and_gradient(point, gradient),
            Self::Composed(composed) => composed.value_and_gradient(point, gradient),
        }
    }
}
