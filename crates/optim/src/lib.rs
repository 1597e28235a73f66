//! Particle swarm search in a box, and its polish to a stationary point.
//!
//! [`Pso`] looks for a minimum with values alone; each [`Run`] says what it found, what it cost and
//! why it ended. Randomness is seeded and addressed, never shared: the same seed gives the same
//! bits for any number of threads and any batch size. NaN values are counted and lose to everything.
//!
//! ```
//! use optim::{Bounds, FnObjective, Pso, Reason};
//!
//! let bowl = FnObjective::new(2, |x: &[f64]| (x[0] - 0.3).powi(2) + 2.0 * (x[1] + 0.2).powi(2));
//! let bounds = Bounds::cube(2, -1.0, 1.0)?;
//! let search = Pso::new(7).search(&bowl, &bounds, 4, &())?;
//! let run = search.best().expect("the bowl is finite everywhere");
//! assert!(run.value() < 1e-9);
//! assert_eq!(run.reason, Reason::Budget);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bounds;
mod box_model;
mod descent;
mod hessian;
mod objective;
mod observer;
mod polish;
mod pso;
mod report;
mod stream;
mod swarm;
mod topology;

pub use bounds::{Bounds, BoundsError, MAX_BOUND};
pub use objective::{FnObjective, FnSmooth, Objective, Smooth};
pub use observer::{Observer, Progress};
pub use polish::{MAX_POLISH_DIMENSION, MAX_POLISH_EVALUATIONS, MAX_STARTS, Polish, PolishError};
pub use pso::{MAX_COORDINATES, MAX_EVALUATIONS, MAX_HISTORY, MAX_PARTICLES, Pso, PsoError, Stagnation};
pub use report::{Best, Bound, PolishReason, Polished, Reason, Run, Search};
pub use topology::Topology;
