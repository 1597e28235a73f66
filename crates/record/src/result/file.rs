use serde::{Deserialize, Serialize};

/// A file written beside the record.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct FileEntry {
    pub(super) file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) description: Option<String>,
}
