//! Sides that meet, but under other names than they have, or run the other way.

use plateau::{TensorBoundary, TriangleBoundary};
use surfaces::Point;

use super::side::Side;
use crate::diagnostic::{Diagnostic, Fault};

/// Which points belong under which name, and in which order, for all sides to meet.
pub(super) struct Arrangement {
    /// `places[k]`: the name under which the points given as side k belong, by its place among the names.
    places: Vec<usize>,
    /// Whether they run the wrong way.
    turned: Vec<bool>,
}

impl Arrangement {
    /// The arrangement that touches the fewest sides, and of those the one that renames the fewest; none if the sides meet in none.
    pub(super) fn of(sides: &[Side], weld: f64) -> Option<Self> {
        let count = sides.len();
        if count < 3 {
            // Opposite sides need not meet.
            return None;
        }
        let found = orders(count).into_iter().flat_map(|places| {
            (0..1usize << count).map(move |turned| Self {
                places: places.clone(),
                turned: (0..count).map(|k| turned >> k & 1 == 1).collect(),
            })
        });
        found.filter(|arrangement| arrangement.meets(sides, weld)).min_by_key(Self::changes)
    }

    fn changes(&self) -> (usize, usize) {
        let moved = |k: &usize| self.places[*k] != *k;
        let touched = |k: &usize| moved(k) || self.turned[*k];
        let all = || 0..self.places.len();
        (all().filter(touched).count(), all().filter(moved).count())
    }

    fn meets(&self, sides: &[Side], weld: f64) -> bool {
        let corners: &[_] =
            if sides.len() == 3 { &TriangleBoundary::CORNERS } else { &TensorBoundary::CORNERS };
        let from = |place: usize| self.places.iter().position(|p| *p == place).unwrap_or(place);
        let end = |(place, at_end): (usize, bool)| {
            let k = from(place);
            let points = &sides[k].list.points;
            let point = points[if at_end == self.turned[k] { 0 } else { points.len() - 1 }].get_ref();
            Point::from(*point)
        };
        let as_long =
            |a: usize, b: usize| sides[from(a)].list.points.len() == sides[from(b)].list.points.len();
        let fits =
            if sides.len() == 3 { as_long(0, 1) && as_long(0, 2) } else { as_long(0, 1) && as_long(2, 3) };
        fits && corners.iter().all(|&(_, [p, q])| end(p).distance(end(q)) <= weld)
    }

    /// The fault, in the words of the file. `rule` says where sides meet.
    pub(super) fn told(&self, sides: &[Side], rule: &str) -> Diagnostic {
        let named = |k: usize| format!("`{}`", sides[k].name);
        let all = |which: &dyn Fn(usize) -> bool| {
            (0..sides.len()).filter(|&k| which(k)).map(named).collect::<Vec<_>>()
        };
        let moved = all(&|k| self.places[k] != k);
        let turned = all(&|k| self.turned[k]);
        let what = match (&moved[..], turned.len()) {
            ([], 1) => {
                format!("{} in [boundary] runs in the wrong direction: reversed, all sides meet", turned[0])
            }
            ([], _) => format!(
                "{} in [boundary] run in the wrong direction: reversed, all sides meet",
                turned.join(" and ")
            ),
            ([one, other], 0) => format!(
                "{one} and {other} in [boundary] are exchanged: each under the other's name, all sides meet"
            ),
            (moved, 0) => format!(
                "{} in [boundary] stand under each other's names: exchanged, all sides meet",
                moved.join(", ")
            ),
            (moved, _) => format!(
                "{} in [boundary] stand under each other's names, and {} in the wrong direction: put right, all sides meet",
                moved.join(", "),
                turned.join(", "),
            ),
        };
        let label = |k: usize| match (self.places[k] != k, self.turned[k]) {
            (true, true) => {
                format!("write these points as `{}`, in the other order", sides[self.places[k]].name)
            }
            (true, false) => format!("write these points as `{}`", sides[self.places[k]].name),
            (false, _) => "write these points in the other order".to_owned(),
        };
        let mut wrong = (0..sides.len()).filter(|&k| self.places[k] != k || self.turned[k]);
        let first = wrong.next().unwrap_or_default();
        let fault = Diagnostic::at(Fault::Conflict, sides[first].span.clone(), what, label(first)).help(rule);
        wrong.fold(fault, |fault, k| fault.beside(sides[k].span.clone(), label(k)))
    }
}

/// All orders of 0 … n − 1.
fn orders(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![Vec::new()];
    }
    let shorter = orders(n - 1);
    let with = |order: &Vec<usize>, at: usize| {
        let mut order = order.clone();
        order.insert(at, n - 1);
        order
    };
    shorter.iter().flat_map(|order| (0..n).map(move |at| with(order, at))).collect()
}
