//! `[curve]`: one curve, sampled.

use bases::{Aht, At, BasisFamily};
use plateau::{CurveFunction, MAX_DEGREE};
use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;

use super::shape::{self, OF_A_CURVE};
use crate::text::{Form, Interval, Key, Kind, List, Name, Place, Points, Reals, Section, Value, Ways, Whole};

/// Largest |coordinate| of a point: its square stays finite. Derivatives that do not are told apart when they are computed.
const LARGEST_COORDINATE: f64 = 1e150;

/// Most curves of one experiment.
const MOST_SHAPES: usize = 12;

const ONE_FORM: &str = "a curve is given by one of points, function, ends; the last two for \"aht\" and \"at\": points = [[0, 0], [1, 2], [3, 2], [4, 0]]";

/// Most samples of a curve.
const MOST_SAMPLES: usize = 100_000;

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

/// The shape parameters of one GT curve, or of several.
#[derive(Clone, Copy)]
pub(crate) struct Shapes;

/// A pair of shape parameters.
pub(crate) type Pair = Vec<Spanned<f64>>;

const PAIRS: List<Reals> =
    List { each: OF_A_CURVE, least: 1, most: MOST_SHAPES, example: "[[0.5, 0.5], [1.0, 2.0]]" };

impl Form for Shapes {
    fn expected(&self) -> String {
        OF_A_CURVE.expected()
    }

    fn admits(&self) -> String {
        format!("{}, or {}", OF_A_CURVE.admits(), PAIRS.admits())
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Json::Object(OF_A_CURVE.schema()), Json::Object(PAIRS.schema())];
        [("anyOf".to_owned(), json!(forms))].into_iter().collect()
    }
}

impl Kind for Shapes {
    type Value = Vec<Spanned<Pair>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let is_list = |list: &[Value<'_>]| list.first().is_some_and(|first| first.get_ref().is_array());
        if value.get_ref().as_array().is_some_and(|list| is_list(list)) {
            return PAIRS.read(place, value);
        }
        OF_A_CURVE.read(place, value).map(|pair| vec![Spanned::new(value.span(), pair)])
    }
}

/// The families of functions by their words.
pub(super) const FAMILIES: Name<BasisFamily> = Name(&BasisFamily::NAMES);

pub(crate) static BASIS: Key<Name<BasisFamily>> =
    Key::new("basis", FAMILIES, "the basis of the control points: \"bernstein\", \"gt\", \"aht\" or \"at\"")
        .required()
        .such_as("\"gt\"");
pub(crate) static SHAPE: Key<Shapes> =
    Key::new("shape", Shapes, "").meaning(shape::meaning_of_a_curve).advice(shape::advice_of_a_curve);
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
.such_as("[[0, 0], [1, 2], [3, 2], [4, 0]]")
.hint(ONE_FORM);
pub(crate) static FUNCTION: Key<Name<CurveFunction>> = Key::new(
    "function",
    Name(&CurveFunction::NAMES),
    "instead of control points a curve by its formula over [0, span], given exactly: circle (cos t, sin t), helix (cos t, sin t, t) and cycloid \
     (t − sin t, 1 − cos t) by \"aht\" and \"at\", spiral (t cos t, t sin t) and conical spiral (t cos t, t sin t, t) by \"at\", catenary \
     (t, cosh t) and hyperbola (cosh t, sinh t) by \"aht\"",
)
.such_as("\"conical-spiral\"")
.hint(ONE_FORM);
pub(crate) static ENDS: Key<List<Points>> = Key::new(
    "ends",
    List {
        each: Points::between(3, 3, LARGEST_COORDINATE).or_planar().counting("points"),
        least: 2,
        most: 2,
        example: "[[[1, 0], [0, 1], [-1, 0]], [[0, 1], [-1, 0], [0, -1]]]",
    },
    "instead of control points what the curve is at both ends: point, first and second derivative at 0, then at `span`. Any function of the \
     space of \"aht\" or \"at\" is given by its ends",
)
.such_as("[[[1, 0], [0, 1], [-1, 0]], [[0, 1], [-1, 0], [0, -1]]]")
.hint("write ends = [[point, first derivative, second derivative], […]], at 0 and at `span`");
pub(crate) static SAMPLES: Key<Samples> =
    Key::new("samples", Samples, "the parameters in the basis' domain, or how many equally spaced ones")
        .or("101");

pub(crate) static SECTION: Section = Section {
    doc: "one planar or space curve, or one for each of several shapes: samples, derivatives, curvature",
    keys: &[&BASIS, &SHAPE, &SPAN, &POINTS, &FUNCTION, &ENDS, &SAMPLES],
    ways: Ways::One(&[&["points"], &["function"], &["ends"]]),
};
