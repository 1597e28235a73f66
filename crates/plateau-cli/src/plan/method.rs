//! `[[method]]`: keys that fit together, and the boundary they are for.

use std::collections::HashMap;
use std::ops::Range;

use serde_spanned::Spanned;

use super::Wanted;
use super::boundary::{Kind, Sides};
use super::check::{Check, Table, top};
use super::expected::check::{Subject, expected, published};
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{MethodSpec, Section, Step, shorten};
use plateau::{Basis, Energy, Interior, Method, Patch, Shape, SolverChoice};

pub(super) const ENERGIES: [(&str, Energy); 5] = [
    ("dirichlet", Energy::Dirichlet),
    ("laplacian", Energy::Laplacian),
    ("bending", Energy::Bending),
    ("coons", Energy::Coons),
    ("area", Energy::Area),
];

/// Checks every `[[method]]` against what is known of the boundary.
pub(super) fn methods(
    check: &mut Check<'_>,
    specs: &Spanned<Vec<Spanned<Section<MethodSpec>>>>,
    sides: &Sides,
) -> Option<Vec<(Method, Wanted)>> {
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
pub(super) struct Draft<'s> {
    pub(super) table: Table,
    pub(super) spec: &'s MethodSpec,
    pub(super) sides: &'s Sides,
}

fn method(
    check: &mut Check<'_>,
    index: usize,
    spec: &Spanned<Section<MethodSpec>>,
    sides: &Sides,
) -> Option<(Method, Wanted)> {
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
    let draft = Draft { table, spec: spec.get_ref(), sides };
    draft.finish(check)
}

impl Draft<'_> {
    fn finish(&self, check: &mut Check<'_>) -> Option<(Method, Wanted)> {
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
        let tolerance = self.tolerance(check, interior.as_ref());
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
                let name = format!("[method.expect] of {}", self.table.name);
                let table = check.inner(&self.table, name, key.span(), &top("expect"));
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
        let method = Method {
            name: name?,
            patch: patch?,
            basis: basis?,
            shape: shape?,
            interior: interior?,
            search_energy: search_energy?,
            raise: raise?,
            solver: solver?,
            tolerance: tolerance?,
        };
        Some((method, Wanted { expect: expect?, published: published? }))
    }

    pub(super) fn clash(
        &self,
        check: &mut Check<'_>,
        (span, label): (Range<usize>, &str),
        message: String,
        help: &str,
    ) {
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

    /// How nearly the least area is to be reached.
    fn tolerance(&self, check: &mut Check<'_>, interior: Option<&Interior>) -> Option<f64> {
        const FINEST: f64 = 1e-12;
        const DEFAULT: f64 = 1e-11;
        let Some(key) = &self.spec.tolerance else { return Some(DEFAULT) };
        let help =
            "it is the relative decrease of the area that counts as none; 1e-7 is quick, 1e-11 the default";
        let admitted = (|x| (FINEST..=1e-2).contains(&x), "in [1e-12, 1e-2]");
        let tolerance = check.number(&self.table, "tolerance", key, admitted, help)?;
        if interior.is_some_and(|i| !matches!(i, Interior::Extremal { energy: Energy::Area, .. })) {
            self.clash(
                check,
                (key.span(), "needs energy = \"area\""),
                format!("{} has `tolerance`, but its interior is not of least area", self.table.name),
                "leave it out: every other interior is one linear solve, exact to rounding",
            );
            return None;
        }
        Some(tolerance)
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
