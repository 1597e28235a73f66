//! The functions of a tensor patch, and their shape.

use surfaces::{Net, ShapedFamily, SurfaceError, TensorPatch};

use super::SearchEnergy;
use crate::{Family, SearchMode};

/// The functions that weigh the control points of a tensor net.
#[derive(Clone, Debug, PartialEq)]
pub enum Functions {
    /// Bernstein polynomials.
    Bernstein,
    /// A family with a given shape.
    Shaped(FixedShape),
    /// A family whose shape is searched.
    Searched {
        /// The family.
        family: ShapedFamily,
        /// How it is searched.
        mode: SearchMode,
        /// What the shape minimises, which need not be the energy of the extremal.
        energy: SearchEnergy,
    },
}

/// A family with a shape that it has.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedShape {
    family: ShapedFamily,
    parameters: Vec<f64>,
}

impl FixedShape {
    /// `family` at a shape, one number for each of its [`parameters`](ShapedFamily::parameters).
    ///
    /// # Errors
    /// [`SurfaceError::ShapeCount`] for another number of them, [`SurfaceError::Basis`] where the family has no such shape.
    pub fn new(family: ShapedFamily, parameters: Vec<f64>) -> Result<Self, SurfaceError> {
        family.coordinates(&parameters)?;
        match family.fault(&parameters) {
            Some((_, error)) => Err(error.into()),
            None => Ok(Self { family, parameters }),
        }
    }

    /// The family.
    #[must_use]
    pub fn family(&self) -> ShapedFamily {
        self.family
    }

    /// The shape parameters, those in u before those in v.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The patch of a net.
    pub(crate) fn patch(&self, net: Net) -> Result<TensorPatch, SurfaceError> {
        self.family.patch(net, &self.parameters)
    }
}

impl Functions {
    /// The family a patch of these functions belongs to.
    #[must_use]
    pub fn family(&self) -> Family {
        match self {
            Self::Bernstein => Family::Bernstein,
            Self::Shaped(shape) => Family::Shaped(shape.family),
            Self::Searched { family, .. } => Family::Shaped(*family),
        }
    }

    /// Whether a patch is a sum of several products of families.
    #[must_use]
    pub fn is_blend(&self) -> bool {
        match self {
            Self::Bernstein => false,
            Self::Shaped(shape) => shape.family.is_blend(),
            Self::Searched { family, .. } => family.is_blend(),
        }
    }

    /// What is searched and what for, if anything is.
    #[must_use]
    pub fn searched(&self) -> Option<(ShapedFamily, SearchMode, SearchEnergy)> {
        match self {
            Self::Bernstein | Self::Shaped(_) => None,
            Self::Searched { family, mode, energy } => Some((*family, *mode, *energy)),
        }
    }
}

/// The patch of a net with the functions of a shape; of Bernstein polynomials where there is none.
pub(crate) fn patch_of(net: Net, shape: Option<&FixedShape>) -> Result<TensorPatch, SurfaceError> {
    match shape {
        Some(shape) => shape.patch(net),
        None => TensorPatch::bernstein(net),
    }
}
