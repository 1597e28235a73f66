//! `[[method]]`: keys that fit together, and the boundary they are for.

use std::collections::HashMap;
use std::ops::Range;

use plateau::{
    Energy, Family, Functional, Functions, Method, MethodFault, ReferenceTriangle, SearchEnergy,
    ShapedFamily, SolverChoice, TensorInterior, TriangleInterior, TriangleMask,
};

use super::Wanted;
use super::boundary::{Kind, Sides};
use super::draft::Draft;
use super::expected::check::{Subject, wanted_of};
use super::interior::Interior;
use super::shape::Shape;
use crate::diagnostic::shorten;
use crate::keys::method::{BOUND, DOMAIN, LAYERS, NAME, SOLVER, Solver, TENSOR, TOLERANCE, TRIANGLE};
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

/// The numbers and choices of a method beside its functions and its interior.
struct Settings {
    solver: SolverChoice,
    domain: ReferenceTriangle,
    tolerance: f64,
    bound: bool,
    layers: usize,
}

impl Draft<'_> {
    fn finish(self, name: Option<String>) -> Option<(Method, Wanted)> {
        let family = self.family();
        let shape = family.and_then(|family| self.shape(family));
        let interior = self.interior();
        let raise = self.raise(interior.as_ref());
        let fits = self.fits_boundary(interior.as_ref(), family, raise);
        let solver = self.solver(family, interior.as_ref());
        let tolerance = self.tolerance(interior.as_ref());
        let bound = self.bound(family, interior.as_ref());
        let layers = self.layers(family, interior.as_ref());
        let search_energy = match (&shape, &interior) {
            (Some(shape), Some(interior)) => self.search_energy(shape, interior),
            _ => None,
        };
        let domain = self.domain(interior.as_ref());
        let searched = matches!(shape, Some(Shape::Search(_)));
        let subject = match layers {
            Some(1..) => Some(Subject::Film { least: Some(true), bound, loops: Some(1) }),
            Some(0) | None => family.filter(|_| shape.is_some()).map(|family| Subject::Patch {
                family,
                searched,
                interior,
                bound,
            }),
        };
        // What does not fit its boundary has been reported, and is not built to be refused again.
        let method = (|| {
            let settings = Settings {
                solver: solver?,
                domain: domain?,
                tolerance: tolerance?,
                bound: bound?,
                layers: layers?,
            };
            let functions = functions(family?, shape?, search_energy?);
            fits.then(|| self.method(name?, (functions, interior?), &settings, raise?))?
        })();
        let fits = fits && method.as_ref().is_none_or(|method| self.fits_method(method));
        let wanted = wanted_of(&self.table, subject);
        if !fits {
            return None;
        }
        Some((method?, wanted?))
    }

    /// The method in the engine's terms; what the engine finds wrong with it is a fault of the table.
    fn method(
        &self,
        name: String,
        (functions, interior): (Functions, Interior),
        settings: &Settings,
        raise: usize,
    ) -> Option<Method> {
        let made = if self.is_triangle() {
            of_triangle(interior, settings).map(|interior| Method::triangle(name, interior))
        } else {
            of_tensor(interior, settings).map(|interior| Method::tensor(name, functions, interior))
        };
        let made = made?.and_then(|method| method.raised(raise));
        made.map_err(|fault| self.refuse(&fault)).ok()
    }

    fn refuse(&self, fault: &MethodFault) {
        self.table.faults().clash(
            (self.table.span(), "is no method"),
            format!("{}: {fault}", self.table.name()),
            "change one of its keys",
        );
    }

    /// The family of patches that `patch`, `basis` and the boundary say.
    fn family(&self) -> Option<Family> {
        let blend = match &self.patch {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(_) if self.is_triangle() => return None,
            Given::Sound(patch) => *patch.get_ref(),
        };
        let basis = match &self.basis {
            Given::Absent => None,
            Given::Faulty => return None,
            Given::Sound(basis) => Some((*basis.get_ref(), basis.span())),
        };
        if self.is_triangle() {
            return self.family_of_triangle(basis);
        }
        match (blend, basis) {
            (None, None) => Some(Family::Bernstein),
            (None, Some((basis, _))) => Some(basis.map_or(Family::Bernstein, Family::Shaped)),
            (Some(blend), None) => Some(Family::Shaped(blend)),
            (Some(blend), Some((Some(basis), _))) if basis.names().1 == blend.names().1 => {
                Some(Family::Shaped(blend))
            }
            (Some(_), Some((basis, span))) => {
                self.table.faults().clash(
                    (span, "a TB–Coons patch uses both bases"),
                    format!(
                        "{} asks for a TB–Coons patch in {}",
                        self.table.name(),
                        basis.map_or("the Bernstein basis", ShapedFamily::title)
                    ),
                    "leave out `basis`: a TB–Coons patch blends Bernstein and GT functions; for a plain Bézier patch \
                     leave out `patch`",
                );
                None
            }
        }
    }

    fn family_of_triangle(&self, basis: Option<(Option<ShapedFamily>, Range<usize>)>) -> Option<Family> {
        let Some((Some(basis), span)) = basis else { return Some(Family::Triangle) };
        self.table.faults().conflict(
            (span, "not for triangles"),
            (self.sides.header.clone(), "a triangular boundary"),
            format!("{} asks for {} on a triangle", self.table.name(), basis.title()),
            "leave out `basis`: triangular patches are Bernstein–Bézier patches",
        );
        None
    }

    /// How nearly the least area is to be reached.
    fn tolerance(&self, interior: Option<&Interior>) -> Option<f64> {
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
    fn layers(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<usize> {
        let wanted = self.table.or_default(&LAYERS, &self.layers)?;
        // Over three sides the key itself is refused.
        let span = self.layers.span().filter(|_| wanted > 0 && !self.is_triangle());
        let help = "leave it out, or write energy = \"area\" and no `basis`";
        self.is_of_least_areas((span, "layers", help), family, interior).then_some(wanted)
    }

    /// Whether a lower bound is to be proved.
    fn bound(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<bool> {
        let wanted = self.table.or_default(&BOUND, &self.bound)?;
        let span = self.bound.span().filter(|_| wanted);
        let help = "leave it out: what is proved of a least area in the Bernstein basis holds for all surfaces with the same boundary curves";
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
    fn domain(&self, interior: Option<&Interior>) -> Option<ReferenceTriangle> {
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

    fn solver(&self, family: Option<Family>, interior: Option<&Interior>) -> Option<SolverChoice> {
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

    fn search_energy(&self, shape: &Shape, interior: &Interior) -> Option<SearchEnergy> {
        let natural = match interior {
            Interior::Extremal(energy) => Some(Energy::Quadratic(*energy)),
            Interior::MetricCorrections(_) => Some(Energy::DIRICHLET),
            Interior::LeastArea => Some(Energy::Area),
            Interior::Harmonic => Some(Energy::LAPLACIAN),
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
            Given::Absent => Some(natural.unwrap_or(Energy::DIRICHLET).into()),
        }
    }
}

/// The functions of a tensor patch; of a triangle, which has one kind, they are not asked for.
fn functions(family: Family, shape: Shape, energy: SearchEnergy) -> Functions {
    match (family, shape) {
        (Family::Shaped(family), Shape::Search(mode)) => Functions::Searched { family, mode, energy },
        (_, Shape::Fixed(shape)) => Functions::Shaped(shape),
        (_, Shape::Search(_) | Shape::None) => Functions::Bernstein,
    }
}

/// The interior of a tensor net; none for a mask of triangles, which has been reported.
fn of_tensor(interior: Interior, settings: &Settings) -> Option<TensorInterior> {
    let &Settings { solver, tolerance, bound, layers, .. } = settings;
    Some(match interior {
        Interior::Extremal(energy) => TensorInterior::Extremal { energy, solver },
        Interior::MetricCorrections(steps) => TensorInterior::MetricCorrections { steps, solver },
        Interior::LeastArea => TensorInterior::LeastArea { tolerance, bound, layers },
        Interior::Mask(TriangleMask::Symmetric(alpha)) => TensorInterior::Mask { alpha },
        Interior::Mask(TriangleMask::Dirichlet | TriangleMask::Coons) => return None,
        Interior::DiscreteCoons => TensorInterior::DiscreteCoons,
        Interior::Harmonic => TensorInterior::Harmonic,
    })
}

/// The interior of a triangular net; none for a harmonic one, which has been reported.
fn of_triangle(interior: Interior, settings: &Settings) -> Option<TriangleInterior> {
    let &Settings { domain, tolerance, .. } = settings;
    Some(match interior {
        Interior::Extremal(energy) => TriangleInterior::Extremal { energy, domain },
        Interior::MetricCorrections(steps) => TriangleInterior::MetricCorrections { steps, domain },
        Interior::LeastArea => TriangleInterior::LeastArea { tolerance },
        Interior::Mask(mask) => TriangleInterior::Mask(mask),
        Interior::DiscreteCoons => TriangleInterior::DiscreteCoons,
        Interior::Harmonic => return None,
    })
}
