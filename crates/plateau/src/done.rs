//! A patch that was found, with its figures.

use surfaces::{Mesh, Patch};

use crate::{
    BoundaryFigures, ClosedForm, Context, Family, Figures, FilmFigures, LowerBound, MethodError, Search,
    Solved, Surface, Warning, trust,
};

/// A method that found its patch.
#[derive(Debug)]
#[non_exhaustive]
pub struct Done {
    /// The patch and the way to it.
    pub solved: Solved,
    /// The mesh the files and the largest curvature are taken from.
    pub mesh: Mesh,
    /// Its figures.
    pub figures: Figures,
    /// What its boundary admits and how far it moved, for patches on the unit square.
    pub boundary: Option<BoundaryFigures>,
    /// How it compares with its closed form, for surfaces that have one.
    pub closed_form: Option<ClosedForm>,
    /// How its patches lie, for surfaces over loops and faces.
    pub film: Option<FilmFigures>,
    /// What the area is above the least area of the boundary, where it was estimated.
    pub estimate: Option<f64>,
    /// An area that no surface, or no graph, with the same rim is below, where it was asked for and proved.
    pub bound: Option<LowerBound>,
    /// What a reader must know about this method.
    pub warnings: Vec<Warning>,
}

impl Done {
    /// A surface that is there already, with its figures: nothing is minimised, and nothing is known of a way to it.
    ///
    /// ```
    /// use plateau::{Done, Family, Surface};
    /// use surfaces::{Net, Point, TensorPatch};
    /// let square = [[0., 0., 0.], [0., 1., 0.], [2., 0., 0.], [2., 1., 0.]].map(Point::from);
    /// let patch = TensorPatch::bernstein(Net::new(2, 2, square.to_vec())?)?;
    /// let done = Done::of(Surface::Tensor(patch), Family::Bernstein)?;
    /// assert!((done.figures.area.value - 2.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MethodError::Family`] if the family has no such surfaces, and others where a figure cannot be computed.
    pub fn of(surface: Surface, family: Family) -> Result<Self, MethodError> {
        let mesh = surface.mesh(Context::new(0).mesh)?;
        let figures = match &surface {
            Surface::Complex(complex) => {
                let patches = (0..complex.faces().len())
                    .map(|face| complex.patch(face))
                    .collect::<Result<Vec<_>, _>>()?;
                let patches: Vec<&dyn Patch> = patches.iter().map(|patch| patch as _).collect();
                Figures::of_all(&patches, &mesh)?
            }
            Surface::Tensor(patch) => Figures::of(patch, &mesh)?,
            Surface::Triangle(patch) => Figures::of(patch, &mesh)?,
            Surface::Pieces(pieces) => Figures::of(pieces, &mesh)?,
        };
        let boundary = match &surface {
            Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
            Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_) => None,
        };
        Ok(Self::given(Solved::given(surface, family)?, (mesh, figures, boundary)))
    }

    /// A surface that was given, with what was measured of it, and the warnings that follow.
    pub(crate) fn given(
        solved: Solved,
        (mesh, figures, boundary): (Mesh, Figures, Option<BoundaryFigures>),
    ) -> Self {
        let warnings = trust::warnings(&solved, &figures, &Search::default());
        Self {
            solved,
            mesh,
            figures,
            boundary,
            closed_form: None,
            film: None,
            estimate: None,
            bound: None,
            warnings,
        }
    }
}
