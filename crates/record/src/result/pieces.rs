use serde::{Deserialize, Serialize};
use surfaces::{Net, Pieces, SurfaceError, TensorPatch};

use super::net::{Rows, net, rows};
use super::unfit::{Unfit, unfit};

/// One patch of a surface that was cut: its intervals in the parameters of the whole, and its net.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct PieceEntry {
    u: [f64; 2],
    v: [f64; 2],
    net: Rows,
}

/// The intervals of the parameters of the whole surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct DomainEntry {
    u: [f64; 2],
    v: [f64; 2],
}

impl DomainEntry {
    pub(super) fn of(pieces: &Pieces) -> Self {
        let [u, v] = pieces.cuts().map(|cuts| [cuts[0], cuts[cuts.len() - 1]]);
        Self { u, v }
    }

    /// The one piece of a surface that is not cut.
    pub(super) fn with(self, net: Rows) -> PieceEntry {
        PieceEntry { u: self.u, v: self.v, net }
    }
}

/// The patch of a net over intervals of two lengths.
pub(super) type OfNet = fn(Net, [f64; 2]) -> Result<TensorPatch, SurfaceError>;

/// The net of a surface in one piece.
pub(super) fn single_net(pieces: &Pieces) -> Option<Rows> {
    match pieces.patches() {
        [patch] => Some(rows(patch.net())),
        _ => None,
    }
}

/// The pieces of a surface in several, all in v of the first in u first.
pub(super) fn entries(pieces: &Pieces) -> Option<Vec<PieceEntry>> {
    let [u, v] = pieces.cuts();
    let intervals = u.windows(2).flat_map(|u| v.windows(2).map(|v| ([u[0], u[1]], [v[0], v[1]])));
    let entry =
        |((u, v), patch): (([f64; 2], [f64; 2]), &TensorPatch)| PieceEntry { u, v, net: rows(patch.net()) };
    (pieces.patches().len() > 1).then(|| intervals.zip(pieces.patches()).map(entry).collect())
}

/// The surface that is cut into `entries`; `key` is where they stand.
pub(super) fn pieces(entries: &[PieceEntry], patch: OfNet, key: &str) -> Result<Pieces, Unfit> {
    let Some(first) = entries.first() else { return Err(unfit(key, "is empty")) };
    let cols = entries.iter().take_while(|entry| entry.u == first.u).count();
    let cuts = |ends: &mut dyn Iterator<Item = [f64; 2]>| -> Vec<f64> {
        let mut cuts = Vec::new();
        for [start, end] in ends {
            if cuts.is_empty() {
                cuts.push(start);
            }
            cuts.push(end);
        }
        cuts
    };
    let v = cuts(&mut entries[..cols].iter().map(|entry| entry.v));
    let u = cuts(&mut entries.iter().step_by(cols).map(|entry| entry.u));
    let mut patches = Vec::with_capacity(entries.len());
    for (k, entry) in entries.iter().enumerate() {
        let here = format!("{key}[{k}]");
        let net = net(&entry.net, &format!("{here}.net"))?;
        let (row, col) = (k / cols, k % cols);
        if [u[row], u[row + 1]] != entry.u || [v[col], v[col + 1]] != entry.v {
            return Err(unfit(&here, "its intervals do not continue the grid of the pieces before it"));
        }
        let spans = [entry.u, entry.v].map(|[start, end]| end - start);
        patches.push(patch(net, spans).map_err(|error| unfit(&here, error))?);
    }
    Pieces::from_patches(u, v, patches).map_err(|error| unfit(key, error))
}
