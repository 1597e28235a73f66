//! What proves a lower bound.

use plateau::{CalibratedFace, LowerBound};
use serde::{Deserialize, Serialize};
use surfaces::Point;

/// A lower bound's calibration: with the surface beside it, all that a program needs to check it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct ProofEntry {
    /// The surfaces that have no less area.
    holds_for: String,
    plane: PlaneEntry,
    faces: Vec<CalibratedEntry>,
}

/// A part of the region below the rim, in the parameters of a patch, and the potential on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct CalibratedEntry {
    net: Vec<Vec<[f64; 3]>>,
    potential: Vec<Vec<f64>>,
}

/// The plane over which the surface is a graph, which rises along the third axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct PlaneEntry {
    origin: [f64; 3],
    axes: [[f64; 3]; 3],
}

impl ProofEntry {
    pub(super) fn new(bound: &LowerBound) -> Self {
        Self {
            holds_for: bound.competitors.name().to_owned(),
            plane: PlaneEntry { origin: bound.plane.origin.into(), axes: bound.plane.axes.map(Into::into) },
            faces: bound.faces.iter().map(CalibratedEntry::new).collect(),
        }
    }
}

impl CalibratedEntry {
    fn new(face: &CalibratedFace) -> Self {
        let points = |row: &Vec<Point>| row.iter().map(|&p| p.into()).collect();
        Self { net: face.net.iter().map(points).collect(), potential: face.potential.clone() }
    }
}
