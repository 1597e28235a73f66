//! `[boundary]`: points, lengths, corners.

use std::ops::Range;

use serde_spanned::Spanned;

use super::check::{Check, Table, top};
use super::number::{counted, shown, shown_point};
use crate::diagnostic::{Diagnostic, Fault};
use crate::spec::{BoundarySpec, Integer, Key, PointList, Section};
use plateau::{Boundary, MAX_COORDINATE, MAX_DEGREE, MIN_SIZE};

const SIDES_OF_A_NET: &str = "a tensor boundary has four lists of points: u0 (row i = 0), u1 (row i = m), \
     v0 (column j = 0), v1 (column j = n), with the corners repeated";
const SIDES_OF_A_TRIANGLE: &str =
    "a triangular boundary has three lists of points: ab from A to B, bc from B to C, ca from C to A";

/// Which keys a boundary uses, sound or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Tensor,
    TwoSides,
    Triangle,
}

/// What is known of a boundary: its kind as soon as the keys tell, the points only if they are sound.
pub(super) struct Sides {
    pub(super) kind: Option<Kind>,
    pub(super) header: Range<usize>,
    pub(super) boundary: Option<Boundary>,
}

/// One list of points with its key.
struct Side<'s> {
    name: &'static str,
    key: &'s Spanned<PointList>,
    points: Vec<[f64; 3]>,
}

/// Checks `[boundary]`.
pub(super) fn boundary(check: &mut Check<'_>, spec: &Spanned<Section<BoundarySpec>>) -> Sides {
    let table = check.table("[boundary]", spec.span(), &top("boundary"));
    let header = spec.span();
    let spec = spec.get_ref();
    let rows = spec.u0.is_some() || spec.u1.is_some();
    let columns = spec.v0.is_some() || spec.v1.is_some();
    let triangle = spec.ab.is_some() || spec.bc.is_some() || spec.ca.is_some();
    if triangle && (rows || columns || spec.u_degree.is_some() || spec.v_degree.is_some()) {
        mixed(check, spec);
        return Sides { kind: None, header, boundary: None };
    }
    let (kind, boundary) = match (triangle, rows, columns) {
        (true, ..) => (Some(Kind::Triangle), triangular(check, &table, spec)),
        (_, true, false) if spec.u_degree.is_some() => (Some(Kind::TwoSides), two_rows(check, &table, spec)),
        (_, false, true) if spec.v_degree.is_some() => {
            (Some(Kind::TwoSides), two_columns(check, &table, spec))
        }
        (_, false, false) => {
            empty(check, &table);
            (None, None)
        }
        _ => (Some(Kind::Tensor), tensor(check, &table, spec)),
    };
    let boundary = boundary.filter(|_| large_enough(check, spec));
    Sides { kind, header, boundary }
}

/// Whether the largest coordinate is large enough for areas to be told from 0; a boundary of zeros is told apart later.
fn large_enough(check: &mut Check<'_>, spec: &BoundarySpec) -> bool {
    let sides = [
        ("u0", &spec.u0),
        ("u1", &spec.u1),
        ("v0", &spec.v0),
        ("v1", &spec.v1),
        ("ab", &spec.ab),
        ("bc", &spec.bc),
        ("ca", &spec.ca),
    ];
    let mut largest = (0.0, String::new(), 0..0);
    for (name, key) in sides {
        for (k, point) in key.iter().flat_map(|key| &key.get_ref().0).enumerate() {
            for (axis, coordinate) in ["x", "y", "z"].iter().zip(&point.get_ref().0) {
                let size = coordinate.get_ref().0.abs();
                if size > largest.0 {
                    largest = (size, format!("{axis} of point {k} of `{name}`"), coordinate.span());
                }
            }
        }
    }
    let (size, place, span) = largest;
    if size == 0.0 || size >= MIN_SIZE {
        return true;
    }
    check.inadmissible(
        span,
        format!("the points of [boundary] are too small: the largest coordinate, {place}, is {} (points are counted from 0)", shown(size)),
        "the largest of all",
        "areas of so small a boundary leave the range of double precision: choose a smaller unit of length, in which the largest \
         coordinate is at least 1e-60",
    );
    false
}

fn empty(check: &mut Check<'_>, table: &Table) {
    if !table.damaged {
        let label = "no side of a net, no side of a triangle";
        check.report(
            Diagnostic::at(Fault::Missing, table.span.clone(), "[boundary] holds no points", label)
                .help(SIDES_OF_A_NET)
                .help(SIDES_OF_A_TRIANGLE),
        );
    }
}

