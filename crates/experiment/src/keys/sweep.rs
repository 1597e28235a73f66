//! `[sweep]`: many experiments of one file.

use plateau::Quantity;
use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;
use toml::de::DeValue;

use super::expect::QUANTITIES;
use crate::text::{
    Flag, Form, Interval, Key, Kind, List, Name, Place, Section, Several, Text, Value, Ways, Whole, finite,
};

/// Most axes of a sweep.
pub(crate) const MOST_AXES: usize = 8;

/// Most values of an axis, and most cells.
pub(crate) const MOST_CELLS: usize = 100_000;

/// Most keys that one axis replaces together, as the file lists them.
const MOST_KEYS: usize = 64;

pub(crate) static FIGURE: Key<Name<Quantity>> =
    Key::new("figure", Name(&QUANTITIES), "the figure that is plotted and whose least value is marked")
        .or("\"area\"");
pub(crate) static GAP: Key<Flag> = Key::new(
    "gap",
    Flag,
    "whether the plots show how far the figure lies above the least of its panel, on a logarithmic axis, instead of the figure itself",
)
.or("false");
pub(crate) static AXIS: Key<Several> = Key::table("axis", Several(&axis::SECTION));

pub(crate) static SECTION: Section = Section {
    doc: "many experiments of one file, one for each combination of the values of its axes",
    keys: &[&FIGURE, &GAP, &AXIS],
    ways: Ways::Any(&[&["axis"]]),
};

/// What of every point of the boundary is multiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stretch {
    /// One coordinate.
    Coordinate(usize),
    /// All coordinates, and the radii of circles.
    Size,
}

/// How the values between two ends are spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spacing {
    Linear,
    Logarithmic,
}

/// `[[sweep.axis]]`.
pub(crate) mod axis {
    use super::*;

    pub(crate) static NAME: Key<Text> = Key::new(
        "name",
        Text::Named,
        "what varies, in a word: it heads the columns and begins the names of the cells; letters, digits and -+._ and blanks, at most 32",
    )
    .required()
    .hint("give every axis a name of its own: name = \"height\"");
    pub(crate) static KEY: Key<Texts> = Key::new(
        "key",
        Texts,
        "the key of the file whose value is replaced, or several: tables and keys with dots between them, methods by their names or \
         numbers from 0, `*` for all: 'method.*.raise', 'method.\"Least area\".raise', 'boundary.u0.1.2'",
    )
    .such_as("\"method.*.raise\"")
    .hint("name a key that stands in the file, from its outermost table on: key = \"method.*.raise\", key = \"search.particles\"");
    pub(crate) static SCALE: Key<Name<Stretch>> = Key::new(
        "scale",
        Name(&[
            ("x", Stretch::Coordinate(0)),
            ("y", Stretch::Coordinate(1)),
            ("z", Stretch::Coordinate(2)),
            ("size", Stretch::Size),
        ]),
        "which coordinate of every point of the boundary the values multiply, or all of them",
    )
    .such_as("\"z\"");
    pub(crate) static BOUNDARIES: Key<Text> = Key::new(
        "boundaries",
        Text::Named,
        "a folder, seen from that of this file: the boundary of each experiment file in it takes the place of the one here, in the order of \
         their names",
    )
    .such_as("\"frames\"");
    pub(crate) static VALUES: Key<Anything> =
        Key::new("values", Anything, "the values, as the key would have them").such_as("[0, 2, 4]");
    pub(crate) static LABELS: Key<List<Text>> = Key::new(
        "labels",
        List { each: Text::Named, least: 1, most: MOST_CELLS, example: "[\"flat\", \"steep\"]" },
        "what the values are called in names and tables, one for each; left out, numbers and words are their own labels and others are counted",
    )
    .such_as("[\"flat\", \"steep\"]");
    pub(crate) static FROM: Key<Interval> =
        Key::new("from", Interval::FINITE, "the first of a range of values").such_as("1");
    pub(crate) static TO: Key<Interval> =
        Key::new("to", Interval::FINITE, "where the range ends").such_as("4");
    pub(crate) static COUNT: Key<Whole<usize>> = Key::new(
        "count",
        Whole::between(2, MOST_CELLS as u64),
        "how many values the range has, both ends included",
    )
    .such_as("7");
    pub(crate) static BY: Key<Interval> = Key::new(
        "by",
        Interval::above(0.0, f64::INFINITY),
        "the step from each value of the range to the next, instead of `count`",
    )
    .such_as("2");
    pub(crate) static SPACING: Key<Name<Spacing>> = Key::new(
        "spacing",
        Name(&[("linear", Spacing::Linear), ("logarithmic", Spacing::Logarithmic)]),
        "whether neighbours in a range of `count` values have equal distances or equal ratios",
    )
    .or("\"linear\"");
    pub(crate) static WITH: Key<Text> = Key::new(
        "with",
        Text::Named,
        "the name of another axis with as many values, with which this one goes in step: its first value with the first there",
    )
    .such_as("\"degree\"");

