//! What to do about an error of the engine, in the words of the file.

use plateau::MethodError;

/// The error with advice where the keys of the file are shorter than its sentence.
pub(crate) fn advised(error: MethodError) -> MethodError {
    let advice = if let MethodError::SingularMask { .. } = error {
        "In the file: raise = 1, or construction = \"discrete-coons\", or energy = \"coons\""
    } else if let MethodError::Degree { .. } = error {
        "In the file: leave out `solver`; for triangular nets construction = \"discrete-coons\", or a mask"
    } else {
        return error;
    };
    MethodError::Advised { error: Box::new(error), advice }
}
