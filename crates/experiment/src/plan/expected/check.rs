//! `expect` and `published` tables.

use std::ops::Range;

use plateau::{Bearer, Family, Quantity, counted};
use serde_spanned::Spanned;

use super::{Expected, Published, Wanted};
use crate::diagnostic::position;
use crate::keys::expect::{self, Expectation, HEADING, PRINTED, QUANTITY, REASON, SOURCE};
use crate::keys::method::{EXPECT, PUBLISHED};
use crate::plan::interior::Interior;
use crate::text::{Faults, Given, Table, Tables, half_unit_of_last_digit};

/// What the expected numbers are about: it decides which of them exist.
#[derive(Clone, Copy, Debug)]
pub(in crate::plan) enum Subject {
    Patch {
        family: Family,
        searched: bool,
        /// None where it is faulty: then it has whatever is asked for.
        interior: Option<Interior>,
        /// Whether a bound is to be proved: none where that is faulty.
        bound: Option<bool>,
    },
    Film {
        /// Whether its area is least: none where that is faulty.
        least: Option<bool>,
        /// Whether a bound is to be proved: none where that is faulty.
        bound: Option<bool>,
        /// How many loops are spanned: none where those are faulty.
        loops: Option<usize>,
    },
    Helicoid,
    Net,
    /// As many samples in all; with several shapes, where these are listed.
    Curve {
        samples: usize,
        shapes: Option<[usize; 2]>,
    },
}

