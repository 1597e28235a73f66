//! `[[method]]`: keys that fit together, and the boundary they are for.

use std::collections::HashMap;
use std::ops::Range;

use serde_spanned::Spanned;

use super::boundary::{Kind, Sides};
use super::check::{Check, Table, top};
use super::expected::check::{Subject, expected, published};
use super::number::shown;
use super::{
    Basis, Boundary, Energy, Interior, MAX_DEGREE, Mask, Method, Patch, SearchMode, Shape, SolverChoice,
};
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{MaskKey, MethodSpec, NumberList, SearchKey, Step, shorten};

const ENERGIES: [(&str, Energy); 5] = [
    ("dirichlet", Energy::Dirichlet),
    ("laplacian", Energy::Laplacian),
    ("bending", Energy::Bending),
    ("coons", Energy::Coons),
    ("area", Energy::Area),
];

const INTERIORS: &str = "say how the interior is found by one of energy = \"dirichlet\" (or \"laplacian\", \"bending\", \
     \"coons\", \"area\"), mask = -0.25, construction = \"discrete-coons\" or \"harmonic\"";

/// Checks every `[[method]]` against what is known of the boundary.
pub(super) fn methods(
    check: &mut Check<'_>,
    specs: &Spanned<Vec<Spanned<MethodSpec>>>,
    sides: &Sides,
) -> Option<Vec<Method>> {
    let specs = specs.get_ref();
    let mut first_use: HashMap<&str, Range<usize>> = HashMap::new();
    let mut methods = Vec::new();
    for (k, spec) in specs.iter().enumerate() {
        if let Some(name) = &spec.get_ref().name {
            let text = name.get_ref().0.as_str();
            match first_use.get(text) {
                Some(first) => check.conflict(
                    (name.span(), "the same name again"),
                    (first.clone(), "first used here"),
                    format!("two methods are called \"{}\"", shorten(text)),
                    "give each method its own name: it labels its row of the table",
                ),
                None => {
                    first_use.insert(text, name.span());
                }
            }
        }
        methods.extend(method(check, k, spec, sides));
    }
    (methods.len() == specs.len()).then_some(methods)
}

/// One method under check.
struct Draft<'s> {
    table: Table,
    path: Vec<Step>,
    spec: &'s MethodSpec,
    sides: &'s Sides,
}

fn method(check: &mut Check<'_>, index: usize, spec: &Spanned<MethodSpec>, sides: &Sides) -> Option<Method> {
    let path = [top("method"), vec![Step::Index(index)]].concat();
    let called = match &spec.get_ref().name {
        Some(name) if !name.get_ref().0.trim().is_empty() => {
            format!("method \"{}\"", shorten(&name.get_ref().0))
        }
        _ => format!("method {}", index + 1),
    };
    let table = check.table(called, spec.span(), &path);
    if table.damaged {
        // What the unreadable entry meant is unknown, and every other key is judged beside it.
        return None;
    }
    let draft = Draft { table, path, spec: spec.get_ref(), sides };
    draft.finish(check)
}