fn mixed(check: &mut Check<'_>, spec: &BoundarySpec) {
    let triangle = [("ab", &spec.ab), ("bc", &spec.bc), ("ca", &spec.ca)];
    let net = [("u0", &spec.u0), ("u1", &spec.u1), ("v0", &spec.v0), ("v1", &spec.v1)];
    let degrees = [("u-degree", &spec.u_degree), ("v-degree", &spec.v_degree)];
    let of = |(name, key): (&'static str, &Key<PointList>)| key.as_ref().map(|key| (name, key.span()));
    let side = triangle.into_iter().find_map(of);
    let other = net
        .into_iter()
        .find_map(of)
        .or_else(|| degrees.into_iter().find_map(|(name, key)| key.as_ref().map(|key| (name, key.span()))));
    if let (Some((side, at)), Some((other, beside))) = (side, other) {
        check.conflict(
            (at, "a side of a triangle"),
            (beside, "belongs to a tensor net"),
            format!("[boundary] holds `{side}` of a triangle and `{other}` of a tensor net"),
            format!("keep one kind: {SIDES_OF_A_NET}; {SIDES_OF_A_TRIANGLE}"),
        );
    }
}

fn tensor(check: &mut Check<'_>, table: &Table, spec: &BoundarySpec) -> Option<Boundary> {
    let row_help = match spec.u0.is_none() && spec.u1.is_none() {
        true => format!("{SIDES_OF_A_NET}; only a harmonic net takes v0, v1 and v-degree = n instead"),
        false => SIDES_OF_A_NET.to_owned(),
    };
    let column_help = match spec.v0.is_none() && spec.v1.is_none() {
        true => format!("{SIDES_OF_A_NET}; only a harmonic net takes u0, u1 and u-degree = m instead"),
        false => SIDES_OF_A_NET.to_owned(),
    };
    let u0 = side(check, table, "u0", &spec.u0, &row_help);
    let u1 = side(check, table, "u1", &spec.u1, &row_help);
    let v0 = side(check, table, "v0", &spec.v0, &column_help);
    let v1 = side(check, table, "v1", &spec.v1, &column_help);
    let rows = same_length(check, u0.as_ref(), u1.as_ref());
    let columns = same_length(check, v0.as_ref(), v1.as_ref());
    let meet = !(rows && columns)
        || corners(
            check,
            &[u0.as_ref(), u1.as_ref(), v0.as_ref(), v1.as_ref()],
            &[
                ("P_00", (0, false), (2, false)),
                ("P_0n", (0, true), (3, false)),
                ("P_m0", (1, false), (2, true)),
                ("P_mn", (1, true), (3, true)),
            ],
            "opposite sides run in the same direction: u0 and v0 begin at one corner, v0 ends where u1 begins, u0 where v1 begins",
        );
    let agree = stated_degree(check, "u-degree", &spec.u_degree, v0.as_ref())
        & stated_degree(check, "v-degree", &spec.v_degree, u0.as_ref());
    let (u0, u1, v0, v1) = (u0?.points, u1?.points, v0?.points, v1?.points);
    (rows && columns && meet && agree).then_some(Boundary::Tensor { u0, u1, v0, v1 })
}

/// With all four sides there, a degree is no news; it must be true.
fn stated_degree(check: &mut Check<'_>, name: &str, degree: &Key<Integer>, side: Option<&Side<'_>>) -> bool {
    let (Some(degree), Some(side)) = (degree, side) else { return true };
    let true_degree = side.points.len() - 1;
    if degree.get_ref().0 == true_degree as i128 {
        return true;
    }
    check.conflict(
        (degree.span(), "the stated degree"),
        (side.key.span(), &format!("{} points, degree {true_degree}", side.points.len())),
        format!(
            "`{name}` in [boundary] is {}, but `{}` has degree {true_degree}",
            degree.get_ref().0,
            side.name
        ),
        format!("leave out `{name}`: it is needed only where the other pair of sides is not given"),
    );
    false
}

fn two_rows(check: &mut Check<'_>, table: &Table, spec: &BoundarySpec) -> Option<Boundary> {
    let help = "a harmonic net takes u0, u1 and u-degree = m; any other method takes u0, u1, v0, v1";
    let u0 = side(check, table, "u0", &spec.u0, help);
    let u1 = side(check, table, "u1", &spec.u1, help);
    let degree = free_degree(check, table, "u-degree", &spec.u_degree);
    let equal = same_length(check, u0.as_ref(), u1.as_ref());
    let (u0, u1, degree) = (u0?.points, u1?.points, degree?);
    equal.then_some(Boundary::Rows { u0, u1, degree })
}

fn two_columns(check: &mut Check<'_>, table: &Table, spec: &BoundarySpec) -> Option<Boundary> {
    let help = "a harmonic net takes v0, v1 and v-degree = n; any other method takes u0, u1, v0, v1";
    let v0 = side(check, table, "v0", &spec.v0, help);
    let v1 = side(check, table, "v1", &spec.v1, help);
    let degree = free_degree(check, table, "v-degree", &spec.v_degree);
    let equal = same_length(check, v0.as_ref(), v1.as_ref());
    let (v0, v1, degree) = (v0?.points, v1?.points, degree?);
    equal.then_some(Boundary::Columns { v0, v1, degree })
}

fn free_degree(check: &mut Check<'_>, table: &Table, name: &str, key: &Key<Integer>) -> Option<usize> {
    let key = key.as_ref()?;
    check.count(
        table,
        name,
        key,
        1..=MAX_DEGREE,
        "it is the degree of the net in the direction whose sides are not given",
    )
}

fn triangular(check: &mut Check<'_>, table: &Table, spec: &BoundarySpec) -> Option<Boundary> {
    let ab = side(check, table, "ab", &spec.ab, SIDES_OF_A_TRIANGLE);
    let bc = side(check, table, "bc", &spec.bc, SIDES_OF_A_TRIANGLE);
    let ca = side(check, table, "ca", &spec.ca, SIDES_OF_A_TRIANGLE);
    let equal = same_length(check, ab.as_ref(), bc.as_ref()) & same_length(check, ab.as_ref(), ca.as_ref());
    let meet = !equal
        || corners(
            check,
            &[ab.as_ref(), bc.as_ref(), ca.as_ref()],
            &[("A", (0, false), (2, true)), ("B", (0, true), (1, false)), ("C", (1, true), (2, false))],
            "each side begins where the one before it ends",
        );
    let (ab, bc, ca) = (ab?.points, bc?.points, ca?.points);
    (equal && meet).then_some(Boundary::Triangle { ab, bc, ca })
}

/// A list of at least two points.
fn side<'s>(
    check: &mut Check<'_>,
    table: &Table,
    name: &'static str,
    key: &'s Key<PointList>,
    help: &str,
) -> Option<Side<'s>> {
    let key = check.required(table, name, key, help)?;
    let name_in_table = format!("`{name}` in [boundary]");
    let points = points(check, &name_in_table, key, &[3], 2..=MAX_DEGREE + 1, MAX_COORDINATE)?;
    Some(Side { name, key, points })
}

