//! `[boundary]`: points, lengths, corners.

use std::ops::Range;

use super::arrangement::Arrangement;
use super::side::Side;
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::boundary::{
    AB, BC, CA, SIDES_OF_A_NET, SIDES_OF_A_TRIANGLE, U_DEGREE, U0, U1, V_DEGREE, V0, V1,
};
use plateau::{Boundary, BoundaryError, Gap, Loop, OppositeSides, TensorBoundary, TriangleBoundary};
use surfaces::{Point, extent};

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

/// Checks a `[boundary]` of a net.
pub(super) fn boundary(table: &Table<'_>) -> Sides {
    let read = Read {
        table,
        faults: table.faults(),
        net: NET.map(|key| table.take(key)),
        degrees: [&U_DEGREE, &V_DEGREE].map(|key| table.take(key)),
        triangle: TRIANGLE.map(|key| table.take(key)),
    };
    let (kind, boundary) = read.judge();
    Sides { kind, header: table.span(), boundary }
}

/// The ways to give a boundary: their keys, and what these are.
const WAYS: [(&[&str], &str); 5] = [
    (&["ab", "bc", "ca"], "a side of a triangle"),
    (&["u0", "u1", "v0", "v1", "u-degree", "v-degree"], "of a tensor net"),
    (&["polygon"], "a polygon"),
    (&["sides"], "the sides of a loop"),
    (&["loops"], "loops of curves"),
];

