//! How small the area can be at all: a proved lower bound over every surface with the rim, by a calibration.

use bases::{GaussLegendre, Matrix};
use energy::{Calibration, EnergyError, Plane, Unproved, certify};
use solve::{SolveError, solve_spd};
use surfaces::{
    Bezier, Complex, ComplexError, Edge, Face, FixedEdge, Net, Point, Side, SurfaceError, Vertex,
};
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
    /// The region below the rim, cut into faces, with the potential on each. Faces that share an edge have the control points and
    /// the coefficients along it in common.
    pub faces: Vec<CalibratedFace>,
}

/// A part of the region below a rim, and the potential on it.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibratedFace {
    /// Control points `P_ij` of a patch whose projection to the plane parametrises the part; on the rim they are those of the rim.
    pub net: Vec<Vec<Point>>,
    /// Bernstein coefficients of the potential in the same parameters.
    pub potential: Vec<Vec<f64>>,
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
    /// A net that is no face of a complex.
    #[error(transparent)]
    Net(#[from] SurfaceError),
}

impl From<ComplexError> for NoBound {
    fn from(error: ComplexError) -> Self {
        Self::Energy(error.into())
    }
}

/// By how much the degree of the potential exceeds that of the surface: with the same degree the gap is a thousand times larger.
const HIGHER: usize = 3;

/// The degree of the potential is not made larger than this where that of the rim is not: in Bernstein form the systems lose four
/// fifths of a digit a degree.
const HIGHEST: usize = 12;

/// Most coefficients of a potential: a dense system of this order takes seconds.
const MOST_UNKNOWNS: usize = 2500;

/// Faces are cut in four where the potential does not have more coefficients then: over one patch this brings the bound ten times nearer, and
/// takes a second.
const FEW_UNKNOWNS: usize = 700;

/// Newton steps at most, and halvings of one: convergence is quadratic once near.
const STEPS: usize = 40;
const HALVINGS: i32 = 20;

/// Share of the diagonal that is added to a matrix which is singular to working precision: it slows the steps, and harms no bound.
const REGULAR: f64 = 1e-12;

/// What the potential is shrunk by, one after the other, until its rise is shown to be at most 1.
const SHRINKING: [f64; 6] = [0.0, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5];

/// A lower bound of the area of every surface with the rim of `complex`, where that bounds a graph over a plane, which is looked for.
/// The higher the degree of the complex, the closer the bound is to the least area.
///
/// For every continuous ψ with |∇ψ| ≤ 1 over the region Ω below the rim, `A ≥ ∮ z dψ + ∫_Ω √(1 − |∇ψ|²)`; ψ is taken of degree
/// p + 3, at most 12 or p, on the faces, from the least-squares fit to the flux of the Coons surface by Newton's method. The faces
/// are those of the Coons surface over the rim, or of the surface itself where the projection of that turns over; a few are cut in
/// four.
///
/// # Errors
/// [`NoBound`] says why there is none.
pub fn lower_bound(complex: &Complex) -> Result<LowerBound, NoBound> {
    let degree = (complex.degree() + HIGHER).min(HIGHEST).max(complex.degree());
    of_first([coons(complex), Ok(complex.clone())], degree)
}

/// As [`lower_bound`], of surfaces with the border of the Bernstein–Bézier patch on `border`, whose inner points play no part;
/// `surface` is the net of a surface near the least area.
///
/// # Errors
/// [`NoBound`] says why there is none.
pub fn lower_bound_of_net(border: &Net, surface: &Net) -> Result<LowerBound, NoBound> {
    let degree_of = |net: &Net| net.degrees().0.max(net.degrees().1);
    let degree = (degree_of(surface) + HIGHER).min(HIGHEST).max(degree_of(surface));
    // The faces of the surface itself, over its own rim: that of the border but for rounding.
    let with_inside = one_face(surface).and_then(|(complex, net)| {
        let mut points = complex.points().to_vec();
        for (&node, &point) in complex.faces()[0].nodes().iter().zip(net.points()) {
            points[node] = point;
        }
        Ok(complex.with_points(points)?)
    });
    let over_border = one_face(border).map(|(complex, _)| complex)?;
    // The border is that of the net but for the rounding of its raising.
    // Degrees are raised one by one; each raising rounds every control point once.
    let raised = moved(&over_border, degree_of(surface) - border.degrees().0.min(border.degrees().1));
    let mut bound = of_first([Ok(over_border), with_inside], degree)?;
    bound.value -= raised;
    Ok(bound)
}

/// The bound over the first of several surfaces with the same rim that gives one, by a potential of a degree.
fn of_first<const N: usize>(
    surfaces: [Result<Complex, NoBound>; N],
    degree: usize,
) -> Result<LowerBound, NoBound> {
    let mut why = NoBound::NoGraph;
    for surface in surfaces {
        // Quarters first: the bound is nearer to the area where they succeed.
        let bound = surface.and_then(|surface| match of_quarters(&surface, degree) {
            Some(Ok(bound)) => Ok(bound),
            Some(Err(_)) | None => of_faces(&surface, degree),
        });
        match bound {
            Ok(bound) => return Ok(bound),
            Err(error) => why = error,
        }
    }
    Err(why)
}

