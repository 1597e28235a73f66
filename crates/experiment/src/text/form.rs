//! What a key takes, without reading it.

use serde_json::{Map, Value as Json};
use toml::de::DeValue;

use super::head::Head;

/// What can be said of a kind of value without reading one.
pub(crate) trait Form: Sync {
    /// What the file must hold: "a whole number".
    fn expected(&self) -> String;

    /// Which values are admitted, for the book: "0 to 4".
    fn admits(&self) -> String;

    /// The keywords of its JSON Schema.
    fn schema(&self) -> Map<String, Json>;

    /// What to do about a value of another type, where that is more than an example.
    fn remedy(&self, _key: &Head, _found: &DeValue<'_>) -> Option<String> {
        None
    }
}

/// Keywords of a JSON Schema.
pub(super) fn keywords<const N: usize>(pairs: [(&str, Json); N]) -> Map<String, Json> {
    pairs.into_iter().map(|(keyword, rule)| (keyword.to_owned(), rule)).collect()
}
