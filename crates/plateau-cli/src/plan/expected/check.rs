//! `expect` and `published` tables.

use std::ops::Range;

use serde_spanned::Spanned;

use super::{Expected, Published};
use crate::diagnostic::{Diagnostic, Fault, position};
use crate::plan::check::{Check, Table, top};
use crate::plan::number::{counted, half_unit_of_last_digit, shown};
use crate::spec::{self, ExpectSpec, ExpectValue, Key, Number, PublishedSpec, Section, Step, TolerancedSpec};
use plateau::{Patch, Quantity, Shape};

/// What the expected numbers are about: it decides which of them exist.
#[derive(Clone, Copy, Debug)]
pub(in crate::plan) enum Subject {
    Patch { patch: Patch, shape: Shape },
    Helicoid,
    Curve { samples: usize },
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
            (Self::Patch { .. }, Q::Deviation) => {
                Some("`deviation` is for helicoids: write `boundary-deviation`, or take the key out")
            }
            (Self::Patch { shape: Shape::None, .. }, Q::Shape(_)) => {
                Some("the Bernstein basis has no shape parameters: take the key out, or write basis = \"gt\"")
            }
            (Self::Patch { shape: Shape::None | Shape::Fixed(_), .. }, Q::SearchMinimum) => {
                Some("this method searches nothing: add search = true, or take the key out")
            }
            (Self::Patch { patch: Patch::Triangle, .. }, Q::BoundaryDeviation | Q::HarmonicBound) => {
                Some("only tensor patches have this figure: take the key out")
            }
            _ => None,
        }
    }

    /// How many numbers a quantity with an index has.
    fn length(self, quantity: Quantity) -> Option<usize> {
        match (self, quantity) {
            (_, Quantity::Shape(_)) => Some(4),
            (Self::Curve { samples }, Quantity::Curvature(_)) => Some(samples),
            _ => None,
        }
    }
}

fn with_index(quantity: Quantity, index: usize) -> Quantity {
    match quantity {
        Quantity::Shape(_) => Quantity::Shape(index),
        Quantity::Curvature(_) => Quantity::Curvature(index),
        other => other,
    }
}

fn entries(spec: &ExpectSpec) -> [(Quantity, &Key<ExpectValue>); 14] {
    [
        (Quantity::Dirichlet, &spec.dirichlet),
        (Quantity::Area, &spec.area),
        (Quantity::LaplacianDefect, &spec.laplacian_defect),
        (Quantity::Bending, &spec.bending),
        (Quantity::ConformalityGap, &spec.conformality_gap),
        (Quantity::MeanCurvatureMax, &spec.mean_curvature_max),
        (Quantity::MeanCurvatureRms, &spec.mean_curvature_rms),
        (Quantity::Residual, &spec.residual),
        (Quantity::BoundaryDeviation, &spec.boundary_deviation),
        (Quantity::HarmonicBound, &spec.harmonic_bound),
        (Quantity::Deviation, &spec.deviation),
        (Quantity::Shape(0), &spec.shape),
        (Quantity::SearchMinimum, &spec.search_minimum),
        (Quantity::Curvature(0), &spec.curvature),
    ]
}

/// Checks an `expect` table. One number for a quantity with several means each of them.
pub(in crate::plan) fn expected(
    check: &mut Check<'_>,
    table: &Table,
    spec: &ExpectSpec,
    subject: Subject,
) -> Option<Vec<Expected>> {
    let mut numbers = Vec::new();
    let mut sound = true;
    for (quantity, key) in entries(spec) {
        let Some(key) = key else { continue };
        if let Some(reason) = subject.lacks(quantity) {
            check.report(
                Diagnostic::at(
                    Fault::Conflict,
                    key.span(),
                    format!("{} expects `{}`, which the result will not have", table.name, quantity.name()),
                    "no such figure",
                )
                .help(reason),
            );
            sound = false;
            continue;
        }
        match entry(check, table, quantity, key, subject) {
            Some(entry) => numbers.extend(entry),
            None => sound = false,
        }
    }
    sound.then_some(numbers)
}

fn entry(
    check: &mut Check<'_>,
    table: &Table,
    quantity: Quantity,
    key: &Spanned<ExpectValue>,
    subject: Subject,
) -> Option<Vec<Expected>> {
    let name = quantity.name();
    let length = subject.length(quantity);
    let every = |number: Expected| -> Vec<Expected> {
        (0..length.unwrap_or(1))
            .map(|k| Expected { quantity: with_index(quantity, k), ..number.clone() })
            .collect()
    };
    match key.get_ref() {
        ExpectValue::Number(value) => number(check, table, quantity, *value, key.span()).map(every),
        ExpectValue::Toleranced(spec) => toleranced(check, table, quantity, spec, key.span()).map(every),
        ExpectValue::List(list) if Some(list.len()) == length => {
            let numbers: Vec<Expected> = list
                .iter()
                .enumerate()
                .filter_map(|(k, n)| number(check, table, with_index(quantity, k), n.get_ref().0, n.span()))
                .collect();
            (numbers.len() == list.len()).then_some(numbers)
        }
        ExpectValue::List(list) => {
            let help = match length {
                Some(length) => format!("write one number for all, or a list of {length}"),
                None => format!("write one number: {name} = 1.5"),
            };
            check.inadmissible(
                key.span(),
                format!("`{name}` in {} is a list of {}", table.name, counted(list.len(), "number")),
                length.map_or("expected one number".to_owned(), |length| {
                    format!("expected {length} numbers, or one")
                }),
                help,
            );
            None
        }
    }
}

