//! The reduced energy J(α) = min over the free points, as the swarm and the polish ask for it.

use energy::Functional;
use optim::{Objective, Smooth};
use solve::{AffineSamples, Path, SeparableParametric};
use surfaces::{Net, ShapeFactor, ShapedFamily};

use super::at_shapes::AtShapes;
use super::composed::{Composed, Inner, form};
use super::least_area::LeastArea;
use super::minima::Minima;
use super::reduced_energy::ReducedEnergy;
use crate::interior::extremal::prefers_separable;
use crate::{Arithmetic, Energy, MethodError, Progress, SearchEnergy, SolverChoice, TensorInterior};

/// J of a method over a net; the gradient comes with the solve, by the envelope theorem.
pub(super) enum Reduced<'a> {
    /// Polynomials of the shape, contracted with the boundary once: for small nets, any quadratic energy, any blend.
    Parametric(Box<ReducedEnergy>),
    /// Samples of the functions, orthonormalised at every shape: for large nets, where Gram matrices lose digits.
    Separable(Box<AtShapes<SeparableParametric>>),
    /// The extremal itself at every shape: for large nets, any quadratic energy, any blend.
    Minima(Box<Minima>),
    /// The least area over the border: a minimisation at every shape.
    Area(Box<LeastArea<'a>>),
    /// Another energy than the one whose extremal is taken.
    Composed(Box<Composed<'a>>),
}

/// The tolerance of a least area that no method has set.
const TOLERANCE: f64 = 1e-10;

/// Largest degree at which samples made orthonormal keep the digits of J.
const SEPARABLE_TO: usize = 20;

/// Largest degree at which Gram matrices do.
const PARAMETRIC_TO: usize = 12;

impl<'a> Reduced<'a> {
    pub(super) fn new(
        net: &Net,
        (family, energy): (ShapedFamily, SearchEnergy),
        interior: TensorInterior,
        arithmetic: Arithmetic,
        progress: &'a dyn Progress,
    ) -> Result<Self, MethodError> {
        let area = |tolerance| LeastArea::new(net, family, tolerance, progress);
        let composed = |inner| Ok(Self::Composed(Box::new(Composed::new(net, family, inner, energy)?)));
        match interior {
            TensorInterior::LeastArea { tolerance, .. } if energy == Energy::Area.into() => {
                return Ok(Self::Area(Box::new(area(tolerance))));
            }
            TensorInterior::LeastArea { tolerance, .. } => return composed(Inner::Area(area(tolerance))),
            TensorInterior::Extremal { energy: inner, .. } if energy != Energy::Quadratic(inner).into() => {
                return composed(Inner::Quadratic(form(inner, family, net)?));
            }
            TensorInterior::MetricCorrections { .. } if energy != Energy::DIRICHLET.into() => {
                return composed(Inner::Quadratic(form(Functional::Dirichlet, family, net)?));
            }
            TensorInterior::Extremal { .. }
            | TensorInterior::MetricCorrections { .. }
            | TensorInterior::Mask { .. }
            | TensorInterior::DiscreteCoons
            | TensorInterior::Harmonic => {}
        }
        match energy {
            SearchEnergy::Energy(Energy::Area) => Ok(Self::Area(Box::new(area(TOLERANCE)))),
            SearchEnergy::Energy(Energy::Quadratic(functional)) => {
                Self::quadratic(net, family, functional, interior.solver(), arithmetic)
            }
            // Here all points are given: any form would do.
            SearchEnergy::Conformality => {
                composed(Inner::Quadratic(form(Functional::Dirichlet, family, net)?))
            }
        }
    }

    /// J of a quadratic energy, minimised over the free points if there are any.
    fn quadratic(
        net: &Net,
        family: ShapedFamily,
        functional: Functional,
        solver: SolverChoice,
        arithmetic: Arithmetic,
    ) -> Result<Self, MethodError> {
        let (m, n) = net.degrees();
        let solved_for = net.fixed().contains(&false);
        let splits = functional == Functional::Dirichlet && !family.is_blend() && solved_for;
        let separable = match solver {
            SolverChoice::Separable => splits,
            SolverChoice::Auto => splits && prefers_separable(net),
            SolverChoice::Dense => false,
        };
        let is_large = if separable { SEPARABLE_TO } else { PARAMETRIC_TO } < m.max(n);
        if solved_for && is_large && m.min(n) >= 2 {
            return Ok(Self::Minima(Box::new(Minima::new(net, family, functional))));
        }
        if let ([[u, v]], true) = (family.factors((m, n))?.as_slice(), separable) {
            let (u, v) = (affine_samples(u, m)?, affine_samples(v, n)?);
            let interior = |degree: usize| (1..degree).collect::<Vec<_>>();
            let minimum = SeparableParametric::new(u, v, &interior(m), &interior(n), &net.coordinates())?;
            return Ok(Self::Separable(Box::new(AtShapes { minimum, family })));
        }
        let reduced = ReducedEnergy::new(functional, family, net)?;
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

/// The functions of one degree and their derivatives, split into the parts affine in the shape.
fn affine_samples(factor: &ShapeFactor, degree: usize) -> Result<AffineSamples, MethodError> {
    let (parts, functions) = (factor.affine()?, degree + 1);
    let samples = bases::Samples::new(parts.as_ref(), bases::Samples::points_for(functions), 1)?;
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

impl Reduced<'_> {
    /// The objective as such.
    fn objective(&self) -> &dyn Objective {
        match self {
            Self::Parametric(reduced) => reduced.as_ref(),
            Self::Separable(system) => system.as_ref(),
            Self::Minima(minima) => minima.as_ref(),
            Self::Area(least) => least.as_ref(),
            Self::Composed(composed) => composed.as_ref(),
        }
    }

    /// The objective with its gradient.
    fn smooth(&self) -> &dyn Smooth {
        match self {
            Self::Parametric(reduced) => reduced.as_ref(),
            Self::Separable(system) => system.as_ref(),
            Self::Minima(minima) => minima.as_ref(),
            Self::Area(least) => least.as_ref(),
            Self::Composed(composed) => composed.as_ref(),
        }
    }
}

impl Objective for Reduced<'_> {
    fn dimension(&self) -> usize {
        self.objective().dimension()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        self.objective().evaluate(points, values);
    }
}

impl Smooth for Reduced<'_> {
    fn dimension(&self) -> usize {
        self.smooth().dimension()
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        self.smooth().value_and_gradient(point, gradient)
    }
}
