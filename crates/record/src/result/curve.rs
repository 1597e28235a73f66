use serde::{Deserialize, Serialize};

use plateau::CurveResult;

/// A sampled curve; every list has one row per sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct CurveEntry {
    name: String,
    length: f64,
    length_error: f64,
    t: Vec<f64>,
    basis: Vec<Vec<f64>>,
    basis_d1: Vec<Vec<f64>>,
    basis_d2: Vec<Vec<f64>>,
    point: Vec<Vec<f64>>,
    d1: Vec<Vec<f64>>,
    d2: Vec<Vec<f64>>,
    /// Left out if one sample has none: a list with holes would be read as one without.
    #[serde(skip_serializing_if = "Option::is_none")]
    curvature: Option<Vec<f64>>,
}

impl CurveEntry {
    pub(super) fn new(curve: &CurveResult) -> Self {
        let order = |r: usize| curve.samples().iter().map(|sample| sample.basis.row(r).to_vec()).collect();
        let along = |point: fn(&surfaces::CurveJet) -> surfaces::Point| {
            curve.samples().iter().map(|sample| curve.coordinates(point(&sample.jet))).collect()
        };
        let [length, length_error] = curve.length();
        Self {
            name: curve.name().to_owned(),
            length,
            length_error,
            t: curve.samples().iter().map(|sample| sample.t).collect(),
            basis: order(0),
            basis_d1: order(1),
            basis_d2: order(2),
            point: along(|jet| jet.point),
            d1: along(|jet| jet.d1),
            d2: along(|jet| jet.d2),
            curvature: curve.samples().iter().map(|sample| sample.curvature).collect(),
        }
    }
}