fn number(
    check: &mut Check<'_>,
    table: &Table,
    quantity: Quantity,
    value: f64,
    span: Range<usize>,
) -> Option<Expected> {
    let text = check.text.get(span.clone()).unwrap_or_default().to_owned();
    if !value.is_finite() {
        check.inadmissible(
            span,
            format!("`{}` in {} must be finite", quantity.name(), table.name),
            format!("this is {}", shown(value)),
            "expect an ordinary number, with as many digits as the result must reproduce",
        );
        return None;
    }
    let (line, _) = position(check.text, span.start);
    Some(Expected { quantity, value, tolerance: half_unit_of_last_digit(&text), text, line })
}

fn toleranced(
    check: &mut Check<'_>,
    table: &Table,
    quantity: Quantity,
    spec: &TolerancedSpec,
    span: Range<usize>,
) -> Option<Expected> {
    let name = quantity.name();
    let form = format!(
        "write {name} = {{ value = 38.0, tolerance = 0.05 }}, or the number alone to have its digits decide"
    );
    let inner = check.inner(table, format!("`{name}` in {}", table.name), span, &top(name));
    let value = check.required(&inner, "value", &spec.value, &form);
    let tolerance = check.required(&inner, "tolerance", &spec.tolerance, &form);
    let value = value.and_then(|key| number(check, table, quantity, key.get_ref().0, key.span()));
    let nonnegative = (|x| x >= 0.0, "0 or positive");
    let tolerance = tolerance.and_then(|key| check.number(&inner, "tolerance", key, nonnegative, &form));
    Some(Expected { tolerance: tolerance?, ..value? })
}

/// Checks the `published` tables of a method.
pub(in crate::plan) fn published(
    check: &mut Check<'_>,
    method: &Table,
    key: &Spanned<spec::Published>,
) -> Option<Vec<Published>> {
    let (found, count): (Vec<Published>, usize) = match key.get_ref() {
        spec::Published::One(spec) => (one(check, method, spec, key.span(), None).into_iter().collect(), 1),
        spec::Published::Several(specs) => {
            let read = |(k, spec): (usize, &Spanned<Section<PublishedSpec>>)| {
                one(check, method, spec.get_ref(), spec.span(), Some(k))
            };
            (specs.iter().enumerate().filter_map(read).collect(), specs.len())
        }
    };
    (found.len() == count).then_some(found)
}

fn one(
    check: &mut Check<'_>,
    method: &Table,
    spec: &PublishedSpec,
    span: Range<usize>,
    index: Option<usize>,
) -> Option<Published> {
    let steps = [top("published"), index.map(Step::Index).into_iter().collect()].concat();
    let table = check.inner(method, format!("[method.published] of {}", method.name), span, &steps);
    let source_help = "say where the number is printed: source = \"GT Table 1\"";
    let source = check
        .required(&table, "source", &spec.source, source_help)
        .and_then(|key| check.name(&table, "source", key, source_help));
    let quantity_help = "say which of our figures the printed number is: quantity = \"dirichlet\"";
    let names: Vec<(&str, Quantity)> = entries(&ExpectSpec::default()).map(|(q, _)| (q.name(), q)).to_vec();
    let quantity = check
        .required(&table, "quantity", &spec.quantity, quantity_help)
        .and_then(|key| check.choice(&table, "quantity", key, &names));
    let printed_help = "give the number with the digits it has in print: printed = 38.0000";
    let printed = check
        .required(&table, "printed", &spec.printed, printed_help)
        .and_then(|key| printed_number(check, &table, key, printed_help));
    let text = |key: &Key<spec::Text>| key.as_ref().map(|key| key.get_ref().0.clone());
    let (printed, text_printed, line) = printed?;
    Some(Published {
        source: source?,
        quantity: quantity?,
        heading: text(&spec.heading),
        printed,
        tolerance: half_unit_of_last_digit(&text_printed),
        text: text_printed,
        reason: text(&spec.reason),
        line,
    })
}

fn printed_number(
    check: &mut Check<'_>,
    table: &Table,
    key: &Spanned<Number>,
    help: &str,
) -> Option<(f64, String, usize)> {
    let value = check.number(table, "printed", key, (|_| true, "finite"), help)?;
    let text = check.text.get(key.span()).unwrap_or_default().to_owned();
    let (line, _) = position(check.text, key.span().start);
    Some((value, text, line))
}
