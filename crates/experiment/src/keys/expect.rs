//! `[expect]`, `[method.expect]` and `[method.published]`.

use plateau::Quantity;
use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;

use crate::text::{Entry, Form, Interval, Key, Kind, Name, Place, Reals, Section, Table, Text, Value, Ways};

const COUNT: usize = Quantity::ALL.len();

/// A number of an `expect` table, with its digits.
#[derive(Clone, Debug)]
pub(crate) enum Expectation {
    /// One for every index of the figure; its digits say how nearly it is to be met, or a tolerance does.
    Every(Spanned<f64>, Option<f64>),
    /// One for each index.
    Each(Vec<Spanned<f64>>),
}

/// Numbers to expect.
#[derive(Clone, Copy)]
pub(crate) struct Expected;

const LIST: Reals = Reals { least: 0, most: 100_000, each: Interval::FINITE };

impl Form for Expected {
    fn expected(&self) -> String {
        "a number, a list of numbers, or { value = …, tolerance = … }".to_owned()
    }

    fn admits(&self) -> String {
        "a number, a list of them, or `{ value, tolerance }`".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Interval::FINITE.schema(), LIST.schema(), TOLERANCED.schema()].map(Json::Object);
        [("anyOf".to_owned(), json!(forms))].into_iter().collect()
    }
}

impl Kind for Expected {
    type Value = Expectation;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Expectation> {
        if value.get_ref().is_array() {
            return LIST.read(place, value).map(Expectation::Each);
        }
        if let Some(table) = Table::of_value(place, value, &TOLERANCED) {
            let (number, tolerance) = (table.require(&VALUE), table.require(&TOLERANCE));
            return Some(Expectation::Every(number?, Some(tolerance?.into_inner())));
        }
        if !value.get_ref().is_float() && !value.get_ref().is_integer() {
            place.wrong_type(value, &self.expected());
            return None;
        }
        let number = place.real_in(value, Interval::FINITE)?;
        Some(Expectation::Every(Spanned::new(value.span(), number), None))
    }
}

const FORM: &str = "write { value = 38.0, tolerance = 0.05 }, or the number alone to have its digits decide";

static VALUE: Key<Interval> = Key::new("value", Interval::FINITE, "the number").required().hint(FORM);
static TOLERANCE: Key<Interval> =
    Key::new("tolerance", Interval::between(0.0, f64::INFINITY), "the largest admissible distance")
        .required()
        .hint(FORM);

static TOLERANCED: Section = Section {
    doc: "a number and how far ours may lie from it",
    keys: &[&VALUE, &TOLERANCE],
    ways: Ways::Free,
};

/// The keys of `expect`, one for each figure.
pub(crate) static KEYS: [Key<Expected>; COUNT] = {
    let mut keys = [Key::new("", Expected, ""); COUNT];
    let mut k = 0;
    while k < COUNT {
        let quantity = Quantity::ALL[k];
        keys[k] = Key::new(quantity.name(), Expected, quantity.meaning())
            .such_as("1.5")
            .hint("expect an ordinary number, with as many digits as the result must reproduce");
        k += 1;
    }
    keys
};

static ENTRIES: [&dyn Entry; COUNT] = {
    let mut entries: [&dyn Entry; COUNT] = [&KEYS[0]; COUNT];
    let mut k = 0;
    while k < COUNT {
        entries[k] = &KEYS[k];
        k += 1;
    }
    entries
};

pub(crate) static SECTION: Section = Section {
    doc: "numbers the result must reproduce, to the digits written: 38.35 admits 38.345 to 38.355; a miss makes `plateau run` end \
          with status 1",
    keys: &ENTRIES,
    ways: Ways::Free,
};

/// The keys of `expect` with the figures they are about.
pub(crate) fn figures() -> impl Iterator<Item = (Quantity, &'static Key<Expected>)> {
    Quantity::ALL.iter().copied().zip(&KEYS)
}

/// Every figure by its name.
pub(crate) static QUANTITIES: [(&str, Quantity); COUNT] = {
    let mut names = [("", Quantity::Dirichlet); COUNT];
    let mut k = 0;
    while k < COUNT {
        names[k] = (Quantity::ALL[k].name(), Quantity::ALL[k]);
        k += 1;
    }
    names
};

pub(crate) static SOURCE: Key<Text> = Key::new("source", Text::Named, "where the number is printed")
    .required()
    .hint("say where the number is printed: source = \"GT Table 1\"");
pub(crate) static QUANTITY: Key<Name<Quantity>> =
    Key::new("quantity", Name(&QUANTITIES), "which of our figures the printed number really is")
        .required()
        .such_as("\"dirichlet\"");
pub(crate) static HEADING: Key<Text> =
    Key::new("heading", Text::Free, "what it is called there, if that differs").such_as("\"Area\"");
pub(crate) static PRINTED: Key<Interval> =
    Key::new("printed", Interval::FINITE, "the number with the digits it has in print")
        .required()
        .such_as("38.0000");
pub(crate) static REASON: Key<Text> =
    Key::new("reason", Text::Free, "why ours differs, where it does").such_as("\"a misprint\"");

pub(crate) static PUBLISHED: Section = Section {
    doc: "a number printed elsewhere, shown beside ours by `plateau reproduce`",
    keys: &[&SOURCE, &QUANTITY, &HEADING, &PRINTED, &REASON],
    ways: Ways::Free,
};
