//! What `result.json` says of the way to a least area.

use plateau::{AreaExtremal, Surface};
use serde::{Deserialize, Serialize};

use super::mode::ModeEntry;
use super::number::finite;

/// The way to the least area: where it began, how it ended, whether it is stable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct AreaEntry {
    start_area: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    gradient: Option<f64>,
    iterations: usize,
    evaluations: usize,
    reason: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    second_variation: Option<f64>,
    /// The displacement that has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mode: Option<ModeEntry>,
    /// What surface it began with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    start: Option<String>,
    /// The gradient in all coordinates; `gradient` is that along the normals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    whole_gradient: Option<f64>,
    /// The last surface's stages.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stages: Option<Stages>,
    /// Whether a saddle was left on the way.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    left_saddle: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Stages {
    corrections: StageEntry,
    steps: StageEntry,
    normal_steps: StageEntry,
}

/// Steps of one kind and the area lost by them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct StageEntry {
    steps: usize,
    gained: f64,
}

impl From<plateau::Stage> for StageEntry {
    fn from(stage: plateau::Stage) -> Self {
        Self { steps: stage.steps, gained: stage.gained }
    }
}

impl AreaEntry {
    /// How `surface` was found.
    pub(super) fn new(found: &AreaExtremal, surface: &Surface) -> Self {
        Self {
            start_area: found.start,
            gradient: finite(found.gradient),
            iterations: found.iterations,
            evaluations: found.evaluations,
            reason: found.reason(),
            second_variation: found.second_variation.and_then(finite),
            mode: found.mode.as_ref().and_then(|mode| ModeEntry::of(mode, surface)),
            start: Some(found.from.to_string()),
            whole_gradient: finite(found.whole_gradient),
            stages: Some(Stages {
                corrections: found.corrections.into(),
                steps: found.steps.into(),
                normal_steps: found.normal_steps.into(),
            }),
            left_saddle: found.left_saddle,
        }
    }
}
