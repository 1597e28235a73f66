//! `[helicoid]` and `[trapezium-helicoid]`.

use plateau::{Construction, DeformationPath, Helicoid};
use serde_spanned::Spanned;
use surfaces::TrapeziumHelicoid;

use super::Wanted;
use super::built::built;
use super::expected::check::{Subject, wanted};
use crate::keys::helicoid::trapezium::{BETA, CONSTRUCTION, GAMMA, SPAN};
use crate::keys::helicoid::{A, B, FRAMES, PATH, PATH_DEGREE, Path, SMALLEST_WEIGHT, U_SPAN, V_SPAN};
use crate::text::{Given, Table, shown};

/// Checks `[helicoid]`.
pub(super) fn helicoid(table: &Table<'_>, expect: Given<Table<'_>>) -> Option<(Helicoid, Wanted)> {
    let (a, b) = (table.require(&A), table.require(&B));
    let (u_span, v_span) = (table.require(&U_SPAN), table.require(&V_SPAN));
    let deformation = deformation(table);
    let wanted = wanted(expect, Some(Subject::Helicoid));
    let (a, b) = (a?, b?);
    if !is_large_enough(table, &a, &b) {
        return None;
    }
    let (u_span, v_span) = (u_span?.into_inner(), v_span?.into_inner());
    let form = surfaces::Helicoid::new(a.into_inner(), b.into_inner(), u_span, v_span);
    let helicoid = Helicoid::new(built(table, table.span(), form)?);
    let helicoid = match deformation? {
        Some((frames, path)) => built(table, table.span(), helicoid.deformed(frames, path))?,
        None => helicoid,
    };
    Some((helicoid, wanted?))
}

fn is_large_enough(table: &Table<'_>, a: &Spanned<f64>, b: &Spanned<f64>) -> bool {
    let (a, b, place) = (*a.get_ref(), *b.get_ref(), b.span());
    if a == 0.0 && b == 0.0 {
        table.faults().inadmissible(
            place,
            "[helicoid] has a = 0 and b = 0: the surface shrinks to a point",
            "a is zero, too",
            "a = 1, b = 0 is the right helicoid, a = 0, b = 1 the catenoid: make one of the two nonzero",
        );
        return false;
    }
    if a.abs().max(b.abs()) < SMALLEST_WEIGHT {
        table.faults().inadmissible(
            place,
            format!("[helicoid] has a = {} and b = {}: the surface is too small", shown(a), shown(b)),
            "a is as small",
            "areas of so small a surface leave the range of double precision: one of the two weights must be at least 1e-30",
        );
        return false;
    }
    true
}

/// `None` if faulty; `Some(None)` if there is none.
fn deformation(table: &Table<'_>) -> Option<Option<(usize, DeformationPath)>> {
    let frames = table.take(&FRAMES);
    let given_path = table.take(&PATH);
    let degree = table.take(&PATH_DEGREE);
    let path = table.or_default(&PATH, &given_path).and_then(|path| with_degree(table, path, &degree));
    match (frames, given_path) {
        (Given::Faulty, _) => None,
        (Given::Sound(frames), _) => Some(Some((frames.into_inner(), path?))),
        (Given::Absent, Given::Absent) => path.map(|_| None),
        (Given::Absent, Given::Faulty) => None,
        (Given::Absent, Given::Sound(path)) => {
            table.faults().clash(
                (path.span(), "the path of which deformation?"),
                "[helicoid] has a `path` but no `frames`",
                "add frames = 11 for the deformation from (a, b) = (1, 0) to (0, 1), or leave out `path`",
            );
            None
        }
    }
}

/// The path with its degree, which only one kind has.
fn with_degree(table: &Table<'_>, path: Path, degree: &Given<u32>) -> Option<DeformationPath> {
    match (path, degree) {
        (_, Given::Faulty) => None,
        (Path::Bernstein, Given::Sound(degree)) => {
            Some(DeformationPath::Bernstein { degree: *degree.get_ref() })
        }
        (Path::Bernstein, Given::Absent) => {
            let help = "path = \"bernstein\" moves (a, b) along ((1 - λ)^n, λ^n): give the degree n, path-degree = 3";
            table.missing("path-degree", help);
            None
        }
        (Path::Trigonometric | Path::Linear, Given::Sound(degree)) => {
            table.faults().clash(
                (degree.span(), "not for this path"),
                "[helicoid] has a `path-degree`, but its path has no degree",
                "write path = \"bernstein\" for ((1 - λ)^n, λ^n), or leave out `path-degree`",
            );
            None
        }
        (Path::Trigonometric, Given::Absent) => Some(DeformationPath::Trigonometric),
        (Path::Linear, Given::Absent) => Some(DeformationPath::Linear),
    }
}

/// Checks `[trapezium-helicoid]`.
pub(super) fn trapezium(
    table: &Table<'_>,
    expect: Given<Table<'_>>,
) -> Option<((TrapeziumHelicoid, Construction), Wanted)> {
    let span = table.require(&SPAN);
    let (gamma, beta) = (table.require(&GAMMA), table.require(&BETA));
    let construction = table.take_or_default(&CONSTRUCTION);
    let wanted = wanted(expect, Some(Subject::Helicoid));
    let (span, gamma, beta) = (span?.into_inner(), gamma?, beta?);
    let places = (beta.span(), gamma.span());
    let (gamma, beta) = (pair(&gamma)?, pair(&beta)?);
    let at_start = gamma[1] - gamma[0];
    let at_end = (gamma[1] + beta[1] * span) - (gamma[0] + beta[0] * span);
    let is_crossed = (at_start < 0.0 && at_end > 0.0) || (at_start > 0.0 && at_end < 0.0);
    let apart = at_start.abs().max(at_end.abs());
    if is_crossed || apart < SMALLEST_WEIGHT {
        let what = if apart < SMALLEST_WEIGHT {
            "the two sides of [trapezium-helicoid] coincide".to_owned()
        } else {
            let v = -at_start / (beta[1] - beta[0]);
            format!("the two sides of [trapezium-helicoid] cross at v = {}", shown(v))
        };
        table.faults().conflict(
            (places.0, "slopes β0, β1"),
            (places.1, "offsets γ0, γ1"),
            what,
            "w runs from γ0 + β0 v to γ1 + β1 v: choose sides that keep apart for 0 < v < span",
        );
        return None;
    }
    let helicoid = built(table, table.span(), TrapeziumHelicoid::new(span, gamma, beta))?;
    Some(((helicoid, construction?), wanted?))
}

fn pair(numbers: &Spanned<Vec<Spanned<f64>>>) -> Option<[f64; 2]> {
    let values: Vec<f64> = numbers.get_ref().iter().map(|number| *number.get_ref()).collect();
    values.try_into().ok()
}
