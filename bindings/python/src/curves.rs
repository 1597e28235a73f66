//! Curves of files and of users.

use exchange::{FileCurve, Shape};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use surfaces::{CurveError, EllipseArc, Point, SplineCurve};

use crate::arrays::{array, coordinates, points};
use crate::errors::BoundaryError;
use crate::spelling::spelled;
use crate::watch::watched;

/// A curve as the package has it: the fields of `plateau_patches.Curve`.
#[derive(FromPyObject)]
pub(crate) struct Given<'py> {
    name: String,
    kind: String,
    points: PyReadonlyArray2<'py, f64>,
    degree: usize,
    knots: Vec<f64>,
    weights: Option<Vec<f64>>,
    radii: Option<[f64; 2]>,
    angles: Option<[f64; 2]>,
    closed: bool,
}

impl Given<'_> {
    /// The same for the engine.
    pub(crate) fn curve(&self, line: usize) -> PyResult<FileCurve> {
        let points = points(&self.points)?;
        let refused = |error: CurveError| {
            let name = if self.name.is_empty() { format!("curve {line}") } else { self.name.clone() };
            BoundaryError::new_err(format!("{name}: {error}"))
        };
        let shape = match self.kind.as_str() {
            "polyline" => Shape::Polyline(points),
            "spline" => {
                let spline = SplineCurve::new(self.degree, self.knots.clone(), points, self.weights.clone());
                Shape::Spline(spline.map_err(refused)?)
            }
            _ => Shape::Arc(self.arc(&points).map_err(refused)?),
        };
        Ok(FileCurve { name: self.name.clone(), line, shape, closes: self.closed, joints: Vec::new() })
    }

    fn arc(&self, points: &[Point]) -> Result<EllipseArc, CurveError> {
        let at = |k: usize| points.get(k).copied().unwrap_or_default();
        let [from, to] = self.angles.unwrap_or_default();
        EllipseArc::new(at(0), [at(1), at(2)], self.radii.unwrap_or_default(), from, to)
    }
}

/// (name, kind, points, degree, knots, weights, radii, angles, closed) of a curve.
type Fields<'py> = (
    String,
    &'static str,
    Bound<'py, PyArray2<f64>>,
    usize,
    Vec<f64>,
    Option<Vec<f64>>,
    Option<[f64; 2]>,
    Option<[f64; 2]>,
    bool,
);

/// The curves of a file, what is to be said of it, and the unit it states.
///
/// Of an arc the points are its centre and the unit vectors of its axes.
#[pyfunction]
pub(crate) fn read_curves<'py>(
    py: Python<'py>,
    bytes: &[u8],
    name: &str,
) -> PyResult<(Vec<Fields<'py>>, Vec<String>, Option<&'static str>)> {
    let (given, called) = (bytes.to_owned(), name.to_owned());
    let file = watched(py, None, move |_| exchange::read_curves(&given, &called))?
        .map_err(|error| BoundaryError::new_err(format!("{name}: {error}")))?;
    let curves = file.curves.into_iter().map(|curve| fields(py, curve)).collect::<PyResult<_>>()?;
    let notes = file.notes.iter().map(|note| note.told(&spelled)).collect();
    Ok((curves, notes, file.unit.map(exchange::LengthUnit::name)))
}

fn fields(py: Python<'_>, curve: FileCurve) -> PyResult<Fields<'_>> {
    let rows = |points: &[Point]| array(py, [points.len(), 3], coordinates(points));
    let FileCurve { name, shape, closes, .. } = curve;
    Ok(match shape {
        Shape::Polyline(points) => {
            (name, "polyline", rows(&points)?, 1, Vec::new(), None, None, None, closes)
        }
        Shape::Spline(spline) => {
            let weights = spline.weights().map(<[f64]>::to_vec);
            (
                name,
                "spline",
                rows(spline.points())?,
                spline.degree(),
                spline.knots().to_vec(),
                weights,
                None,
                None,
                closes,
            )
        }
        Shape::Arc(arc) => {
            let [first, second] = arc.axes();
            let points = rows(&[arc.center(), first, second])?;
            (name, "arc", points, 2, Vec::new(), None, Some(arc.radii()), Some(arc.angles()), closes)
        }
    })
}
