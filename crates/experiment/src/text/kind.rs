//! Kinds of values: what is expected, how it is read, its JSON Schema.

use std::marker::PhantomData;

use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;
use toml::de::DeValue;

use super::faults::Faults;
use super::interval::Interval;
use super::key::{Head, Section};
use super::number::{counted, shown};
use super::table::Table;
use super::value::{self, TooLarge, Value};
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};

/// Faults of the elements of one list that are reported: it may have a hundred thousand.
pub(super) const MOST_OF_A_LIST: usize = 16;

/// What can be said of a kind of value without reading one.
pub(crate) trait Form: Sync {
    /// What the file must hold: "a whole number".
    fn expected(&self) -> String;

    /// The keywords of its JSON Schema.
    fn schema(&self) -> Map<String, Json>;

    /// What to do about a value of another type, where that is more than an example.
    fn remedy(&self, _key: &Head, _found: &DeValue<'_>) -> Option<String> {
        None
    }
}

/// A kind of value that a key may hold.
pub(crate) trait Kind: Form {
    type Value;

    /// The value, if it is sound; else its faults are reported.
    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value>;
}

/// The key that is being read.
pub(crate) struct Place<'p> {
    pub(super) table: &'p Table<'p>,
    pub(super) key: &'p Head,
    pub(super) form: &'p dyn Form,
}

impl Place<'_> {
    pub(crate) fn faults(&self) -> &Faults<'_> {
        self.table.faults()
    }

    /// `mesh` in [output].
    fn named(&self, table: &str) -> String {
        if table.is_empty() {
            format!("`{}`", self.key.name)
        } else {
            format!("`{}` in {table}", self.key.name)
        }
    }

    /// The key as messages call it.
    pub(crate) fn called(&self) -> String {
        self.named(self.table.called_or_empty())
    }

    /// The value as a table, if it is one.
    pub(crate) fn table<'v>(&'v self, value: &'v Value<'v>, section: &'static Section) -> Option<Table<'v>> {
        let entries = value.get_ref().as_table()?;
        let table = self.table.within(self.key, section, Some((entries, value.span())), false);
        Some(table.called(self.called()))
    }

    /// A value of another type than the key takes.
    pub(crate) fn wrong_type(&self, value: &Value<'_>, expected: &str) {
        let found = value::noun(value.get_ref());
        let message = format!("{} has a value of the wrong type", self.named(self.table.header()));
        let help = match (value.get_ref(), expected) {
            (DeValue::String(_), "a number" | "a whole number") => {
                "take the quotes away: numbers stand without them".to_owned()
            }
            (DeValue::Float(_), "a whole number") => "write it without a decimal point".to_owned(),
            (found, _) => self.form.remedy(self.key, found).unwrap_or_else(|| self.key.remedy()),
        };
        let label = format!("expected {expected}; this is {found}");
        self.faults().report(Diagnostic::at(Fault::WrongType, value.span(), message, label).help(help));
    }

    /// A number beyond its type.
    pub(crate) fn too_large(&self, value: &Value<'_>) {
        self.faults().inadmissible(
            value.span(),
            format!("{} holds a number too large to be represented", self.named(self.table.header())),
            "too large",
            "whole numbers end at 2^63 - 1 and others at 1.8e308; coordinates are admitted up to 1e60: choose a larger unit",
        );
    }

    /// A value outside the admissible set: what the key must do, and what this is.
    pub(crate) fn inadmissible(&self, value: &Value<'_>, must: &str, label: impl Into<String>) {
        let message = format!("{} must {must}", self.called());
        self.faults().inadmissible(value.span(), message, label, self.key.remedy());
    }

    /// A number that is not too large; not yet judged.
    pub(super) fn real(&self, value: &Value<'_>) -> Option<f64> {
        match value::real(value.get_ref()) {
            Some(Ok(number)) => Some(number),
            Some(Err(TooLarge)) => {
                self.too_large(value);
                None
            }
            None => {
                self.wrong_type(value, "a number");
                None
            }
        }
    }

    /// A number in an interval.
    pub(crate) fn real_in(&self, value: &Value<'_>, interval: Interval) -> Option<f64> {
        let number = self.real(value)?;
        if interval.holds(number) {
            return Some(number);
        }
        let must = if number.is_finite() { interval } else { Interval::FINITE };
        self.inadmissible(value, &must.to_string(), format!("this is {}", shown(number)));
        None
    }

    /// One of several names.
    pub(crate) fn one_of<T: Copy>(&self, word: &str, value: &Value<'_>, names: &[(&str, T)]) -> Option<T> {
        if let Some((_, meant)) = names.iter().find(|(name, _)| *name == word) {
            return Some(*meant);
        }
        let message = format!("{} cannot be \"{}\"", self.called(), shorten(word));
        let label = format!("expected {}", alternatives(names));
        let help = match nearest(word, names.iter().map(|(name, _)| *name)) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("write one of these names, as in {} = {}", self.key.name, self.key.example()),
        };
        self.faults().inadmissible(value.span(), message, label, help);
        None
    }
}

