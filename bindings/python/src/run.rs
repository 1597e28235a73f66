//! Experiments, run.

use std::path::PathBuf;
use std::sync::Arc;

use experiment::{Finished, Options, Plan};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use record::{ExportError, ResultFile};

use crate::errors::{MethodError, of_method, of_refusal};
use crate::surface::Surface;
use crate::watch::{watched, watched_to_its_end};

/// An experiment that was run.
#[pyclass(frozen, module = "plateau_patches._engine")]
pub(crate) struct Run {
    plan: Arc<Plan>,
    finished: Arc<Finished>,
}

/// Runs the experiment in a text, of a file called `name`.
#[pyfunction]
#[pyo3(signature = (text, name, seed=None, told=None))]
pub(crate) fn run(
    py: Python<'_>,
    text: &str,
    name: &str,
    seed: Option<u64>,
    told: Option<Py<PyAny>>,
) -> PyResult<Run> {
    let (text, name) = (text.to_owned(), name.to_owned());
    let options = Options { seed, ..Options::default() };
    let ran = watched(py, told.as_ref(), move |progress| {
        let plan = Plan::parse(&name, &text).map_err(|refusal| of_refusal(&refusal))?;
        let finished = experiment::run(&plan, options, progress).map_err(|error| of_method(&error))?;
        Ok::<_, PyErr>((plan, finished))
    })?;
    let (plan, finished) = ran?;
    Ok(Run { plan: Arc::new(plan), finished: Arc::new(finished) })
}

#[pymethods]
impl Run {
    /// The surface of the method at a place.
    fn surface(&self, index: usize) -> PyResult<Surface> {
        let method = self.finished.results.methods().get(index);
        let method = method.ok_or_else(|| MethodError::new_err(format!("there is no method {index}")))?;
        if let Err(error) = &method.outcome {
            return Err(of_method(error));
        }
        Surface::of(method)
    }

    /// The text of `result.json`.
    fn record(&self) -> PyResult<String> {
        let record = ResultFile::new(&self.plan, &self.finished);
        record.to_json().map_err(|error| MethodError::new_err(error.to_string()))
    }

    /// What its numbers are, if the experiment says so.
    #[getter]
    fn unit(&self) -> Option<&'static str> {
        self.plan.output.step.unit.map(exchange::LengthUnit::name)
    }

    /// The table that the command prints, in so many columns.
    fn table(&self, width: usize) -> String {
        show::table(&self.finished.results, width)
    }

    /// The page that the command writes.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        let (plan, finished) = (self.plan.clone(), self.finished.clone());
        watched(py, None, move |_| record::report(&plan, &finished, show::Source::Experiment(&plan.file)))
    }

    /// Writes the folder that the command writes, and its notes.
    fn deliver(&self, py: Python<'_>, out: PathBuf) -> PyResult<(PathBuf, Vec<String>)> {
        let (plan, finished) = (self.plan.clone(), self.finished.clone());
        let delivered = watched_to_its_end(py, move |progress| {
            let _claim = record::prepare(&plan, &out)?;
            record::deliver_watched(&plan, &finished, &out, progress)
        })?;
        let delivered = delivered.map_err(|error| PyOSError::new_err(error.to_string()))?;
        let failed = |why: &&ExportError| matches!(why, ExportError::Failed(_));
        if let Some(error) = delivered.refusals.iter().find(failed) {
            return Err(PyOSError::new_err(error.to_string()));
        }
        let refusals = delivered.refusals.iter().map(ToString::to_string);
        Ok((delivered.folder, delivered.notes.into_iter().chain(refusals).collect()))
    }
}
