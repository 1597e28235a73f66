//! What is known of a surface of least area.

use std::fmt;

use energy::Integral;

use super::Mode;
use super::displacement::Displacement;

/// What is known of a net of least area.
#[derive(Debug, Clone, PartialEq)]
pub struct AreaExtremal {
    /// The area, with the error the rule was found to make (unit: length²).
    pub area: Integral,
    /// The area of the surface it was reached from.
    pub start: f64,
    /// What that surface was.
    pub from: Start,
    /// Metric corrections: each the extremal of the Dirichlet energy in the metric of the surface before.
    pub corrections: Stage,
    /// Newton steps in all coordinates.
    pub steps: Stage,
    /// Newton steps along the normals.
    pub normal_steps: Stage,
    /// The norm of the gradient of the area over √area, in displacements along the normals at the nodes whose Dirichlet norm
    /// over the surface is 1; dimensionless. Rounding is of the order of 1e-14. Not a number where the metric of the surface is
    /// singular to working precision.
    pub gradient: f64,
    /// The same over all displacements. What it has more belongs to the parametrisation: moving points along the surface
    /// hardly changes the area.
    pub whole_gradient: f64,
    /// Points at which a Hessian or a metric was formed, over all starts.
    pub iterations: usize,
    /// Of these, those at the degree of the surface: the others led to the surfaces of lower degrees that it was reached from.
    pub last_iterations: usize,
    /// Evaluations of the area, over all starts.
    pub evaluations: usize,
    /// Why it ended.
    pub end: AreaEnd,
    /// What kept the steps in all coordinates from going on.
    pub valley: ValleyEnd,
    /// The least over the mean of `|x_u × x_v|` at the points of the rule; 0 where the parametrisation folds or is singular.
    pub jacobian_ratio: f64,
    /// The smallest value of `∫ (|∇f|² + 2 K f²) dA / ∫ |∇f|² dA` over displacements f N along the unit normal, f one of the
    /// functions of the net that vanish on the border: the second variation of the area. Dimensionless, at most 1 where
    /// K ≤ 0; positive for a stable minimum, negative for a saddle. An upper bound of its value over all f. Lines where three or
    /// more patches meet are held. None if no point is free, where the surface is singular or nearly, or one-sided.
    pub second_variation: Option<f64>,
    /// The displacement that has it: how the surface gives way most easily.
    pub mode: Option<Mode>,
    /// Whether a saddle was met and left along its negative direction.
    pub left_saddle: bool,
    /// The area that was given up so that no control point lies far from the border and the parametrisation stays even (unit:
    /// length²): what a smaller tolerance gains at least. 0 if nothing was.
    pub given_up: f64,
    /// How the inside of a net of high degree was sought; none for a net that was sought as a whole.
    pub displacement: Option<Displacement>,
}

impl AreaExtremal {
    /// Why it ended, in words.
    pub fn reason(&self) -> String {
        let given_up = match self.given_up > 0.0 {
            true => format!(", which would gain {:.0e} of the area", self.given_up / self.area.value),
            false => String::new(),
        };
        let displaced = self.displacement.map_or(String::new(), |displacement| format!("; {displacement}"));
        format!("{}; {}{given_up}{displaced}", self.end, self.valley)
    }
}

/// Steps of one kind and what they gained.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stage {
    /// Steps taken.
    pub steps: usize,
    /// Area lost by them.
    pub gained: f64,
}

/// The surface a minimisation started from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Start {
    /// The Coons patch of its border.
    Coons,
    /// The extremal of the Dirichlet energy.
    Dirichlet,
    /// A surface that was at hand: of a lower degree, or of another method.
    AtHand,
}

/// Why a minimisation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum AreaEnd {
    /// The gradient along the normals is rounding, and no curvature among them is negative.
    Stationary,
    /// No step along the normals lowers the area beyond rounding, though their gradient is more than that: the surface is
    /// singular, or its area not resolved by the rule.
    Rough,
    /// All steps along the normals that are allowed were made.
    Budget,
}

/// Why the steps in all coordinates ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ValleyEnd {
    /// Two steps one after the other gained less than the tolerance.
    Tolerance,
    /// No step gains anything beyond rounding.
    Rounding,
    /// The parametrisation would have become less even than a tenth of the start's.
    Ratio,
    /// All steps that are allowed were made.
    Budget,
    /// The control points were kept within the size of the border from it, and the parametrisation as even as a tenth of the
    /// start's.
    Reach,
    /// Control points lie further from the border than its size, or the parametrisation is less even than a tenth of the
    /// start's, and no surface near was found where neither is so.
    Far,
    /// The surface is singular at a point of the rule: there its area has no gradient.
    Singular,
}

impl fmt::Display for Start {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Coons => "the Coons patch",
            Self::Dirichlet => "the Dirichlet extremal",
            Self::AtHand => "a surface at hand",
        })
    }
}

impl fmt::Display for AreaEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stationary => "the gradient along the normals is rounding",
            Self::Rough => {
                "no step along the normals lowers the area beyond rounding, but their gradient is more than that"
            }
            Self::Budget => "all steps along the normals that are allowed were made",
        })
    }
}

impl fmt::Display for ValleyEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Tolerance => "moving points along the surface gains less than the tolerance",
            Self::Rounding => "moving points along the surface gains no more than rounding",
            Self::Ratio => "moving points further along the surface would nearly fold the parametrisation",
            Self::Budget => "all steps that may move points along the surface were made",
            Self::Reach => {
                "moving points further along the surface would nearly fold it, or lead control points far from the border"
            }
            Self::Far => "control points lie far from the border, or the surface nearly folds",
            Self::Singular => "where the surface is singular no step moves points along it",
        })
    }
}
