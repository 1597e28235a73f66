//! How small the area can be at all: a proved lower bound over every surface with the rim, by a calibration.

mod faces;
mod no_bound;
mod plane;
mod potential;
mod rim;

use energy::{Calibration, Plane, Unproved, certify};
use surfaces::{Complex, Face, Net, Point};

use faces::{coons, one_face};
pub use no_bound::NoBound;
use plane::plane;
use potential::potential;
use rim::is_convex;

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

/// What the potential is shrunk by, one after the other, until its rise is shown to be at most 1.
const SHRINKING: [f64; 8] = [0.0, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3];

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
    let best = potential(&calibration)?.ok_or(NoBound::Singular { degree })?;
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
