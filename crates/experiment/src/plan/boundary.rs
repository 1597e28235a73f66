//! `[boundary]`: points, lengths, corners.

use std::ops::Range;

use serde_spanned::Spanned;

use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::boundary::{
    AB, BC, CA, SIDES_OF_A_NET, SIDES_OF_A_TRIANGLE, U_DEGREE, U0, U1, V_DEGREE, V0, V1,
};
use plateau::{Boundary, MIN_SIZE};

use crate::text::{Entry, Faults, Given, Key, PointList, Points, Table, shown, shown_point};

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
struct Side {
    name: &'static str,
    span: Range<usize>,
    points: Vec<Spanned<[f64; 3]>>,
}

impl Side {
    fn plain(&self) -> Vec<[f64; 3]> {
        self.points.iter().map(|point| *point.get_ref()).collect()
    }
}

/// The keys of `[boundary]`, read.
struct Read<'t> {
    table: &'t Table<'t>,
    faults: &'t Faults<'t>,
    net: [Given<PointList>; 4],
    degrees: [Given<usize>; 2],
    triangle: [Given<PointList>; 3],
}

const NET: [&Key<Points>; 4] = [&U0, &U1, &V0, &V1];
const TRIANGLE: [&Key<Points>; 3] = [&AB, &BC, &CA];

/// Checks `[boundary]`.
pub(super) fn boundary(table: &Table<'_>) -> Sides {
    if is_mixed(table) {
        return Sides { kind: None, header: table.span(), boundary: None };
    }
    let read = Read {
        table,
        faults: table.faults(),
        net: NET.map(|key| table.take(key)),
        degrees: [&U_DEGREE, &V_DEGREE].map(|key| table.take(key)),
        triangle: TRIANGLE.map(|key| table.take(key)),
    };
    let (kind, boundary) = read.judge();
    let boundary = boundary.filter(|_| read.is_large_enough());
    Sides { kind, header: table.span(), boundary }
}

