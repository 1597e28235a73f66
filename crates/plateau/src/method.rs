//! Methods: ways to fill a boundary.

use energy::ReferenceTriangle;

use crate::search::SearchMode;

/// One way to fill the boundary: one row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    /// Name of the row; not empty, unique in the experiment.
    pub name: String,
    /// The kind of patch.
    pub patch: Patch,
    /// The basis of a tensor net; [`Basis::Gt`] for TB–Coons, [`Basis::Bernstein`] for triangles.
    /// With [`Basis::Gt`] the degree after `raise` is at least 2 in each direction.
    pub basis: Basis,
    /// The shape parameters: [`Shape::None`] exactly if the basis is Bernstein.
    pub shape: Shape,
    /// How the interior control points are found.
    pub interior: Interior,
    /// What the shape parameters minimise, if they are searched. For methods without a search it is
    /// the energy of the extremal, or Dirichlet where there is none, and means nothing.
    pub search_energy: Energy,
    /// Degrees to raise the boundary by before solving; degree + raise ≤ [`MAX_DEGREE`](crate::MAX_DEGREE).
    pub raise: usize,
    /// The linear solver. [`SolverChoice::Separable`] only for Dirichlet extremals of tensor patches,
    /// [`SolverChoice::Sparse`] only for masks.
    pub solver: SolverChoice,
    /// For extremals of quadratic energies over a triangular net: the plane triangle over which the energy is taken.
    pub domain: ReferenceTriangle,
    /// For [`Energy::Area`]: the relative decrease of the area that counts as none, in [1e-12, 1e-2].
    pub tolerance: f64,
    /// For [`Energy::Area`] in the Bernstein basis over a tensor boundary: whether a lower bound is to be proved.
    pub bound: bool,
}

/// The kind of patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Patch {
    /// `Σ P_ij φ_i(u) ψ_j(v)`.
    Tensor,
    /// The Bernstein–GT Coons blend of GT §7.
    TbCoons,
    /// `Σ P_ijk B^n_ijk(u, v)` on the unit triangle.
    Triangle,
}

/// The univariate basis of a tensor patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Bernstein polynomials.
    Bernstein,
    /// Generalized trigonometric functions with shape parameters (GT).
    Gt,
}

/// The four shape parameters (α1, α2; β1, β2): α in u, β in v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// The basis has none.
    None,
    /// Given: each in [0, 4], neither pair both zero.
    Fixed([f64; 4]),
    /// To be searched.
    Search(SearchMode),
}

/// How the interior control points are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interior {
    /// The extremal of an energy.
    Extremal {
        /// The energy that is minimised.
        energy: Energy,
        /// Steps of the metric correction afterwards (TRI §7), at most 1000; 0 unless the energy is Dirichlet.
        metric_steps: usize,
    },
    /// Each interior point is a fixed combination of its eight (tensor) or nine (triangle) neighbours.
    Mask(Mask),
    /// The discrete Coons patch; it raises a triangle's degree by one (COONS (3)).
    DiscreteCoons,
    /// The net of a harmonic Bézier surface (GT §6, corrected), for tensor patches without `raise`.
    ///
    /// With [`Boundary::Opposite`](crate::Boundary::Opposite) the two sides determine it; with
    /// [`Boundary::Tensor`](crate::Boundary::Tensor) all four sides are data, and it is the runner's to find them in conflict.
    Harmonic,
}

/// A mask: weights that express an interior point by its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mask {
    /// The symmetric mask with corner weight α: edge weight β with 3α + 6β = 1 for triangles,
    /// 4α + 4β = 1 for tensor nets.
    Alpha(f64),
    /// The Dirichlet mask of TRI, triangles only.
    Dirichlet,
    /// The Coons mask of COONS Prop. 4, triangles only (for tensor nets it is α = −1/4).
    Coons,
}

/// An energy of a patch (spec §2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// ½∫(E + G).
    Dirichlet,
    /// ∫‖x_uu + x_vv‖².
    Laplacian,
    /// ∫‖x_uu‖² + 2‖x_uv‖² + ‖x_vv‖².
    Bending,
    /// ∫‖x_uv‖².
    Coons,
    /// ∫√(EG − F²).
    Area,
}

/// A linear solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolverChoice {
    /// Whatever suits the system best.
    #[default]
    Auto,
    /// Dense factorization.
    Dense,
    /// Two small generalized eigenproblems.
    Separable,
    /// Sparse factorization.
    Sparse,
}

impl Method {
    /// The energy whose extremal the interior is; none for constructions.
    pub fn extremal_energy(&self) -> Option<Energy> {
        match self.interior {
            Interior::Extremal { energy, .. } => Some(energy),
            Interior::Mask(_) | Interior::DiscreteCoons | Interior::Harmonic => None,
        }
    }
}

impl Energy {
    /// The quadratic functional behind the energy; none for the area.
    pub(crate) fn functional(self) -> Option<energy::Functional> {
        match self {
            Self::Dirichlet => Some(energy::Functional::Dirichlet),
            Self::Laplacian => Some(energy::Functional::Laplacian),
            Self::Bending => Some(energy::Functional::Bending),
            Self::Coons => Some(energy::Functional::Coons),
            Self::Area => None,
        }
    }
}
