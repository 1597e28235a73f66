//! Arrays whose allocation can fail: a size taken from bad input is an error, never an abort.

use crate::SolveError;
use faer::dyn_stack::{MemBuffer, StackReq};

pub(crate) fn filled<T: Clone>(length: usize, value: T) -> Result<Vec<T>, SolveError> {
    let mut array = Vec::new();
    let bytes = length.saturating_mul(size_of::<T>());
    array.try_reserve_exact(length).map_err(|_| SolveError::OutOfMemory { bytes })?;
    array.resize(length, value);
    Ok(array)
}

pub(crate) fn zeros(length: usize) -> Result<Vec<f64>, SolveError> {
    filled(length, 0.0)
}

pub(crate) fn copy(array: &[f64]) -> Result<Vec<f64>, SolveError> {
    let mut copy = Vec::new();
    let bytes = size_of_val(array);
    copy.try_reserve_exact(array.len()).map_err(|_| SolveError::OutOfMemory { bytes })?;
    copy.extend_from_slice(array);
    Ok(copy)
}

/// The `columns × rows` transpose of a row-major `rows × columns` array.
pub(crate) fn transposed(rows: usize, columns: usize, array: &[f64]) -> Result<Vec<f64>, SolveError> {
    let mut out = zeros(rows * columns)?;
    for i in 0..rows {
        for j in 0..columns {
            out[j * rows + i] = array[i * columns + j];
        }
    }
    Ok(out)
}

pub(crate) fn scratch(request: StackReq) -> Result<MemBuffer, SolveError> {
    MemBuffer::try_new(request).map_err(|error| crate::error::from_alloc(error, request.size_bytes()))
}
