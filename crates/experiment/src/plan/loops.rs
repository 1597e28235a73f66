//! `polygon`, `sides` and `loops` of `[boundary]`.

use std::collections::HashMap;
use std::ops::Range;

use plateau::{CuttingError, Loop};
use serde_spanned::Spanned;
use surfaces::{BoundaryCurve, Point};

use super::curves::NamedCurve;
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};
use crate::text::{PointList, Table, shown, shown_point};

/// The loop of a polygon.
pub(super) fn polygon(table: &Table<'_>, corners: &Spanned<PointList>) -> Option<Loop> {
    let points = &corners.get_ref().points;
    let count = points.len();
    for k in 0..count {
        let next = &points[(k + 1) % count];
        if points[k].get_ref() != next.get_ref() {
            continue;
        }
        let is_last = k + 1 == count;
        let (span, help) = if is_last {
            (points[k].span(), "leave out the last corner: a polygon closes by itself")
        } else {
            (next.span(), "leave one of the two out: neighbouring corners differ")
        };
        table.faults().inadmissible(
            span,
            format!(
                "two neighbouring corners of `polygon` in [boundary] are the point {}",
                shown_point(points[k].get_ref())
            ),
            if is_last { "the first corner again" } else { "the corner before again" },
            help,
        );
        return None;
    }
    let made = Loop::polygon(&plain(corners.get_ref()));
    made.map_err(|error| refuse(table, corners.span(), &error)).ok()
}

/// The loop of Bézier sides.
pub(super) fn sides(table: &Table<'_>, sides: &Spanned<Vec<Spanned<PointList>>>) -> Option<Loop> {
    let lists = sides.get_ref();
    match Loop::sides(lists.iter().map(|side| plain(side.get_ref())).collect()) {
        Ok(around) => Some(around),
        Err(CuttingError::Gap { curve, gap, weld }) => {
            let before = (curve + lists.len() - 1) % lists.len();
            let ends = [&lists[before].get_ref().points, &lists[curve].get_ref().points];
            let (end, start) = (ends[0].last()?, ends[1].first()?);
            table.faults().conflict(
                (start.span(), &format!("side {curve} begins at {}", shown_point(start.get_ref()))),
                (end.span(), &format!("side {before} ends at {}", shown_point(end.get_ref()))),
                format!(
                    "side {curve} of `sides` in [boundary] begins {} from where side {before} ends (sides are counted from 0)",
                    shown(gap)
                ),
                format!(
                    "each side begins where the one before it ends, and the first where the last one ends; what differs by no more \
                     than {weld:.0e}, a millionth of the size, is made one"
                ),
            );
            None
        }
        Err(CuttingError::Curve { curve, error }) => {
            let message =
                format!("side {curve} of `sides` in [boundary] (counted from 0) is no curve: {error}");
            table.faults().inadmissible(
                lists[curve].span(),
                message,
                "here",
                "give it other points, or leave it out",
            );
            None
        }
        Err(error) => {
            refuse(table, sides.span(), &error);
            None
        }
    }
}

/// The loops over curves; every curve stands in one of them, once.
pub(super) fn loops(
    table: &Table<'_>,
    lists: &[Spanned<Vec<Spanned<String>>>],
    curves: &[NamedCurve],
) -> Option<Vec<Loop>> {
    let mut used: HashMap<usize, Range<usize>> = HashMap::new();
    let chained: Vec<Option<Loop>> = lists.iter().map(|list| chain(table, list, curves, &mut used)).collect();
    let loops: Vec<Loop> = chained.into_iter().collect::<Option<_>>()?;
    let mut all = true;
    for (k, curve) in curves.iter().enumerate() {
        if !used.contains_key(&k) {
            all = false;
            table.faults().clash(
                (curve.span.clone(), "in no loop"),
                format!("the curve \"{}\" stands in no loop", shorten(&curve.name)),
                "name it in `loops`, or take it out",
            );
        }
    }
    all.then_some(loops)
}

/// A curve of a loop, in the sense in which it is walked.
struct Walked<'c> {
    named: &'c NamedCurve,
    is_backward: bool,
    span: Range<usize>,
}

impl Walked<'_> {
    /// The vertex at its start (0) or its end (1).
    fn vertex(&self, end: usize) -> Option<&str> {
        let ends = self.named.ends.as_ref()?;
        Some(ends[if self.is_backward { 1 - end } else { end }].get_ref())
    }

    fn curve(&self) -> BoundaryCurve {
        if self.is_backward { self.named.curve.reversed() } else { self.named.curve.clone() }
    }
}

