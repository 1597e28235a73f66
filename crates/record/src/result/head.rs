use plateau::MethodResult;
use serde::{Deserialize, Serialize};

/// Which method an entry is of: what it made its surface from, or why there is none.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Head {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) patch: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) basis: Option<String>,
}

impl Head {
    pub(super) fn of(result: &MethodResult) -> Self {
        let name = Some(result.name.clone());
        match &result.outcome {
            Err(error) => Self { name, error: Some(error.to_string()), ..Self::default() },
            Ok(done) => {
                let (patch, basis) = done.solved.family().names();
                Self { name, error: None, patch: Some(patch.to_owned()), basis: Some(basis.to_owned()) }
            }
        }
    }
}
