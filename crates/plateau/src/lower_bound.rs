//! How small the area can be at all: a proved lower bound over every surface with the rim, by a calibration.

use bases::Matrix;
use energy::{Calibration, EnergyError, Plane, Unproved, certify};
use solve::{SolveError, solve_spd};
use surfaces::{Complex, Point, Side};
use thiserror::Error;

/// A lower bound of area, with what proves it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LowerBound {
    /// No surface of `competitors` has less area (unit: length²). Proved: whatever rounding did is taken off.
    pub value: f64,
    /// Which surfaces are meant.
    pub competitors: Competitors,
    /// The plane over which the surface is a graph.
    pub plane: Plane,
    /// Degree of the potential on each face.
    pub degree: usize,
    /// The coefficients of the potential, one for each control point of the complex raised to `degree`.
    pub potential: Vec<f64>,
}

/// The surfaces that a bound holds for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Competitors {
    /// Every oriented surface with this rim, of any topology: the rim projects to a convex curve.
    Surfaces,
    /// Every graph over the plane with this rim.
    Graphs,
}

impl Competitors {
    /// Who is meant, for sentences.
    pub fn name(self) -> &'static str {
        match self {
            Self::Surfaces => "every surface with this rim",
            Self::Graphs => "every graph over this plane with this rim",
        }
    }
}

