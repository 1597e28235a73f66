//! The exceptions of the package, with the sentences of the engine.

use std::io;

use experiment::Refusal;
use plateau::{MethodError as Failure, MethodFailure};
use pyo3::PyErr;
use pyo3::exceptions::{PyKeyboardInterrupt, PyMemoryError};
use record::ExportError;

pyo3::import_exception!(plateau_patches.errors, BoundaryError);
pyo3::import_exception!(plateau_patches.errors, ExperimentError);
pyo3::import_exception!(plateau_patches.errors, FormatError);
pyo3::import_exception!(plateau_patches.errors, MethodError);

/// A method that found no surface. What is wrong with the boundary itself is the caller's.
pub(crate) fn of_method(error: &Failure) -> PyErr {
    let sentence = error.to_string();
    match error.failure() {
        MethodFailure::Interrupted => PyKeyboardInterrupt::new_err(sentence),
        MethodFailure::Memory => PyMemoryError::new_err(sentence),
        MethodFailure::Boundary => BoundaryError::new_err(sentence),
        MethodFailure::Method => MethodError::new_err(sentence),
    }
}

/// A refused experiment: the report, and every fault as (line, column, sentence, what to do).
pub(crate) fn of_refusal(refusal: &Refusal) -> PyErr {
    let faults: Vec<(Option<usize>, Option<usize>, String, String)> = refusal
        .diagnostics()
        .iter()
        .map(|fault| {
            let (line, column) = refusal.position(fault).unzip();
            (line, column, fault.message().to_owned(), fault.remedies().join("; "))
        })
        .collect();
    ExperimentError::new_err((refusal.to_string(), faults))
}

/// A file that was not written.
pub(crate) fn of_export(error: &ExportError) -> PyErr {
    match error {
        ExportError::Refused { .. } => FormatError::new_err(error.to_string()),
        ExportError::Failed(failed) => io::Error::new(failed.source.kind(), error.to_string()).into(),
    }
}
