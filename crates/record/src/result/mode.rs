//! The mode of the second variation.

use plateau::{Mode, Surface};
use serde::{Deserialize, Serialize};
use surfaces::Complex;

/// The coefficients of a mode, laid out as the control points of its surface are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(crate) enum ModeEntry {
    /// One number a point of a triangular net.
    Points(Vec<f64>),
    /// One a point of a rectangular net, row by row.
    Rows(Vec<Vec<f64>>),
    /// One a point of the net of every face.
    Faces(Vec<Vec<Vec<f64>>>),
}

impl ModeEntry {
    /// None for surfaces of several pieces, which have no mode.
    pub(super) fn of(mode: &Mode, surface: &Surface) -> Option<Self> {
        let all = mode.coefficients();
        let rows = |values: Vec<f64>, columns: usize| -> Vec<Vec<f64>> {
            values.chunks_exact(columns).map(<[f64]>::to_vec).collect()
        };
        match surface {
            Surface::Tensor(patch) => Some(Self::Rows(rows(all.to_vec(), patch.net().cols()))),
            Surface::Triangle(_) => Some(Self::Points(all.to_vec())),
            Surface::Complex(complex) => {
                let of_face = |nodes: &[usize]| nodes.iter().map(|&k| all[k]).collect();
                let faces =
                    complex.faces().iter().map(|face| rows(of_face(face.nodes()), complex.degree() + 1));
                Some(Self::Faces(faces.collect()))
            }
            Surface::Pieces(_) => None,
        }
    }

    /// The mode of a surface; none if it is laid out in another way.
    pub(crate) fn of_surface(&self, surface: &Surface) -> Option<Mode> {
        let of_rows = |rows: &[Vec<f64>]| rows.iter().flatten().copied().collect::<Vec<f64>>();
        let (all, count) = match (self, surface) {
            (Self::Rows(rows), Surface::Tensor(patch)) => (of_rows(rows), patch.net().points().len()),
            (Self::Points(all), Surface::Triangle(patch)) => (all.clone(), patch.net().points().len()),
            (Self::Faces(faces), Surface::Complex(complex)) => {
                (of_faces(faces.iter().map(|rows| of_rows(rows)), complex)?, complex.points().len())
            }
            (Self::Rows(_) | Self::Points(_) | Self::Faces(_), _) => return None,
        };
        if all.len() == count { Mode::new(all) } else { None }
    }
}

/// One number a point of a complex from those of its faces.
fn of_faces(faces: impl ExactSizeIterator<Item = Vec<f64>>, complex: &Complex) -> Option<Vec<f64>> {
    let mut all = vec![0.0; complex.points().len()];
    if faces.len() != complex.faces().len() {
        return None;
    }
    for (values, face) in faces.zip(complex.faces()) {
        if values.len() != face.nodes().len() {
            return None;
        }
        face.nodes().iter().zip(values).for_each(|(&node, value)| all[node] = value);
    }
    Some(all)
}
