//! `[net]`.

use std::ops::Range;

use bases::{Aht, At, BasisFamily};
use plateau::{MIN_SIZE, NetBasis, OrderSix, OwnNet, ShapedFamily, counted};
use serde_spanned::Spanned;
use surfaces::{Net, Point};

use super::Wanted;
use super::built::built;
use super::expected::check::{Subject, wanted};
use super::shape::fixed_shape;
use crate::keys::helicoid::SHORTEST;
use crate::keys::net::{BASIS, BOUNDS, POINTS, SHAPE, U_CUTS, U_SPAN, V_CUTS, V_SPAN};
use crate::keys::shape::needed;
use crate::text::{Entry, Given, Interval, Key, PointList, Reals, Table, shown};

type Rows = Spanned<Vec<Spanned<PointList>>>;

/// Checks `[net]`.
pub(super) fn net(table: &Table<'_>, expect: Given<Table<'_>>) -> Option<(OwnNet, Wanted)> {
    let family = table.require(&BASIS);
    let rows = table.require(&POINTS);
    let shape = table.take(&SHAPE);
    let directions = [
        Direction { name: "u", span: (&U_SPAN, table.take(&U_SPAN)), cuts: (&U_CUTS, table.take(&U_CUTS)) },
        Direction { name: "v", span: (&V_SPAN, table.take(&V_SPAN)), cuts: (&V_CUTS, table.take(&V_CUTS)) },
    ];
    let wanted = wanted(expect, Some(Subject::Net));
    let points = rows.as_ref().and_then(|rows| points(table, rows));
    let family = family?;
    let fits = is_for(table, &family);
    let (points, rows) = (points?, rows?);
    let counts = [points.rows(), points.cols()];
    let basis = match *family.get_ref() {
        BasisFamily::Bernstein => Some(NetBasis::Bernstein),
        BasisFamily::Gt => {
            let sized = has_counts(
                table,
                &rows,
                counts,
                |count| count >= 3,
                "3 or more: the GT basis begins at degree 2",
            );
            if shape.is_absent() {
                table.missing("shape", &needed(ShapedFamily::Gt));
            }
            let Given::Sound(shape) = &shape else { return None };
            fixed_shape(table, ShapedFamily::Gt, shape).filter(|_| sized).map(NetBasis::Shaped)
        }
        BasisFamily::Aht => order_six(table, &rows, counts, &directions, Aht::SUPREMUM).map(NetBasis::Aht),
        BasisFamily::At => order_six(table, &rows, counts, &directions, At::SUPREMUM).map(NetBasis::At),
    };
    let net = built(table, rows.span(), OwnNet::new(points, basis.filter(|_| fits)?));
    Some((net?, wanted?))
}

