//! What is asked of every argument before any arithmetic is done with it.

use crate::{Place, SolveError};

/// Largest order of a dense system (a matrix of 2 GiB).
pub(crate) const LARGEST_DENSE_ORDER: usize = 16_384;

pub(crate) fn length(what: &'static str, expected: usize, found: usize) -> Result<(), SolveError> {
    if expected == found { Ok(()) } else { Err(SolveError::WrongShape { what, expected, found }) }
}

pub(crate) fn limit(what: &'static str, found: usize, limit: usize) -> Result<(), SolveError> {
    if found <= limit { Ok(()) } else { Err(SolveError::TooLarge { what, found, limit }) }
}

pub(crate) fn product(what: &'static str, a: usize, b: usize) -> Result<usize, SolveError> {
    let limit = isize::MAX as usize / size_of::<f64>();
    match a.checked_mul(b) {
        Some(found) if found <= limit => Ok(found),
        _ => Err(SolveError::TooLarge { what, found: a.saturating_mul(b), limit }),
    }
}

/// A strictly increasing list below `bound`.
pub(crate) fn indices(what: &'static str, list: &[usize], bound: usize) -> Result<(), SolveError> {
    for (k, &index) in list.iter().enumerate() {
        if index >= bound || (k > 0 && index <= list[k - 1]) {
            return Err(SolveError::WrongIndex { what, index, bound });
        }
    }
    Ok(())
}

pub(crate) fn finite(place: Place, columns: usize, array: &[f64]) -> Result<(), SolveError> {
    // A sum of products with 0 is 0 unless something is not finite: one pass without branches.
    if array.iter().fold(0.0, |sum, &a| sum + a * 0.0) == 0.0 {
        return Ok(());
    }
    match array.iter().position(|a| !a.is_finite()) {
        Some(k) => Err(SolveError::NotFinite { place, row: k / columns, column: k % columns }),
        None => Ok(()),
    }
}

/// A square matrix of finite entries whose order is affordable.
pub(crate) fn square(n: usize, matrix: &[f64]) -> Result<(), SolveError> {
    limit("order of the dense system", n, LARGEST_DENSE_ORDER)?;
    length("length of the matrix", n * n, matrix.len())?;
    finite(Place::Matrix, n, matrix)
}

/// Symmetry up to the rounding of an assembly that sums up to 16 n products an entry.
pub(crate) fn symmetric(n: usize, matrix: &[f64]) -> Result<(), SolveError> {
    let (mut largest, mut entry) = (0.0f64, 0.0f64);
    let mut place = (0, 0);
    for i in 0..n {
        entry = entry.max(matrix[i * n + i].abs());
        for j in 0..i {
            let (lower, upper) = (matrix[i * n + j], matrix[j * n + i]);
            entry = entry.max(lower.abs()).max(upper.abs());
            if (lower - upper).abs() > largest {
                (largest, place) = ((lower - upper).abs(), (i, j));
            }
        }
    }
    if largest <= 16.0 * n as f64 * f64::EPSILON * entry {
        Ok(())
    } else {
        Err(SolveError::NotSymmetric { row: place.0, column: place.1, difference: largest })
    }
}

pub(crate) fn right_hand_side(n: usize, columns: usize, rhs: &[f64]) -> Result<(), SolveError> {
    length("length of the right-hand side", product("size of the right-hand side", n, columns)?, rhs.len())?;
    finite(Place::RightHandSide, columns.max(1), rhs)
}
