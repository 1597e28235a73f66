//! One boundary of the curves of a file.

use surfaces::{BoundaryCurve, CurveError, Point};
use thiserror::Error;

use crate::{CurveFile, Shape};

mod corner;
mod cycle_basis;
mod face;
mod gap;
mod junction;
mod loops;
mod network;
mod side;
mod split;
mod weld;

use network::Network;

/// What is left open by a file of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyOptions {
    /// Ends of curves that lie at most this far apart are one point; by default [`Self::WELD`] of the size.
    pub weld: Option<f64>,
    /// A polyline has a corner where its direction turns by more than this, in degrees from 1 to 179.
    pub corner_angle: f64,
}

impl AssemblyOptions {
    /// Share of the size (the diagonal of the box around all curves) within which ends are welded.
    pub const WELD: f64 = 1e-4;
    /// Turn in degrees above which a polyline has a corner.
    pub const CORNER_ANGLE: f64 = 30.0;
}

impl Default for AssemblyOptions {
    fn default() -> Self {
        Self { weld: None, corner_angle: Self::CORNER_ANGLE }
    }
}

/// A curve between two vertices, or a closed one without any.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// Its name, distinct from those of all others.
    pub name: String,
    /// The line of the file on which its first curve begins.
    pub line: usize,
    /// Indices of the vertices where it begins and ends.
    pub ends: Option<[usize; 2]>,
    /// What it is. Polylines and splines end in their vertices digit for digit; the points of a closed polyline end with the first.
    pub shape: Shape,
}

impl Side {
    /// The side as the boundary of a surface: straight sides and splines as they are, polylines of more points as samples of a
    /// smooth curve that passes each within `tolerance` (a length).
    ///
    /// # Errors
    /// [`CurveError`], for a tolerance that is not positive.
    pub fn curve(&self, tolerance: f64) -> Result<BoundaryCurve, CurveError> {
        match &self.shape {
            Shape::Polyline(points) if points.len() == 2 => BoundaryCurve::polyline(points.clone()),
            Shape::Polyline(points) => BoundaryCurve::through(points.clone(), tolerance),
            Shape::Spline(spline) => Ok(spline.clone().into()),
            Shape::Arc(arc) => Ok(arc.clone().into()),
        }
    }

    /// Its control points, if it is one polynomial Bézier curve: a straight line or a spline without inner knots and weights.
    pub fn control_points(&self) -> Option<&[Point]> {
        match &self.shape {
            Shape::Polyline(points) => (points.len() == 2).then_some(points),
            Shape::Spline(spline) => {
                let is_bezier = spline.weights().is_none() && spline.points().len() == spline.degree() + 1;
                // Only where its knots end it in its first and last point.
                (is_bezier && spline.knots()[0] == spline.knots()[spline.degree()]).then(|| spline.points())
            }
            Shape::Arc(_) => None,
        }
    }
}

/// A side on the way round a loop or a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Walk {
    /// Index of the side.
    pub side: usize,
    /// Whether it is walked from its beginning to its end.
    pub forward: bool,
}

/// How the sides hang together.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// One loop or two; the first begins with the first curve of the file.
    Loops(Vec<Vec<Walk>>),
    /// A graph, three or more sides meeting in some vertices, and its faces.
    Faces(Vec<Vec<Walk>>),
}

/// What was welded.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weld {
    /// The largest distance allowed.
    pub tolerance: f64,
    /// How many ends were moved.
    pub count: usize,
    /// The farthest any of them was moved.
    pub largest: f64,
}

/// A boundary: sides between vertices, and loops or faces of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// The vertices.
    pub vertices: Vec<Point>,
    /// The sides.
    pub sides: Vec<Side>,
    /// Loops or faces.
    pub form: Form,
    /// What was welded.
    pub weld: Weld,
    /// The diagonal of the box around all curves.
    pub size: f64,
    /// Sentences a user should see.
    pub notes: Vec<String>,
}

/// Why curves make no boundary.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// A number of the options.
    #[error("{name} = {value}: {expected}")]
    Option {
        /// The option.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What may be given.
        expected: &'static str,
    },
    /// All points of all curves are one point, or their box is too large for a number.
    #[error("the curves have no size: all their points are the same, or too far apart")]
    NoSize,
    /// Ends of curves that meet nothing.
    #[error("{0}")]
    Gap(String),
    /// More than can be understood without being told.
    #[error("{0}")]
    Ambiguous(String),
    /// Too much work.
    #[error("{0}")]
    TooMany(String),
}

impl Assembly {
    /// Chains the curves of a file into loops or a graph.
    ///
    /// Curves may stand in any order and direction. Ends of curves that nothing meets are welded to the ends, then to the points
    /// and the straight segments of others within the tolerance; nothing else is moved. Curves that stand twice count once.
    /// Polylines that go on in each other are one, cut where three or more meet, where a table begins another side, where other
    /// kinds of curves begin and at corners. Polylines of a straight line become two points. Where three or more sides meet, the
    /// shortest cycles of the graph are its faces, provided that they are the only ones.
    ///
    /// # Errors
    /// [`AssemblyError`].
    pub fn new(file: &CurveFile, options: &AssemblyOptions) -> Result<Self, AssemblyError> {
        let angle = options.corner_angle;
        if !(1.0..=179.0).contains(&angle) {
            return Err(AssemblyError::Option {
                name: "corner angle",
                value: angle,
                expected: "1 to 179 degrees",
            });
        }
        let size = size(file).ok_or(AssemblyError::NoSize)?;
        let tolerance = options.weld.unwrap_or(AssemblyOptions::WELD * size);
        if !(tolerance >= 0.0 && tolerance <= 0.25 * size) {
            let expected = "0 to a quarter of the size of the curves";
            return Err(AssemblyError::Option { name: "weld", value: tolerance, expected });
        }
        let mut notes = Vec::new();
        let mut network = Network::new(file, &mut notes)?;
        let mut weld = weld::weld(&mut network, tolerance)?;
        junction::split(&mut network, tolerance, &mut weld)?;
        network.close_loops();
        network.drop_copies(file, size, &mut notes);
        gap::none(&network, file, &weld)?;
        if weld.count > 0 {
            notes.push(format!(
                "{} of curves welded, moved by at most {:.2e} ({:.1e} of the size; --weld {:.2e})",
                if weld.count == 1 { "1 end".into() } else { format!("{} ends", weld.count) },
                weld.largest,
                weld.largest / size,
                weld.tolerance
            ));
        }
        let corners = corner::find(&network, file, angle.to_radians(), &mut notes);
        let (mut vertices, mut sides) = side::sides(&network, file, &corners, size);
        let mut form = loops::form(&vertices, &sides)?;
        if let Form::Faces(faces) = &mut form {
            split::split(&mut vertices, &mut sides, faces);
        }
        Ok(Self { vertices, sides, form, weld, size, notes })
    }
}

/// The diagonal of the box around all curves, if it is a positive number.
fn size(file: &CurveFile) -> Option<f64> {
    let mut bounds: Option<[Point; 2]> = None;
    for p in file.curves.iter().flat_map(|curve| curve.shape.sampled()) {
        let [low, high] = bounds.unwrap_or([p, p]);
        let pick =
            |f: fn(f64, f64) -> f64, a: Point, b: Point| Point::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));
        bounds = Some([pick(f64::min, low, p), pick(f64::max, high, p)]);
    }
    let [low, high] = bounds?;
    Some((high - low).norm()).filter(|size| *size > 0.0 && size.is_finite())
}
