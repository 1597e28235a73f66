//! Methods: what joins a boundary, an energy and a solver into a patch.

mod area;
mod area_search;
mod error;
mod extremal;
mod harmonic;
mod mask;
mod reduced;
mod search;
mod triangle;

use surfaces::{
    Mesh, Net, Patch as SurfacePatch, Pieces, Point, TensorPatch, TrianglePatch, discrete_coons,
    rectangular_mask, tb_coons,
};

pub use area::{AreaExtremal, least_area, least_area_triangle};
pub use error::MethodError;
pub use search::{SearchOutcome, SearchRun};

use crate::{
    Arithmetic, Basis, Boundary, Checkpoint, Energy, Family, Interior, Mask, Method, Patch, PatchExperiment,
    Progress, Shape,
};

/// The patch a method found, with what is known of the way to it.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The patch.
    pub surface: Surface,
    /// The functions it is made of.
    pub family: Family,
    /// The shape parameters (α1, α2, β1, β2), for bases that have them.
    pub shape: Option<[f64; 4]>,
    /// How the interior was solved for, if it was.
    pub solve: Option<SolveFigures>,
    /// How the least area was reached, if it was asked for.
    pub area: Option<AreaExtremal>,
    /// The search for shape parameters, if there was one.
    pub search: Option<SearchOutcome>,
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
}

impl SolveFigures {
    /// Of nets given by a formula: nothing was solved.
    const EXPLICIT: Self =
        Self { solver: "explicit", residual: 0.0, condition: 1.0, basis_condition: None, certified: None };

    /// Of the extremal of a form with some points fixed, by a dense factorisation.
    fn dense(
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
            certified: Some(solve::proves_positive_definite(partition.free().len(), &block)?),
        })
    }
}

/// A surface that loses more than this share of its size to cancellation is not one.
pub(crate) const WORST_CANCELLATION: f64 = 1e-3;

/// A patch of any kind.
#[derive(Debug, Clone)]
pub enum Surface {
    /// On a rectangular net.
    Tensor(TensorPatch),
    /// On a triangular net.
    Triangle(TrianglePatch),
    /// On several rectangular nets that meet, or one.
    Pieces(Pieces),
}

impl Surface {
    /// The patch as such.
    pub fn patch(&self) -> &dyn SurfacePatch {
        match self {
            Self::Tensor(patch) => patch,
            Self::Triangle(patch) => patch,
            Self::Pieces(pieces) => pieces,
        }
    }

    /// Share of the size of the boundary that rounding takes of the points of the surface: where free control points lie far
    /// beyond the boundary, the surface is what their differences leave.
    pub fn cancellation(&self) -> f64 {
        let share = |fixed: &[bool], points: &[Point]| {
            let border = || fixed.iter().zip(points).filter(|(fixed, _)| **fixed).map(|(_, &p)| p);
            let Some(origin) = border().next() else { return 0.0 };
            let size = border().map(|p| p.distance(origin)).fold(0.0, f64::max);
            let reach = points.iter().map(|p| p.distance(origin)).fold(0.0, f64::max);
            if size > 0.0 { f64::EPSILON * reach / size } else { 0.0 }
        };
        match self {
            Self::Tensor(patch) => {
                let (rows, cols) = (patch.net().rows(), patch.net().cols());
                // Constructed nets have all points fixed.
                let on_border = |k: usize| {
                    let (i, j) = (k / cols, k % cols);
                    i == 0 || j == 0 || i + 1 == rows || j + 1 == cols
                };
                share(&(0..rows * cols).map(on_border).collect::<Vec<_>>(), patch.net().points())
            }
            Self::Triangle(patch) => {
                let on_border = |index: [usize; 3]| index.contains(&0);
                share(&patch.net().indices().map(on_border).collect::<Vec<_>>(), patch.net().points())
            }
            Self::Pieces(_) => 0.0,
        }
    }

    /// The degrees in u and v; twice the same of a triangular patch, 0 of several pieces.
    pub(crate) fn degrees(&self) -> (usize, usize) {
        match self {
            Self::Tensor(patch) => patch.net().degrees(),
            Self::Triangle(patch) => (patch.net().degree(), patch.net().degree()),
            Self::Pieces(_) => (0, 0),
        }
    }

    /// Its triangle mesh.
    pub fn mesh(&self, subdivisions: usize) -> Mesh {
        Mesh::of(self.patch(), subdivisions)
    }
}

/// What a method sees of its experiment while it runs.
#[derive(Clone, Copy)]
pub(crate) struct Context<'a> {
    pub(crate) experiment: &'a PatchExperiment,
    /// Which method of the experiment this is.
    pub(crate) index: usize,
    /// Where runs of searches that have ended are kept.
    pub(crate) checkpoint: Option<&'a Checkpoint>,
    pub(crate) seed: u64,
    pub(crate) arithmetic: Arithmetic,
    pub(crate) progress: &'a dyn Progress,
}

