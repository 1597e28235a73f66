//! `[[method]]`: keys that fit together, and the boundary they are for.

use std::collections::HashMap;
use std::ops::Range;

use plateau::{Basis, Energy, Interior, Mask, Method, Patch, ReferenceTriangle, Shape, SolverChoice};
use serde_spanned::Spanned;

use super::Wanted;
use super::boundary::{Kind, Sides};
use super::expected::check::{Subject, wanted_of};
use crate::diagnostic::shorten;
use crate::keys::method::{
    BASIS, BOUND, CONSTRUCTION, DOMAIN, ENERGY, MASK, METRIC_STEPS, NAME, PATCH, RAISE, SEARCH,
    SEARCH_ENERGY, SHAPE, SOLVER, Searched, TENSOR, TOLERANCE, TRIANGLE,
};
use crate::text::{Given, Table};

/// A method with its name, if that is sound; names are unique.
pub(super) type Named<'t> = (Option<String>, Table<'t>);

/// The methods by their names.
pub(super) fn named<'p, 't: 'p>(tables: impl Iterator<Item = &'p Table<'t>>) -> Vec<Named<'t>> {
    let mut first_use: HashMap<String, Range<usize>> = HashMap::new();
    let mut methods = Vec::new();
    for (k, table) in tables.enumerate() {
        let table = table.clone().called(format!("method {}", k + 1));
        let Some(name) = table.require(&NAME) else {
            methods.push((None, table));
            continue;
        };
        match first_use.get(name.get_ref()) {
            Some(first) => table.faults().conflict(
                (name.span(), "the same name again"),
                (first.clone(), "first used here"),
                format!("two methods are called \"{}\"", shorten(name.get_ref())),
                "give each method its own name: it labels its row of the table",
            ),
            None => {
                first_use.insert(name.get_ref().clone(), name.span());
            }
        }
        let called = format!("method \"{}\"", shorten(name.get_ref()));
        methods.push((Some(name.into_inner()), table.called(called)));
    }
    methods
}

/// Checks every method over a net against what is known of the boundary.
pub(super) fn methods(named: Vec<Named<'_>>, sides: &Sides) -> Option<Vec<(Method, Wanted)>> {
    let over = sides.kind.map(|kind| match kind {
        Kind::Tensor | Kind::TwoSides => (TENSOR, "a tensor boundary"),
        Kind::Triangle => (TRIANGLE, "a triangular boundary"),
    });
    let checked: Vec<Option<(Method, Wanted)>> = named
        .into_iter()
        .map(|(name, table)| {
            let fits = over.is_none_or(|over| has_only_keys_over(&table, over, &sides.header));
            Draft::new(table, sides).finish(name).filter(|_| fits)
        })
        .collect();
    checked.into_iter().collect()
}

/// Whether a method has no key that is for other boundaries.
pub(super) fn has_only_keys_over(
    table: &Table<'_>,
    (over, called): (&str, &str),
    header: &Range<usize>,
) -> bool {
    let mut all = true;
    for (key, span) in table.present().filter(|(key, _)| !key.over.is_empty() && !key.over.contains(&over)) {
        all = false;
        table.faults().conflict(
            (span, &format!("not for {called}")),
            (header.clone(), called),
            format!("{} has a `{}`, which is not for {called}", table.name(), key.name),
            format!("leave out `{}`: it is for boundaries of the kind {}", key.name, key.over.join(" or ")),
        );
    }
    all
}

/// One method under check: its keys, read.
pub(super) struct Draft<'t> {
    pub(super) table: Table<'t>,
    pub(super) sides: &'t Sides,
    patch: Given<Patch>,
    basis: Given<Basis>,
    pub(super) shape: Given<Vec<Spanned<f64>>>,
    pub(super) search: Given<Searched>,
    pub(super) energy: Given<Energy>,
    pub(super) raise: Given<usize>,
    domain: Given<ReferenceTriangle>,
    pub(super) metric_steps: Given<usize>,
    pub(super) mask: Given<Mask>,
    pub(super) construction: Given<Interior>,
    pub(super) search_energy: Given<Energy>,
    solver: Given<SolverChoice>,
    tolerance: Given<f64>,
    bound: Given<bool>,
}