/// One of u and v: the keys it has.
struct Direction {
    name: &'static str,
    span: (&'static Key<Interval>, Given<f64>),
    cuts: (&'static Key<Reals>, Given<Vec<Spanned<f64>>>),
}

/// The net, if its rows have the same length and it is of a size that figures can be had of.
fn points(table: &Table<'_>, rows: &Rows) -> Option<Net> {
    let lists = rows.get_ref();
    let cols = lists[0].get_ref().points.len();
    if let Some((i, row)) = lists.iter().enumerate().find(|(_, row)| row.get_ref().points.len() != cols) {
        let found = counted(row.get_ref().points.len(), "point");
        table.faults().conflict(
            (row.span(), &found),
            (lists[0].span(), &counted(cols, "point")),
            format!("row {i} of `points` in [net] has {found}, row 0 has {cols} (rows are counted from 0)"),
            "every row of a net has as many points as the others: complete the shorter one",
        );
        return None;
    }
    let all: Vec<Point> =
        lists.iter().flat_map(|row| &row.get_ref().points).map(|p| Point::from(*p.get_ref())).collect();
    let largest = all.iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0, |largest, x| f64::max(largest, x.abs()));
    if largest < MIN_SIZE {
        table.faults().inadmissible(
            rows.span(),
            format!("the points of [net] are too small: the largest coordinate is {}", shown(largest)),
            "the largest of all is too small",
            "areas of so small a surface leave the range of double precision: choose a smaller unit of length, in which the largest \
             coordinate is at least 1e-60",
        );
        return None;
    }
    Net::new(lists.len(), cols, all).ok()
}

/// Reports keys that the functions do not take.
fn is_for(table: &Table<'_>, family: &Spanned<BasisFamily>) -> bool {
    let strange: &[&str] = match family.get_ref() {
        BasisFamily::Bernstein => &["shape", "u-span", "v-span", "u-cuts", "v-cuts"],
        BasisFamily::Gt => &["u-span", "v-span", "u-cuts", "v-cuts"],
        BasisFamily::Aht | BasisFamily::At => &["shape"],
    };
    let Some((key, place)) = strange.iter().find_map(|key| Some((key, table.place(&[key])?))) else {
        return true;
    };
    let said = table.faults().excerpt(&family.span());
    table.faults().clash(
        (place, "not for this basis"),
        format!("[net] has a `{key}`, which basis = {said} does not take"),
        "`shape` belongs to basis = \"gt\", spans and cuts to \"aht\" and \"at\"; take the key out or change the basis",
    );
    false
}

fn has_counts(
    table: &Table<'_>,
    rows: &Rows,
    counts: [usize; 2],
    admitted: fn(usize) -> bool,
    wanted: &str,
) -> bool {
    if counts.into_iter().all(admitted) {
        return true;
    }
    table.faults().inadmissible(
        rows.span(),
        format!("`points` in [net] are {} × {}", counts[0], counts[1]),
        format!("{} rows of {}", counts[0], counted(counts[1], "point")),
        format!("in each direction there must be {wanted}"),
    );
    false
}

/// Spans and cuts of a net in functions of order 6.
fn order_six(
    table: &Table<'_>,
    rows: &Rows,
    counts: [usize; 2],
    directions: &[Direction; 2],
    bound: f64,
) -> Option<OrderSix> {
    let six = "6 points, or 2 where the surface is linear: the basis has six functions";
    let sized = has_counts(table, rows, counts, |count| count == 2 || count == 6, six);
    if sized && counts == [2, 2] {
        table.faults().inadmissible(
            rows.span(),
            "`points` in [net] are 2 × 2: nothing of the basis is in it",
            "linear in both directions",
            "give 6 points in one direction at least, or write basis = \"bernstein\"",
        );
        return None;
    }
    if !sized {
        return None;
    }
    let [u, v] = [0, 1].map(|k| directions[k].read(table, counts[k], bound));
    let ((u_span, u_cuts), (v_span, v_cuts)) = (u?, v?);
    built(table, rows.span(), OrderSix::new([u_span, v_span], [u_cuts, v_cuts]))
}

impl Direction {
    /// The span, 1 where the surface is linear, and the cuts.
    fn read(&self, table: &Table<'_>, count: usize, bound: f64) -> Option<(f64, Vec<f64>)> {
        let (span_key, cuts_key) = (self.span.0.head().name, self.cuts.0.head().name);
        if count == 2 {
            return self.linear(table).then(|| (1.0, Vec::new()));
        }
        if self.span.1.is_absent() {
            table.missing(span_key, BOUNDS);
        }
        let (span, place) = (*self.span.1.value()?, self.span.1.span()?);
        let interval = Interval::below(SHORTEST, bound);
        if !interval.holds(span) {
            let message = format!("`{span_key}` in [net] must {interval}");
            table.faults().inadmissible(place, message, format!("this is {}", shown(span)), BOUNDS);
            return None;
        }
        let cuts = match &self.cuts.1 {
            Given::Absent => return Some((span, Vec::new())),
            Given::Faulty => return None,
            Given::Sound(cuts) => cuts.get_ref(),
        };
        let ends: Vec<f64> = cuts.iter().map(|cut| *cut.get_ref()).chain([span]).collect();
        let mut start = 0.0;
        for (cut, &end) in cuts.iter().zip(&ends[1..]) {
            let at = *cut.get_ref();
            if !(at - start >= SHORTEST && end - at >= SHORTEST && at < span) {
                self.misplaced(table, cut.span(), cuts_key, (start, at, span));
                return None;
            }
            start = at;
        }
        Some((span, ends[..cuts.len()].to_vec()))
    }

    fn misplaced(
        &self,
        table: &Table<'_>,
        place: Range<usize>,
        key: &str,
        (start, at, span): (f64, f64, f64),
    ) {
        table.faults().inadmissible(
            place,
            format!(
                "`{key}` in [net] holds {}, which leaves no interval between {} and {}",
                shown(at),
                shown(start),
                shown(span)
            ),
            format!("this is {}", shown(at)),
            format!(
                "cuts ascend from 0 to `{}-span`, and no two are nearer than {}",
                self.name,
                shown(SHORTEST)
            ),
        );
    }

    /// A direction of two points takes neither a span nor cuts.
    fn linear(&self, table: &Table<'_>) -> bool {
        let keys = [self.span.0.head().name, self.cuts.0.head().name];
        let Some((key, place)) = keys.into_iter().find_map(|key| Some((key, table.place(&[key])?))) else {
            return true;
        };
        table.faults().clash(
            (place, "nothing to set"),
            format!(
                "[net] has a `{key}`, but two points in {}: the surface is linear there, over [0, 1]",
                self.name
            ),
            "take the key out, or give 6 points in this direction",
        );
        false
    }
}