/// `"a"`, `"a" or "b"`, `"a", "b" or "c"`.
pub(super) fn alternatives<T>(names: &[(&str, T)]) -> String {
    let quoted: Vec<String> = names.iter().map(|(name, _)| format!("\"{name}\"")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

fn keywords<const N: usize>(pairs: [(&str, Json); N]) -> Map<String, Json> {
    pairs.into_iter().map(|(keyword, rule)| (keyword.to_owned(), rule)).collect()
}

/// A text.
#[derive(Clone, Copy)]
pub(crate) enum Text {
    /// Not blank.
    Named,
    /// Of any length.
    Free,
}

impl Form for Text {
    fn expected(&self) -> String {
        "a text in quotes".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        match self {
            Self::Named => keywords([("type", json!("string")), ("minLength", json!(1))]),
            Self::Free => keywords([("type", json!("string"))]),
        }
    }
}

impl Kind for Text {
    type Value = String;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<String> {
        let Some(text) = value.get_ref().as_str() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        match self {
            Self::Named if text.trim().is_empty() => {
                let message = format!("{} is empty", place.called());
                place.faults().inadmissible(value.span(), message, "no name in it", place.key.remedy());
                None
            }
            Self::Named | Self::Free => Some(text.to_owned()),
        }
    }
}

/// Yes or no.
#[derive(Clone, Copy)]
pub(crate) struct Flag;

impl Form for Flag {
    fn expected(&self) -> String {
        "true or false".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        keywords([("type", json!("boolean"))])
    }
}

impl Kind for Flag {
    type Value = bool;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<bool> {
        let truth = value.get_ref().as_bool();
        if truth.is_none() {
            place.wrong_type(value, &self.expected());
        }
        truth
    }
}

/// A whole number between two bounds, both included.
pub(crate) struct Whole<T> {
    least: u64,
    most: u64,
    held_as: PhantomData<fn() -> T>,
}

impl<T> Clone for Whole<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Whole<T> {}

impl<T> Whole<T> {
    /// `T` must be able to hold both.
    pub(crate) const fn between(least: u64, most: u64) -> Self {
        Self { least, most, held_as: PhantomData }
    }
}

impl<T: TryFrom<u64>> Whole<T> {
    fn of(&self, place: &Place<'_>, value: &Value<'_>, number: i128) -> Option<T> {
        let admitted = u64::try_from(number).ok().filter(|n| (self.least..=self.most).contains(n));
        if let Some(found) = admitted.and_then(|n| T::try_from(n).ok()) {
            return Some(found);
        }
        // The one bound that nobody knows by its digits.
        let most = if self.most == i64::MAX as u64 { "2^63 - 1 = " } else { "" };
        let must = format!("lie between {} and {most}{}", self.least, self.most);
        place.inadmissible(value, &must, format!("this is {number}"));
        None
    }
}

impl<T: TryFrom<u64>> Form for Whole<T> {
    fn expected(&self) -> String {
        "a whole number".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let bounds = [("minimum", json!(self.least)), ("maximum", json!(self.most))];
        keywords([("type", json!("integer"))]).into_iter().chain(keywords(bounds)).collect()
    }
}

impl<T: TryFrom<u64>> Kind for Whole<T> {
    type Value = T;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<T> {
        match value::whole(value.get_ref()) {
            Some(Ok(number)) => self.of(place, value, number),
            Some(Err(TooLarge)) => {
                place.too_large(value);
                None
            }
            None => {
                place.wrong_type(value, &self.expected());
                None
            }
        }
    }
}

impl Form for Interval {
    fn expected(&self) -> String {
        "a number".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        keywords([("type", json!("number"))]).into_iter().chain(self.bounds()).collect()
    }
}

impl Kind for Interval {
    type Value = f64;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<f64> {
        place.real_in(value, *self)
    }
}

/// One of several names, each with what it means.
pub(crate) struct Name<T: 'static>(pub(crate) &'static [(&'static str, T)]);

impl<T> Clone for Name<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Name<T> {}

impl<T: Copy + Sync> Form for Name<T> {
    fn expected(&self) -> String {
        "a text in quotes".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let names: Vec<&str> = self.0.iter().map(|(name, _)| *name).collect();
        keywords([("enum", json!(names))])
    }
}

impl<T: Copy + Sync> Kind for Name<T> {
    type Value = T;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<T> {
        match value.get_ref().as_str() {
            Some(word) => place.one_of(word, value, self.0),
            None => {
                place.wrong_type(value, &self.expected());
                None
            }
        }
    }
}

/// A list of texts of a kind.
#[derive(Clone, Copy)]
pub(crate) struct List<K>(pub(crate) K);

/// A list of names.
pub(crate) type Names<T> = List<Name<T>>;

impl<K: Form> Form for List<K> {
    fn expected(&self) -> String {
        "a list of texts, like [\"obj\", \"ply\"]".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        keywords([("type", json!("array")), ("items", Json::Object(self.0.schema()))])
    }
}

impl<K: Kind> Kind for List<K> {
    type Value = Vec<Spanned<K::Value>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        let mut elements = Vec::with_capacity(list.len());
        let mut faulty = 0;
        for element in list {
            match self.0.read(place, element) {
                Some(sound) => elements.push(Spanned::new(element.span(), sound)),
                None => faulty += 1,
            }
            if faulty == MOST_OF_A_LIST {
                return None;
            }
        }
        (faulty == 0).then_some(elements)
    }
}

/// A list of numbers in an interval.
#[derive(Clone, Copy)]
pub(crate) struct Reals {
    pub(crate) least: usize,
    pub(crate) most: usize,
    pub(crate) each: Interval,
}

impl Reals {
    /// Exactly `count` numbers.
    pub(crate) const fn exactly(count: usize, each: Interval) -> Self {
        Self { least: count, most: count, each }
    }
}

impl Form for Reals {
    fn expected(&self) -> String {
        "a list of numbers, like [1.0, 2.0]".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let lengths = [("minItems", json!(self.least)), ("maxItems", json!(self.most))];
        let list = [("type", json!("array")), ("items", Json::Object(self.each.schema()))];
        keywords(list).into_iter().chain(keywords(lengths)).collect()
    }
}

impl Kind for Reals {
    type Value = Vec<Spanned<f64>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        let found = counted(list.len(), "number");
        let wanted = match (list.len() < self.least, self.least == self.most) {
            _ if (self.least..=self.most).contains(&list.len()) => None,
            (_, true) => Some(self.least.to_string()),
            (true, false) => Some(format!("at least {}", self.least)),
            (false, false) => Some(format!("at most {}", self.most)),
        };
        if let Some(wanted) = wanted {
            let message = format!("{} has {found} instead of {wanted}", place.called());
            place.faults().inadmissible(value.span(), message, found, place.key.remedy());
            return None;
        }
        numbers(place, list, self.each)
    }
}

/// The numbers of a list; all that lie outside are reported, of other types the first.
fn numbers(place: &Place<'_>, list: &[Value<'_>], each: Interval) -> Option<Vec<Spanned<f64>>> {
    let mut numbers = Vec::with_capacity(list.len());
    let mut faulty = 0;
    for element in list {
        let number = place.real(element)?;
        if !each.holds(number) {
            let must = if number.is_finite() { each } else { Interval::FINITE };
            let message =
                format!("{} holds {}: each of its numbers must {must}", place.called(), shown(number));
            place.faults().inadmissible(
                element.span(),
                message,
                format!("this is {}", shown(number)),
                place.key.remedy(),
            );
            faulty += 1;
        }
        if faulty == MOST_OF_A_LIST {
            return None;
        }
        numbers.push(Spanned::new(element.span(), number));
    }
    (faulty == 0).then_some(numbers)
}
