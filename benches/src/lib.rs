//! Fixtures of the benchmarks: boundary nets, and their reduced energy as the solver and the searches take it.
//!
//! Everything here is a few lines of glue that `plateau` keeps to itself, repeated so that its parts can be timed one
//! at a time; the laws in `tests/` hold it against the known minima of GT Examples 5.1 and 5.2.
//!
//! ```
//! use plateau_benches::{Reduced, example_5_1, search_box};
//!
//! let reduced = Reduced::new(&example_5_1()?)?;
//! let found = optim::Polish::default().run(&reduced, &search_box()?, &[1.0; 4])?;
//! assert!((found.value - 37.4395612).abs() < 1e-7);
//! # Ok::<(), plateau_benches::FixtureError>(())
//! ```

mod net;
mod problem;
mod reduced;
mod samples;
mod settings;

pub use net::{example_5_1, example_5_2, wave};
pub use problem::{gt_dirichlet, interior, parametric_problem};
pub use reduced::{Reduced, search_box, shapes};
pub use samples::{affine_samples, gt_samples, separable_parametric};
pub use settings::criterion;

/// Whatever a fixture could not be made for.
pub type FixtureError = Box<dyn std::error::Error>;
