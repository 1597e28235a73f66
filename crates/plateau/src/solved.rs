//! What a method found, and how.

use energy::Functional;
use surfaces::{Complex, Point, TensorPatch, TrianglePatch};

use crate::{AreaExtremal, Energy, Family, FixedShape, MethodError, SearchOutcome, Surface};

/// The patch a method found, with what is known of the way to it.
#[derive(Debug, Clone)]
pub struct Solved {
    surface: Surface,
    family: Family,
    shape: Option<Vec<f64>>,
    interior: Interior,
    search: Option<SearchOutcome>,
}

/// How the inner points of a surface were found.
#[derive(Debug, Clone)]
pub(crate) enum Interior {
    /// Given, or by a construction; with its linear system, if there was one.
    Constructed(Option<SolveFigures>),
    /// As the extremal of a quadratic energy; nothing is known of the system of several patches.
    Extremal(Functional, Option<SolveFigures>),
    /// As the least area.
    LeastArea(Box<AreaExtremal>),
}

impl Solved {
    /// A rectangular patch in the functions of a shape, of Bernstein polynomials where there is none.
    pub(crate) fn tensor(patch: TensorPatch, shape: Option<&FixedShape>, interior: Interior) -> Self {
        let family = shape.map_or(Family::Bernstein, |shape| Family::Shaped(shape.family()));
        let shape = shape.map(|shape| shape.parameters().to_vec());
        Self { surface: Surface::Tensor(patch), family, shape, interior, search: None }
    }

    /// A triangular patch.
    pub(crate) fn triangle(patch: TrianglePatch, interior: Interior) -> Self {
        let surface = Surface::Triangle(patch);
        Self { surface, family: Family::Triangle, shape: None, interior, search: None }
    }

    /// Patches that share edges.
    pub(crate) fn complex(complex: Complex, interior: Interior) -> Self {
        let surface = Surface::Complex(complex);
        Self { surface, family: Family::Complex, shape: None, interior, search: None }
    }

    /// A surface that was given, of whose shape nothing is known.
    ///
    /// # Errors
    /// [`MethodError::Family`] if the family has no surfaces of this kind.
    pub(crate) fn given(surface: Surface, family: Family) -> Result<Self, MethodError> {
        match (&surface, family) {
            (Surface::Tensor(_), Family::Bernstein | Family::Shaped(_))
            | (Surface::Triangle(_), Family::Triangle)
            | (Surface::Pieces(_), Family::Aht | Family::At)
            | (Surface::Complex(_), Family::Complex) => {
                Ok(Self { surface, family, shape: None, interior: Interior::Constructed(None), search: None })
            }
            (
                Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_),
                Family::Bernstein
                | Family::Shaped(_)
                | Family::Triangle
                | Family::Aht
                | Family::At
                | Family::Complex,
            ) => Err(MethodError::Family { surface: surface.kind(), family }),
        }
    }

    /// As a search found its shape.
    pub(crate) fn searched(self, search: Option<SearchOutcome>) -> Self {
        Self { search, ..self }
    }

    /// The same surface elsewhere.
    pub(crate) fn moved(self, by: Point) -> Result<Self, MethodError> {
        Ok(Self { surface: self.surface.moved(by)?, ..self })
    }

    /// The patch.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The patch by itself.
    #[must_use]
    pub fn into_surface(self) -> Surface {
        self.surface
    }

    /// The functions it is made of.
    #[must_use]
    pub fn family(&self) -> Family {
        self.family
    }

    /// The shape parameters, for families that have them: those in u before those in v. None where they are not known.
    #[must_use]
    pub fn shape(&self) -> Option<&[f64]> {
        self.shape.as_deref()
    }

    /// The energy whose extremal the interior is; none for constructions and closed forms.
    #[must_use]
    pub fn minimised(&self) -> Option<Energy> {
        match &self.interior {
            Interior::Constructed(_) => None,
            Interior::Extremal(functional, _) => Some(Energy::Quadratic(*functional)),
            Interior::LeastArea(_) => Some(Energy::Area),
        }
    }

    /// How the interior was solved for, if one linear system was.
    #[must_use]
    pub fn solve(&self) -> Option<&SolveFigures> {
        match &self.interior {
            Interior::Constructed(solve) | Interior::Extremal(_, solve) => solve.as_ref(),
            Interior::LeastArea(_) => None,
        }
    }

    /// How the least area was reached, if it was asked for.
    #[must_use]
    pub fn area(&self) -> Option<&AreaExtremal> {
        match &self.interior {
            Interior::Constructed(_) | Interior::Extremal(..) => None,
            Interior::LeastArea(found) => Some(found),
        }
    }

    /// The search for shape parameters, if there was one.
    #[must_use]
    pub fn search(&self) -> Option<&SearchOutcome> {
        self.search.as_ref()
    }
}

/// What is known of a linear solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveFigures {
    /// Which solver.
    pub solver: &'static str,
    /// Residual as LAPACK's tests scale it: about 1 is rounding, above 30 a failure.
    pub residual: f64,
    /// Estimate of the condition number of the system that was solved.
    pub condition: f64,
    /// For the separable solver: what the control points may lose besides, the surface not (the condition of the two
    /// families of functions).
    pub basis_condition: Option<f64>,
    /// For the dense solver: whether the matrix is proved positive definite
    /// ([`proves_positive_definite`](solve::proves_positive_definite)), so that the net is the only extremal and a minimum.
    pub certified: Option<bool>,
    /// For conjugate gradients: how far, at most, the parts of the extremal reach that no control net in doubles holds and that
    /// were left out; share of the size of the boundary.
    pub left_out: Option<f64>,
    /// For metric corrections: the energy D^g of the last, whose extremal the net is.
    pub metric: Option<energy::Integral>,
}

impl SolveFigures {
    /// Of nets given by a formula: nothing was solved.
    pub(crate) const EXPLICIT: Self = Self {
        solver: "explicit",
        residual: 0.0,
        condition: 1.0,
        basis_condition: None,
        certified: None,
        left_out: None,
        metric: None,
    };

    /// Of the extremal of a form with some points fixed, by a dense factorisation.
    pub(crate) fn dense(
        matrix: &bases::Matrix,
        partition: &solve::Partition,
        solution: &solve::Solution,
    ) -> Result<Self, solve::SolveError> {
        let block = partition.free_block(matrix.as_slice())?;
        Ok(Self {
            solver: "dense",
            residual: solution.residual,
            condition: solution.condition,
            basis_condition: None,
            left_out: None,
            metric: None,
            certified: Some(solve::proves_positive_definite(partition.free().len(), &block)?),
        })
    }
}
