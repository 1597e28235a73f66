//! Ends that meet nothing, in words.

use plateau::Notation;
use surfaces::Point;

use super::network::Network;
use super::weld::MOST_WELDED;
use super::{AssemblyError, Weld};
use crate::{CurveFile, Kind, Sentence, Setting};

/// Most gaps that are named.
const NAMED: usize = 4;

/// Most free ends among which the nearest are looked for: it takes the square of them.
const MOST_PAIRED: usize = 2000;

/// Refuses curves of which an end meets nothing.
pub(super) fn none(network: &Network, file: &CurveFile, weld: &Weld) -> Result<(), AssemblyError> {
    let incidence = network.incidence();
    let free: Vec<usize> = (0..incidence.len()).filter(|node| incidence[*node].len() == 1).collect();
    if free.is_empty() {
        return if network.links.is_empty() { Err(AssemblyError::NoSize) } else { Ok(()) };
    }
    let whose = |node: usize| {
        let curve = network.links[incidence[node][0]].curve;
        let name = file.curves[curve].called();
        let verb = if network.ends[curve][0] == node { "begins" } else { "ends" };
        format!("{name} {verb} at {}", shown(network.points[node]))
    };
    let pairs = pairs(network, &free[..free.len().min(MOST_PAIRED)]);
    let mut text = String::from("the curves do not close: ");
    if pairs.is_empty() {
        text += &format!("{}, where nothing meets it", whose(free[0]));
        return Err(AssemblyError::Gap(text.into()));
    }
    let named: Vec<String> = pairs
        .iter()
        .take(NAMED)
        .map(|&(gap, a, b)| format!("{}, {}, a gap of {}", whose(a), whose(b), Notation::Short(4).of(gap)))
        .collect();
    text += &named.join("; ");
    if pairs.len() > NAMED {
        text += &format!("; and {} more", pairs.len() - NAMED);
    }
    let widest = pairs.iter().fold(0.0, |widest, pair| f64::max(widest, pair.0));
    text += &format!(". Ends within {:.2e} are welded", weld.tolerance);
    if pairs.iter().any(|pair| pair.0 <= weld.tolerance) {
        text += ", but none that are farther apart than a quarter of the shortest edge of the curves there";
    }
    text += ": ";
    let is_of_one = |&(_, a, b): &(f64, usize, usize)| {
        network.links[incidence[a][0]].curve == network.links[incidence[b][0]].curve
    };
    text += if pairs.iter().all(is_of_one) {
        match file.kind {
            Kind::Table => {
                "repeat the first point of a curve at its end to close it, or call the column of sides `ring`: then all are closed"
            }
            Kind::Obj | Kind::Step | Kind::Dxf => "repeat the first point of a curve at its end to close it",
        }
    } else {
        "a side may be missing there"
    };
    // A wider weld is refused.
    // What is proposed is rounded up, and must still be taken.
    let wide = rounded_up(widest);
    if wide <= MOST_WELDED * surfaces::extent(&network.points) {
        let all = if pairs.len() == 1 { "them" } else { "them all" };
        let wider = Sentence::from(text + ", or `").value(Setting::Weld, Notation::Short(2).of(wide));
        return Err(AssemblyError::Gap(wider.text(format!("` joins {all}"))));
    }
    Err(AssemblyError::Gap(text.into()))
}

/// Each free end with the nearest other one and their distance; the smallest gaps first, each once.
fn pairs(network: &Network, free: &[usize]) -> Vec<(f64, usize, usize)> {
    let nearest = |&a: &usize| {
        let others = free.iter().filter(|b| **b != a);
        let distance = |b: usize| network.points[a].distance(network.points[b]);
        others.map(|&b| (distance(b), a.min(b), a.max(b))).min_by(|p, q| p.0.total_cmp(&q.0))
    };
    let mut pairs: Vec<(f64, usize, usize)> = free.iter().filter_map(nearest).collect();
    pairs.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)).then(p.2.cmp(&q.2)));
    pairs.dedup();
    pairs
}

/// A point in few digits.
pub(super) fn shown(p: Point) -> String {
    let [x, y, z] = [p.x, p.y, p.z].map(|x| Notation::Short(6).of(x));
    format!("({x}, {y}, {z})")
}

/// Two digits, not below x.
fn rounded_up(x: f64) -> f64 {
    let unit = libm::pow(10.0, libm::floor(libm::log10(x)) - 1.0);
    libm::ceil(x / unit * (1.0 + 1e-12)) * unit
}