/// The points of a list: lengths, number of coordinates, sizes. Planar points get z = 0.
pub(super) fn points(
    check: &mut Check<'_>,
    name: &str,
    key: &Spanned<PointList>,
    dimensions: &[usize],
    admitted: std::ops::RangeInclusive<usize>,
    largest: f64,
) -> Option<Vec<[f64; 3]>> {
    let list = &key.get_ref().0;
    let (least, most) = admitted.into_inner();
    if !(least..=most).contains(&list.len()) {
        let help = if least == most {
            format!("give exactly {least} points")
        } else if list.len() < least {
            format!("give at least {least} points: n + 1 points make degree n")
        } else {
            format!("give at most {most} points: the degree is limited to {}", most - 1)
        };
        let found = counted(list.len(), "point");
        check.inadmissible(key.span(), format!("{name} has {found}"), found, help);
        return None;
    }
    let mut points = Vec::with_capacity(list.len());
    let mut sound = true;
    for (k, point) in list.iter().enumerate() {
        let coordinates = &point.get_ref().0;
        if !dimensions.contains(&coordinates.len()) {
            let found = counted(coordinates.len(), "coordinate");
            let wanted = if dimensions.len() == 1 { "3" } else { "2 or 3" };
            let mut help = format!("write a point as [x, y, z]; this is point {k} of {name}, counted from 0");
            if coordinates.len() == 2 {
                help = format!("add the third coordinate, 0 for a planar boundary; {help}");
            }
            check.inadmissible(
                point.span(),
                format!("a point of {name} has {found} instead of {wanted}"),
                found,
                help,
            );
            return None;
        }
        let mut row = [0.0; 3];
        for (c, coordinate) in coordinates.iter().enumerate() {
            row[c] = coordinate.get_ref().0;
            if row[c].is_finite() && row[c].abs() <= largest {
                continue;
            }
            let axis = ["x", "y", "z"][c];
            let (what, help) = if row[c].is_finite() {
                (
                    "too large",
                    format!(
                        "coordinates are admitted up to {largest:e}, so that every figure stays finite: choose a larger unit of length"
                    ),
                )
            } else {
                ("not finite", "every coordinate must be an ordinary number: replace nan or inf".to_owned())
            };
            check.inadmissible(
                coordinate.span(),
                format!("{axis} of point {k} of {name} is {what} (points are counted from 0)"),
                shown(row[c]),
                help,
            );
            sound = false;
        }
        points.push(row);
    }
    sound.then_some(points)
}

