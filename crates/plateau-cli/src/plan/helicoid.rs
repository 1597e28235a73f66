//! `[helicoid]` and `[trapezium-helicoid]`.

use std::ops::RangeInclusive;

use serde_spanned::Spanned;

use super::Wanted;
use super::check::{Check, Table, top};
use super::expected::check::{Subject, expected};
use super::number::{counted, shown};
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{ExpectSpec, HelicoidSpec, Key, Number, NumberList, Section, TrapeziumSpec};
use plateau::{Deformation, DeformationPath, Helicoid, MAX_DEGREE, TrapeziumHelicoid};

/// Largest weight: with cosh u ≤ cosh 100 the squares of area densities stay below overflow.
const LARGEST_WEIGHT: f64 = 1e30;

/// The larger weight is at least this: the fourth powers of lengths stay above underflow.
const SMALLEST_WEIGHT: f64 = 1e-30;

/// Shortest interval: on a shorter one the surface drowns in the rounding of its coordinates, its derivatives first.
const SHORTEST: f64 = 1e-6;

/// Longest intervals: cosh u stays far below overflow, the number of patches within thousands.
const LONGEST: [f64; 2] = [100.0, 1000.0];

/// Checks `[helicoid]`.
pub(super) fn helicoid(
    check: &mut Check<'_>,
    spec: &Spanned<Section<HelicoidSpec>>,
    expect: &Key<Section<ExpectSpec>>,
) -> Option<(Helicoid, Wanted)> {
    let table = check.table("[helicoid]", spec.span(), &top("helicoid"));
    let spec = spec.get_ref();
    let a = weight(check, &table, "a", &spec.a);
    let b = weight(check, &table, "b", &spec.b);
    let piece = surfaces::Helicoid::LARGEST_WHOLE;
    let [u_most, v_most] = LONGEST;
    let u_span = length(check, &table, "u-span", &spec.u_span, SHORTEST..=u_most, piece);
    let v_span = length(check, &table, "v-span", &spec.v_span, SHORTEST..=v_most, piece);
    let deformation = deformation(check, &table, spec);
    let expect = expectations(check, expect, Subject::Helicoid);
    if let (Some(0.0), Some(0.0), Some(key)) = (a, b, &spec.b) {
        check.inadmissible(
            key.span(),
            "[helicoid] has a = 0 and b = 0: the surface shrinks to a point",
            "a is zero, too",
            "a = 1, b = 0 is the right helicoid, a = 0, b = 1 the catenoid: make one of the two nonzero",
        );
        return None;
    }
    if let (Some(weight_a), Some(weight_b), Some(key)) = (a, b, &spec.b)
        && weight_a.abs().max(weight_b.abs()) < SMALLEST_WEIGHT
    {
        check.inadmissible(
            key.span(),
            format!("[helicoid] has a = {} and b = {}: the surface is too small", shown(weight_a), shown(weight_b)),
            "a is as small",
            "areas of so small a surface leave the range of double precision: one of the two weights must be at least 1e-30",
        );
        return None;
    }
    let helicoid = Helicoid { a: a?, b: b?, u_span: u_span?, v_span: v_span?, deformation: deformation? };
    Some((helicoid, expect?))
}

fn weight(check: &mut Check<'_>, table: &Table, name: &str, key: &Key<Number>) -> Option<f64> {
    let help = "x = a sinh u cos v - b cosh u sin v, y = a sinh u sin v + b cosh u cos v, z = a v + b u: give both a and b";
    let key = check.required(table, name, key, help)?;
    check.number(table, name, key, (|x| x.abs() <= LARGEST_WEIGHT, "between -1e30 and 1e30"), help)
}

fn length(
    check: &mut Check<'_>,
    table: &Table,
    name: &str,
    key: &Key<Number>,
    admitted: RangeInclusive<f64>,
    piece: f64,
) -> Option<f64> {
    let help = format!(
        "it is the length of the parameter interval [0, {name}]; beyond {piece:.3} it is cut into several patches"
    );
    let key = check.required(table, name, key, &help)?;
    let set = format!("above 0 (at least {:e}) and at most {}", admitted.start(), admitted.end());
    check.number(table, name, key, (|x| admitted.contains(&x), &set), &help)
}

/// `None` if faulty; `Some(None)` if there is none.
fn deformation(check: &mut Check<'_>, table: &Table, spec: &HelicoidSpec) -> Option<Option<Deformation>> {
    let names =
        [("trigonometric", Path::Trigonometric), ("linear", Path::Linear), ("bernstein", Path::Bernstein)];
    let path = match &spec.path {
        Some(key) => check.choice(table, "path", key, &names),
        None => Some(Path::Trigonometric),
    };
    let path = path.and_then(|path| with_degree(check, table, path, spec));
    match (&spec.frames, &spec.path) {
        (Some(frames), _) => {
            let help = "it is the number of surfaces from (a, b) = (1, 0) to (0, 1), both ends included";
            let frames = check.count(table, "frames", frames, 2..=1000, help)?;
            Some(Some(Deformation { frames, path: path? }))
        }
        (None, Some(key)) => {
            if !table.damaged {
                check.report(
                    Diagnostic::at(
                        Fault::Conflict,
                        key.span(),
                        "[helicoid] has a `path` but no `frames`",
                        "the path of which deformation?",
                    )
                    .help("add frames = 11 for the deformation from (a, b) = (1, 0) to (0, 1), or leave out `path`"),
                );
            }
            None
        }
        (None, None) => Some(None),
    }
}

