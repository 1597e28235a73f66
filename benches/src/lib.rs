//! Fixtures of the benchmarks: boundary nets, and their reduced energy as the solver and the searches take it.
//!
//! The laws in `tests/` hold it against the known minima of GT Examples 5.1 and 5.2.
//!
//! ```
//! use plateau_benches::{example_5_1, gt_dirichlet, search_box};
//!
//! let reduced = gt_dirichlet(&example_5_1()?)?;
//! let found = optim::Polish::default().run(&reduced, &search_box()?, &[1.0; 4])?;
//! assert!((found.value - 37.4395612).abs() < 1e-7);
//! # Ok::<(), plateau_benches::FixtureError>(())
//! ```

mod frames;
mod net;
mod problem;
mod samples;
mod search_box;
mod settings;

pub use frames::{catenoid, cube, hexagon, ribbon, saddle, triangle};
pub use net::{example_5_1, example_5_2, wave};
pub use problem::{gt_dirichlet, interior};
pub use samples::{affine_samples, gt_samples, separable_parametric};
pub use search_box::{search_box, shapes};
pub use settings::criterion;

/// Whatever a fixture could not be made for.
pub type FixtureError = Box<dyn std::error::Error>;