/// Why no bound was proved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NoBound {
    /// Three faces meet at an edge.
    #[error("three and more faces meet at an edge: such films are no graph over a plane")]
    FilmsMeet,
    /// The surface is no graph.
    #[error("the surface is no graph over any plane that was tried")]
    NoGraph,
    /// More coefficients than are solved for.
    #[error("the bound needs {unknowns} coefficients, more than {max}; lower the degree")]
    TooLarge {
        /// Coefficients needed.
        unknowns: usize,
        /// Most that are offered.
        max: usize,
    },
    /// A potential was found, but the signs that make it a proof could not be shown.
    #[error("a bound was found but not proved: {0}")]
    Unproved(#[from] Unproved),
    /// The integrals could not be made.
    #[error(transparent)]
    Energy(#[from] EnergyError),
    /// The systems could not be solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

/// By how much the degree of the potential exceeds that of the surface: with the same degree the gap is a thousand times larger.
const HIGHER: usize = 3;

/// Most coefficients of a potential: a dense system of this order takes seconds.
const MOST_UNKNOWNS: usize = 2500;

/// Newton steps: convergence is quadratic.
const STEPS: usize = 12;

/// What the potential is shrunk by, one after the other, until its rise is shown to be at most 1.
const SHRINKING: [f64; 6] = [0.0, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5];

/// A lower bound of the area of every surface with the rim of `complex`, where that is a graph over a plane, which is looked for. The
/// closer the complex is to the surface of least area, the closer the bound is to the least area.
///
/// For every continuous ψ with |∇ψ| ≤ 1 over the region Ω below the surface, `A ≥ ∮ z dψ + ∫_Ω √(1 − |∇ψ|²)`; ψ is taken of degree
/// p + 3 on the faces, from the least-squares fit to the flux of the surface by Newton's method.
///
/// # Errors
/// [`NoBound`] says why there is none.
pub fn lower_bound(complex: &Complex) -> Result<LowerBound, NoBound> {
    if complex.edges().iter().any(|edge| edge.uses().len() > 2) {
        return Err(NoBound::FilmsMeet);
    }
    let degree = complex.degree() + HIGHER;
    let unknowns = complex.with_degree(degree).map_err(EnergyError::from)?.points().len();
    if unknowns > MOST_UNKNOWNS {
        return Err(NoBound::TooLarge { unknowns, max: MOST_UNKNOWNS });
    }
    let plane = plane(complex)?.ok_or(NoBound::NoGraph)?;
    let calibration = Calibration::new(complex, &plane, degree, 2 * degree)?.ok_or(NoBound::NoGraph)?;
    let best = potential(&calibration)?;
    let mut last = None;
    for shrink in SHRINKING {
        let potential: Vec<f64> = best.iter().map(|c| c * (1.0 - shrink)).collect();
        match certify(complex, &plane, degree, &potential) {
            Ok(value) => {
                let competitors =
                    if is_convex(complex, &plane) { Competitors::Surfaces } else { Competitors::Graphs };
                return Ok(LowerBound { value, competitors, plane, degree, potential });
            }
            Err(why @ Unproved::Steep { .. }) => last = Some(why),
            Err(why) => return Err(why.into()),
        }
    }
    Err(last.map_or(NoBound::NoGraph, NoBound::from))
}

/// A plane to which every normal of the surface leans, with its normal on their side; none if there is none. The normals' mean is
/// turned towards the one furthest from it until all are on its side.
fn plane(complex: &Complex) -> Result<Option<Plane>, NoBound> {
    let mut normals = Vec::new();
    let samples = complex.degree() + 2;
    for face in 0..complex.faces().len() {
        let patch = complex.patch(face).map_err(EnergyError::from)?;
        let at: Vec<f64> = (0..=samples).map(|k| k as f64 / samples as f64).collect();
        normals.extend(surfaces::Patch::jets(&patch, &at, &at).iter().map(|jet| jet.u.cross(jet.v)));
    }
    let mut sum = normals.iter().fold(Point::ZERO, |sum, &normal| sum + normal);
    let directions: Vec<Point> = normals.into_iter().filter_map(Point::unit).collect();
    let centre =
        complex.points().iter().fold(Point::ZERO, |sum, &p| sum + p) * (1.0 / complex.points().len() as f64);
    for _ in 0..200 {
        let Some(plane) = Plane::with_normal(centre, sum) else { return Ok(None) };
        let lean = |d: &Point| d.dot(plane.axes[2]);
        let Some(worst) = directions.iter().min_by(|a, b| lean(a).total_cmp(&lean(b))) else {
            return Ok(None);
        };
        if lean(worst) > 1e-3 {
            return Ok(Some(plane));
        }
        sum = plane.axes[2] + *worst * (0.2 - lean(worst));
    }
    Ok(None)
}

/// The best potential of a calibration.
fn potential(calibration: &Calibration) -> Result<Vec<f64>, NoBound> {
    let (matrix, rhs) = calibration.fit();
    let mut psi = solved(&matrix, &rhs)?;
    let mut value = calibration.value(&psi);
    while value.is_none() {
        psi.iter_mut().for_each(|c| *c *= 0.95);
        value = calibration.value(&psi);
    }
    let Some(mut value) = value else { return Ok(psi) };
    for _ in 0..STEPS {
        let (gradient, hessian) = calibration.derivatives(&psi);
        let step = solved(&hessian, &gradient)?;
        let risen = [1.0, 0.5, 0.25, 0.1, 0.01].into_iter().find_map(|length| {
            let next: Vec<f64> = psi.iter().zip(&step).map(|(c, s)| c + length * s).collect();
            calibration.value(&next).filter(|&reached| reached > value).map(|reached| (next, reached))
        });
        let Some((next, reached)) = risen else { break };
        let gained = reached - value;
        (psi, value) = (next, reached);
        if gained <= 1e-15 * value {
            break;
        }
    }
    Ok(psi)
}

/// The solution whose first coefficient is 0: constants are the kernel of both matrices.
fn solved(matrix: &Matrix, rhs: &[f64]) -> Result<Vec<f64>, SolveError> {
    let n = rhs.len() - 1;
    let reduced: Vec<f64> = (1..=n).flat_map(|i| matrix.row(i)[1..].to_vec()).collect();
    let solution = solve_spd(n, &reduced, 1, &rhs[1..])?;
    Ok(std::iter::once(0.0).chain(solution.x).collect())
}

/// Whether the rim is one loop that projects to a convex curve: its control polygons, end to end, turn left all the way, once.
fn is_convex(complex: &Complex, plane: &Plane) -> bool {
    let Some(polygon) = rim_polygon(complex) else { return false };
    let flat: Vec<[f64; 2]> = polygon.iter().map(|&p| plane.coordinates(p)).map(|[x, y, _]| [x, y]).collect();
    let steps: Vec<[f64; 2]> = (0..flat.len())
        .map(|k| (flat[k], flat[(k + 1) % flat.len()]))
        .map(|(a, b)| [b[0] - a[0], b[1] - a[1]])
        .filter(|s| s[0] != 0.0 || s[1] != 0.0)
        .collect();
    let mut turned = 0.0;
    for (k, a) in steps.iter().enumerate() {
        let b = steps[(k + 1) % steps.len()];
        let (cross, along) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        let rounding = 64.0 * f64::EPSILON * complex.size() * (a[0].hypot(a[1]) + b[0].hypot(b[1]));
        if cross < -rounding {
            return false;
        }
        turned += cross.max(0.0).atan2(along);
    }
    (turned - std::f64::consts::TAU).abs() < 1e-6
}

/// The control points of the rim in order, with the surface on the left; none if it is not one loop.
fn rim_polygon(complex: &Complex) -> Option<Vec<Point>> {
    let mut runs: Vec<Vec<usize>> = Vec::new();
    for (number, edge) in complex.edges().iter().enumerate() {
        let [only] = edge.uses() else { continue };
        let mut nodes = complex.edge_nodes(number);
        if only.reversed == Side::runs_round(only.side) {
            nodes.reverse();
        }
        runs.push(nodes);
    }
    let mut current = runs.pop()?;
    let (first, mut polygon) = (current[0], Vec::new());
    loop {
        let end = *current.last()?;
        polygon.extend(current[..current.len() - 1].iter().map(|&node| complex.points()[node]));
        if end == first {
            return runs.is_empty().then_some(polygon);
        }
        let next = runs.iter().position(|run| run[0] == end)?;
        current = runs.swap_remove(next);
    }
}
