//! The layout of experiment files, for editors.

/// A JSON Schema (draft 2020-12) of experiment files: every table and key with its type, its bounds and what it means.
///
/// Editors with a TOML language server complete and explain keys by it. It is a little weaker than [`Plan::parse`](crate::Plan::parse), which
/// also knows which keys fit together: every sound file validates, not every valid file is sound.
///
/// ```
/// let schema: serde_json::Value = serde_json::from_str(plateau_cli::EXPERIMENT_SCHEMA)?;
/// assert_eq!(schema["properties"]["output"]["properties"]["mesh"]["default"], 48);
/// # Ok::<(), serde_json::Error>(())
/// ```
pub const EXPERIMENT_SCHEMA: &str = include_str!("../schema/experiment.schema.json");