/// Whether the boundary is given in two ways, which is reported; which of them is meant is unknown.
pub(super) fn is_mixed(table: &Table<'_>) -> bool {
    let first = |(keys, noun): &(&[&'static str], &'static str)| {
        keys.iter().find_map(|key| Some((*key, *noun, table.place(&[key])?)))
    };
    let given: Vec<_> = WAYS.iter().filter_map(first).collect();
    let [(one, what, at), (other, what_else, beside), ..] = given.as_slice() else { return false };
    table.faults().conflict(
        (at.clone(), what),
        (beside.clone(), what_else),
        format!("[boundary] holds `{one}`, {what}, and `{other}`, {what_else}"),
        format!(
            "keep one kind: {SIDES_OF_A_NET}; {SIDES_OF_A_TRIANGLE}; a polygon = [[0, 0, 0], …]; sides = [[[0, 0, 0], …], …]; or \
             loops = [[\"rim\"]] of [[curve]]s"
        ),
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

    fn nothing(&self) {
        if self.table.has_strays() {
            return;
        }
        let label = "no side of a net, no side of a triangle";
        self.faults.report(
            Diagnostic::at(Fault::Missing, self.table.span(), "[boundary] holds no points", label)
                .help(SIDES_OF_A_NET)
                .help(SIDES_OF_A_TRIANGLE)
                .help("any number of sides make polygon = [[0, 0, 0], …], sides = [[[0, 0, 0], …], …] or loops = [[\"rim\"]] of [[curve]]s"),
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
        let (list, span) = list.value().cloned().zip(list.span())?;
        Some(Side { name, span, list })
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
        let [u_degree, v_degree] = &self.degrees;
        let agree = self.is_degree("u-degree", u_degree, v0.as_ref())
            & self.is_degree("v-degree", v_degree, u0.as_ref());
        let sides = [u0?, u1?, v0?, v1?];
        let [u0, u1, v0, v1] = sides.each_ref().map(Side::points);
        let rule = "opposite sides run in the same direction: u0 and v0 begin at one corner, v0 ends where u1 begins, u0 where \
                    v1 begins";
        let boundary = self.unless(TensorBoundary::new(u0, u1, v0, v1), &sides, rule);
        boundary.filter(|_| agree && !u_degree.is_faulty() && !v_degree.is_faulty()).map(Boundary::Tensor)
    }

    /// With all four sides there, a degree is no news; it must be true.
    fn is_degree(&self, name: &str, degree: &Given<usize>, side: Option<&Side>) -> bool {
        let (Some(stated), Some(span), Some(side)) = (degree.value(), degree.span(), side) else {
            return true;
        };
        let count = side.list.points.len();
        if *stated == count - 1 {
            return true;
        }
        self.faults.conflict(
            (span, "the stated degree"),
            (side.span.clone(), &format!("{count} points, degree {}", count - 1)),
            format!("`{name}` in [boundary] is {stated}, but `{}` has degree {}", side.name, count - 1),
            format!("leave out `{name}`: it is needed only where the other pair of sides is not given"),
        );
        false
    }

    fn two_rows(&self) -> Option<Boundary> {
        let help = "a harmonic net takes u0, u1 and u-degree = m; any other method takes u0, u1, v0, v1";
        let [u0, u1] = [0, 1].map(|k| self.side(k, help));
        let (sides, degree) = ([u0?, u1?], *self.degrees[0].value()?);
        let [u0, u1] = sides.each_ref().map(Side::points);
        self.unless(OppositeSides::rows(u0, u1, degree), &sides, "").map(Boundary::Opposite)
    }

    fn two_columns(&self) -> Option<Boundary> {
        let help = "a harmonic net takes v0, v1 and v-degree = n; any other method takes u0, u1, v0, v1";
        let [v0, v1] = [2, 3].map(|k| self.side(k, help));
        let (sides, degree) = ([v0?, v1?], *self.degrees[1].value()?);
        let [v0, v1] = sides.each_ref().map(Side::points);
        self.unless(OppositeSides::columns(v0, v1, degree), &sides, "").map(Boundary::Opposite)
    }

    fn triangular(&self) -> Option<Boundary> {
        let [ab, bc, ca] = [0, 1, 2].map(|k| self.named(TRIANGLE[k], &self.triangle[k], SIDES_OF_A_TRIANGLE));
        let sides = [ab?, bc?, ca?];
        let [ab, bc, ca] = sides.each_ref().map(Side::points);
        let rule = "each side begins where the one before it ends";
        self.unless(TriangleBoundary::new(ab, bc, ca), &sides, rule).map(Boundary::Triangle)
    }

    /// The boundary, unless the sides make none, which is reported in the words of the file. `rule` says where they meet.
    fn unless<T>(&self, made: Result<T, BoundaryError>, sides: &[Side], rule: &str) -> Option<T> {
        match made {
            Ok(boundary) => return Some(boundary),
            Err(BoundaryError::TooSmall { size }) => self.too_small(size, sides),
            Err(BoundaryError::Lengths { sides: names, counts }) => {
                let all: Vec<Point> = sides.iter().flat_map(Side::points).collect();
                match Arrangement::of(sides, Loop::WELD * extent(&all)) {
                    Some(found) => self.faults.report(found.told(sides, rule)),
                    None => self.differ_in_length(sides, names, counts),
                }
            }
            Err(BoundaryError::Apart { gaps, weld }) => self.do_not_meet(sides, &gaps, weld, rule),
            // The numbers themselves were admitted one by one.
            Err(error) => self.faults.inadmissible(self.table.span(), error.to_string(), "these sides", rule),
        }
        None
    }

    /// The largest coordinate is too small for areas to be told from 0; a boundary of zeros is told apart later.
    fn too_small(&self, size: f64, sides: &[Side]) {
        let coordinates = sides.iter().flat_map(|side| {
            let points = side.list.points.iter().zip(&side.list.coordinates).enumerate();
            points.flat_map(move |(k, (point, places))| {
                let axes = ["x", "y", "z"].into_iter().zip(point.get_ref()).zip(places);
                axes.map(move |((axis, x), place)| {
                    (x.abs(), format!("{axis} of point {k} of `{}`", side.name), place)
                })
            })
        });
        let largest = coordinates.into_iter().find(|(x, _, _)| *x == size);
        let (place, span) =
            largest.map_or((String::new(), self.table.span()), |(_, called, span)| (called, span.clone()));
        self.faults.inadmissible(
            span,
            format!("the points of [boundary] are too small: the largest coordinate, {place}, is {} (points are counted from 0)", shown(size)),
            "the largest of all",
            "areas of so small a boundary leave the range of double precision: choose a smaller unit of length, in which the largest \
             coordinate is at least 1e-60",
        );
    }

    fn differ_in_length(&self, sides: &[Side], [one, other]: [&str; 2], [first, second]: [usize; 2]) {
        let span = |name| {
            sides.iter().find(|side| side.name == name).map_or(self.table.span(), |side| side.span.clone())
        };
        self.faults.conflict(
            (span(other), &format!("{second} points")),
            (span(one), &format!("{first} points")),
            format!("`{one}` and `{other}` in [boundary] differ in length: {first} and {second} points"),
            "sides of one net have the same number of points: raise the degree of the shorter one, or complete it",
        );
    }

    /// Sides that would meet under other names or in the other order are one fault, others are one for each corner.
    fn do_not_meet(&self, sides: &[Side], gaps: &[Gap], weld: f64, rule: &str) {
        match Arrangement::of(sides, weld) {
            Some(found) => self.faults.report(found.told(sides, rule)),
            None => gaps.iter().for_each(|gap| self.does_not_meet(sides, gap, weld)),
        }
    }

    fn does_not_meet(&self, sides: &[Side], gap: &Gap, weld: f64) {
        let end = |k: usize| {
            let ((side, at_end), point) = (gap.ends[k], <[f64; 3]>::from(gap.points[k]));
            let side = &sides[side];
            let last = side.list.points.len() - 1;
            let (place, span) = match at_end {
                true => ("last", side.list.points[last].span()),
                false => ("first", side.list.points[0].span()),
            };
            (side.name, place, shown_point(&point), span)
        };
        let ((one, first, p, p_span), (other, second, q, q_span)) = (end(0), end(1));
        self.faults.conflict(
            (q_span, &format!("the {second} point of `{other}` is {q}")),
            (p_span, &format!("the {first} point of `{one}` is {p}")),
            format!("`{one}` and `{other}` in [boundary] disagree at the corner {}: {p} and {q}", gap.corner),
            format!(
                "corners are repeated: make the {first} point of `{one}` and the {second} point of `{other}` the same; what differs by \
                 no more than {weld:.0e}, a millionth of the size, is made one"
            ),
        );
    }
}
