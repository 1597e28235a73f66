//! `[curve]`.

use std::ops::{Range, RangeInclusive};

use bases::{Aht, At};
use plateau::{Curve, CurveBasis, MAX_DEGREE};
use serde_spanned::Spanned;

use super::Wanted;
use super::expected::check::{Subject, wanted};
use super::shape::shape_of_curve;
use crate::keys::curve::{BASIS, Family, POINTS, SAMPLES, SHAPE, SPAN, Sampling};
use crate::text::{Given, Interval, PointList, Table, counted, shown};

/// Checks `[curve]`.
pub(super) fn curve(table: &Table<'_>, expect: Given<Table<'_>>) -> Option<(Curve, Wanted)> {
    let family = table.require(&BASIS);
    let shape = table.take(&SHAPE);
    let span = table.take(&SPAN);
    let points = table.require(&POINTS);
    let samples = table.take(&SAMPLES);
    let basis = family.as_ref().and_then(|family| basis(table, family, &shape, &span));
    let points = points.filter(|points| match &family {
        Some(family) => is_number_of_points(table, points, *family.get_ref()),
        None => true,
    });
    let samples = basis.and_then(|basis| parameters(table, &samples, basis.domain()));
    let subject = samples.as_ref().map(|samples| Subject::Curve { samples: samples.len() });
    let wanted = wanted(expect, subject);
    let PointList { points, dimension, .. } = points?.into_inner();
    let points = points.into_iter().map(Spanned::into_inner).collect();
    Some((Curve { basis: basis?, points, dimension, samples: samples? }, wanted?))
}

fn basis(
    table: &Table<'_>,
    family: &Spanned<Family>,
    shape: &Given<Vec<Spanned<f64>>>,
    span: &Given<f64>,
) -> Option<CurveBasis> {
    let has = |key: &'static str| table.place(&[key]).map(|span| (key, span));
    let superfluous = match family.get_ref() {
        Family::Bernstein => has("shape").or(has("span")),
        Family::Gt => has("span"),
        Family::Aht | Family::At => has("shape"),
    };
    if let Some((key, place)) = superfluous {
        let said = table.faults().excerpt(&family.span());
        table.faults().clash(
            (place, "not for this basis"),
            format!("[curve] has a `{key}`, which basis = {said} does not take"),
            "`shape` belongs to basis = \"gt\", `span` to \"aht\" and \"at\"; take the key out or change the basis",
        );
        return None;
    }
    match family.get_ref() {
        Family::Bernstein => Some(CurveBasis::Bernstein),
        Family::Gt => {
            if shape.is_absent() {
                let help = "the GT basis has two shape parameters, each in [0, 4]: shape = [1.0, 2.0]";
                table.missing("shape", help);
            }
            let Given::Sound(shape) = shape else { return None };
            Some(CurveBasis::Gt { shape: shape_of_curve(table, shape)? })
        }
        Family::Aht => length(table, span, Aht::MIN_SPAN..Aht::SUPREMUM).map(|span| CurveBasis::Aht { span }),
        Family::At => length(table, span, At::MIN_SPAN..At::SUPREMUM).map(|span| CurveBasis::At { span }),
    }
}

/// The length of the domain, below the bound of its basis.
fn length(table: &Table<'_>, span: &Given<f64>, admitted: Range<f64>) -> Option<f64> {
    let help = "the basis lives on [0, span] and becomes negative beyond this bound: split a longer curve into several";
    if span.is_absent() {
        table.missing("span", help);
    }
    let (length, place) = (*span.value()?, span.span()?);
    let interval = Interval::below(admitted.start, admitted.end);
    if interval.holds(length) {
        return Some(length);
    }
    let message = format!("`span` in [curve] must {interval}");
    table.faults().inadmissible(place, message, format!("this is {}", shown(length)), help);
    None
}

/// Whether there are as many points as the basis has functions.
fn is_number_of_points(table: &Table<'_>, points: &Spanned<PointList>, family: Family) -> bool {
    let admitted: RangeInclusive<usize> = match family {
        Family::Aht | Family::At => 6..=6,
        Family::Gt => 3..=MAX_DEGREE + 1,
        Family::Bernstein => 2..=MAX_DEGREE + 1,
    };
    let count = points.get_ref().points.len();
    if admitted.contains(&count) {
        return true;
    }
    let found = counted(count, "point");
    let help = match family {
        Family::Aht | Family::At => "give exactly 6 points: the basis has six functions",
        Family::Gt | Family::Bernstein => "give at least 3 points: the GT basis begins at degree 2",
    };
    table.faults().inadmissible(points.span(), format!("`points` in [curve] has {found}"), found, help);
    false
}

/// The parameters of the samples, all of them in the domain.
fn parameters(table: &Table<'_>, samples: &Given<Sampling>, [start, end]: [f64; 2]) -> Option<Vec<f64>> {
    let equal = |count: usize| -> Vec<f64> {
        (0..count).map(|k| start + (end - start) * (k as f64 / (count - 1) as f64)).collect()
    };
    let list = match table.or_default(&SAMPLES, samples)? {
        Sampling::Count(count) => return Some(equal(count)),
        Sampling::Parameters(list) => list,
    };
    let domain = format!("[{}, {}]", shown(start), shown(end));
    if let Some(outside) = list.iter().find(|t| !(start..=end).contains(t.get_ref())) {
        table.faults().inadmissible(
            outside.span(),
            format!("a sample of [curve] lies outside the domain {domain}: {}", shown(*outside.get_ref())),
            "outside the domain",
            format!("give a count of 2 or more, samples = 101, or a list of parameters in {domain}"),
        );
        return None;
    }
    Some(list.into_iter().map(Spanned::into_inner).collect())
}