impl<'t> Draft<'t> {
    fn new(table: Table<'t>, sides: &'t Sides) -> Self {
        Self {
            sides,
            patch: table.take(&PATCH),
            basis: table.take(&BASIS),
            shape: table.take(&SHAPE),
            search: table.take(&SEARCH),
            energy: table.take(&ENERGY),
            raise: table.take(&RAISE),
            domain: table.take(&DOMAIN),
            metric_steps: table.take(&METRIC_STEPS),
            mask: table.take(&MASK),
            construction: table.take(&CONSTRUCTION),
            search_energy: table.take(&SEARCH_ENERGY),
            solver: table.take(&SOLVER),
            tolerance: table.take(&TOLERANCE),
            bound: table.take(&BOUND),
            table,
        }
    }

    fn finish(self, name: Option<String>) -> Option<(Method, Wanted)> {
        let patch = self.patch();
        let basis = patch.and_then(|patch| self.basis(patch));
        let shape = basis.and_then(|basis| self.shape(basis));
        let interior = self.interior();
        let raise = self.raise(interior.as_ref());
        let fits = self.fits_boundary(interior.as_ref(), basis, raise);
        let solver = self.solver(patch, interior.as_ref());
        let tolerance = self.tolerance(interior.as_ref());
        let bound = self.bound(patch.zip(basis), interior.as_ref());
        let search_energy = match (shape, &interior) {
            (Some(shape), Some(interior)) => self.search_energy(shape, interior),
            _ => None,
        };
        let domain = self.domain(interior.as_ref());
        let method = (|| {
            Some(Method {
                name: name?,
                patch: patch?,
                basis: basis?,
                shape: shape?,
                interior: interior?,
                search_energy: search_energy?,
                raise: raise?,
                solver: solver?,
                domain: domain?,
                tolerance: tolerance?,
                bound: bound?,
            })
        })();
        let fits = fits && method.as_ref().is_none_or(|method| self.fits_method(method));
        let subject = patch.zip(shape).map(|(patch, shape)| Subject::Patch { patch, shape });
        let wanted = wanted_of(&self.table, subject);
        if !fits {
            return None;
        }
        Some((method?, wanted?))
    }

    /// What the file says of the kind of patch.
    pub(super) fn patch_key(&self) -> Option<Patch> {
        self.patch.value().copied()
    }

    fn patch(&self) -> Option<Patch> {
        let triangle = self.sides.kind == Some(Kind::Triangle);
        match &self.patch {
            Given::Absent if triangle => Some(Patch::Triangle),
            Given::Absent => Some(Patch::Tensor),
            Given::Faulty => None,
            Given::Sound(_) if triangle => None,
            Given::Sound(patch) => Some(*patch.get_ref()),
        }
    }

    fn basis(&self, patch: Patch) -> Option<Basis> {
        let (basis, span) = match &self.basis {
            Given::Absent => {
                return Some(match patch {
                    Patch::TbCoons => Basis::Gt,
                    Patch::Tensor | Patch::Triangle => Basis::Bernstein,
                });
            }
            Given::Faulty => return None,
            Given::Sound(basis) => (*basis.get_ref(), basis.span()),
        };
        match (patch, basis) {
            (Patch::Triangle, Basis::Gt) => {
                self.table.faults().conflict(
                    (span, "not for triangles"),
                    (self.sides.header.clone(), "a triangular boundary"),
                    format!("{} asks for the GT basis on a triangle", self.table.name()),
                    "leave out `basis`: triangular patches are Bernstein–Bézier patches",
                );
                None
            }
            (Patch::TbCoons, Basis::Bernstein) => {
                self.table.faults().clash(
                    (span, "a TB–Coons patch uses both bases"),
                    format!("{} asks for a TB–Coons patch in the Bernstein basis", self.table.name()),
                    "leave out `basis`: a TB–Coons patch blends Bernstein and GT functions; for a plain Bézier patch \
                     leave out `patch`",
                );
                None
            }
            (Patch::Triangle, Basis::Bernstein) | (Patch::TbCoons, Basis::Gt) | (Patch::Tensor, _) => {
                Some(basis)
            }
        }
    }