fn chain(
    table: &Table<'_>,
    list: &Spanned<Vec<Spanned<String>>>,
    curves: &[NamedCurve],
    used: &mut HashMap<usize, Range<usize>>,
) -> Option<Loop> {
    let names = list.get_ref();
    let found: Vec<Option<Walked<'_>>> = names.iter().map(|name| walked(table, name, curves, used)).collect();
    let walk: Vec<Walked<'_>> = found.into_iter().collect::<Option<_>>()?;
    for (k, this) in walk.iter().enumerate() {
        let next = &walk[(k + 1) % walk.len()];
        let (Some(end), Some(start)) = (this.vertex(1), next.vertex(0)) else {
            if walk.len() == 1 {
                continue;
            }
            let closed = if this.named.ends.is_none() { this } else { next };
            table.faults().clash(
                (closed.span.clone(), "a closed curve is a loop by itself"),
                format!(
                    "the curve \"{}\" has no `ends`, so it is closed, but stands in a loop with others",
                    shorten(&closed.named.name)
                ),
                "write its `ends`, or give it a loop of its own",
            );
            return None;
        };
        if end != start {
            table.faults().conflict(
                (next.span.clone(), &format!("begins at \"{}\"", shorten(start))),
                (this.span.clone(), &format!("ends at \"{}\"", shorten(end))),
                format!("a loop goes on at \"{}\" where it has come to \"{}\"", shorten(start), shorten(end)),
                "name the curves in order round; `-` before a name lets the curve run from its second end to its first",
            );
            return None;
        }
    }
    match Loop::new(walk.iter().map(Walked::curve).collect(), None) {
        Ok(around) => Some(around),
        Err(CuttingError::Gap { curve, gap, weld }) => {
            let before = &walk[(curve + walk.len() - 1) % walk.len()];
            let this = &walk[curve];
            let place = |point: Point| shown_point(&<[f64; 3]>::from(point));
            table.faults().conflict(
                (this.span.clone(), &format!("begins at {}", place(this.curve().start()))),
                (before.span.clone(), &format!("ends at {}", place(before.curve().end()))),
                format!("two curves end at the same vertex, but {} from one another", shown(gap)),
                format!("move one of the ends; what differs by no more than {weld:.0e}, a millionth of the size, is made one"),
            );
            None
        }
        Err(error) => {
            refuse(table, list.span(), &error);
            None
        }
    }
}

/// The curve that a name of a loop means.
fn walked<'c>(
    table: &Table<'_>,
    name: &Spanned<String>,
    curves: &'c [NamedCurve],
    used: &mut HashMap<usize, Range<usize>>,
) -> Option<Walked<'c>> {
    let text = name.get_ref();
    let (bare, is_backward) = text.strip_prefix('-').map_or((text.as_str(), false), |bare| (bare, true));
    let Some(k) = curves.iter().position(|curve| curve.name == bare) else {
        let message =
            format!("`loops` in [boundary] names a curve \"{}\", which is not there", shorten(bare));
        let diagnostic = Diagnostic::at(Fault::Conflict, name.span(), message, "no [[curve]] has this name");
        let near = nearest(bare, curves.iter().map(|curve| curve.name.as_str()));
        table.faults().report(match near {
            Some(near) => diagnostic.help(format!("did you mean \"{near}\"?")),
            None => diagnostic.help("add a table [[curve]] with this name"),
        });
        return None;
    };
    if let Some(first) = used.insert(k, name.span()) {
        table.faults().conflict(
            (name.span(), "and here"),
            (first, "it stands here"),
            format!("the curve \"{}\" stands in loops twice", shorten(bare)),
            "a curve is walked once: a boundary that runs back on itself spans nothing there",
        );
        return None;
    }
    Some(Walked { named: &curves[k], is_backward, span: name.span() })
}

fn plain(list: &PointList) -> Vec<Point> {
    list.points.iter().map(|point| Point::from(*point.get_ref())).collect()
}

fn refuse(table: &Table<'_>, span: Range<usize>, error: &CuttingError) {
    let help = "compare it with a template: `plateau new loops` prints one";
    table.faults().inadmissible(span, format!("[boundary] makes no loop: {error}"), "here", help);
}