impl Subject {
    /// Why a result of this subject has no such figure, if it has none.
    fn lacks(self, quantity: Quantity) -> Option<&'static str> {
        let is_curve = matches!(self, Self::Curve { .. });
        if is_curve && quantity.bearer() != Bearer::Curve {
            return Some("the result of a curve has only `curvature`: take the key out");
        }
        match quantity.bearer() {
            Bearer::Curve => (!is_curve).then_some(
                "`curvature` is for [curve] experiments; surfaces have `mean-curvature-max`: take the key out",
            ),
            Bearer::Surface => None,
            Bearer::Spanning => self.lacks_estimate(),
            Bearer::Bounded => self.lacks_bound(),
            Bearer::Extremal(functional) => self.unless_made_by(
                |interior| interior == Interior::Extremal(functional),
                "only what minimises it has it, as its `energy`: take the key out",
            ),
            Bearer::Corrected => self.unless_made_by(
                |interior| matches!(interior, Interior::MetricCorrections(_)),
                "only metric corrections have it: add `metric-steps`, or take the key out",
            ),
            Bearer::Solved => self.unless_made_by(
                |interior| !matches!(interior, Interior::LeastArea),
                "no single linear system is solved for this surface: take the key out",
            ),
            Bearer::FourSides => match self {
                Self::Patch { family, .. } if family != Family::Triangle => None,
                Self::Patch { .. } | Self::Film { .. } | Self::Helicoid | Self::Net | Self::Curve { .. } => {
                    Some("only tensor patches over four sides have this figure: take the key out")
                }
            },
            Bearer::Closed => self.lacks_deviation(),
            Bearer::Film => (!matches!(self, Self::Film { .. }))
                .then_some("only surfaces over loops and faces have this figure: take the key out"),
            Bearer::TwoLoops => (!matches!(self, Self::Film { least: None | Some(true), loops: None | Some(2), .. }))
                .then_some("only least areas over two loops have this figure: take the key out"),
            Bearer::Even => match self {
                Self::Film { .. } => None,
                Self::Patch { .. } | Self::Helicoid | Self::Net | Self::Curve { .. } => self.unless_made_by(
                    |interior| matches!(interior, Interior::LeastArea),
                    "only least areas and surfaces over loops and faces have this figure: take the key out",
                ),
            },
            Bearer::Shaped => self.lacks_shape(false),
            Bearer::Searched => self.lacks_shape(true),
        }
    }

    /// The same of what lies above the least area.
    fn lacks_estimate(self) -> Option<&'static str> {
        match self {
            Self::Patch { .. } | Self::Film { .. } => None,
            Self::Helicoid | Self::Net | Self::Curve { .. } => Some(
                "how far an area lies above the least one is estimated only for surfaces that span a boundary: take the key out",
            ),
        }
    }

    /// The same of a proved bound.
    fn lacks_bound(self) -> Option<&'static str> {
        match self {
            Self::Patch { bound, .. } | Self::Film { bound, .. } if bound != Some(false) => None,
            Self::Patch { .. } | Self::Film { .. } | Self::Helicoid | Self::Net | Self::Curve { .. } => {
                Some("only least areas with bound = true have it: add that, or take the key out")
            }
        }
    }

    /// The same of the distance to a closed form.
    fn lacks_deviation(self) -> Option<&'static str> {
        match self {
            Self::Helicoid => None,
            Self::Net => Some("no closed form is known for a net that is given: take the key out"),
            Self::Patch { .. } | Self::Film { .. } | Self::Curve { .. } => Some(
                "`deviation` is for helicoids: write `boundary-deviation` or `rim-deviation`, or take the key out",
            ),
        }
    }

    /// The same of the shape parameters, or of what a search for them found.
    fn lacks_shape(self, found: bool) -> Option<&'static str> {
        match self {
            Self::Patch { searched: true, .. } if found => None,
            Self::Patch { .. } if found => {
                Some("this method searches nothing: add search = true, or take the key out")
            }
            Self::Patch { family, .. } if !family.parameters().is_empty() => None,
            Self::Patch { .. } => {
                Some("the Bernstein basis has no shape parameters: take the key out, or write basis = \"gt\"")
            }
            Self::Film { .. } => Some(
                "surfaces over loops and faces have energies, area and curvatures, and no shape parameters: take the key out",
            ),
            Self::Helicoid => Some(
                "a helicoid has no shape parameters to compare, only its `deviation` from the closed form: take the key out",
            ),
            Self::Net | Self::Curve { .. } => {
                Some("what is given here has no shape parameters to compare or to search: take the key out")
            }
        }
    }

    /// `reason`, but for patches whose interior is made in a way that has the figure.
    fn unless_made_by(self, has: impl Fn(Interior) -> bool, reason: &'static str) -> Option<&'static str> {
        match self {
            Self::Patch { interior, .. } if interior.is_none_or(has) => None,
            Self::Patch { .. } | Self::Film { .. } | Self::Helicoid | Self::Net | Self::Curve { .. } => {
                Some(reason)
            }
        }
    }

    /// How many numbers a quantity with an index has.
    fn length(self, quantity: Quantity) -> Option<usize> {
        match (self, quantity) {
            (Self::Patch { family, .. }, Quantity::Shape(_)) => Some(family.parameters().len()),
            (Self::Curve { samples, .. }, Quantity::Curvature(_)) => Some(samples),
            _ => None,
        }
    }

    /// Where that number comes from besides.
    fn counted_by(self) -> Option<Range<usize>> {
        match self {
            Self::Curve { shapes, .. } => shapes.map(|[start, end]| start..end),
            Self::Patch { .. } | Self::Film { .. } | Self::Helicoid | Self::Net => None,
        }
    }
}

/// Checks the top-level `expect` table.
pub(in crate::plan) fn wanted(given: Given<Table<'_>>, subject: Option<Subject>) -> Option<Wanted> {
    expectations(given, subject).map(|expect| Wanted { expect, published: Vec::new() })
}

/// Checks what a method wants of its figures.
pub(in crate::plan) fn wanted_of(method: &Table<'_>, subject: Option<Subject>) -> Option<Wanted> {
    let expect = expectations(method.inner(&EXPECT).map(|table| of(method, table)), subject);
    let published = match method.one_or_several(&PUBLISHED) {
        Given::Absent => Some(Vec::new()),
        Given::Faulty => None,
        Given::Sound(tables) => match tables.into_inner() {
            Tables::One(table) => published([of(method, table)]),
            Tables::Several(tables) => published(tables.into_iter().map(|table| of(method, table))),
        },
    };
    Some(Wanted { expect: expect?, published: published? })
}

/// A table inside, called after its method.
fn of<'t>(method: &Table<'_>, inner: Table<'t>) -> Table<'t> {
    let called = format!("{} of {}", inner.name(), method.name());
    inner.called(called)
}

/// Checks an `expect` table, if there is one.
pub(in crate::plan) fn expectations(
    given: Given<Table<'_>>,
    subject: Option<Subject>,
) -> Option<Vec<Expected>> {
    match given {
        Given::Absent => Some(Vec::new()),
        Given::Faulty => None,
        Given::Sound(table) => expected(table.get_ref(), subject),
    }
}