/// Runs one method.
pub(crate) fn solve(method: &Method, context: &Context<'_>) -> Result<Solved, MethodError> {
    let boundary = &context.experiment.boundary;
    if let Boundary::Triangle { ab, bc, ca } = boundary {
        let (patch, solve, area) = triangle::solve(method, [ab, bc, ca], context.progress)?;
        let (surface, family) = (Surface::Triangle(patch), Family::Triangle);
        return Ok(Solved { surface, family, shape: None, solve, area, search: None });
    }
    let (net, construction) = construct(method, boundary)?;
    let (shape, search) = match method.shape {
        Shape::None => (None, None),
        Shape::Fixed(shape) => (Some(shape), None),
        Shape::Search(mode) => {
            let outcome = search::search(&net, method, mode, context)?;
            (Some(outcome.shape), Some(outcome))
        }
    };
    let patch = with_shape(net, method, shape)?;
    let (patch, solve, area) = match construction {
        Some(figures) => (patch, Some(figures), None),
        None if extremal_energy(method) == Some(Energy::Area) => {
            context.progress.begin(&format!("least area of {}", method.name), None);
            let found = least_area(&patch, method.tolerance, context.progress);
            context.progress.end();
            let (patch, found) = found?;
            (patch, None, Some(found))
        }
        None => {
            let (patch, figures) = extremal::solve(&patch, method)?;
            (patch, Some(figures), None)
        }
    };
    let family = match (method.patch, method.basis) {
        (Patch::TbCoons, _) => Family::TbCoons,
        (_, Basis::Gt) => Family::Gt,
        _ => Family::Bernstein,
    };
    Ok(Solved { surface: Surface::Tensor(patch), family, shape, solve, area, search })
}

/// The net of a method: whole, with the figures of its construction, or with an interior yet to be solved for.
fn construct(method: &Method, boundary: &Boundary) -> Result<(Net, Option<SolveFigures>), MethodError> {
    if method.interior == Interior::Harmonic {
        let (net, figures) = harmonic::net(boundary)?;
        return Ok((net, Some(figures)));
    }
    let net = boundary_net(method, boundary)?;
    let alpha = match method.interior {
        Interior::Mask(Mask::Alpha(alpha)) => alpha,
        Interior::DiscreteCoons => {
            let [u0, u1, v0, v1] = net.boundary();
            return Ok((discrete_coons(&u0, &u1, &v0, &v1)?.with_all_fixed(), Some(SolveFigures::EXPLICIT)));
        }
        Interior::Mask(_) => return Err(MethodError::Unavailable { what: "this mask for tensor nets" }),
        Interior::Extremal { .. } | Interior::Harmonic => return Ok((net, None)),
    };
    let system = rectangular_mask(alpha, &net)?;
    let (m, n) = net.degrees();
    let (coordinates, figures) = mask::solve(&system, net.fixed(), &net.coordinates())
        .map_err(|error| error.of_mask(alpha, m.max(n)))?;
    Ok((net.with_coordinates(&coordinates)?.with_all_fixed(), Some(figures)))
}

/// The net with its boundary fixed, raised as the method asks.
fn boundary_net(method: &Method, boundary: &Boundary) -> Result<Net, MethodError> {
    let points = |row: &[[f64; 3]]| row.iter().copied().map(Point::from).collect::<Vec<_>>();
    match boundary {
        Boundary::Tensor { u0, u1, v0, v1 } => {
            let net = Net::from_boundary(&points(u0), &points(u1), &points(v0), &points(v1))?;
            Ok(net.raised(method.raise))
        }
        _ => Err(MethodError::Unavailable { what: "this kind of boundary" }),
    }
}

/// The patch of a method on a net, its interior not yet solved for.
fn with_shape(net: Net, method: &Method, shape: Option<[f64; 4]>) -> Result<TensorPatch, MethodError> {
    Ok(match (method.patch, method.basis, shape) {
        (Patch::TbCoons, _, Some(shape)) => tb_coons(net, shape)?,
        (_, Basis::Gt, Some(shape)) => TensorPatch::gt(net, shape)?,
        _ => TensorPatch::bernstein(net)?,
    })
}

/// The quadratic functional behind an energy of the plan; none for the area.
fn functional(energy: Energy) -> Option<energy::Functional> {
    match energy {
        Energy::Dirichlet => Some(energy::Functional::Dirichlet),
        Energy::Laplacian => Some(energy::Functional::Laplacian),
        Energy::Bending => Some(energy::Functional::Bending),
        Energy::Coons => Some(energy::Functional::Coons),
        Energy::Area => None,
    }
}

/// Degree from which the separable solver is both faster than a dense one and more accurate.
const SEPARABLE_FROM: usize = 7;

/// Whether the automatic choice is the separable solver, where it applies.
fn prefers_separable(net: &Net) -> bool {
    let (m, n) = net.degrees();
    m.max(n) >= SEPARABLE_FROM
}

/// The energy whose extremal a method's interior is; none for constructions.
fn extremal_energy(method: &Method) -> Option<Energy> {
    match method.interior {
        Interior::Extremal { energy, .. } => Some(energy),
        _ => None,
    }
}
