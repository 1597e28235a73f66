use serde::{Deserialize, Serialize};
use surfaces::Pieces;

use super::net::rows;

/// One patch of a surface that was cut: its intervals in the parameters of the whole, and its net.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct PieceEntry {
    u: [f64; 2],
    v: [f64; 2],
    net: Vec<Vec<[f64; 3]>>,
}

/// The intervals of the parameters of the whole surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct DomainEntry {
    u: [f64; 2],
    v: [f64; 2],
}

impl DomainEntry {
    pub(super) fn new(pieces: &Pieces) -> Self {
        let [u, v] = pieces.cuts().map(|cuts| [cuts[0], cuts[cuts.len() - 1]]);
        Self { u, v }
    }
}

/// The net of a surface in one piece.
pub(super) fn single_net(pieces: &Pieces) -> Option<Vec<Vec<[f64; 3]>>> {
    match pieces.patches() {
        [patch] => Some(rows(patch.net())),
        _ => None,
    }
}

/// The pieces of a surface in several, all in v of the first in u first.
pub(super) fn piece_entries(pieces: &Pieces) -> Option<Vec<PieceEntry>> {
    let [u, v] = pieces.cuts();
    let intervals = u.windows(2).flat_map(|u| v.windows(2).map(|v| ([u[0], u[1]], [v[0], v[1]])));
    let entry = |((u, v), patch): (([f64; 2], [f64; 2]), &surfaces::TensorPatch)| PieceEntry {
        u,
        v,
        net: rows(patch.net()),
    };
    (pieces.patches().len() > 1).then(|| intervals.zip(pieces.patches()).map(entry).collect())
}