    /// How nearly the least area is to be reached.
    fn tolerance(&self, interior: Option<&Interior>) -> Option<f64> {
        let is_area =
            |interior: &Interior| matches!(interior, Interior::Extremal { energy: Energy::Area, .. });
        if let (Some(span), Some(interior)) = (self.tolerance.span(), interior)
            && !is_area(interior)
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

    /// Whether a lower bound is to be proved.
    fn bound(&self, of: Option<(Patch, Basis)>, interior: Option<&Interior>) -> Option<bool> {
        let wanted = self.table.or_default(&BOUND, &self.bound)?;
        let span = self.bound.span().filter(|_| wanted);
        let (Some(span), Some(of), Some(interior)) = (span, of, interior) else { return Some(wanted) };
        let why = match (of, interior) {
            ((Patch::Tensor, Basis::Bernstein), Interior::Extremal { energy: Energy::Area, .. }) => {
                return Some(wanted);
            }
            ((Patch::Tensor, Basis::Bernstein), _) => "its interior is not of least area",
            ((Patch::Tensor | Patch::TbCoons | Patch::Triangle, _), _) => {
                "its patch is no tensor patch in the Bernstein basis"
            }
        };
        self.table.faults().clash(
            (span, "needs energy = \"area\" in the Bernstein basis over four sides"),
            format!("{} has `bound`, but {why}", self.table.name()),
            "leave it out: what is proved of a least area in the Bernstein basis holds for all surfaces with the same boundary curves",
        );
        None
    }

    /// The triangle over which an energy is taken.
    fn domain(&self, interior: Option<&Interior>) -> Option<ReferenceTriangle> {
        let is_quadratic = |interior: &Interior| match interior {
            Interior::Extremal { energy, .. } => *energy != Energy::Area,
            Interior::Mask(_) | Interior::DiscreteCoons | Interior::Harmonic => false,
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

    fn solver(&self, patch: Option<Patch>, interior: Option<&Interior>) -> Option<SolverChoice> {
        let solver = self.table.or_default(&SOLVER, &self.solver)?;
        let dirichlet = matches!(interior, Some(Interior::Extremal { energy: Energy::Dirichlet, .. }));
        let masked = matches!(interior, Some(Interior::Mask(_)));
        let (fits, needs) = match solver {
            SolverChoice::Auto | SolverChoice::Dense => (true, ""),
            SolverChoice::Separable => (
                dirichlet && patch == Some(Patch::Tensor),
                "the separable solver serves energy = \"dirichlet\" on tensor patches only",
            ),
            SolverChoice::Sparse => {
                (masked, "the sparse solver serves masks only: extremals couple all points")
            }
        };
        let Some(span) = self.solver.span().filter(|_| !fits && patch.is_some() && interior.is_some()) else {
            return Some(solver);
        };
        let said = self.table.faults().excerpt(&span);
        self.table.faults().clash(
            (span.clone(), "does not serve this system"),
            format!("{} cannot be solved by solver = {said}", self.table.name()),
            format!("{needs}; write solver = \"auto\", or leave it out"),
        );
        None
    }

    fn search_energy(&self, shape: Shape, interior: &Interior) -> Option<Energy> {
        let natural = match interior {
            Interior::Extremal { energy, .. } => Some(*energy),
            Interior::Harmonic => Some(Energy::Laplacian),
            Interior::Mask(_) | Interior::DiscreteCoons => None,
        };
        let is_searched = matches!(shape, Shape::Search(_));
        match &self.search_energy {
            Given::Faulty => None,
            Given::Sound(energy) if is_searched => Some(*energy.get_ref()),
            Given::Sound(energy) => {
                self.table.faults().clash(
                    (energy.span(), "nothing is searched"),
                    format!("{} has a `search-energy` but no search", self.table.name()),
                    "add search = true, or leave out `search-energy`; the interior's own energy is `energy`",
                );
                None
            }
            Given::Absent if is_searched && natural.is_none() => {
                self.table.missing(
                    "search-energy",
                    "a mask or a Coons construction minimises no energy of its own: say what the search of the shape \
                     parameters minimises, as in search-energy = \"dirichlet\"",
                );
                None
            }
            Given::Absent => Some(natural.unwrap_or(Energy::Dirichlet)),
        }
    }
}