/// Checks an `expect` table. One number for a quantity with several means each of them. Where the subject is unknown, only
/// the numbers themselves are looked at.
fn expected(table: &Table<'_>, subject: Option<Subject>) -> Option<Vec<Expected>> {
    let mut numbers = Vec::new();
    let mut is_sound = true;
    for (quantity, key) in expect::figures() {
        let given = match table.take(key) {
            Given::Absent => continue,
            Given::Faulty => {
                is_sound = false;
                continue;
            }
            Given::Sound(given) => given,
        };
        let Some(subject) = subject else { continue };
        if let Some(reason) = subject.lacks(quantity) {
            table.faults().clash(
                (given.span(), "no such figure"),
                format!("{} expects `{}`, which the result will not have", table.name(), quantity.name()),
                reason,
            );
            is_sound = false;
            continue;
        }
        match entry(table, quantity, given, (subject.length(quantity), subject.counted_by())) {
            Some(entry) => numbers.extend(entry),
            None => is_sound = false,
        }
    }
    (is_sound && subject.is_some()).then_some(numbers)
}

fn entry(
    table: &Table<'_>,
    quantity: Quantity,
    given: Spanned<Expectation>,
    (length, counted_by): (Option<usize>, Option<Range<usize>>),
) -> Option<Vec<Expected>> {
    let (faults, span) = (table.faults(), given.span());
    match given.into_inner() {
        Expectation::Every(number, tolerance) => {
            let mut one = digits(faults, quantity, &number);
            one.tolerance = tolerance.unwrap_or(one.tolerance);
            let every = |k| Expected { quantity: quantity.at(k), ..one.clone() };
            Some((0..length.unwrap_or(1)).map(every).collect())
        }
        Expectation::Each(list) if Some(list.len()) == length => {
            let each = |(k, number)| digits(faults, quantity.at(k), number);
            Some(list.iter().enumerate().map(each).collect())
        }
        Expectation::Each(list) => {
            let name = quantity.name();
            let (label, help) = match length {
                Some(length) => (
                    format!("expected {length} numbers, or one"),
                    format!("write one number for all, or a list of {length}"),
                ),
                None => ("expected one number".to_owned(), format!("write one number: {name} = 1.5")),
            };
            let message =
                format!("`{name}` in {} is a list of {}", table.name(), counted(list.len(), "number"));
            match counted_by {
                Some(shapes) => {
                    faults.conflict((span, &label), (shapes, "a curve for each of these"), message, help)
                }
                None => faults.inadmissible(span, message, label, help),
            }
            None
        }
    }
}

/// A number that is to be met to the digits written.
fn digits(faults: &Faults<'_>, quantity: Quantity, number: &Spanned<f64>) -> Expected {
    let text = faults.excerpt(&number.span()).to_owned();
    let (line, _) = position(faults.text(), number.span().start);
    Expected { quantity, value: *number.get_ref(), tolerance: half_unit_of_last_digit(&text), text, line }
}

/// Checks the `published` tables of a method.
pub(crate) fn published<'t>(tables: impl IntoIterator<Item = Table<'t>>) -> Option<Vec<Published>> {
    let read: Vec<Option<Published>> = tables.into_iter().map(|table| one(&table)).collect();
    read.into_iter().collect()
}

fn one(table: &Table<'_>) -> Option<Published> {
    let source = table.require(&SOURCE);
    let quantity = table.require(&QUANTITY);
    let heading = table.take(&HEADING).known();
    let printed = table.require(&PRINTED);
    let reason = table.take(&REASON).known();
    let quantity = quantity?.into_inner();
    let Expected { value, tolerance, text, line, .. } = digits(table.faults(), quantity, &printed?);
    Some(Published {
        source: source?.into_inner(),
        quantity,
        heading: heading?.map(Spanned::into_inner),
        printed: value,
        tolerance,
        text,
        reason: reason?.map(Spanned::into_inner),
        line,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Entry;

    #[test]
    fn every_figure_has_a_key_of_its_name() {
        for (quantity, key) in expect::figures() {
            assert_eq!(quantity.name(), key.head().name);
        }
    }
}
