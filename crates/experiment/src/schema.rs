//! The layout of experiment files, for editors.

use serde_json::{Value as Json, json};

use crate::keys::EXPERIMENT;

/// A JSON Schema (draft 2020-12) of experiment files: every table and key with its type, its bounds and what it means, from
/// the same description as the reader. Ends with a newline.
///
/// Editors with a TOML language server complete and explain keys by it. It is a little weaker than [`Plan::parse`](crate::Plan::parse), which
/// also knows which keys fit together: every sound file validates, not every valid file is sound.
///
/// ```
/// let schema: serde_json::Value = serde_json::from_str(&experiment::experiment_schema())?;
/// assert_eq!(schema["properties"]["output"]["properties"]["mesh"]["default"], 48);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[must_use]
pub fn experiment_schema() -> String {
    let mut schema = EXPERIMENT.schema();
    schema.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".into(), json!("plateau experiment"));
    format!("{:#}\n", Json::Object(schema))
}
