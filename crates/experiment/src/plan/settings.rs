//! What a method says beside its functions and its interior.

use std::ops::Range;

use plateau::{Family, Functional, ReferenceTriangle, SolverChoice};

use super::draft::Draft;
use super::interior::Interior;
use crate::keys::method::{BOUND, DOMAIN, LAYERS, SOLVER, Solver, TOLERANCE};

/// The numbers and choices of a method beside its functions and its interior.
pub(super) struct Settings {
    pub(super) solver: SolverChoice,
    pub(super) domain: ReferenceTriangle,
    pub(super) tolerance: f64,
    pub(super) bound: bool,
    pub(super) layers: usize,
}

impl Draft<'_> {
    /// How nearly the least area is to be reached.
    pub(super) fn tolerance(&self, interior: Option<&Interior>) -> Option<f64> {
        if let (Some(span), Some(interior)) = (self.tolerance.span(), interior)
            && *interior != Interior::LeastArea
        {
            self.table.faults().clash(
                (span, "needs energy = \"area\""),
                format!("{} has `tolerance`, but its interior is not of least area", self.table.name()),
                "leave it out: every other interior is one linear solve, exact to rounding",
            );
            return None;
        }
        self.table.or_default(&TOLERANCE, &self.tolerance)
    }

    /// How many layers of smaller patches there are around corners.
    pub(super) fn layers(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<usize> {
        let wanted = self.table.or_default(&LAYERS, &self.layers)?;
        // Over three sides the key itself is refused.
        let span = self.layers.span().filter(|_| wanted > 0 && !self.is_triangle());
        let help = "leave it out, or write energy = \"area\" and no `basis`";
        self.is_of_least_areas((span, "layers", help), family, interior).then_some(wanted)
    }

    /// Whether a lower bound is to be proved.
    pub(super) fn bound(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<bool> {
        let wanted = self.table.or_default(&BOUND, &self.bound)?;
        let span = self.bound.span().filter(|_| wanted);
        let help = "leave it out: what is proved of a least area in the Bernstein basis holds for other surfaces with the same boundary curves, too";
        self.is_of_least_areas((span, "bound", help), family, interior).then_some(wanted)
    }

    /// Whether a key that only least areas in the Bernstein basis have, if it is given, stands where it may; what is wrong is reported.
    fn is_of_least_areas(
        &self,
        (span, key, help): (Option<Range<usize>>, &str, &str),
        family: Option<Family>,
        interior: Option<&Interior>,
    ) -> bool {
        let (Some(span), Some(family), Some(interior)) = (span, family, interior) else { return true };
        let why = match (family == Family::Bernstein, *interior == Interior::LeastArea) {
            (true, true) => return true,
            (true, false) => "its interior is not of least area",
            (false, _) => "its patch is no tensor patch in the Bernstein basis",
        };
        self.table.faults().clash(
            (span, "needs energy = \"area\" in the Bernstein basis over four sides"),
            format!("{} has `{key}`, but {why}", self.table.name()),
            help,
        );
        false
    }

    /// The triangle over which an energy is taken.
    pub(super) fn domain(&self, interior: Option<&Interior>) -> Option<ReferenceTriangle> {
        let is_quadratic = |interior: &Interior| match interior {
            Interior::Extremal(_) | Interior::MetricCorrections(_) => true,
            Interior::LeastArea | Interior::Mask(_) | Interior::DiscreteCoons | Interior::Harmonic => false,
        };
        if let (Some(span), Some(false)) = (self.domain.span(), interior.map(is_quadratic)) {
            self.table.faults().clash(
                (span, "for extremals of quadratic energies"),
                format!("{} has `domain`, but its interior is no extremal of a quadratic energy", self.table.name()),
                "leave it out: neither an area nor a mask nor a construction is taken over a triangle of the plane",
            );
            return None;
        }
        self.table.or_default(&DOMAIN, &self.domain)
    }

    pub(super) fn solver(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<SolverChoice> {
        let solver = self.table.or_default(&SOLVER, &self.solver)?;
        let dirichlet = matches!(
            interior,
            Some(Interior::Extremal(Functional::Dirichlet) | Interior::MetricCorrections(_))
        );
        let separates = match family {
            Some(Family::Bernstein) => true,
            Some(Family::Shaped(family)) => !family.is_blend(),
            Some(Family::Triangle | Family::Aht | Family::At | Family::Complex) | None => false,
        };
        let masked = matches!(interior, Some(Interior::Mask(_)));
        let (choice, fits, needs) = match solver {
            Solver::Of(choice @ (SolverChoice::Auto | SolverChoice::Dense)) => (choice, true, ""),
            Solver::Of(SolverChoice::Separable) => (
                SolverChoice::Separable,
                dirichlet && separates,
                "the separable solver serves energy = \"dirichlet\" on tensor patches only",
            ),
            Solver::Sparse => (
                SolverChoice::Auto,
                masked,
                "the sparse solver serves masks only: extremals couple all points",
            ),
        };
        let Some(span) = self.solver.span().filter(|_| !fits && family.is_some() && interior.is_some())
        else {
            return Some(choice);
        };
        let said = self.table.faults().excerpt(&span);
        self.table.faults().clash(
            (span.clone(), "does not serve this system"),
            format!("{} cannot be solved by solver = {said}", self.table.name()),
            format!("{needs}; write solver = \"auto\", or leave it out"),
        );
        None
    }
}
