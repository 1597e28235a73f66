use solve::NewtonEnd;

use super::AreaExtremal;

impl AreaExtremal {
    /// The reason where the area says nothing of some directions of the net: its points slide within the surface, and only what
    /// does not depend on the parameters is determined.
    pub const SLIDES: &str = "the area is all but constant along what remains of the gradient";

    /// Why the last iteration ended, in words.
    pub fn reason(&self) -> &'static str {
        match self.end {
            NewtonEnd::Minimum => "the gradient vanishes and no curvature is negative",
            NewtonEnd::Flat => Self::SLIDES,
            NewtonEnd::NoDecrease => "no step decreases the area any more",
            NewtonEnd::Budget => "all steps allowed were made",
            NewtonEnd::Stopped => "it was stopped",
            NewtonEnd::NotFinite => "the area is not finite at the start",
            _ => "the iteration ended",
        }
    }
}
