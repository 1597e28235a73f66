//! Degrees beyond which a method is not offered.

use thiserror::Error;

use crate::{Energy, Filling, Functions, MAX_DEGREE, Method, SearchEnergy, TensorInterior, TriangleInterior};

/// What is offered to a lower degree than [`MAX_DEGREE`](crate::MAX_DEGREE). Where its system is solved in control points, their condition is beyond
/// double precision at the next degrees, whatever the boundary; least areas would besides take minutes and gigabytes to say so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum DegreeLimit {
    /// Extremals of quadratic energies over a triangle.
    #[error("extremals over triangles are offered to degree {}", self.degree())]
    Triangle,
    /// Metric corrections on tensor nets.
    #[error("metric corrections of tensor nets are offered to degree {}", self.degree())]
    MetricSteps,
    /// Harmonic nets, found by singular values of all relations: O(degree⁶).
    #[error("harmonic nets are offered to degree {}", self.degree())]
    Harmonic,
    /// Least areas of patches with shapes: at degree 32 the rounding of control points may be seen in the seventh digit of the area, at 40
    /// nothing else.
    #[error("least areas of patches with shapes are offered to degree {}: beyond, their control points are so large that rounding alone moves the surface", self.degree())]
    LeastArea,
    /// Least areas of blends, whose functions are sampled all together: beyond, they take minutes and gigabytes.
    #[error("least areas of TB–Coons patches are offered to degree {}: beyond, they take minutes and gigabytes", self.degree())]
    BlendLeastArea,
    /// Discrete Coons nets over triangles, which have one degree more than their sides.
    #[error("discrete Coons nets over triangles, which have one degree more than their sides, are offered to degree {}", self.degree())]
    TriangularCoons,
    /// Least areas of several patches.
    #[error("surfaces of several patches are offered to degree {}", self.degree())]
    Patches,
    /// Least areas over a triangle, whose tables of all basis functions at all points grow with the fourth power of the degree.
    #[error("least areas over triangles are offered to degree {}", self.degree())]
    TriangularLeastArea,
    /// Searches for the shape that minimises another energy than the extremal does.
    #[error("a shape that minimises another energy than the extremal does is searched to degree {}", self.degree())]
    OtherSearchEnergy,
}

impl DegreeLimit {
    /// The highest degree of two rows whose harmonic nets rounding tells apart.
    pub(crate) const HARMONIC_ROWS: usize = 14;

    /// The least degree across two rows of degree `along` whose harmonic net they determine, whatever their points: every higher one does, too.
    pub(crate) const fn across_harmonic_rows(along: usize) -> usize {
        if along.is_multiple_of(2) { along + 1 } else { along }
    }

    /// The largest degree after `raise`, in the larger direction.
    #[must_use]
    pub const fn degree(self) -> usize {
        match self {
            Self::Triangle | Self::Patches => 24,
            Self::MetricSteps => 13,
            Self::Harmonic => 20,
            Self::LeastArea => 32,
            Self::BlendLeastArea => 12,
            Self::TriangularCoons => MAX_DEGREE - 1,
            Self::TriangularLeastArea => 18,
            Self::OtherSearchEnergy => 16,
        }
    }

    /// Refuses boundaries of these degrees once raised, if they are too high: the limit itself is what is wrong.
    pub(crate) fn admits(self, (m, n): (usize, usize), raise: usize) -> Result<(), Self> {
        if m.max(n) + raise <= self.degree() { Ok(()) } else { Err(self) }
    }
}

impl Method {
    /// What limits the degree of this method; none if it is offered to [`MAX_DEGREE`](crate::MAX_DEGREE).
    #[must_use]
    pub fn degree_limit(&self) -> Option<DegreeLimit> {
        match self.filling() {
            Filling::Triangle(TriangleInterior::LeastArea { .. }) => Some(DegreeLimit::TriangularLeastArea),
            Filling::Triangle(
                TriangleInterior::Extremal { .. } | TriangleInterior::MetricCorrections { .. },
            ) => Some(DegreeLimit::Triangle),
            Filling::Triangle(TriangleInterior::DiscreteCoons) => Some(DegreeLimit::TriangularCoons),
            Filling::Triangle(TriangleInterior::Mask(_)) => None,
            Filling::Tensor { functions, interior } => limit_of_tensor(functions, *interior),
        }
    }
}

fn limit_of_tensor(functions: &Functions, interior: TensorInterior) -> Option<DegreeLimit> {
    let sought = functions.searched().map(|(_, _, sought)| sought);
    match interior {
        TensorInterior::LeastArea { layers: 1.., .. } => Some(DegreeLimit::Patches),
        // Polynomials are sought by displacements of lower degree.
        TensorInterior::LeastArea { .. } => match functions {
            Functions::Bernstein => None,
            Functions::Shaped(_) | Functions::Searched { .. } if functions.is_blend() => {
                Some(DegreeLimit::BlendLeastArea)
            }
            Functions::Shaped(_) | Functions::Searched { .. } => Some(DegreeLimit::LeastArea),
        },
        TensorInterior::MetricCorrections { .. } => Some(DegreeLimit::MetricSteps),
        TensorInterior::Harmonic => Some(DegreeLimit::Harmonic),
        TensorInterior::Extremal { energy, .. } => {
            let own = SearchEnergy::Energy(Energy::Quadratic(energy));
            sought.is_some_and(|sought| sought != own).then_some(DegreeLimit::OtherSearchEnergy)
        }
        TensorInterior::Mask { .. } | TensorInterior::DiscreteCoons => {
            (sought == Some(SearchEnergy::Conformality)).then_some(DegreeLimit::OtherSearchEnergy)
        }
    }
}
