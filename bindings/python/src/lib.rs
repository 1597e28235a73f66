//! The engine for Python: the compiled half of the package `plateau_patches`.
//!
//! It takes and gives arrays, texts and numbers; names, defaults, checks of what users pass and conversions to other libraries
//! are in the Python half. Computations leave the interpreter to other threads and end when Python has a signal to tell of.

mod arrays;
mod curves;
mod errors;
mod fill;
mod page;
mod run;
mod spelling;
mod surface;
mod watch;

#[pyo3::pymodule]
mod _engine {
    #[pymodule_export]
    use crate::curves::read_curves;
    #[pymodule_export]
    use crate::fill::{fill_faces, fill_loops};
    #[pymodule_export]
    use crate::page::page;
    #[pymodule_export]
    use crate::run::{Run, run};
    #[pymodule_export]
    use crate::surface::{Surface, format_of, formats};
}