/// What `path` may name.
#[derive(Clone, Copy)]
enum Path {
    Trigonometric,
    Linear,
    Bernstein,
}

/// The path with its degree, which only one kind has.
fn with_degree(
    check: &mut Check<'_>,
    table: &Table,
    path: Path,
    spec: &HelicoidSpec,
) -> Option<DeformationPath> {
    let help = "path = \"bernstein\" moves (a, b) along ((1 - λ)^n, λ^n): give the degree n, path-degree = 3";
    match (path, &spec.path_degree) {
        (Path::Bernstein, Some(key)) => {
            let degree = check.count(table, "path-degree", key, 1..=MAX_DEGREE, help)?;
            Some(DeformationPath::Bernstein { degree: u32::try_from(degree).ok()? })
        }
        (Path::Bernstein, None) => {
            check.missing(table, "path-degree", help);
            None
        }
        (_, Some(key)) => {
            check.report(
                Diagnostic::at(
                    Fault::Conflict,
                    key.span(),
                    "[helicoid] has a `path-degree`, but its path has no degree",
                    "not for this path",
                )
                .help("write path = \"bernstein\" for ((1 - λ)^n, λ^n), or leave out `path-degree`"),
            );
            None
        }
        (Path::Trigonometric, None) => Some(DeformationPath::Trigonometric),
        (Path::Linear, None) => Some(DeformationPath::Linear),
    }
}

/// Checks `[trapezium-helicoid]`.
pub(super) fn trapezium(
    check: &mut Check<'_>,
    spec: &Spanned<Section<TrapeziumSpec>>,
    expect: &Key<Section<ExpectSpec>>,
) -> Option<(TrapeziumHelicoid, Wanted)> {
    let table = check.table("[trapezium-helicoid]", spec.span(), &top("trapezium-helicoid"));
    let spec = spec.get_ref();
    let piece = surfaces::TrapeziumHelicoid::LARGEST_WHOLE;
    let span = length(check, &table, "span", &spec.span, SHORTEST..=LONGEST[1], piece);
    let gamma = pair(check, &table, "gamma", &spec.gamma);
    let beta = pair(check, &table, "beta", &spec.beta);
    let expect = expectations(check, expect, Subject::Helicoid);
    let (span, gamma, beta) = (span?, gamma?, beta?);
    let at_start = gamma[1] - gamma[0];
    let at_end = (gamma[1] + beta[1] * span) - (gamma[0] + beta[0] * span);
    let crossed = (at_start < 0.0 && at_end > 0.0) || (at_start > 0.0 && at_end < 0.0);
    let apart = at_start.abs().max(at_end.abs());
    if crossed || apart < SMALLEST_WEIGHT {
        let what = if apart < SMALLEST_WEIGHT {
            "the two sides of [trapezium-helicoid] coincide".to_owned()
        } else {
            let v = -at_start / (beta[1] - beta[0]);
            format!("the two sides of [trapezium-helicoid] cross at v = {}", shown(v))
        };
        let (Some(gamma), Some(beta)) = (&spec.gamma, &spec.beta) else { return None };
        check.conflict(
            (beta.span(), "slopes β0, β1"),
            (gamma.span(), "offsets γ0, γ1"),
            what,
            "w runs from γ0 + β0 v to γ1 + β1 v: choose sides that keep apart for 0 < v < span",
        );
        return None;
    }
    Some((TrapeziumHelicoid { span, gamma, beta }, expect?))
}

fn pair(check: &mut Check<'_>, table: &Table, name: &str, key: &Key<NumberList>) -> Option<[f64; 2]> {
    let help = format!("write {name} = [first side, second side]: w runs from γ0 + β0 v to γ1 + β1 v");
    let key = check.required(table, name, key, &help)?;
    let [first, second] = key.get_ref().0.as_slice() else {
        let length = key.get_ref().0.len();
        check.inadmissible(
            key.span(),
            format!("`{name}` in {} has {} instead of 2", table.name, counted(length, "number")),
            counted(length, "number"),
            help,
        );
        return None;
    };
    let admitted = || (|x: f64| x.abs() <= LARGEST_WEIGHT, "between -1e30 and 1e30");
    let first = check.number(table, name, first, admitted(), &help);
    let second = check.number(table, name, second, admitted(), &help);
    Some([first?, second?])
}

/// The top-level `[expect]`.
pub(super) fn expectations(
    check: &mut Check<'_>,
    key: &Key<Section<ExpectSpec>>,
    subject: Subject,
) -> Option<Wanted> {
    let Some(key) = key else { return Some(Wanted::default()) };
    let table = check.table("[expect]", key.span(), &top("expect"));
    let expect = expected(check, &table, key.get_ref(), subject)?;
    Some(Wanted { expect, published: Vec::new() })
}
