//! `[curve]`: one curve, sampled.

use bases::{Aht, At};
use plateau::MAX_DEGREE;
use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;

use crate::text::{Form, Interval, Key, Kind, Name, Place, Points, Reals, Section, Value, Ways, Whole};

/// Largest |coordinate| of a point: its square stays finite. Derivatives that do not are told apart when they are computed.
const LARGEST_COORDINATE: f64 = 1e150;

/// Most samples of a curve.
const MOST_SAMPLES: usize = 100_000;

/// The basis of a curve, without its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    Bernstein,
    Gt,
    Aht,
    At,
}

/// The samples of a curve: parameters, or how many equally spaced ones.
#[derive(Clone, Copy)]
pub(crate) struct Samples;

/// What `samples` says.
#[derive(Clone, Debug)]
pub(crate) enum Sampling {
    Count(usize),
    Parameters(Vec<Spanned<f64>>),
}

const COUNT: Whole<usize> = Whole::between(2, MOST_SAMPLES as u64);
const PARAMETERS: Reals = Reals { least: 1, most: MOST_SAMPLES, each: Interval::FINITE };

impl Form for Samples {
    fn expected(&self) -> String {
        "a list of parameters, or how many".to_owned()
    }

    fn admits(&self) -> String {
        format!("{}, or {}", COUNT.admits(), PARAMETERS.admits())
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Json::Object(COUNT.schema()), Json::Object(PARAMETERS.schema())];
        [("anyOf".to_owned(), json!(forms))].into_iter().collect()
    }
}

impl Kind for Samples {
    type Value = Sampling;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Sampling> {
        if value.get_ref().is_integer() {
            return COUNT.read(place, value).map(Sampling::Count);
        }
        if value.get_ref().is_array() {
            return PARAMETERS.read(place, value).map(Sampling::Parameters);
        }
        place.wrong_type(value, &self.expected());
        None
    }
}

pub(crate) static BASIS: Key<Name<Family>> = Key::new(
    "basis",
    Name(&[("bernstein", Family::Bernstein), ("gt", Family::Gt), ("aht", Family::Aht), ("at", Family::At)]),
    "the basis of the control points: \"bernstein\", \"gt\", \"aht\" or \"at\"",
)
.required()
.such_as("\"gt\"");
pub(crate) static SHAPE: Key<Reals> = Key::new(
    "shape",
    Reals::exactly(2, Interval::between(0.0, 4.0)),
    "the shape parameters [θ1, θ2] of the GT basis",
)
.hint("the GT basis has two shape parameters, each in [0, 4]: write shape = [theta1, theta2]");
pub(crate) static SPAN: Key<Interval> = Key::new(
    "span",
    Interval::below(At::MIN_SPAN.min(Aht::MIN_SPAN), Aht::SUPREMUM.max(At::SUPREMUM)),
    "the right end of the domain [0, span] of the AHT basis (below 7.853204624) or the AT basis (below 2π)",
)
.hint("the basis lives on [0, span] and becomes negative beyond a bound, 7.853204624 for \"aht\" and 2π for \"at\": split a longer \
     curve into several");
pub(crate) static POINTS: Key<Points> = Key::new(
    "points",
    Points::between(2, MAX_DEGREE + 1, LARGEST_COORDINATE).or_planar(),
    "the control points, planar or in space: 6 for `aht` and `at`, 3 or more for `gt`, 2 or more for `bernstein`",
)
.required()
.such_as("[[0, 0], [1, 2], [3, 2], [4, 0]]");
pub(crate) static SAMPLES: Key<Samples> =
    Key::new("samples", Samples, "the parameters in the basis' domain, or how many equally spaced ones")
        .or("101");

pub(crate) static SECTION: Section = Section {
    doc: "one planar or space curve: samples, derivatives, curvature",
    keys: &[&BASIS, &SHAPE, &SPAN, &POINTS, &SAMPLES],
    ways: Ways::Free,
};
