//! How a method finds the interior, and whether the boundary allows it.

use std::ops::Range;

use plateau::{Boundary, DegreeLimit, Energy, Family, Functional, MAX_DEGREE, Method, TriangleMask};

use super::boundary::Kind;
use super::draft::Draft;
use crate::keys::method::{Construction, METRIC_STEPS, RAISE};
use crate::text::Given;

const INTERIORS: &str = "say how the interior is found by one of energy = \"dirichlet\" (or \"laplacian\", \"bending\", \
     \"coons\", \"area\"), mask = -0.25, construction = \"discrete-coons\" or \"harmonic\"";

/// How a method says its interior is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::plan) enum Interior {
    Extremal(Functional),
    MetricCorrections(usize),
    LeastArea,
    Mask(TriangleMask),
    DiscreteCoons,
    Harmonic,
}

impl Draft<'_> {
    pub(super) fn interior(&self) -> Option<Interior> {
        let given: Vec<(&str, Range<usize>)> = ["energy", "mask", "construction"]
            .into_iter()
            .filter_map(|key| Some((key, self.table.place(&[key])?)))
            .collect();
        if let [(first, first_span), (second, second_span), ..] = given.as_slice() {
            self.table.faults().conflict(
                (second_span.clone(), "and here"),
                (first_span.clone(), "the interior is determined here"),
                format!("{} has both `{first}` and `{second}`", self.table.name()),
                "keep one of them: `energy` makes the interior an extremal, `mask` a combination of neighbours, \
                 `construction` a closed formula",
            );
            return None;
        }
        if given.is_empty() {
            self.table.missing("energy", INTERIORS);
            return None;
        }
        let metric_steps = self.metric_steps()?;
        match (&self.energy, &self.mask, &self.construction) {
            (Given::Sound(energy), _, _) => Some(match energy.get_ref() {
                Energy::Quadratic(_) if metric_steps > 0 => Interior::MetricCorrections(metric_steps),
                Energy::Quadratic(functional) => Interior::Extremal(*functional),
                Energy::Area => Interior::LeastArea,
            }),
            (_, Given::Sound(mask), _) => self.mask(*mask.get_ref(), mask.span()).map(Interior::Mask),
            (_, _, Given::Sound(construction)) => Some(match construction.get_ref() {
                Construction::DiscreteCoons => Interior::DiscreteCoons,
                Construction::Harmonic => Interior::Harmonic,
            }),
            (Given::Absent | Given::Faulty, Given::Absent | Given::Faulty, Given::Absent | Given::Faulty) => {
                None
            }
        }
    }

    fn metric_steps(&self) -> Option<usize> {
        let steps = self.table.or_default(&METRIC_STEPS, &self.metric_steps)?;
        let is_other = match &self.energy {
            Given::Absent => true,
            Given::Faulty => false,
            Given::Sound(energy) => *energy.get_ref() != Energy::DIRICHLET,
        };
        if let Some(span) = self.metric_steps.span().filter(|_| steps > 0 && is_other) {
            self.table.faults().clash(
                (span, "needs energy = \"dirichlet\""),
                format!("{} has `metric-steps`, but its interior is no Dirichlet extremal", self.table.name()),
                "write energy = \"dirichlet\": each step minimises the Dirichlet energy in the metric of the surface before",
            );
            return None;
        }
        Some(steps)
    }

    fn mask(&self, mask: TriangleMask, span: Range<usize>) -> Option<TriangleMask> {
        let is_named = match mask {
            TriangleMask::Symmetric(_) => false,
            TriangleMask::Dirichlet | TriangleMask::Coons => true,
        };
        if is_named && matches!(self.sides.kind, Some(Kind::Tensor | Kind::TwoSides)) {
            self.table.faults().conflict(
                (span, "a mask of triangular nets"),
                (self.sides.header.clone(), "a tensor boundary"),
                format!("{} has a triangular mask, but the boundary is a tensor net", self.table.name()),
                "give the corner weight α of a tensor mask, where 4α + 4β = 1: mask = -0.25 is the Coons mask",
            );
            return None;
        }
        Some(mask)
    }

    pub(super) fn raise(&self, interior: Option<&Interior>) -> Option<usize> {
        let raise = self.table.or_default(&RAISE, &self.raise)?;
        let is_harmonic = matches!(interior, Some(Interior::Harmonic));
        if let Some(span) = self.raise.span().filter(|_| raise > 0 && is_harmonic) {
            self.table.faults().clash(
                (span, "not for harmonic nets"),
                format!("{} raises the degree of a harmonic net", self.table.name()),
                "leave out `raise`: the degrees of a harmonic net are those of [boundary]",
            );
            return None;
        }
        Some(raise)
    }

    /// Whether the boundary is of the kind and the degree the method needs.
    pub(super) fn fits_boundary(
        &self,
        interior: Option<&Interior>,
        family: Option<Family>,
        raise: Option<usize>,
    ) -> bool {
        let harmonic = matches!(interior, Some(Interior::Harmonic));
        let key = || self.construction.span().unwrap_or(self.table.span());
        if harmonic && self.sides.kind == Some(Kind::Triangle) {
            self.table.faults().conflict(
                (key(), "for tensor nets"),
                (self.sides.header.clone(), "a triangular boundary"),
                format!("{} asks for a harmonic tensor net on a triangle", self.table.name()),
                "on triangles minimise instead: energy = \"laplacian\" or \"dirichlet\"",
            );
            return false;
        }
        if harmonic && self.blend().is_some() {
            self.table.faults().clash(
                (key(), "for patch = \"tensor\""),
                format!("{} asks for a harmonic net in a TB–Coons patch", self.table.name()),
                "leave out `patch`: a harmonic net is a tensor net in the Bernstein basis, which may be read in the GT basis",
            );
            return false;
        }
        if interior.is_some() && !harmonic && self.sides.kind == Some(Kind::TwoSides) {
            self.table.faults().conflict(
                (self.table.span(), "needs all four sides"),
                (self.sides.header.clone(), "holds two opposite sides only"),
                format!("{} needs all four sides of the boundary", self.table.name()),
                "give u0, u1, v0 and v1, or write construction = \"harmonic\", which two opposite sides determine",
            );
            return false;
        }
        let (Some(boundary), Some(raise)) = (&self.sides.boundary, raise) else { return true };
        self.fits_degree(boundary, family, raise)
    }

    fn fits_degree(&self, boundary: &Boundary, family: Option<Family>, raise: usize) -> bool {
        let (m, n) = boundary.degrees();
        if m.max(n) + raise > MAX_DEGREE {
            self.table.faults().conflict(
                (self.raise.span().unwrap_or(self.table.span()), "raises it too far"),
                (self.sides.header.clone(), &format!("degree {}", m.max(n))),
                format!(
                    "{} would have degree {}, above the limit {MAX_DEGREE}",
                    self.table.name(),
                    m.max(n) + raise
                ),
                format!("raise by at most {}", MAX_DEGREE - m.max(n)),
            );
            return false;
        }
        let shaped = match family {
            Some(Family::Shaped(family)) => family,
            Some(Family::Bernstein | Family::Triangle | Family::Aht | Family::At | Family::Complex)
            | None => return true,
        };
        let least = shaped.least_degree();
        let Some(missing) = least.checked_sub(m.min(n) + raise).filter(|&missing| missing > 0) else {
            return true;
        };
        self.table.faults().conflict(
            (
                self.table.place(&["basis"]).unwrap_or(self.table.span()),
                &format!("needs degree {least} or more"),
            ),
            (self.sides.header.clone(), &format!("degrees {m} in u and {n} in v")),
            format!(
                "{} reads a net of degree {} in {}, which begins at degree {least}",
                self.table.name(),
                m.min(n) + raise,
                shaped.title()
            ),
            format!(
                "write raise = {}, give {} points or more per side, or use basis = \"bernstein\"",
                raise + missing,
                ["three", "four", "five"].get(least.saturating_sub(2)).unwrap_or(&"more"),
            ),
        );
        false
    }

    /// Whether the method is offered at the degree of its net.
    pub(super) fn fits_method(&self, method: &Method) -> bool {
        let (Some(boundary), Some(limit)) = (&self.sides.boundary, method.degree_limit()) else {
            return true;
        };
        let (m, n) = boundary.degrees();
        let (given, degree) = (m.max(n), m.max(n) + method.raise());
        if degree <= limit.degree() {
            return true;
        }
        let key = match limit {
            DegreeLimit::Triangle
            | DegreeLimit::LeastArea
            | DegreeLimit::BlendLeastArea
            | DegreeLimit::TriangularLeastArea => self.energy.span(),
            DegreeLimit::Patches => self.layers.span(),
            DegreeLimit::MetricSteps => self.metric_steps.span(),
            DegreeLimit::Harmonic | DegreeLimit::TriangularCoons => self.construction.span(),
            DegreeLimit::OtherSearchEnergy => self.search_energy.span(),
        };
        let lower = match limit.degree().checked_sub(given) {
            Some(0) => "leave out `raise`, or ".to_owned(),
            Some(raise) => format!("raise by at most {raise}, or "),
            None => String::new(),
        };
        let instead = match limit {
            DegreeLimit::Triangle => {
                "write mask = \"dirichlet\" or construction = \"discrete-coons\", which are sound at higher degrees"
            }
            DegreeLimit::MetricSteps => {
                "write energy = \"area\" without `metric-steps`: it goes farther than any number of steps, at every degree"
            }
            DegreeLimit::Harmonic => "write energy = \"laplacian\" over all four sides",
            DegreeLimit::TriangularCoons => "describe the sides with one control point less",
            DegreeLimit::BlendLeastArea => {
                "leave out `patch`: polynomials of least area go on to degree 64; or write energy = \"dirichlet\", which does as a blend, too"
            }
            DegreeLimit::LeastArea => {
                "leave out `basis`: polynomials of least area go on to degree 64; or write energy = \"dirichlet\", which does in every basis"
            }
            DegreeLimit::Patches => "leave out `layers`: a single patch of least area goes on to degree 64",
            DegreeLimit::TriangularLeastArea => {
                "describe the sides with fewer control points, or write mask = \"dirichlet\", which is sound at higher degrees"
            }
            DegreeLimit::OtherSearchEnergy => {
                "leave out `search-energy`: then the shape minimises the energy of the extremal, at every degree"
            }
        };
        self.table.faults().conflict(
            (key.unwrap_or(self.table.span()), &format!("offered to degree {}", limit.degree())),
            (
                self.sides.header.clone(),
                &format!("degree {given}{}", if method.raise() > 0 { " before it is raised" } else { "" }),
            ),
            format!("{} would have degree {degree}: {limit}", self.table.name()),
            format!("{lower}{instead}"),
        );
        false
    }
}