/// Whether the sides are of two kinds, which is reported; which of them are meant is unknown.
fn is_mixed(table: &Table<'_>) -> bool {
    let first = |keys: &[&'static str]| keys.iter().find_map(|key| Some((*key, table.place(&[key])?)));
    let side = first(&["ab", "bc", "ca"]);
    let other = first(&["u0", "u1", "v0", "v1", "u-degree", "v-degree"]);
    let (Some((side, at)), Some((other, beside))) = (side, other) else { return false };
    table.faults().conflict(
        (at, "a side of a triangle"),
        (beside, "belongs to a tensor net"),
        format!("[boundary] holds `{side}` of a triangle and `{other}` of a tensor net"),
        format!("keep one kind: {SIDES_OF_A_NET}; {SIDES_OF_A_TRIANGLE}"),
    );
    true
}

impl Read<'_> {
    fn judge(&self) -> (Option<Kind>, Option<Boundary>) {
        let has = |keys: &[&str]| keys.iter().any(|key| self.table.place(&[key]).is_some());
        let (rows, columns) = (has(&["u0", "u1"]), has(&["v0", "v1"]));
        if has(&["ab", "bc", "ca"]) {
            return (Some(Kind::Triangle), self.triangular());
        }
        match (rows, columns) {
            (true, false) if has(&["u-degree"]) => (Some(Kind::TwoSides), self.two_rows()),
            (false, true) if has(&["v-degree"]) => (Some(Kind::TwoSides), self.two_columns()),
            (false, false) => {
                self.nothing();
                (None, None)
            }
            _ => (Some(Kind::Tensor), self.tensor()),
        }
    }

    /// Whether the largest coordinate is large enough for areas to be told from 0; a boundary of zeros is told apart later.
    fn is_large_enough(&self) -> bool {
        let mut largest = (0.0, String::new(), 0..0);
        let lists = NET.iter().zip(&self.net).chain(TRIANGLE.iter().zip(&self.triangle));
        for (key, list) in lists {
            let points = list.value().into_iter().flat_map(|list| list.points.iter().zip(&list.coordinates));
            for (k, (point, places)) in points.enumerate() {
                for ((axis, x), place) in ["x", "y", "z"].iter().zip(point.get_ref()).zip(places) {
                    if x.abs() > largest.0 {
                        let called = format!("{axis} of point {k} of `{}`", key.head().name);
                        largest = (x.abs(), called, place.clone());
                    }
                }
            }
        }
        let (size, place, span) = largest;
        if size == 0.0 || size >= MIN_SIZE {
            return true;
        }
        self.faults.inadmissible(
            span,
            format!("the points of [boundary] are too small: the largest coordinate, {place}, is {} (points are counted from 0)", shown(size)),
            "the largest of all",
            "areas of so small a boundary leave the range of double precision: choose a smaller unit of length, in which the largest \
             coordinate is at least 1e-60",
        );
        false
    }

    fn nothing(&self) {
        if self.table.has_strays() {
            return;
        }
        let label = "no side of a net, no side of a triangle";
        self.faults.report(
            Diagnostic::at(Fault::Missing, self.table.span(), "[boundary] holds no points", label)
                .help(SIDES_OF_A_NET)
                .help(SIDES_OF_A_TRIANGLE),
        );
    }

    /// The k-th side of a net, which must be there.
    fn side(&self, k: usize, help: &str) -> Option<Side> {
        self.named(NET[k], &self.net[k], help)
    }

    fn named(&self, key: &'static Key<Points>, list: &Given<PointList>, help: &str) -> Option<Side> {
        let name = key.head().name;
        if list.is_absent() {
            self.table.missing(name, help);
        }
        let (points, span) = list.value().map(|list| list.points.clone()).zip(list.span())?;
        Some(Side { name, span, points })
    }

    fn tensor(&self) -> Option<Boundary> {
        let or_harmonic = |sides: &[&str], alone: &str| match sides
            .iter()
            .any(|side| self.table.place(&[side]).is_some())
        {
            true => SIDES_OF_A_NET.to_owned(),
            false => format!("{SIDES_OF_A_NET}; only a harmonic net takes {alone} instead"),
        };
        let row_help = or_harmonic(&["u0", "u1"], "v0, v1 and v-degree = n");
        let column_help = or_harmonic(&["v0", "v1"], "u0, u1 and u-degree = m");
        let [u0, u1] = [0, 1].map(|k| self.side(k, &row_help));
        let [v0, v1] = [2, 3].map(|k| self.side(k, &column_help));
        let rows = self.same_length(u0.as_ref(), u1.as_ref());
        let columns = self.same_length(v0.as_ref(), v1.as_ref());
        let meet = self.meet(
            &[u0.as_ref(), u1.as_ref(), v0.as_ref(), v1.as_ref()],
            &[
                ("P_00", (0, false), (2, false)),
                ("P_0n", (0, true), (3, false)),
                ("P_m0", (1, false), (2, true)),
                ("P_mn", (1, true), (3, true)),
            ],
            "opposite sides run in the same direction: u0 and v0 begin at one corner, v0 ends where u1 begins, u0 where v1 begins",
        );
        let [u_degree, v_degree] = &self.degrees;
        let agree = self.is_degree("u-degree", u_degree, v0.as_ref())
            & self.is_degree("v-degree", v_degree, u0.as_ref());
        let (u0, u1, v0, v1) = (u0?.plain(), u1?.plain(), v0?.plain(), v1?.plain());
        (rows && columns && meet && agree && !u_degree.is_faulty() && !v_degree.is_faulty())
            .then_some(Boundary::Tensor { u0, u1, v0, v1 })
    }

    /// With all four sides there, a degree is no news; it must be true.
    fn is_degree(&self, name: &str, degree: &Given<usize>, side: Option<&Side>) -> bool {
        let (Some(stated), Some(span), Some(side)) = (degree.value(), degree.span(), side) else {
            return true;
        };
        let true_degree = side.points.len() - 1;
        if *stated == true_degree {
            return true;
        }
        self.faults.conflict(
            (span, "the stated degree"),
            (side.span.clone(), &format!("{} points, degree {true_degree}", side.points.len())),
            format!("`{name}` in [boundary] is {stated}, but `{}` has degree {true_degree}", side.name),
            format!("leave out `{name}`: it is needed only where the other pair of sides is not given"),
        );
        false
    }

    fn two_rows(&self) -> Option<Boundary> {
        let help = "a harmonic net takes u0, u1 and u-degree = m; any other method takes u0, u1, v0, v1";
        let [u0, u1] = [0, 1].map(|k| self.side(k, help));
        let equal = self.same_length(u0.as_ref(), u1.as_ref());
        let (u0, u1, degree) = (u0?.plain(), u1?.plain(), *self.degrees[0].value()?);
        equal.then_some(Boundary::Rows { u0, u1, degree })
    }

    fn two_columns(&self) -> Option<Boundary> {
        let help = "a harmonic net takes v0, v1 and v-degree = n; any other method takes u0, u1, v0, v1";
        let [v0, v1] = [2, 3].map(|k| self.side(k, help));
        let equal = self.same_length(v0.as_ref(), v1.as_ref());
        let (v0, v1, degree) = (v0?.plain(), v1?.plain(), *self.degrees[1].value()?);
        equal.then_some(Boundary::Columns { v0, v1, degree })
    }

    fn triangular(&self) -> Option<Boundary> {
        let [ab, bc, ca] = [0, 1, 2].map(|k| self.named(TRIANGLE[k], &self.triangle[k], SIDES_OF_A_TRIANGLE));
        let equal = self.same_length(ab.as_ref(), bc.as_ref()) & self.same_length(ab.as_ref(), ca.as_ref());
        let meet = !equal
            || self.meet(
                &[ab.as_ref(), bc.as_ref(), ca.as_ref()],
                &[("A", (0, false), (2, true)), ("B", (0, true), (1, false)), ("C", (1, true), (2, false))],
                "each side begins where the one before it ends",
            );
        let (ab, bc, ca) = (ab?.plain(), bc?.plain(), ca?.plain());
        (equal && meet).then_some(Boundary::Triangle { ab, bc, ca })
    }

    /// Whether two opposite sides have the same number of points; true if one of them is unknown.
    fn same_length(&self, one: Option<&Side>, other: Option<&Side>) -> bool {
        let (Some(one), Some(other)) = (one, other) else { return true };
        let (first, second) = (one.points.len(), other.points.len());
        if first == second {
            return true;
        }
        self.faults.conflict(
            (other.span.clone(), &format!("{second} points")),
            (one.span.clone(), &format!("{first} points")),
            format!(
                "`{}` and `{}` in [boundary] differ in length: {first} and {second} points",
                one.name, other.name
            ),
            "sides of one net have the same number of points: raise the degree of the shorter one, or complete it",
        );
        false
    }

    /// Whether sides meet in their corners; true of sides that are unknown. Sides that would meet if some were reversed are
    /// one fault.
    fn meet(&self, sides: &[Option<&Side>], corners: &[Corner], rule: &str) -> bool {
        let known: Option<Vec<&Side>> = sides.iter().copied().collect();
        let Some(turned) = known.and_then(|known| reversed(&known, corners)) else {
            return corners.iter().fold(true, |meet, &(name, (one, one_at_end), (other, other_at_end))| {
                meet & self.meet_in(name, (sides[one], one_at_end), (sides[other], other_at_end))
            });
        };
        let [first, rest @ ..] = &turned[..] else { return true };
        let names: Vec<String> = turned.iter().map(|side| format!("`{}`", side.name)).collect();
        let (names, run) = (names.join(" and "), if rest.is_empty() { "runs" } else { "run" });
        let what = format!("{names} in [boundary] {run} in the wrong direction: reversed, all sides meet");
        let label = "write these points in the other order";
        let diagnostic = Diagnostic::at(Fault::Conflict, first.span.clone(), what, label).help(rule);
        let whole = rest.iter().fold(diagnostic, |fault, side| fault.beside(side.span.clone(), label));
        self.faults.report(whole);
        false
    }

    /// Whether two sides meet in a corner; true if one of them is unknown.
    fn meet_in(
        &self,
        corner: &str,
        (one, one_at_end): (Option<&Side>, bool),
        (other, other_at_end): (Option<&Side>, bool),
    ) -> bool {
        let (Some(one), Some(other)) = (one, other) else { return true };
        let pick = |side: &Side, at_end: bool| {
            let k = if at_end { side.points.len() - 1 } else { 0 };
            let place = if at_end { "last" } else { "first" };
            (*side.points[k].get_ref(), side.points[k].span(), place)
        };
        let (p, p_span, p_place) = pick(one, one_at_end);
        let (q, q_span, q_place) = pick(other, other_at_end);
        if p == q {
            return true;
        }
        let (one, other) = (one.name, other.name);
        self.faults.conflict(
            (q_span, &format!("the {q_place} point of `{other}` is {}", shown_point(&q))),
            (p_span, &format!("the {p_place} point of `{one}` is {}", shown_point(&p))),
            format!(
                "`{one}` and `{other}` in [boundary] disagree at the corner {corner}: {} and {}",
                shown_point(&p),
                shown_point(&q)
            ),
            format!(
                "corners are repeated and must be equal digit for digit: make the {p_place} point of `{one}` and the {q_place} point of `{other}` the same"
            ),
        );
        false
    }
}

/// A corner: its name, and the two sides that meet in it, each with whether it does so at its end.
type Corner = (&'static str, (usize, bool), (usize, bool));

/// The fewest sides whose reversal makes all sides meet; none if they meet as they are.
fn reversed<'s>(sides: &[&'s Side], corners: &[Corner]) -> Option<Vec<&'s Side>> {
    let is_turned = |turned: usize, k: usize| turned >> k & 1 == 1;
    let end = |k: usize, at_end: bool, turned: usize| {
        let points = &sides[k].points;
        let point = if at_end == is_turned(turned, k) { points.first() } else { points.last() };
        point.map(|point| *point.get_ref())
    };
    let meets = |turned: &usize| {
        corners.iter().all(|&(_, (p, p_end), (q, q_end))| end(p, p_end, *turned) == end(q, q_end, *turned))
    };
    let turned = (0..1 << sides.len()).filter(meets).min_by_key(|turned: &usize| turned.count_ones())?;
    Some((0..sides.len()).filter(|&k| is_turned(turned, k)).map(|k| sides[k]).collect())
}
