//! Whole numbers.

use std::marker::PhantomData;

use serde_json::{Map, Value as Json, json};

use super::form::{Form, keywords};
use super::kind::Kind;
use super::place::Place;
use super::value::{self, TooLarge, Value};

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

    fn admits(&self) -> String {
        let most =
            if self.most == i64::MAX as u64 { "2⁶³ − 1".to_owned() } else { self.most.to_string() };
        format!("a whole number, {} to {most}", self.least)
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
