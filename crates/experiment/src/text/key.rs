//! Keys and the tables in which they stand: the one description from which the reader, the JSON Schema and the book follow.

use serde_json::{Map, Value as Json, json};
use toml::de::DeValue;

use super::form::Form;
use super::head::Head;
use super::kind::Kind;
use super::value::Value;
use super::words::Words;

/// A key: its name, what it means, and the kind of value it takes.
#[derive(Clone, Copy)]
pub(crate) struct Key<K> {
    head: Head,
    pub(super) kind: K,
}

impl<K: Copy> Key<K> {
    /// A key that may be left out.
    pub(crate) const fn new(name: &'static str, kind: K, doc: &'static str) -> Self {
        let (doc, hint) = (Words::Written(doc), Words::Written(""));
        let head = Head { name, doc, default: None, hint, required: false, over: &[], example: None };
        Self { head, kind }
    }

    /// What it means, made of what others say of themselves.
    pub(crate) const fn meaning(self, make: fn() -> String) -> Self {
        Self { head: Head { doc: Words::Made(make), ..self.head }, ..self }
    }

    /// A key whose value is a table, or tables, which say themselves what they are for.
    pub(crate) const fn table(name: &'static str, kind: K) -> Self {
        Self::new(name, kind, "")
    }

    /// As the file writes it.
    pub(crate) const fn name(&self) -> &'static str {
        self.head.name
    }

    /// The value that it has if it is left out, as the file would write it.
    pub(crate) const fn or(self, default: &'static str) -> Self {
        Self { head: Head { default: Some(default), ..self.head }, ..self }
    }

    /// A value as the file would write it, where the default is none or says little.
    pub(crate) const fn such_as(self, example: &'static str) -> Self {
        Self { head: Head { example: Some(example), ..self.head }, ..self }
    }

    /// What to do about a value that is refused or missing.
    pub(crate) const fn hint(self, hint: &'static str) -> Self {
        Self { head: Head { hint: Words::Written(hint), ..self.head }, ..self }
    }

    /// The same, made of what others say of themselves.
    pub(crate) const fn advice(self, make: fn() -> String) -> Self {
        Self { head: Head { hint: Words::Made(make), ..self.head }, ..self }
    }

    /// Its table is nothing without it.
    pub(crate) const fn required(self) -> Self {
        Self { head: Head { required: true, ..self.head }, ..self }
    }

    /// Only methods over these kinds of boundary may have it.
    pub(crate) const fn over(self, boundaries: &'static [&'static str]) -> Self {
        Self { head: Head { over: boundaries, ..self.head }, ..self }
    }
}

/// A key of any kind.
pub(crate) trait Entry: Sync {
    fn head(&self) -> &Head;

    fn form(&self) -> &dyn Form;

    /// Its JSON Schema.
    fn schema(&self) -> Json {
        let mut schema = Map::new();
        let doc = self.head().doc.phrase();
        if !doc.is_empty() {
            schema.insert("description".into(), json!(sentence(&doc)));
        }
        if let Some(default) = self.head().default {
            schema.insert("default".into(), json_of(default));
        }
        schema.extend(self.form().schema());
        Json::Object(schema)
    }
}

impl<K: Form> Entry for Key<K> {
    fn head(&self) -> &Head {
        &self.head
    }

    fn form(&self) -> &dyn Form {
        &self.kind
    }
}

impl<K: Kind> Key<K> {
    /// The default, read as if the file said it.
    pub(super) fn default(&self, read: impl FnOnce(&Value<'_>) -> Option<K::Value>) -> Option<K::Value> {
        let text = self.head.default?;
        DeValue::parse(text).ok().and_then(|value| read(&value))
    }
}

/// The keys of a table.
pub(crate) struct Section {
    /// What the table is for, as a noun phrase.
    pub(crate) doc: &'static str,
    pub(crate) keys: &'static [&'static dyn Entry],
    pub(crate) ways: Ways,
}

/// Which keys a table needs besides those that are required.
pub(crate) enum Ways {
    /// None.
    Free,
    /// All of one of these groups.
    Any(&'static [&'static [&'static str]]),
    /// All of exactly one of these groups.
    One(&'static [&'static [&'static str]]),
}

impl Section {
    /// The names of its keys.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + Clone {
        self.keys.iter().map(|key| key.head().name)
    }

    /// The JSON Schema of its tables.
    pub(crate) fn schema(&self) -> Map<String, Json> {
        let properties: Map<String, Json> =
            self.keys.iter().map(|key| (key.head().name.to_owned(), key.schema())).collect();
        let required: Vec<&str> =
            self.keys.iter().filter(|key| key.head().required).map(|key| key.head().name).collect();
        let mut schema = Map::new();
        schema.insert("description".into(), json!(sentence(self.doc)));
        schema.insert("type".into(), json!("object"));
        schema.insert("additionalProperties".into(), json!(false));
        schema.insert("properties".into(), Json::Object(properties));
        if !required.is_empty() {
            schema.insert("required".into(), json!(required));
        }
        let groups = |ways: &[&[&str]]| ways.iter().map(|keys| json!({ "required": keys })).collect();
        match self.ways {
            Ways::Free => None,
            Ways::Any(ways) => schema.insert("anyOf".into(), Json::Array(groups(ways))),
            Ways::One(ways) => schema.insert("oneOf".into(), Json::Array(groups(ways))),
        };
        schema
    }
}

/// A noun phrase as a sentence.
pub(crate) fn sentence(phrase: &str) -> String {
    let mut letters = phrase.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}

/// A value of the file as JSON.
fn json_of(text: &str) -> Json {
    fn convert(value: &DeValue<'_>) -> Json {
        match value {
            DeValue::String(text) => json!(text),
            DeValue::Boolean(truth) => json!(truth),
            DeValue::Integer(integer) => serde_json::from_str(integer.as_str()).unwrap_or_default(),
            DeValue::Float(float) => serde_json::from_str(float.as_str()).unwrap_or_default(),
            DeValue::Array(list) => list.iter().map(|element| convert(element.get_ref())).collect(),
            DeValue::Datetime(_) | DeValue::Table(_) => Json::Null,
        }
    }
    DeValue::parse(text).map(|value| convert(value.get_ref())).unwrap_or_default()
}
