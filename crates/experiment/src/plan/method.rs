//! `[[method]]`: keys that fit together, and the boundary they are for.

use std::collections::HashMap;
use std::ops::Range;

use plateau::{
    Energy, Family, Functions, Method, MethodFault, SearchEnergy, TensorInterior, TriangleInterior,
    TriangleMask,
};

use super::Wanted;
use super::boundary::{Kind, Sides};
use super::draft::Draft;
use super::expected::check::{Subject, wanted_of};
use super::interior::Interior;
use super::settings::Settings;
use super::shape::Shape;
use crate::diagnostic::shorten;
use crate::keys::method::{NAME, TENSOR, TRIANGLE};
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
