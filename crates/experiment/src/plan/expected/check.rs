//! `expect` and `published` tables.

use std::ops::Range;

use plateau::{Family, Quantity};
use serde_spanned::Spanned;

use super::{Expected, Published, Wanted};
use crate::diagnostic::position;
use crate::keys::expect::{self, Expectation, HEADING, PRINTED, QUANTITY, REASON, SOURCE};
use crate::keys::method::{EXPECT, PUBLISHED};
use crate::text::{Faults, Given, Table, Tables, counted, half_unit_of_last_digit};

/// What the expected numbers are about: it decides which of them exist.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Subject {
    Patch {
        family: Family,
        searched: bool,
    },
    Film,
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
        use Quantity as Q;
        match (self, quantity) {
            (Self::Curve { .. }, Q::Curvature(_)) => None,
            (Self::Curve { .. }, _) => Some("the result of a curve has only `curvature`: take the key out"),
            (_, Q::Curvature(_)) => Some(
                "`curvature` is for [curve] experiments; surfaces have `mean-curvature-max`: take the key out",
            ),
            (
                Self::Helicoid,
                Q::Shape(_) | Q::SearchMinimum | Q::BoundaryDeviation | Q::HarmonicBound | Q::Residual,
            ) => Some(
                "a helicoid has neither boundary curves nor shape parameters to compare, only `deviation`: take the key out",
            ),
            (Self::Net, Q::Shape(_) | Q::SearchMinimum | Q::Residual | Q::Deviation) => Some(
                "of a net that is given nothing is solved or searched, and no closed form is known: take the key out",
            ),
            (
                Self::Film,
                Q::Residual
                | Q::BoundaryDeviation
                | Q::HarmonicBound
                | Q::Deviation
                | Q::Shape(_)
                | Q::SearchMinimum,
            ) => Some(
                "surfaces over loops and faces have energies, area and curvatures only: take the key out",
            ),
            (Self::Patch { .. }, Q::Deviation) => {
                Some("`deviation` is for helicoids: write `boundary-deviation`, or take the key out")
            }
            (Self::Patch { family, .. }, Q::Shape(_)) if family.parameters().is_empty() => {
                Some("the Bernstein basis has no shape parameters: take the key out, or write basis = \"gt\"")
            }
            (Self::Patch { searched: false, .. }, Q::SearchMinimum) => {
                Some("this method searches nothing: add search = true, or take the key out")
            }
            (Self::Patch { family: Family::Triangle, .. }, Q::BoundaryDeviation | Q::HarmonicBound) => {
                Some("only tensor patches have this figure: take the key out")
            }
            _ => None,
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
            Self::Patch { .. } | Self::Film | Self::Helicoid | Self::Net => None,
        }
    }
}

/// Checks the top-level `expect` table.
pub(crate) fn wanted(given: Given<Table<'_>>, subject: Option<Subject>) -> Option<Wanted> {
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
pub(crate) fn expectations(given: Given<Table<'_>>, subject: Option<Subject>) -> Option<Vec<Expected>> {
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