/// Whether two opposite sides have the same number of points; true if one of them is unknown.
fn same_length(check: &mut Check<'_>, one: Option<&Side<'_>>, other: Option<&Side<'_>>) -> bool {
    let (Some(one), Some(other)) = (one, other) else { return true };
    if one.points.len() == other.points.len() {
        return true;
    }
    let label = |side: &Side<'_>| format!("{} points", side.points.len());
    check.report(
        Diagnostic::at(
            Fault::Conflict,
            other.key.span(),
            format!(
                "`{}` and `{}` in [boundary] differ in length: {} and {} points",
                one.name,
                other.name,
                one.points.len(),
                other.points.len()
            ),
            label(other),
        )
        .beside(one.key.span(), label(one))
        .help("sides of one net have the same number of points: raise the degree of the shorter one, or complete it"),
    );
    false
}

/// A corner: its name, and the two sides that meet in it, each with whether it does so at its end.
type Corner = (&'static str, (usize, bool), (usize, bool));

/// Whether sides meet in their corners; true of sides that are unknown. Sides that would meet if some were reversed are one
/// fault.
fn corners(check: &mut Check<'_>, sides: &[Option<&Side<'_>>], corners: &[Corner], rule: &str) -> bool {
    let known: Option<Vec<&Side<'_>>> = sides.iter().copied().collect();
    let Some(turned) = known.and_then(|known| reversed(&known, corners)) else {
        return corners.iter().fold(true, |meet, &(name, (one, one_at_end), (other, other_at_end))| {
            meet & corner(check, name, (sides[one], one_at_end), (sides[other], other_at_end))
        });
    };
    let [first, rest @ ..] = &turned[..] else { return true };
    let names: Vec<String> = turned.iter().map(|side| format!("`{}`", side.name)).collect();
    let (names, run) = (names.join(" and "), if rest.is_empty() { "runs" } else { "run" });
    let what = format!("{names} in [boundary] {run} in the wrong direction: reversed, all sides meet");
    let label = "write these points in the other order";
    let diagnostic = Diagnostic::at(Fault::Conflict, first.key.span(), what, label).help(rule);
    check.report(rest.iter().fold(diagnostic, |diagnostic, side| diagnostic.beside(side.key.span(), label)));
    false
}

/// The fewest sides whose reversal makes all sides meet; none if they meet as they are.
fn reversed<'s>(sides: &[&'s Side<'s>], corners: &[Corner]) -> Option<Vec<&'s Side<'s>>> {
    let is_turned = |turned: usize, k: usize| turned >> k & 1 == 1;
    let end = |k: usize, at_end: bool, turned: usize| {
        let points = &sides[k].points;
        if at_end == is_turned(turned, k) { points.first() } else { points.last() }
    };
    let meets = |turned: &usize| {
        corners.iter().all(|&(_, (p, p_end), (q, q_end))| end(p, p_end, *turned) == end(q, q_end, *turned))
    };
    let turned = (0..1 << sides.len()).filter(meets).min_by_key(|turned: &usize| turned.count_ones())?;
    Some((0..sides.len()).filter(|&k| is_turned(turned, k)).map(|k| sides[k]).collect())
}

/// Whether two sides meet in a corner; true if one of them is unknown.
fn corner(
    check: &mut Check<'_>,
    corner: &str,
    (one, one_at_end): (Option<&Side<'_>>, bool),
    (other, other_at_end): (Option<&Side<'_>>, bool),
) -> bool {
    let (Some(one), Some(other)) = (one, other) else { return true };
    let pick = |side: &Side<'_>, at_end: bool| {
        let k = if at_end { side.points.len() - 1 } else { 0 };
        let place = if at_end { "last" } else { "first" };
        (side.points[k], side.key.get_ref().0[k].span(), place)
    };
    let (p, p_span, p_place) = pick(one, one_at_end);
    let (q, q_span, q_place) = pick(other, other_at_end);
    if p == q {
        return true;
    }
    check.report(
        Diagnostic::at(
            Fault::Conflict,
            q_span,
            format!(
                "`{}` and `{}` in [boundary] disagree at the corner {corner}: {} and {}",
                one.name,
                other.name,
                shown_point(&p),
                shown_point(&q)
            ),
            format!("the {q_place} point of `{}` is {}", other.name, shown_point(&q)),
        )
        .beside(p_span, format!("the {p_place} point of `{}` is {}", one.name, shown_point(&p)))
        .help(format!(
            "corners are repeated and must be equal digit for digit: make the {p_place} point of `{}` and the {q_place} point of `{}` the same",
            one.name, other.name
        )),
    );
    false
}
