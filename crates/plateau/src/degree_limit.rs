//! Degrees beyond which a method is not offered.

use thiserror::Error;

use crate::{Energy, Interior, Method, Patch, Shape};

/// What is offered to a lower degree than [`MAX_DEGREE`](crate::MAX_DEGREE), because its system is solved in control points: their condition is beyond
/// double precision at the next degrees, whatever the boundary.
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
    /// Searches for the shape that minimises another energy than the extremal does.
    #[error("a shape that minimises another energy than the extremal does is searched to degree {}", self.degree())]
    OtherSearchEnergy,
}

impl DegreeLimit {
    /// The largest degree after `raise`, in the larger direction.
    #[must_use]
    pub fn degree(self) -> usize {
        match self {
            Self::Triangle => 24,
            Self::MetricSteps => 13,
            Self::Harmonic => 20,
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
        match self.interior {
            Interior::Extremal { energy: Energy::Area, .. } => None,
            Interior::Extremal { .. } if self.patch == Patch::Triangle => Some(DegreeLimit::Triangle),
            Interior::Extremal { metric_steps, .. } if metric_steps > 0 => Some(DegreeLimit::MetricSteps),
            Interior::Extremal { energy, .. }
                if matches!(self.shape, Shape::Search(_)) && self.search_energy != energy =>
            {
                Some(DegreeLimit::OtherSearchEnergy)
            }
            Interior::Harmonic => Some(DegreeLimit::Harmonic),
            Interior::Extremal { .. } | Interior::Mask(_) | Interior::DiscreteCoons => None,
        }
    }
}
