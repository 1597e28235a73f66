//! How a method finds the interior, and whether the boundary allows it.

use std::ops::Range;

use serde_spanned::Spanned;

use super::boundary::Kind;
use super::check::Check;
use super::method::{Draft, ENERGIES};
use super::number::shown;
use crate::spec::MaskKey;
use plateau::{Basis, Boundary, Energy, Interior, MAX_DEGREE, Mask};

const INTERIORS: &str = "say how the interior is found by one of energy = \"dirichlet\" (or \"laplacian\", \"bending\", \
     \"coons\", \"area\"), mask = -0.25, construction = \"discrete-coons\" or \"harmonic\"";

impl Draft<'_> {
    pub(super) fn interior(&self, check: &mut Check<'_>) -> Option<Interior> {
        let spec = self.spec;
        let given: Vec<(&str, Range<usize>)> = [
            spec.energy.as_ref().map(|key| ("energy", key.span())),
            spec.mask.as_ref().map(|key| ("mask", key.span())),
            spec.construction.as_ref().map(|key| ("construction", key.span())),
        ]
        .into_iter()
        .flatten()
        .collect();
        if let [(first, first_span), (second, second_span), ..] = given.as_slice() {
            check.conflict(
                (second_span.clone(), "and here"),
                (first_span.clone(), "the interior is determined here"),
                format!("{} has both `{first}` and `{second}`", self.table.name),
                "keep one of them: `energy` makes the interior an extremal, `mask` a combination of neighbours, \
                 `construction` a closed formula",
            );
            return None;
        }
        let energy = match &spec.energy {
            Some(key) => Some(check.choice(&self.table, "energy", key, &ENERGIES)?),
            None => None,
        };
        let metric_steps = self.metric_steps(check, energy)?;
        if let Some(energy) = energy {
            return Some(Interior::Extremal { energy, metric_steps });
        }
        if let Some(key) = &spec.mask {
            return self.mask(check, key).map(Interior::Mask);
        }
        if let Some(key) = &spec.construction {
            let names = [("discrete-coons", Interior::DiscreteCoons), ("harmonic", Interior::Harmonic)];
            return check.choice(&self.table, "construction", key, &names);
        }
        check.missing(&self.table, "energy", INTERIORS);
        None
    }

    fn metric_steps(&self, check: &mut Check<'_>, energy: Option<Energy>) -> Option<usize> {
        let Some(key) = &self.spec.metric_steps else { return Some(0) };
        let help =
            "one step is the Dirichlet correction of TRI §7, two the second step; 20 come near the limit";
        let steps = check.count(&self.table, "metric-steps", key, 0..=1000, help)?;
        if steps > 0 && energy != Some(Energy::Dirichlet) {
            self.clash(
                check,
                (key.span(), "needs energy = \"dirichlet\""),
                format!("{} has `metric-steps`, but its interior is no Dirichlet extremal", self.table.name),
                "write energy = \"dirichlet\": each step minimises the Dirichlet energy in the metric of the surface before",
            );
            return None;
        }
        Some(steps)
    }

    fn mask(&self, check: &mut Check<'_>, key: &Spanned<MaskKey>) -> Option<Mask> {
        let mask = match key.get_ref() {
            MaskKey::Alpha(alpha) if alpha.is_finite() && alpha.abs() <= 1e6 => {
                return Some(Mask::Alpha(*alpha));
            }
            MaskKey::Alpha(alpha) => {
                check.inadmissible(
                    key.span(),
                    format!("`mask` in {} must be a corner weight between -1e6 and 1e6", self.table.name),
                    format!("this is {}", shown(*alpha)),
                    "the edge weight follows from it: 3α + 6β = 1 on triangles, 4α + 4β = 1 on tensor nets",
                );
                return None;
            }
            MaskKey::Name(word) => {
                let names = [("dirichlet", Mask::Dirichlet), ("coons", Mask::Coons)];
                check.named(&self.table, "mask", word, key.span(), &names)?
            }
        };
        if matches!(self.sides.kind, Some(Kind::Tensor | Kind::TwoSides)) {
            check.conflict(
                (key.span(), "a mask of triangular nets"),
                (self.sides.header.clone(), "a tensor boundary"),
                format!("{} has a triangular mask, but the boundary is a tensor net", self.table.name),
                "give the corner weight α of a tensor mask, where 4α + 4β = 1: mask = -0.25 is the Coons mask",
            );
            return None;
        }
        Some(mask)
    }

    pub(super) fn raise(&self, check: &mut Check<'_>, interior: Option<&Interior>) -> Option<usize> {
        let Some(key) = &self.spec.raise else { return Some(0) };
        let help = "it is the number of degrees by which the boundary is raised before solving";
        let raise = check.count(&self.table, "raise", key, 0..=MAX_DEGREE, help)?;
        if raise > 0 && matches!(interior, Some(Interior::Harmonic)) {
            self.clash(
                check,
                (key.span(), "not for harmonic nets"),
                format!("{} raises the degree of a harmonic net", self.table.name),
                "leave out `raise`: the degrees of a harmonic net are those of [boundary]",
            );
            return None;
        }
        Some(raise)
    }

    /// Whether the boundary is of the kind and the degree the method needs.
    pub(super) fn fits_boundary(
        &self,
        check: &mut Check<'_>,
        interior: Option<&Interior>,
        basis: Option<Basis>,
        raise: Option<usize>,
    ) -> bool {
        let harmonic = matches!(interior, Some(Interior::Harmonic));
        let key = || self.spec.construction.as_ref().map_or(self.table.span.clone(), Spanned::span);
        if harmonic && self.sides.kind == Some(Kind::Triangle) {
            check.conflict(
                (key(), "for tensor nets"),
                (self.sides.header.clone(), "a triangular boundary"),
                format!("{} asks for a harmonic tensor net on a triangle", self.table.name),
                "on triangles minimise instead: energy = \"laplacian\" or \"dirichlet\"",
            );
            return false;
        }
        if harmonic && self.spec.patch.as_ref().is_some_and(|patch| patch.get_ref().0 == "tb-coons") {
            self.clash(
                check,
                (key(), "for patch = \"tensor\""),
                format!("{} asks for a harmonic net in a TB–Coons patch", self.table.name),
                "leave out `patch`: a harmonic net is a tensor net in the Bernstein basis, which may be read in the GT basis",
            );
            return false;
        }
        if interior.is_some() && !harmonic && self.sides.kind == Some(Kind::TwoSides) {
            check.conflict(
                (self.table.span.clone(), "needs all four sides"),
                (self.sides.header.clone(), "holds two opposite sides only"),
                format!("{} needs all four sides of the boundary", self.table.name),
                "give u0, u1, v0 and v1, or write construction = \"harmonic\", which two opposite sides determine",
            );
            return false;
        }
        let (Some(boundary), Some(raise)) = (&self.sides.boundary, raise) else { return true };
        self.fits_degree(check, boundary, basis, raise)
    }

    fn fits_degree(
        &self,
        check: &mut Check<'_>,
        boundary: &Boundary,
        basis: Option<Basis>,
        raise: usize,
    ) -> bool {
        let (m, n) = boundary.degrees();
        let span = |key: Option<Range<usize>>| key.unwrap_or(self.table.span.clone());
        if m.max(n) + raise > MAX_DEGREE {
            check.conflict(
                (span(self.spec.raise.as_ref().map(Spanned::span)), "raises it too far"),
                (self.sides.header.clone(), &format!("degree {}", m.max(n))),
                format!(
                    "{} would have degree {}, above the limit {MAX_DEGREE}",
                    self.table.name,
                    m.max(n) + raise
                ),
                format!("raise by at most {}", MAX_DEGREE - m.max(n)),
            );
            return false;
        }
        if basis == Some(Basis::Gt) && m.min(n) + raise < 2 {
            check.conflict(
                (span(self.spec.basis.as_ref().map(Spanned::span)), "needs degree 2 or more"),
                (self.sides.header.clone(), &format!("degrees {m} in u and {n} in v")),
                format!(
                    "{} reads a net of degree 1 in the GT basis, which begins at degree 2",
                    self.table.name
                ),
                "write raise = 1, give three points or more per side, or use basis = \"bernstein\"",
            );
            return false;
        }
        true
    }
}
