//! Two records, number by number.

use plateau::Quantity;
use serde_json::Value;

use super::{Difference, Level, Verified};

/// What was compared so far.
#[derive(Default)]
pub(super) struct Comparison {
    compared: usize,
    differences: Vec<Difference>,
    /// Whether one of the two says that its points slide within the surface.
    pub(super) slides: bool,
}

/// What of a method is compared: its place in the record, the power of the length in its unit, and whether it is the same where the area is
/// all but constant along some directions of the net. There the points slide within the surface, and everything that depends on the
/// parameters with them.
type Compared = (&'static str, i32, bool);

/// What says something of a surface beside its figures.
const SURFACE: [Compared; 8] = [
    ("patch", 0, true),
    ("basis", 0, true),
    ("net", 1, false),
    ("faces", 1, false),
    ("domain", 0, true),
    ("pieces", 1, false),
    ("weights", 1, false),
    ("kink", 0, false),
];

/// All that is compared: the residual is rounding, and minima of searches are compared by themselves.
fn compared() -> impl Iterator<Item = Compared> {
    // The largest kink is compared with their mean.
    let is_compared = |quantity: &&Quantity| quantity.is_of_the_surface() && **quantity != Quantity::Kink;
    let figures = Quantity::ALL.iter().filter(is_compared);
    let figures = figures
        .map(|quantity| (quantity.key(), quantity.power().unwrap_or(0), quantity.is_free_of_parameters()));
    SURFACE.into_iter().chain(figures)
}

/// The reason that records of earlier versions give where points slid within the surface, so that only what does not depend on the parameters
/// was determined.
const SLIDES: &str = "the area is all but constant along what remains of the gradient";

/// Everything, bit for bit.
pub(super) fn bits(stored: &Value, computed: &Value) -> Comparison {
    let mut comparison = Comparison::default();
    comparison.walk("", Some(stored), Some(computed), &|a, b| a.to_bits() == b.to_bits());
    comparison
}

/// The figures and nets of a method within [`Level::TOLERANCE`] or [`Level::SEARCHED`].
pub(super) fn figures(stored: &Value, computed: &Value) -> Comparison {
    let mut comparison = Comparison::default();
    let failed = [stored, computed].map(|method| method.get("error").is_some());
    if failed != [false, false] {
        let said = |method: &Value| Some(text(method.get("error").unwrap_or(&Value::Null)));
        comparison.compared += 1;
        if failed != [true, true] {
            comparison.differ("error", said(stored), said(computed));
        }
        return comparison;
    }
    let minimum = computed.pointer("/search/minimum").and_then(Value::as_f64);
    let searched = minimum.is_some() || computed.get("area_extremal").is_some();
    let minimised = match minimum {
        Some(minimum) => minimum,
        None => computed.get("area").and_then(Value::as_f64).unwrap_or(f64::NAN),
    };
    let size = size(computed);
    comparison.slides = [stored, computed].iter().any(|method| {
        let reason = method.pointer("/area_extremal/reason").and_then(Value::as_str);
        reason == Some(SLIDES)
    });
    for (key, power, is_free_of_parameters) in compared() {
        if comparison.slides && !is_free_of_parameters {
            continue;
        }
        let pointer = format!("/{}", key.replace('.', "/"));
        let (theirs, ours) = (stored.pointer(&pointer), computed.pointer(&pointer));
        let is_minimum =
            ours.and_then(Value::as_f64).is_some_and(|x| close(x, minimised, Level::TOLERANCE, 0.0));
        let tolerance = if searched && !is_minimum { Level::SEARCHED } else { Level::TOLERANCE };
        // The zeros of a net are zeros of its size.
        let is_net = ["net", "pieces", "faces"].contains(&key);
        let floor = size.powi(power) * if is_net { 1.0 } else { 1e-3 };
        comparison.walk(key, theirs, ours, &|a, b| close(a, b, tolerance, floor));
    }
    let found = [stored, computed].map(|method| method.pointer("/search/minimum"));
    comparison.walk("search.minimum", found[0], found[1], &|a, b| close(a, b, Level::TOLERANCE, 0.0));
    comparison
}

/// The lists of a curve, each within [`Level::TOLERANCE`] of its largest number.
pub(super) fn curve(stored: &Value, computed: &Value) -> Comparison {
    let mut comparison = Comparison::default();
    for key in ["name", "length", "t", "basis", "basis_d1", "basis_d2", "point", "d1", "d2", "curvature"] {
        let (theirs, ours) = (stored.get(key), computed.get(key));
        let floor = ours.map_or(0.0, largest);
        comparison.walk(key, theirs, ours, &|a, b| close(a, b, Level::TOLERANCE, floor));
    }
    comparison
}

fn close(a: f64, b: f64, tolerance: f64, floor: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs()) + tolerance * floor
}

