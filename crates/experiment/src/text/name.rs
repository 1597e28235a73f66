//! Names, and lists of them.

use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;

use super::form::{Form, keywords};
use super::kind::{Kind, MOST_OF_A_LIST};
use super::place::Place;
use super::value::Value;

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

    fn admits(&self) -> String {
        self.0.iter().map(|(name, _)| format!("`\"{name}\"`")).collect::<Vec<_>>().join(", ")
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

/// A list of values of a kind.
#[derive(Clone, Copy)]
pub(crate) struct List<K> {
    pub(crate) each: K,
    pub(crate) least: usize,
    pub(crate) most: usize,
    /// What the file may hold: `["obj", "ply"]`.
    pub(crate) example: &'static str,
}

/// A list of names.
pub(crate) type Names<T> = List<Name<T>>;

impl<K: Form> Form for List<K> {
    fn expected(&self) -> String {
        format!("a list, like {}", self.example)
    }

    fn admits(&self) -> String {
        let count = match self.least == self.most {
            true => self.most.to_string(),
            false => format!("{} to {}", self.least, self.most),
        };
        format!("a list of {count}: {}", self.each.admits())
    }

    fn schema(&self) -> Map<String, Json> {
        let (least, most) = (("minItems", json!(self.least)), ("maxItems", json!(self.most)));
        keywords([("type", json!("array")), ("items", Json::Object(self.each.schema())), least, most])
    }
}

impl<K: Kind> Kind for List<K> {
    type Value = Vec<Spanned<K::Value>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        if !place.has_length(value, list.len(), (self.least, self.most), "element") {
            return None;
        }
        let mut elements = Vec::with_capacity(list.len());
        let mut faulty = 0;
        for element in list {
            match self.each.read(place, element) {
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
