//! Methods: ways to fill a boundary.

mod energy;
mod fault;
mod functions;
mod interior;

pub use energy::{Energy, SearchEnergy};
pub use fault::{MethodFault, TOLERANCES};
pub(crate) use functions::patch_of;
pub use functions::{FixedShape, Functions};
pub use interior::{MAX_METRIC_STEPS, SolverChoice, TensorInterior, TriangleInterior};

use ::energy::Functional;
use surfaces::TriangleMask;

use crate::{Family, MAX_DEGREE, SearchMode};

/// One way to fill a boundary: one row of the table. A method that exists is sound; over a boundary of another kind [`solve`](crate::solve())
/// says so.
///
/// ```
/// use plateau::{Functions, Method, TensorInterior};
///
/// let method = Method::tensor("Least area", Functions::Bernstein, TensorInterior::LeastArea { tolerance: 1e-10, bound: false, layers: 0 })?;
/// assert_eq!(method.raised(3)?.raise(), 3);
/// # Ok::<(), plateau::MethodFault>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    name: String,
    filling: Filling,
    raise: usize,
}

/// What a method fills, and how.
#[derive(Clone, Debug, PartialEq)]
pub enum Filling {
    /// Four sides, or for a harmonic interior two opposite ones, by a tensor patch.
    Tensor {
        /// The functions of the patch.
        functions: Functions,
        /// How its interior is found.
        interior: TensorInterior,
    },
    /// Three sides, by a triangular patch.
    Triangle(TriangleInterior),
}

fn admits_tolerance(tolerance: f64) -> Result<(), MethodFault> {
    if TOLERANCES.contains(&tolerance) { Ok(()) } else { Err(MethodFault::Tolerance { found: tolerance }) }
}

fn admits_steps(steps: usize) -> Result<(), MethodFault> {
    if (1..=MAX_METRIC_STEPS).contains(&steps) { Ok(()) } else { Err(MethodFault::MetricSteps(steps)) }
}

fn admits_weight(alpha: f64) -> Result<(), MethodFault> {
    if alpha.is_finite() { Ok(()) } else { Err(MethodFault::MaskWeight(alpha)) }
}

impl Method {
    /// A method for four sides, or for two opposite ones if the interior is harmonic.
    ///
    /// # Errors
    /// [`MethodFault`] says what of functions and interior does not fit.
    pub fn tensor(
        name: impl Into<String>,
        functions: Functions,
        interior: TensorInterior,
    ) -> Result<Self, MethodFault> {
        match interior {
            TensorInterior::Extremal { energy: Functional::Dirichlet, solver: SolverChoice::Separable }
            | TensorInterior::MetricCorrections { solver: SolverChoice::Separable, .. }
                if functions.is_blend() =>
            {
                return Err(MethodFault::NotSeparable);
            }
            TensorInterior::Extremal { energy, solver: SolverChoice::Separable }
                if energy != Functional::Dirichlet =>
            {
                return Err(MethodFault::NotSeparable);
            }
            TensorInterior::MetricCorrections { steps, .. } => admits_steps(steps)?,
            TensorInterior::LeastArea { tolerance, bound, layers } => {
                admits_tolerance(tolerance)?;
                if bound && functions != Functions::Bernstein {
                    return Err(MethodFault::Bound);
                }
                if layers > 0 && functions != Functions::Bernstein {
                    return Err(MethodFault::Layers);
                }
            }
            TensorInterior::Mask { alpha } => admits_weight(alpha)?,
            TensorInterior::Harmonic if functions.is_blend() => return Err(MethodFault::HarmonicBlend),
            TensorInterior::Extremal { .. } | TensorInterior::DiscreteCoons | TensorInterior::Harmonic => {}
        }
        Self::named(name.into(), Filling::Tensor { functions, interior })
    }

    /// A method for three sides.
    ///
    /// # Errors
    /// [`MethodFault`] for numbers out of range.
    pub fn triangle(name: impl Into<String>, interior: TriangleInterior) -> Result<Self, MethodFault> {
        match interior {
            TriangleInterior::MetricCorrections { steps, .. } => admits_steps(steps)?,
            TriangleInterior::LeastArea { tolerance } => admits_tolerance(tolerance)?,
            TriangleInterior::Mask(TriangleMask::Symmetric(alpha)) => admits_weight(alpha)?,
            TriangleInterior::Extremal { .. }
            | TriangleInterior::Mask(TriangleMask::Dirichlet | TriangleMask::Coons)
            | TriangleInterior::DiscreteCoons => {}
        }
        Self::named(name.into(), Filling::Triangle(interior))
    }

    fn named(name: String, filling: Filling) -> Result<Self, MethodFault> {
        if name.is_empty() {
            return Err(MethodFault::NoName);
        }
        Ok(Self { name, filling, raise: 0 })
    }

    /// The same after the boundary's degree is raised by `raise`, exactly for polynomials.
    ///
    /// # Errors
    /// [`MethodFault::Raised`] beyond [`MAX_DEGREE`], [`MethodFault::HarmonicRaised`] for a harmonic net.
    pub fn raised(self, raise: usize) -> Result<Self, MethodFault> {
        if raise > MAX_DEGREE {
            return Err(MethodFault::Raised(raise));
        }
        if raise > 0 && matches!(self.filling, Filling::Tensor { interior: TensorInterior::Harmonic, .. }) {
            return Err(MethodFault::HarmonicRaised);
        }
        Ok(Self { raise, ..self })
    }

    /// The same with its shape searched in this way; itself where nothing is searched.
    #[must_use]
    pub fn searched_by(mut self, by: SearchMode) -> Self {
        if let Filling::Tensor { functions: Functions::Searched { mode, .. }, .. } = &mut self.filling {
            *mode = by;
        }
        self
    }

    /// How its shape is searched, if it is.
    #[must_use]
    pub fn search_mode(&self) -> Option<SearchMode> {
        match &self.filling {
            Filling::Tensor { functions, .. } => functions.searched().map(|(_, mode, _)| mode),
            Filling::Triangle(_) => None,
        }
    }

    /// The label of its row of the table.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What is filled, and how.
    #[must_use]
    pub fn filling(&self) -> &Filling {
        &self.filling
    }

    /// By how many degrees the boundary is raised before solving.
    #[must_use]
    pub fn raise(&self) -> usize {
        self.raise
    }

    /// The energy whose extremal the interior is; none for constructions.
    #[must_use]
    pub fn minimised(&self) -> Option<Energy> {
        match &self.filling {
            Filling::Tensor { interior, .. } => interior.minimised(),
            Filling::Triangle(interior) => interior.minimised(),
        }
    }

    /// The family its patch belongs to.
    #[must_use]
    pub fn family(&self) -> Family {
        match &self.filling {
            Filling::Tensor { interior: TensorInterior::LeastArea { layers: 1.., .. }, .. } => {
                Family::Complex
            }
            Filling::Tensor { functions, .. } => functions.family(),
            Filling::Triangle(_) => Family::Triangle,
        }
    }
}