/// The largest coordinate of a method's nets; 1 if it has none.
fn size(method: &Value) -> f64 {
    let nets = ["net", "pieces", "faces"].iter().filter_map(|key| method.get(key));
    let size = nets.map(largest).fold(0.0, f64::max);
    if size > 0.0 { size } else { 1.0 }
}

fn largest(value: &Value) -> f64 {
    match value {
        Value::Array(items) => items.iter().map(largest).fold(0.0, f64::max),
        Value::Object(items) => items.values().map(largest).fold(0.0, f64::max),
        Value::Number(number) => number.as_f64().map_or(0.0, f64::abs),
        Value::Null | Value::Bool(_) | Value::String(_) => 0.0,
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::Array(items) => format!("a list of {}", items.len()),
        Value::Object(_) => "a table".into(),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => value.to_string(),
    }
}

impl Comparison {
    pub(super) fn agrees(&self) -> bool {
        self.differences.is_empty()
    }

    pub(super) fn named(self, name: String, differs_in_bits_only: bool) -> Verified {
        let Self { compared, differences, slides } = self;
        Verified { name, compared, differences, differs_in_bits_only, slides }
    }

    fn differ(&mut self, key: &str, stored: Option<String>, computed: Option<String>) {
        self.differences.push(Difference { key: key.into(), stored, computed });
    }

    fn walk(
        &mut self,
        key: &str,
        stored: Option<&Value>,
        computed: Option<&Value>,
        same: &dyn Fn(f64, f64) -> bool,
    ) {
        match (stored, computed) {
            (None, None) => {}
            (Some(Value::Object(theirs)), Some(Value::Object(ours))) => {
                let more = theirs.keys().filter(|key| !ours.contains_key(*key));
                for name in ours.keys().chain(more) {
                    let key = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
                    self.walk(&key, theirs.get(name), ours.get(name), same);
                }
            }
            (Some(Value::Array(theirs)), Some(Value::Array(ours))) if theirs.len() == ours.len() => {
                for (k, (theirs, ours)) in theirs.iter().zip(ours).enumerate() {
                    self.walk(&format!("{key}[{k}]"), Some(theirs), Some(ours), same);
                }
            }
            (theirs, ours) => {
                self.compared += 1;
                let equal = match (theirs, ours) {
                    // Counts are compared as such, for they may exceed what a floating-point number holds.
                    (Some(Value::Number(a)), Some(Value::Number(b))) if a.is_f64() || b.is_f64() => {
                        a.as_f64().zip(b.as_f64()).is_some_and(|(a, b)| same(a, b))
                    }
                    (theirs, ours) => theirs == ours,
                };
                if !equal {
                    self.differ(key, theirs.map(text), ours.map(text));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn figures_of_points_that_slide_are_not_compared() {
        let method = |area: f64, dirichlet: f64, reason: &str| {
            json!({
                "name": "area", "patch": "triangle", "basis": "bernstein", "area": area, "dirichlet": dirichlet,
                "bending": 24.0 * dirichlet, "area_extremal": { "reason": reason },
            })
        };
        let stored = method(0.521_428_673, 0.548_563_7, SLIDES);
        let same = figures(&stored, &method(0.521_428_673, 0.548_606_0, SLIDES));
        assert!(same.agrees() && same.slides && same.compared == 3);
        assert!(!figures(&stored, &method(0.521_429_673, 0.548_563_7, SLIDES)).agrees());
        let settled = "the gradient vanishes and no curvature is negative";
        let stored = method(0.521_428_673, 0.548_563_7, settled);
        assert!(!figures(&stored, &method(0.521_428_673, 0.548_606_0, settled)).agrees());
    }
}
