//! Meshes, surfaces and curves as files for other programs, one format a file.

mod cells;
mod csv;
mod deformation;
mod extent;
mod file;
mod format;
mod name;
mod shell;
mod single;
mod spline;
mod step;
mod step_form;
mod subject;
mod vtk;

pub use csv::write_curves;
pub use deformation::write_deformation;
pub use extent::diagonal;
pub use file::{SurfaceFile, Unfit};
pub use format::{Format, Lengths};
pub use spline::{Accuracy, SplineError, spline};
pub use step_form::{DEFAULT_TOLERANCE, StepForm};
pub use subject::{Colours, Subject, SurfaceForm};