impl Draft<'_> {
    fn finish(&self, check: &mut Check<'_>) -> Option<Method> {
        let spec = self.spec;
        let name_help = "write name = \"…\": it labels the row of the table";
        let name = check
            .required(&self.table, "name", &spec.name, name_help)
            .and_then(|key| check.name(&self.table, "name", key, name_help));
        let patch = self.patch(check);
        let basis = patch.and_then(|patch| self.basis(check, patch));
        let shape = basis.and_then(|basis| self.shape(check, basis));
        let interior = self.interior(check);
        let raise = self.raise(check, interior.as_ref());
        let fits = self.fits_boundary(check, interior.as_ref(), basis, raise);
        let solver = self.solver(check, patch, interior.as_ref());
        let search_energy = match (shape, &interior) {
            (Some(shape), Some(interior)) => self.search_energy(check, shape, interior),
            _ => None,
        };
        let subject = match (patch, shape) {
            (Some(patch), Some(shape)) => Some(Subject::Patch { patch, shape }),
            _ => None,
        };
        let expect = match (&spec.expect, subject) {
            (Some(key), Some(subject)) => {
                let path = [self.path.clone(), top("expect")].concat();
                let table = check.table(format!("[method.expect] of {}", self.table.name), key.span(), &path);
                expected(check, &table, key.get_ref(), subject)
            }
            _ => Some(Vec::new()),
        };
        let published = match &spec.published {
            Some(key) => published(check, &self.table, key),
            None => Some(Vec::new()),
        };
        if !fits {
            return None;
        }
        Some(Method {
            name: name?,
            patch: patch?,
            basis: basis?,
            shape: shape?,
            interior: interior?,
            search_energy: search_energy?,
            raise: raise?,
            solver: solver?,
            expect: expect?,
            published: published?,
        })
    }

    fn clash(&self, check: &mut Check<'_>, (span, label): (Range<usize>, &str), message: String, help: &str) {
        check.report(Diagnostic::at(Fault::Conflict, span, message, label).help(help));
    }

    fn patch(&self, check: &mut Check<'_>) -> Option<Patch> {
        let triangle = self.sides.kind == Some(Kind::Triangle);
        let Some(key) = &self.spec.patch else {
            return Some(if triangle { Patch::Triangle } else { Patch::Tensor });
        };
        if triangle {
            check.conflict(
                (key.span(), "for tensor boundaries"),
                (self.sides.header.clone(), "a triangular boundary"),
                format!("{} has a `patch`, but the boundary is a triangle", self.table.name),
                "leave out `patch`: the sides ab, bc, ca already make the patch triangular",
            );
            return None;
        }
        check.choice(&self.table, "patch", key, &[("tensor", Patch::Tensor), ("tb-coons", Patch::TbCoons)])
    }

    fn basis(&self, check: &mut Check<'_>, patch: Patch) -> Option<Basis> {
        let natural = if patch == Patch::TbCoons { Basis::Gt } else { Basis::Bernstein };
        let Some(key) = &self.spec.basis else { return Some(natural) };
        let names = [("bernstein", Basis::Bernstein), ("gt", Basis::Gt)];
        let basis = check.choice(&self.table, "basis", key, &names)?;
        match (patch, basis) {
            (Patch::Triangle, Basis::Gt) => {
                check.conflict(
                    (key.span(), "not for triangles"),
                    (self.sides.header.clone(), "a triangular boundary"),
                    format!("{} asks for the GT basis on a triangle", self.table.name),
                    "leave out `basis`: triangular patches are Bernstein–Bézier patches",
                );
                None
            }
            (Patch::TbCoons, Basis::Bernstein) => {
                self.clash(
                    check,
                    (key.span(), "a TB–Coons patch uses both bases"),
                    format!("{} asks for a TB–Coons patch in the Bernstein basis", self.table.name),
                    "leave out `basis`: a TB–Coons patch blends Bernstein and GT functions; for a plain Bézier patch \
                     leave out `patch`",
                );
                None
            }
            _ => Some(basis),
        }
    }

    fn shape(&self, check: &mut Check<'_>, basis: Basis) -> Option<Shape> {
        let spec = self.spec;
        let mode = match &spec.search {
            Some(key) => {
                let names = [
                    ("pso", SearchMode::Pso),
                    ("polish", SearchMode::Polish),
                    ("pso-polish", SearchMode::PsoPolish),
                ];
                match key.get_ref() {
                    SearchKey::Truth(true) => Some(SearchMode::Pso),
                    SearchKey::Truth(false) => None,
                    SearchKey::Name(word) => {
                        Some(check.named(&self.table, "search", word, key.span(), &names)?)
                    }
                }
            }
            None => None,
        };
        if basis == Basis::Bernstein {
            let shape_key = spec.shape.as_ref().map(|key| ("shape", key.span()));
            let search_key =
                spec.search.as_ref().filter(|_| mode.is_some()).map(|key| ("search", key.span()));
            let Some((name, span)) = shape_key.or(search_key) else { return Some(Shape::None) };
            self.clash(
                check,
                (span, "nothing to set or search"),
                format!(
                    "{} has a `{name}`, but the Bernstein basis has no shape parameters",
                    self.table.name
                ),
                "write basis = \"gt\", or leave this key out",
            );
            return None;
        }
        match (&spec.shape, mode) {
            (Some(shape), Some(_)) => {
                let search = spec.search.as_ref().map_or(self.table.span.clone(), Spanned::span);
                check.conflict(
                    (search, "searches them"),
                    (shape.span(), "gives the shape parameters"),
                    format!("{} both gives and searches the shape parameters", self.table.name),
                    "keep `shape` for fixed parameters, or `search` to find them",
                );
                None
            }
            (None, Some(mode)) => Some(Shape::Search(mode)),
            (Some(shape), None) => fixed_shape(check, &self.table, shape).map(Shape::Fixed),
            (None, None) => {
                check.missing(
                    &self.table,
                    "shape",
                    "the GT basis needs shape parameters: give shape = [a1, a2, b1, b2], each in [0, 4] (a in u, b in \
                     v), or find them by search = true",
                );
                None
            }
        }
    }

    fn interior(&self, check: &mut Check<'_>) -> Option<Interior> {
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

    fn raise(&self, check: &mut Check<'_>, interior: Option<&Interior>) -> Option<usize> {
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
    fn fits_boundary(
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

    fn solver(
        &self,
        check: &mut Check<'_>,
        patch: Option<Patch>,
        interior: Option<&Interior>,
    ) -> Option<SolverChoice> {
        let Some(key) = &self.spec.solver else { return Some(SolverChoice::Auto) };
        let names = [
            ("auto", SolverChoice::Auto),
            ("dense", SolverChoice::Dense),
            ("separable", SolverChoice::Separable),
            ("sparse", SolverChoice::Sparse),
        ];
        let solver = check.choice(&self.table, "solver", key, &names)?;
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
        if fits || patch.is_none() || interior.is_none() {
            return Some(solver);
        }
        self.clash(
            check,
            (key.span(), "does not serve this system"),
            format!("{} cannot be solved by solver = \"{}\"", self.table.name, key.get_ref().0),
            &format!("{needs}; write solver = \"auto\", or leave it out"),
        );
        None
    }

    fn search_energy(&self, check: &mut Check<'_>, shape: Shape, interior: &Interior) -> Option<Energy> {
        let natural = match interior {
            Interior::Extremal { energy, .. } => Some(*energy),
            Interior::Harmonic => Some(Energy::Laplacian),
            Interior::Mask(_) | Interior::DiscreteCoons => None,
        };
        let searched = matches!(shape, Shape::Search(_));
        match (&self.spec.search_energy, searched) {
            (Some(key), true) => check.choice(&self.table, "search-energy", key, &ENERGIES),
            (Some(key), false) => {
                self.clash(
                    check,
                    (key.span(), "nothing is searched"),
                    format!("{} has a `search-energy` but no search", self.table.name),
                    "add search = true, or leave out `search-energy`; the interior's own energy is `energy`",
                );
                None
            }
            (None, true) if natural.is_none() => {
                check.missing(
                    &self.table,
                    "search-energy",
                    "a mask or a Coons construction minimises no energy of its own: say what the search of the shape \
                     parameters minimises, as in search-energy = \"dirichlet\"",
                );
                None
            }
            (None, _) => Some(natural.unwrap_or(Energy::Dirichlet)),
        }
    }
}

/// Four numbers in [0, 4], neither pair both zero.
fn fixed_shape(check: &mut Check<'_>, table: &Table, key: &Spanned<NumberList>) -> Option<[f64; 4]> {
    shape_parameters(check, table, key, "shape = [a1, a2, b1, b2], a in u and b in v")
}

/// `N` shape parameters in [0, 4]; no pair of them is (0, 0).
pub(super) fn shape_parameters<const N: usize>(
    check: &mut Check<'_>,
    table: &Table,
    key: &Spanned<NumberList>,
    form: &str,
) -> Option<[f64; N]> {
    let list = &key.get_ref().0;
    if list.len() != N {
        check.inadmissible(
            key.span(),
            format!("`shape` in {} has {} numbers instead of {N}", table.name, list.len()),
            format!("{} numbers", list.len()),
            format!("write {form}"),
        );
        return None;
    }
    let mut shape = [0.0; N];
    let mut sound = true;
    for (k, number) in list.iter().enumerate() {
        shape[k] = number.get_ref().0;
        if !(0.0..=4.0).contains(&shape[k]) {
            check.inadmissible(
                number.span(),
                format!("a shape parameter of {} lies outside [0, 4]: {}", table.name, shown(shape[k])),
                "expected a number in [0, 4]",
                format!("write {form}, each in [0, 4]: outside, the GT functions become negative"),
            );
            sound = false;
        }
    }
    if !sound {
        return None;
    }
    for (k, pair) in list.chunks(2).enumerate() {
        if pair.iter().all(|number| number.get_ref().0 == 0.0) {
            check.inadmissible(
                pair[0].span().start..pair[pair.len() - 1].span().end,
                format!("a pair of shape parameters of {} is (0, 0)", table.name),
                ["both of the first pair are zero", "both of the second pair are zero"][k.min(1)],
                "make one of the two positive: at (0, 0) the GT functions are linearly dependent",
            );
            return None;
        }
    }
    Some(shape)
}