/// The bound over the faces of a complex cut in four, where there are few.
fn of_quarters(complex: &Complex, degree: usize) -> Option<Result<LowerBound, NoBound>> {
    let unknowns = complex.faces().len() * (2 * degree + 1).pow(2);
    (unknowns <= FEW_UNKNOWNS).then(|| {
        let mut bound = of_faces(&complex.halved()?, degree)?;
        bound.value -= moved(complex, complex.degree());
        Ok(bound)
    })
}

/// What the area may change by when every control point of the rim is rounded a number of times: no more than what that sweeps.
fn moved(complex: &Complex, roundings: usize) -> f64 {
    let reach = complex.points().iter().map(|p| p.norm()).fold(0.0, f64::max);
    let rim = (0..complex.edges().len()).filter(|&number| complex.edges()[number].uses().len() == 1);
    let polygons = rim.map(|number| complex.edge_curve(number));
    let length: f64 = polygons
        .map(|curve| curve.points().windows(2).map(|ends| ends[0].distance(ends[1])).sum::<f64>())
        .sum();
    // Each point moves by a rounding of its distance from the origin, and sweeps that times the length of the rim.
    8.0 * roundings as f64 * f64::EPSILON * reach * length
}

/// The bound by a potential of a degree on the faces of a complex.
fn of_faces(complex: &Complex, degree: usize) -> Result<LowerBound, NoBound> {
    if complex.edges().iter().any(|edge| edge.uses().len() > 2) {
        return Err(NoBound::FilmsMeet);
    }
    let raised = complex.with_degree(degree)?;
    let unknowns = raised.points().len();
    if unknowns > MOST_UNKNOWNS {
        return Err(NoBound::TooLarge { unknowns, max: MOST_UNKNOWNS });
    }
    let plane = plane(complex)?.ok_or(NoBound::NoGraph)?;
    let calibration = Calibration::new(complex, &plane, degree, 2 * degree)?.ok_or(NoBound::NoGraph)?;
    let best = potential(&calibration)?;
    // Where the surface is steep |∇ψ| is near 1, and above it by rounding: shrunk a little it can be proved, at a loss of that share.
    let mut last = None;
    for shrink in SHRINKING {
        let potential: Vec<f64> = best.iter().map(|c| c * (1.0 - shrink)).collect();
        match certify(complex, &plane, degree, &potential) {
            Ok(value) => {
                let competitors =
                    if is_convex(complex, &plane) { Competitors::Surfaces } else { Competitors::Graphs };
                let face = |(own, fine): (&Face, &Face)| CalibratedFace {
                    net: rows(own, |k| complex.points()[k]),
                    potential: rows(fine, |k| potential[k]),
                };
                let faces = complex.faces().iter().zip(raised.faces()).map(face).collect();
                return Ok(LowerBound { value, competitors, plane, faces });
            }
            // Too steep: shrink more. Any other reason stays whatever the potential.
            Err(why @ Unproved::Steep { .. }) => last = Some(why),
            Err(why) => return Err(why.into()),
        }
    }
    Err(last.map_or(NoBound::NoGraph, NoBound::from))
}

/// What stands at the nodes of a face, row by row.
fn rows<T>(face: &Face, at: impl Fn(usize) -> T) -> Vec<Vec<T>> {
    let side = (face.nodes().len() as f64).sqrt().round() as usize;
    face.nodes().chunks_exact(side).map(|row| row.iter().map(|&k| at(k)).collect()).collect()
}

/// The Coons surface with the faces, edges and rim of a complex.
fn coons(complex: &Complex) -> Result<Complex, NoBound> {
    let of =
        |k: usize| if complex.fixed()[k] { Vertex::Fixed(complex.points()[k]) } else { Vertex::Free(None) };
    let vertices: Vec<Vertex> = (0..complex.vertices()).map(of).collect();
    let faces: Vec<[usize; 4]> = complex.faces().iter().map(Face::vertices).collect();
    let fixed = |(number, edge): (usize, &Edge)| {
        edge.is_fixed().then(|| FixedEdge { ends: edge.ends(), curve: complex.edge_curve(number) })
    };
    let edges: Vec<FixedEdge> = complex.edges().iter().enumerate().filter_map(fixed).collect();
    Ok(Complex::new(complex.degree(), &vertices, &faces, &edges)?)
}

