//! A patch that was found, with its figures.

use crate::{BoundaryFigures, ClosedForm, Figures, FilmFigures, Solved, Warning};

/// A method that found its patch.
#[derive(Debug)]
#[non_exhaustive]
pub struct Done {
    /// The patch and the way to it.
    pub solved: Solved,
    /// The mesh the files and the largest curvature are taken from.
    pub mesh: surfaces::Mesh,
    /// Its figures.
    pub figures: Figures,
    /// What its boundary admits and how far it moved, for patches on the unit square.
    pub boundary: Option<BoundaryFigures>,
    /// How it compares with its closed form, for surfaces that have one.
    pub closed_form: Option<ClosedForm>,
    /// How its patches lie, for surfaces over loops and faces.
    pub film: Option<FilmFigures>,
    /// What a reader must know about this method.
    pub warnings: Vec<Warning>,
}
