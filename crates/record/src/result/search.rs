//! What `result.json` says of a search.

use plateau::{SearchOutcome, SearchRun};
use serde::{Deserialize, Serialize};

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct SearchEntry {
    evaluations: u64,
    nan_evaluations: u64,
    engine: String,
    arithmetic: String,
    minimum: f64,
    runs: Vec<RunEntry>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct RunEntry {
    seed: u64,
    run: usize,
    best: f64,
    shape: Vec<f64>,
    reason: String,
    evaluations: u64,
    history: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polish: Option<PolishEntry>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct PolishEntry {
    value: f64,
    kkt_residual: f64,
    active_bounds: Vec<String>,
    evaluations: usize,
    reason: String,
}

impl SearchEntry {
    pub(super) fn of(outcome: &SearchOutcome) -> Self {
        Self {
            evaluations: outcome.evaluations(),
            nan_evaluations: outcome.nan_evaluations(),
            engine: outcome.engine().to_owned(),
            arithmetic: outcome.arithmetic().to_owned(),
            minimum: outcome.minimum(),
            runs: outcome.runs().iter().map(run_entry).collect(),
        }
    }
}

fn run_entry(run: &SearchRun) -> RunEntry {
    RunEntry {
        seed: run.seed(),
        run: run.index(),
        best: run.value(),
        shape: run.shape().to_vec(),
        reason: run.reason(),
        evaluations: run.evaluations(),
        history: run.history().iter().copied().filter(|v| v.is_finite()).collect(),
        polish: run.polish().map(|p| PolishEntry {
            value: p.value,
            kkt_residual: p.residual,
            active_bounds: active_bounds(p).into_iter().map(str::to_owned).collect(),
            evaluations: p.evaluations,
            reason: p.reason.to_string(),
        }),
    }
}

/// The bounds a polish ended at, as `result.json` lists them.
fn active_bounds(polished: &optim::Polished) -> Vec<&'static str> {
    polished
        .active
        .iter()
        .map(|bound| match bound {
            optim::Bound::Lower => "lower",
            optim::Bound::Free => "free",
            optim::Bound::Upper => "upper",
        })
        .collect()
}
