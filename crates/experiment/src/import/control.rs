//! Points of polylines that are control points.

use exchange::{CurveFile, CurveFileError, FileCurve, Shape};
use surfaces::{Point, SplineCurve};

use super::sides::{self, MANY};
use super::{ImportError, ImportOptions};

/// What is said of sides with the names of an experiment.
const CONTROL: &str = "the points of sides of these names are control points of Bézier curves, as in an experiment; `--degree 6` says that \
                       they are points on the curves";
const ON_CURVES: &str = "the points of the sides are taken for points on the curves, because --degree is given; `--control-points` says otherwise";

/// Takes the points of polylines for the control points of Bézier curves, where the options say so or the polylines have the names of all
/// sides of an experiment and nothing is said; a note says what was done under such names.
///
/// # Errors
/// [`ImportError::Ask`] for many points under such names, [`ImportError::File`] for a curve that is closed by a straight line or has
/// more points than a curve has degrees.
pub(super) fn taken(
    file: CurveFile,
    options: &ImportOptions,
) -> Result<(CurveFile, Option<&'static str>), ImportError> {
    let mut note = None;
    if !options.control_points {
        match (sides::names(&file), options.degree) {
            (None, _) => return Ok((file, None)),
            (Some(_), Some(_)) => return Ok((file, Some(ON_CURVES))),
            (Some(_), None) => ask(&file, SplineCurve::MAX_DEGREE)?,
        }
        note = Some(CONTROL);
    }
    let mut file = file.parted();
    for curve in &mut file.curves {
        if let Shape::Polyline(points) = &curve.shape
            && points.len() > 2
            && points.iter().any(|p| *p != points[0])
        {
            curve.shape = Shape::Spline(bezier(curve, points)?);
        }
    }
    Ok((file, note))
}

/// Refuses sides of so many points that they are more likely on the curve; as control points they may make curves of the `highest` degree.
///
/// # Errors
/// [`ImportError::Ask`] for the first of them.
pub(super) fn ask(file: &CurveFile, highest: usize) -> Result<(), ImportError> {
    let points = |curve: &FileCurve| match &curve.shape {
        Shape::Polyline(points) => points.len(),
        Shape::Spline(_) | Shape::Arc(_) => 0,
    };
    match file.curves.iter().find(|curve| points(curve) > MANY) {
        Some(curve) => Err(ImportError::Ask { side: curve.name.clone(), count: points(curve), highest }),
        None => Ok(()),
    }
}

fn bezier(curve: &FileCurve, points: &[Point]) -> Result<SplineCurve, CurveFileError> {
    let refuse = |why: String| {
        let name = if curve.name.is_empty() { "this curve".into() } else { curve.name.clone() };
        CurveFileError::Line { line: curve.line, why: format!("{name} {why}") }
    };
    if curve.closes && points[0] != points[points.len() - 1] {
        return Err(refuse(
            "is closed by a straight line, and its points were to be control points, of which a curve has a first and a last: name the \
             sides in a column, or repeat the first point at the end"
                .into(),
        ));
    }
    let degree = points.len() - 1;
    if degree > SplineCurve::MAX_DEGREE {
        return Err(refuse(format!(
            "has {} points: as control points they are a curve of degree {degree}, and {} is the highest; are they points on the \
             curve, leave out --control-points, are they of a B-spline, write it as STEP, DXF or OBJ (`curv`), which have its knots",
            points.len(),
            SplineCurve::MAX_DEGREE
        )));
    }
    let knots = [0.0, 1.0].into_iter().flat_map(|end| std::iter::repeat_n(end, degree + 1)).collect();
    SplineCurve::new(degree, knots, points.to_vec(), None).map_err(|error| refuse(error.to_string()))
}
