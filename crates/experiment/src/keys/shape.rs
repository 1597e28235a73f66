//! Shape parameters as their families tell of them: what they are called, how many there are, where they lie.

use bases::{BasisFamily, Gt};
use plateau::{ShapedFamily, counted};

use crate::text::{Interval, Reals, shown};

/// The shapes of all families: as many numbers as one of them has, each in the range of one.
pub(crate) const SHAPES: Reals = {
    let (mut least, mut most) = (usize::MAX, 0);
    let mut k = 0;
    while k < ShapedFamily::ALL.len() {
        let count = ShapedFamily::ALL[k].parameters().len();
        if count < least {
            least = count;
        }
        if count > most {
            most = count;
        }
        k += 1;
    }
    let (lower, upper) = ShapedFamily::WIDEST_RANGE;
    Reals { least, most, each: Interval::between(lower, upper) }
};

/// The shape of a curve, of the one family of functions that has one.
pub(super) const OF_A_CURVE: Reals =
    Reals::exactly(BasisFamily::Gt.parameters().len(), Interval::between(Gt::SHAPES.0, Gt::SHAPES.1));

fn range((from, to): (f64, f64)) -> String {
    format!("[{}, {}]", shown(from), shown(to))
}

fn list(names: &[&str]) -> String {
    format!("[{}]", names.join(", "))
}

/// Every list of parameters that a family has, with its range, and the families that have it.
fn lists() -> Vec<(String, String, Vec<&'static str>)> {
    let mut lists: Vec<(String, String, Vec<_>)> = Vec::new();
    for family in ShapedFamily::ALL {
        let (names, within) = (list(family.parameters()), range(family.range()));
        match lists.iter_mut().find(|(other, range, _)| *other == names && *range == within) {
            Some((.., families)) => families.push(family.title()),
            None => lists.push((names, within, vec![family.title()])),
        }
    }
    lists
}

/// What the shape of a surface means.
pub(super) fn meaning() -> String {
    let of =
        |(names, _, families): &(String, String, Vec<&str>)| format!("{names} of {}", families.join(" and "));
    let all: Vec<String> = lists().iter().map(of).collect();
    format!("the shape parameters {}, those in u before those in v", all.join(", "))
}

/// How the shape of a surface is written.
pub(super) fn advice() -> String {
    let all: Vec<String> =
        lists().iter().map(|(names, within, _)| format!("{names}, each in {within}")).collect();
    format!(
        "write shape = {}, those in u before those in v: outside, the functions become negative",
        all.join(", or ")
    )
}

/// That a family wants a shape.
pub(crate) fn needed(family: ShapedFamily) -> String {
    let (names, within) = (list(family.parameters()), range(family.range()));
    format!("{} needs shape parameters: give shape = {names}, each in {within}", family.title())
}

/// What the shape of a curve means.
pub(super) fn meaning_of_a_curve() -> String {
    let (family, names) = (BasisFamily::Gt, list(BasisFamily::Gt.parameters()));
    format!(
        "the shape parameters {names} of the {} basis; or several such lists, for a curve each, all in one picture",
        family.title()
    )
}

/// How the shape of a curve is written.
pub(super) fn advice_of_a_curve() -> String {
    let (family, names) = (BasisFamily::Gt, BasisFamily::Gt.parameters());
    format!(
        "the {} basis has {}, each in {}: write shape = {}",
        family.title(),
        counted(names.len(), "shape parameter"),
        range(Gt::SHAPES),
        list(names)
    )
}

/// How the box of a search is written.
pub(super) fn advice_of_a_box() -> String {
    let (from, to) = ShapedFamily::WIDEST_RANGE;
    format!(
        "write box = [lower, upper] with {} ≤ lower < upper ≤ {}: the GT functions are nonnegative exactly for shape parameters in {}; \
         the papers use [0.5, 3.5]",
        shown(from),
        shown(to),
        range(Gt::SHAPES)
    )
}
