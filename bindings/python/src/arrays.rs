//! Points and numbers as NumPy has them.

use numpy::ndarray::{Array, Dimension, IntoDimension};
use numpy::{IntoPyArray, PyArray, PyReadonlyArray2};
use pyo3::prelude::*;
use surfaces::Point;

use crate::errors::BoundaryError;

/// The rows of an array (n, 3).
pub(crate) fn points(array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<Point>> {
    let array = array.as_array();
    if array.ncols() != 3 {
        return Err(BoundaryError::new_err(format!("points have 3 coordinates, not {}", array.ncols())));
    }
    Ok(array.rows().into_iter().map(|row| Point::new(row[0], row[1], row[2])).collect())
}

/// Pairs of parameters, the rows of an array (n, 2).
pub(crate) fn parameters(array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<[f64; 2]>> {
    let array = array.as_array();
    if array.ncols() != 2 {
        return Err(BoundaryError::new_err(format!("parameters come in pairs, not {}", array.ncols())));
    }
    Ok(array.rows().into_iter().map(|row| [row[0], row[1]]).collect())
}

/// An array of the given shape that owns its numbers; they are not copied.
pub(crate) fn array<D: IntoDimension>(
    py: Python<'_>,
    shape: D,
    numbers: Vec<f64>,
) -> PyResult<Bound<'_, PyArray<f64, D::Dim>>>
where
    D::Dim: Dimension,
{
    let array = Array::from_shape_vec(shape.into_dimension(), numbers)
        .map_err(|error| pyo3::exceptions::PyRuntimeError::new_err(error.to_string()))?;
    Ok(array.into_pyarray(py))
}

/// The coordinates of points, one after the other.
pub(crate) fn coordinates(points: &[Point]) -> Vec<f64> {
    let mut all = Vec::with_capacity(3 * points.len());
    points.iter().for_each(|&p| all.extend(<[f64; 3]>::from(p)));
    all
}

/// Numbers, with what there is none of as not a number.
pub(crate) fn or_nan(numbers: &[Option<f64>]) -> Vec<f64> {
    numbers.iter().map(|x| x.unwrap_or(f64::NAN)).collect()
}
