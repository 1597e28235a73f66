//! Tables as the values of keys: one, several, or either.

use serde_json::{Map, Value as Json, json};
use toml::de::DeValue;

use super::form::Form;
use super::head::Head;
use super::key::{Section, sentence};

/// A table.
#[derive(Clone, Copy)]
pub(crate) struct Inner(pub(crate) &'static Section);

impl Form for Inner {
    fn expected(&self) -> String {
        "a table of keys".to_owned()
    }

    fn admits(&self) -> String {
        "a table".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        self.0.schema()
    }

    fn remedy(&self, key: &Head, found: &DeValue<'_>) -> Option<String> {
        Some(if found.is_array() {
            format!("write [{}] with single brackets: an experiment has only one", key.name)
        } else {
            format!("open it by the header [{}] on a line of its own, and write its keys below", key.name)
        })
    }
}

/// Tables, any number of them.
#[derive(Clone, Copy)]
pub(crate) struct Several(pub(crate) &'static Section);

impl Form for Several {
    fn expected(&self) -> String {
        "a list of tables".to_owned()
    }

    fn admits(&self) -> String {
        "tables".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        tables(self.0)
    }

    fn remedy(&self, key: &Head, _found: &DeValue<'_>) -> Option<String> {
        Some(format!("write [[{}]] with two brackets: each such table is {}", key.name, self.0.doc))
    }
}

/// A table, or any number of them.
#[derive(Clone, Copy)]
pub(crate) struct OneOrSeveral {
    pub(crate) one: &'static Section,
    pub(crate) several: &'static Section,
}

impl Form for OneOrSeveral {
    fn expected(&self) -> String {
        "a table, or a list of tables".to_owned()
    }

    fn admits(&self) -> String {
        "a table, or tables".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Json::Object(self.one.schema()), Json::Object(tables(self.several))];
        let schema = json!({ "description": sentence(self.one.doc), "anyOf": forms });
        schema.as_object().cloned().unwrap_or_default()
    }

    fn remedy(&self, key: &Head, _found: &DeValue<'_>) -> Option<String> {
        Some(format!("open it by the header [{0}], or [[{0}]] for each of several", key.name))
    }
}

fn tables(section: &'static Section) -> Map<String, Json> {
    let elements = Json::Object(section.schema());
    let list = json!({ "description": sentence(section.doc), "type": "array", "items": elements });
    list.as_object().cloned().unwrap_or_default()
}
