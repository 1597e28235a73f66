//! Kinds of values: how each is read.

use serde_json::{Map, Value as Json, json};

use super::form::{Form, keywords};
use super::interval::Interval;
use super::place::Place;
use super::value::Value;

/// Faults of the elements of one list that are reported: it may have a hundred thousand.
pub(super) const MOST_OF_A_LIST: usize = 16;

/// A kind of value that a key may hold.
pub(crate) trait Kind: Form {
    type Value;

    /// The value, if it is sound; else its faults are reported.
    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value>;
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

    fn admits(&self) -> String {
        match self {
            Self::Named => "a text, not blank".to_owned(),
            Self::Free => "a text".to_owned(),
        }
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
                let message = format!("{} is empty", place.name());
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

    fn admits(&self) -> String {
        "`true`, `false`".to_owned()
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

impl Form for Interval {
    fn expected(&self) -> String {
        "a number".to_owned()
    }

    fn admits(&self) -> String {
        self.words()
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