/// The Coons patch over the border of a net as a complex of one face, and the net with its lower degree raised to the other.
fn one_face(net: &Net) -> Result<(Complex, Net), NoBound> {
    let (m, n) = net.degrees();
    let degree = m.max(n);
    let raised = |points: Vec<Point>| Bezier::new(points).map(|curve| curve.raised(degree));
    let rows: Vec<Bezier> =
        (0..=m).map(|i| raised((0..=n).map(|j| net.point(i, j)).collect())).collect::<Result<_, _>>()?;
    let column = |j: usize| raised(rows.iter().map(|row| row.points()[j]).collect());
    let columns: Vec<Bezier> = (0..=degree).map(column).collect::<Result<_, _>>()?;
    let points = (0..=degree).flat_map(|i| columns.iter().map(move |column| column.points()[i])).collect();
    let net = Net::new(degree + 1, degree + 1, points)?;
    let corners = [(0, 0), (degree, 0), (degree, degree), (0, degree)].map(|(i, j)| net.point(i, j));
    let [u0, u1, v0, v1] = net.boundary();
    let edges: Vec<FixedEdge> = [([0, 1], v0), ([1, 2], u1), ([3, 2], v1), ([0, 3], u0)]
        .into_iter()
        .map(|(ends, points)| Ok(FixedEdge { ends, curve: Bezier::new(points)? }))
        .collect::<Result<_, SurfaceError>>()?;
    let complex = Complex::new(degree, &corners.map(Vertex::Fixed), &[[0, 1, 2, 3]], &edges)?;
    Ok((complex, net))
}

/// A plane to which every normal of the surface leans, with its normal on their side; none if there is none. That across the mean
/// of the normals, which the rim determines, is turned towards the one furthest from it until all are on its side.
fn plane(complex: &Complex) -> Result<Option<Plane>, NoBound> {
    // Where all normals lean to one side the projection to the plane across it keeps its orientation.
    let mut normals = Vec::new();
    let samples = complex.degree() + 2;
    for face in 0..complex.faces().len() {
        let patch = complex.patch(face)?;
        let at: Vec<f64> = (0..=samples).map(|k| k as f64 / samples as f64).collect();
        normals.extend(surfaces::Patch::jets(&patch, &at, &at).iter().map(|jet| jet.u.cross(jet.v)));
    }
    let mut sum = area_vector(complex)?;
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
        // Turned towards the worst one until that leans by 0.2; others may then lean less, and are next.
        sum = plane.axes[2] + *worst * (0.2 - lean(worst));
    }
    Ok(None)
}

/// Twice `∫ N dA = ½ ∮ x × dx`, which only the rim decides.
fn area_vector(complex: &Complex) -> Result<Point, NoBound> {
    // The integrand has degree 2p − 1: exact with p points.
    let rule = GaussLegendre::new(complex.degree()).map_err(EnergyError::from)?.on(0.0, 1.0);
    let origin = complex.points()[0];
    let mut sum = Point::ZERO;
    for (number, edge) in complex.edges().iter().enumerate() {
        // Inner edges are run through in both senses and cancel.
        let [only] = edge.uses() else { continue };
        let curve = complex.edge_curve(number);
        let backwards = only.reversed == only.side.runs_round();
        for (t, weight) in rule.iter() {
            let swept = (curve.point(t) - origin).cross(curve.derivative(t)) * weight;
            sum = if backwards { sum - swept } else { sum + swept };
        }
    }
    Ok(sum)
}

/// The best potential of a calibration.
fn potential(calibration: &Calibration) -> Result<Vec<f64>, NoBound> {
    let (matrix, rhs) = calibration.fit();
    let mut psi = solved(&matrix, &rhs)?;
    let mut value = calibration.value(&psi);
    // The fit may be too steep at some points; ψ = 0 is not, so shrinking comes to an end.
    while value.is_none() {
        psi.iter_mut().for_each(|c| *c *= 0.95);
        value = calibration.value(&psi);
    }
    let Some(mut value) = value else { return Ok(psi) };
    for _ in 0..STEPS {
        let (gradient, hessian) = calibration.derivatives(&psi);
        // Newton for a concave function: `derivatives` gives the negative Hessian, so the step goes up.
        let step = solved(&hessian, &gradient)?;
        // Outside of |∇ψ| < 1 there is no value: such lengths are halved like those that do not rise.
        let risen = (0..HALVINGS).map(|k| 0.5f64.powi(k)).find_map(|length| {
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
    // Without its first row and column the matrix is definite: the constant is held.
    let n = rhs.len() - 1;
    let mut reduced: Vec<f64> = (1..=n).flat_map(|i| matrix.row(i)[1..].to_vec()).collect();
    let solution = match solve_spd(n, &reduced, 1, &rhs[1..]) {
        Err(SolveError::NotPositiveDefinite { .. }) => {
            reduced.iter_mut().step_by(n + 1).for_each(|d| *d *= 1.0 + REGULAR);
            solve_spd(n, &reduced, 1, &rhs[1..])?
        }
        solution => solution?,
    };
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
    // A convex curve turns left by 2π in all; more would be a curve that winds twice.
    let mut turned = 0.0;
    for (k, a) in steps.iter().enumerate() {
        let b = steps[(k + 1) % steps.len()];
        // The control polygon of a Bézier curve turns at least as much as the curve: if it never turns right, nor does the curve.
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
