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

/// A list of parameters, its range, and the families that have it.
struct Listed {
    names: String,
    within: String,
    families: Vec<&'static str>,
}

/// Every list of parameters that some of the families have.
fn lists(families: &[ShapedFamily]) -> Vec<Listed> {
    let mut lists: Vec<Listed> = Vec::new();
    for family in families {
        let (names, within) = (list(family.parameters()), range(family.range()));
        match lists.iter_mut().find(|list| list.names == names && list.within == within) {
            Some(known) => known.families.push(family.title()),
            None => lists.push(Listed { names, within, families: vec![family.title()] }),
        }
    }
    lists
}

fn meaning_of(families: &[ShapedFamily]) -> String {
    let of = |list: &Listed| format!("{} of {}", list.names, list.families.join(" and "));
    let all: Vec<String> = lists(families).iter().map(of).collect();
    format!("the shape parameters {}, those in u before those in v", all.join(", "))
}

fn advice_of(families: &[ShapedFamily]) -> String {
    let of = |list: &Listed| format!("{}, each in {}", list.names, list.within);
    let all: Vec<String> = lists(families).iter().map(of).collect();
    format!(
        "write shape = {}, those in u before those in v: outside, the functions become negative",
        all.join(", or ")
    )
}

/// What the shape of a method means.
pub(super) fn meaning() -> String {
    meaning_of(&ShapedFamily::ALL)
}

/// How the shape of a method is written.
pub(super) fn advice() -> String {
    advice_of(&ShapedFamily::ALL)
}

/// What the shape of a net means.
pub(super) fn meaning_of_a_net() -> String {
    meaning_of(&[ShapedFamily::Gt])
}

/// How the shape of a net is written.
pub(super) fn advice_of_a_net() -> String {
    advice_of(&[ShapedFamily::Gt])
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
