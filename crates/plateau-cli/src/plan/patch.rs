//! Patches over a fixed boundary net: the boundary, the methods, the search.

use super::{Expected, Published};

/// Patches over one boundary, one row of the table per method.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchExperiment {
    /// The fixed control points.
    pub boundary: Boundary,
    /// At least one; names are unique.
    pub methods: Vec<Method>,
    /// How shape parameters are searched, for the methods with [`Shape::Search`].
    pub search: Search,
}

/// The fixed control points of a net.
#[derive(Clone, Debug, PartialEq)]
pub enum Boundary {
    /// All four sides of a tensor net of degree (m, n), corners repeated and equal.
    Tensor {
        /// Row `P_{0,j}`, n + 1 points, n ≥ 1.
        u0: Vec<[f64; 3]>,
        /// Row `P_{m,j}`, n + 1 points.
        u1: Vec<[f64; 3]>,
        /// Column `P_{i,0}`, m + 1 points, m ≥ 1.
        v0: Vec<[f64; 3]>,
        /// Column `P_{i,n}`, m + 1 points.
        v1: Vec<[f64; 3]>,
    },
    /// The rows i = 0 and i = m only, for harmonic nets.
    Rows {
        /// Row `P_{0,j}`, n + 1 points, n ≥ 1.
        u0: Vec<[f64; 3]>,
        /// Row `P_{m,j}`, n + 1 points.
        u1: Vec<[f64; 3]>,
        /// The degree m in u, in 1..=[`MAX_DEGREE`](super::MAX_DEGREE).
        degree: usize,
    },
    /// The columns j = 0 and j = n only, for harmonic nets.
    Columns {
        /// Column `P_{i,0}`, m + 1 points, m ≥ 1.
        v0: Vec<[f64; 3]>,
        /// Column `P_{i,n}`, m + 1 points.
        v1: Vec<[f64; 3]>,
        /// The degree n in v, in 1..=[`MAX_DEGREE`](super::MAX_DEGREE).
        degree: usize,
    },
    /// All three sides of a triangular net of degree n ≥ 1, corners repeated and equal;
    /// A = `P_{n,0,0}`, B = `P_{0,n,0}`, C = `P_{0,0,n}`.
    Triangle {
        /// Side from A to B, n + 1 points.
        ab: Vec<[f64; 3]>,
        /// Side from B to C, n + 1 points.
        bc: Vec<[f64; 3]>,
        /// Side from C to A, n + 1 points.
        ca: Vec<[f64; 3]>,
    },
}

impl Boundary {
    /// Degrees (m, n) of a tensor net, or (n, n) of a triangular one, before any `raise`.
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        match self {
            Self::Tensor { u0, v0, .. } => (v0.len() - 1, u0.len() - 1),
            Self::Rows { u0, degree, .. } => (*degree, u0.len() - 1),
            Self::Columns { v0, degree, .. } => (v0.len() - 1, *degree),
            Self::Triangle { ab, .. } => (ab.len() - 1, ab.len() - 1),
        }
    }
}

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
    /// Degrees to raise the boundary by before solving; degree + raise ≤ [`MAX_DEGREE`](super::MAX_DEGREE).
    pub raise: usize,
    /// The linear solver. [`SolverChoice::Separable`] only for Dirichlet extremals of tensor patches,
    /// [`SolverChoice::Sparse`] only for masks.
    pub solver: SolverChoice,
    /// For [`Energy::Area`]: the relative decrease of the area that counts as none, in [1e-12, 1e-2].
    pub tolerance: f64,
    /// Numbers the result must reproduce.
    pub expect: Vec<Expected>,
    /// Figures printed elsewhere, to be shown beside ours.
    pub published: Vec<Published>,
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

/// How shape parameters are searched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchMode {
    /// Particle swarm only, as in the paper.
    Pso,
    /// Descent with the gradient only, from `runs` starts.
    Polish,
    /// Particle swarm, then descent from each run's best point (`search = true`).
    PsoPolish,
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
    /// With [`Boundary::Rows`] or [`Boundary::Columns`] the two sides determine it; with
    /// [`Boundary::Tensor`] all four sides are data, and it is the runner's to find them in conflict.
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

/// The search for shape parameters: a particle swarm in a box (GT §5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Who informs a particle.
    pub variant: Variant,
    /// Particles of a swarm, in 1..=[`optim::MAX_PARTICLES`].
    pub particles: usize,
    /// Iterations of a run, in 1..=1 000 000.
    pub iterations: usize,
    /// Independent runs, or starts of a polish, in 1..=10 000;
    /// `particles × iterations × runs` ≤ [`MAX_SEARCH_BUDGET`](super::MAX_SEARCH_BUDGET).
    pub runs: usize,
    /// Inertia w, in [0, 1].
    pub inertia: f64,
    /// Social coefficient c1, in [0, 10].
    pub social: f64,
    /// Cognitive coefficient c2, in [0, 10].
    pub cognitive: f64,
    /// Lower end of the box in every parameter, ≥ 0.
    pub lower: f64,
    /// Upper end of the box in every parameter, > lower and ≤ 4.
    pub upper: f64,
}

/// Who informs a particle of a swarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// Every particle.
    Global,
    /// The ring neighbours.
    Local {
        /// Neighbours on each side, ≥ 1.
        neighbours: usize,
    },
}

impl Default for Search {
    /// The values of GT §5: a global swarm of 50, 100 iterations, 10 runs, w = 0.7, c1 = c2 = 1.5,
    /// box [0.5, 3.5].
    fn default() -> Self {
        Self {
            variant: Variant::Global,
            particles: 50,
            iterations: 100,
            runs: 10,
            inertia: 0.7,
            social: 1.5,
            cognitive: 1.5,
            lower: 0.5,
            upper: 3.5,
        }
    }
}
