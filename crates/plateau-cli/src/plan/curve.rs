//! `[curve]`.

use std::ops::Range;

use bases::{Aht, At};
use serde_spanned::Spanned;

use super::Wanted;
use super::boundary::points;
use super::check::{Check, Table, top};
use super::expected::check::Subject;
use super::helicoid::expectations;
use super::number::{counted, shown};
use super::shape::shape_parameters;
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{CurveSpec, ExpectSpec, Key, Samples, Section};
use plateau::{Curve, CurveBasis, MAX_DEGREE};

/// Largest |coordinate| of a point: its square stays finite. Derivatives that do not are told apart when they are computed.
const LARGEST_COORDINATE: f64 = 1e150;

/// Most samples of a curve.
const MOST_SAMPLES: usize = 100_000;

/// Samples of a curve that does not say how many.
const SAMPLES: usize = 101;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Family {
    Bernstein,
    Gt,
    Aht,
    At,
}

/// Checks `[curve]`.
pub(super) fn curve(
    check: &mut Check<'_>,
    spec: &Spanned<Section<CurveSpec>>,
    expect: &Key<Section<ExpectSpec>>,
) -> Option<(Curve, Wanted)> {
    let table = check.table("[curve]", spec.span(), &top("curve"));
    let spec = spec.get_ref();
    let names =
        [("bernstein", Family::Bernstein), ("gt", Family::Gt), ("aht", Family::Aht), ("at", Family::At)];
    let basis_help = "write basis = \"bernstein\", \"gt\", \"aht\" or \"at\"";
    let family = check
        .required(&table, "basis", &spec.basis, basis_help)
        .and_then(|key| check.choice(&table, "basis", key, &names));
    let basis = family.and_then(|family| basis(check, &table, spec, family));
    let points_help = "give the control points: points = [[0, 0], [1, 2], [3, 2], [4, 0]]";
    let control = check.required(&table, "points", &spec.points, points_help).and_then(|key| {
        let admitted = match family {
            Some(Family::Aht | Family::At) => 6..=6,
            Some(Family::Gt) => 3..=MAX_DEGREE + 1,
            Some(Family::Bernstein) | None => 2..=MAX_DEGREE + 1,
        };
        let control = points(check, "`points` in [curve]", key, &[2, 3], admitted, LARGEST_COORDINATE)?;
        let dimension = common_dimension(check, spec)?;
        Some((control, dimension))
    });
    let samples = basis.and_then(|basis| samples(check, &table, spec, basis.domain()));
    let expect = match &samples {
        Some(samples) => expectations(check, expect, Subject::Curve { samples: samples.len() }),
        None => None,
    };
    let (points, dimension) = control?;
    Some((Curve { basis: basis?, points, dimension, samples: samples? }, expect?))
}

fn basis(check: &mut Check<'_>, table: &Table, spec: &CurveSpec, family: Family) -> Option<CurveBasis> {
    let name = spec.basis.as_ref().map_or("", |key| key.get_ref().0.as_str());
    let superfluous = match family {
        Family::Bernstein => spec
            .shape
            .as_ref()
            .map(|key| ("shape", key.span()))
            .or(spec.span.as_ref().map(|key| ("span", key.span()))),
        Family::Gt => spec.span.as_ref().map(|key| ("span", key.span())),
        Family::Aht | Family::At => spec.shape.as_ref().map(|key| ("shape", key.span())),
    };
    if let Some((key, span)) = superfluous {
        check.report(
            Diagnostic::at(
                Fault::Conflict,
                span,
                format!("[curve] has a `{key}`, which basis = \"{name}\" does not take"),
                "not for this basis",
            )
            .help("`shape` belongs to basis = \"gt\", `span` to \"aht\" and \"at\"; take the key out or change the basis"),
        );
        return None;
    }
    match family {
        Family::Bernstein => Some(CurveBasis::Bernstein),
        Family::Gt => {
            let help = "the GT basis has two shape parameters, each in [0, 4]: shape = [1.0, 2.0]";
            let key = check.required(table, "shape", &spec.shape, help)?;
            let shape = shape_parameters(check, table, key, "shape = [theta1, theta2]")?;
            Some(CurveBasis::Gt { shape })
        }
        Family::Aht => {
            span(check, table, spec, Aht::MIN_SPAN..Aht::SUPREMUM, "").map(|span| CurveBasis::Aht { span })
        }
        Family::At => {
            span(check, table, spec, At::MIN_SPAN..At::SUPREMUM, "2π = ").map(|span| CurveBasis::At { span })
        }
    }
}

fn span(
    check: &mut Check<'_>,
    table: &Table,
    spec: &CurveSpec,
    admitted: Range<f64>,
    name_of_bound: &str,
) -> Option<f64> {
    let help = "the basis lives on [0, span] and becomes negative beyond this bound: split a longer curve into several";
    let key = check.required(table, "span", &spec.span, help)?;
    let set = format!("above 0 (at least {:e}) and below {name_of_bound}{:.9}", admitted.start, admitted.end);
    check.number(table, "span", key, (|x| admitted.contains(&x), &set), help)
}

/// The one number of coordinates all points have.
fn common_dimension(check: &mut Check<'_>, spec: &CurveSpec) -> Option<usize> {
    let list = &spec.points.as_ref()?.get_ref().0;
    let first = list.first()?;
    let dimension = first.get_ref().0.len();
    match list.iter().find(|point| point.get_ref().0.len() != dimension) {
        None => Some(dimension),
        Some(other) => {
            check.conflict(
                (other.span(), &counted(other.get_ref().0.len(), "coordinate")),
                (first.span(), &counted(dimension, "coordinate")),
                "`points` in [curve] mixes planar and space points",
                "give every point 2 coordinates (signed curvature) or every point 3",
            );
            None
        }
    }
}

fn samples(
    check: &mut Check<'_>,
    table: &Table,
    spec: &CurveSpec,
    [start, end]: [f64; 2],
) -> Option<Vec<f64>> {
    let equal = |count: usize| -> Vec<f64> {
        (0..count).map(|k| start + (end - start) * (k as f64 / (count - 1) as f64)).collect()
    };
    let help = format!(
        "give a count of 2 or more, samples = 101, or a list of parameters in [{}, {}]",
        shown(start),
        shown(end)
    );
    let Some(key) = &spec.samples else { return Some(equal(SAMPLES)) };
    match key.get_ref() {
        Samples::Count(count) => match usize::try_from(*count) {
            Ok(count) if (2..=MOST_SAMPLES).contains(&count) => Some(equal(count)),
            _ => {
                check.inadmissible(
                    key.span(),
                    format!("`samples` in {} must be a count between 2 and {MOST_SAMPLES}", table.name),
                    format!("this is {count}"),
                    help,
                );
                None
            }
        },
        Samples::Parameters(list) if list.is_empty() || list.len() > MOST_SAMPLES => {
            check.inadmissible(
                key.span(),
                format!("`samples` in {} has {} parameters", table.name, list.len()),
                format!("expected between 1 and {MOST_SAMPLES}"),
                help,
            );
            None
        }
        Samples::Parameters(list) => {
            let mut parameters = Vec::with_capacity(list.len());
            for parameter in list {
                let t = parameter.get_ref().0;
                if !(start..=end).contains(&t) {
                    check.inadmissible(
                        parameter.span(),
                        format!(
                            "a sample of {} lies outside the domain [{}, {}]: {}",
                            table.name,
                            shown(start),
                            shown(end),
                            shown(t)
                        ),
                        "outside the domain",
                        help,
                    );
                    return None;
                }
                parameters.push(t);
            }
            Some(parameters)
        }
    }
}