    pub(crate) static SECTION: Section = Section {
        doc: "one direction of a sweep: what varies (`key`, `scale` or `boundaries`) and through which values (`values`, or a range `from` … `to`)",
        keys: &[&NAME, &KEY, &SCALE, &BOUNDARIES, &VALUES, &LABELS, &FROM, &TO, &COUNT, &BY, &SPACING, &WITH],
        ways: Ways::One(&[&["key"], &["scale"], &["boundaries"]]),
    };
}

/// A text or several.
#[derive(Clone, Copy)]
pub(crate) struct Texts;

const SEVERAL: List<Text> =
    List { each: Text::Named, least: 1, most: MOST_KEYS, example: "[\"boundary.u0.1.2\"]" };

impl Form for Texts {
    fn expected(&self) -> String {
        "a text in quotes, or a list of them".to_owned()
    }

    fn admits(&self) -> String {
        format!("a text, or a list of 1 to {MOST_KEYS}")
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Text::Named.schema(), SEVERAL.schema()].map(Json::Object);
        [("anyOf".to_owned(), json!(forms))].into_iter().collect()
    }
}

impl Kind for Texts {
    type Value = Vec<Spanned<String>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        match value.get_ref() {
            DeValue::Array(_) => SEVERAL.read(place, value),
            DeValue::String(_) => {
                Text::Named.read(place, value).map(|text| vec![Spanned::new(value.span(), text)])
            }
            DeValue::Integer(_)
            | DeValue::Float(_)
            | DeValue::Boolean(_)
            | DeValue::Datetime(_)
            | DeValue::Table(_) => {
                place.wrong_type(value, &self.expected());
                None
            }
        }
    }
}

/// A list of values of any kind: what they replace judges them.
#[derive(Clone, Copy)]
pub(crate) struct Anything;

/// A value as the file writes it.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// Its text.
    pub(crate) text: String,
    /// Its number, if it is one.
    pub(crate) number: Option<f64>,
    /// Its words, if it is a text or a truth.
    pub(crate) word: Option<String>,
}

impl Form for Anything {
    fn expected(&self) -> String {
        "a list of values, like [0, 2, 4]".to_owned()
    }

    fn admits(&self) -> String {
        format!("a list of 1 to {MOST_CELLS} values of any kind")
    }

    fn schema(&self) -> Map<String, Json> {
        let pairs = [("type", json!("array")), ("minItems", json!(1)), ("maxItems", json!(MOST_CELLS))];
        pairs.into_iter().map(|(keyword, rule)| (keyword.to_owned(), rule)).collect()
    }
}

impl Kind for Anything {
    type Value = Vec<Spanned<Written>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        if !(1..=MOST_CELLS).contains(&list.len()) {
            place.inadmissible(
                value,
                &format!("hold 1 to {MOST_CELLS} values"),
                format!("this holds {}", list.len()),
            );
            return None;
        }
        let written = |element: &Value<'_>| {
            let number = finite(element.get_ref());
            let word = element.get_ref().as_str().map(str::to_owned);
            let word = word.or(element.get_ref().as_bool().map(|truth| truth.to_string()));
            let text = place.faults().excerpt(&element.span()).to_owned();
            Spanned::new(element.span(), Written { text, number, word })
        };
        Some(list.iter().map(written).collect())
    }
}
