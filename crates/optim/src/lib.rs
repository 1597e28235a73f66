//! Particle swarm search in a box, and its polish to a stationary point.
//!
//! [`Pso`] looks for a minimum with values alone ([`Objective`], in batches); each [`Run`] says what
//! it found, what it cost and why it ended. A swarm proves nothing, and comes within some 1e-5 of a
//! minimum; [`Polish`] goes on from there, or from random starts, with exact gradients ([`Smooth`])
//! to a point where the KKT conditions of the box hold in rounding, and says which bounds bind.
//!
//! ```
//! use optim::{Bound, Bounds, FnObjective, FnSmooth, Polish, PolishReason, Pso};
//!
//! let bounds = Bounds::new(vec![-1.0, 0.0], vec![1.0, 1.0])?;
//! let bowl = |x: &[f64]| 3.0 + (x[0] - 0.3).powi(2) + 2.0 * (x[1] + 0.2).powi(2);
//! let search = Pso::new(7).search(&FnObjective::new(2, bowl), &bounds, 4, &())?;
//! let start = &search.best().and_then(|run| run.best.as_ref()).ok_or("nothing finite")?.point;
//!
//! let smooth = FnSmooth::new(2, |x: &[f64], gradient: &mut [f64]| {
//!     gradient.copy_from_slice(&[2.0 * (x[0] - 0.3), 4.0 * (x[1] + 0.2)]);
//!     bowl(x)
//! });
//! let polished = Polish::default().run(&smooth, &bounds, start)?;
//! assert_eq!(polished.reason, PolishReason::Stationary);
//! assert_eq!(polished.active, [Bound::Free, Bound::Lower]);
//! assert!((polished.point[0] - 0.3).abs() < 1e-11 && polished.point[1] == 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Repeatability
//!
//! Random numbers are addressed, not shared: particle `i` of run `r` draws from ChaCha8 stream `i`
//! under the key (seed, `r`). All reductions go by index. So a report is the same bit for bit for any
//! number of threads, any batch size, and for a run repeated alone, provided the objective gives a
//! point the same value every time.
//!
//! # Bad values and bad input
//!
//! NaN is counted and loses to everything, as does `+∞`; neither pulls a particle. A search that
//! finds nothing finite says so ([`Reason::NothingFinite`]). Parameters out of range, boxes without
//! interior and starts outside the box are errors that name the parameter or the component; sizes
//! are checked before anything is allocated.
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | what is minimised | [`Objective`], [`Smooth`]; [`FnObjective`], [`FnSmooth`] of closures |
//! | the box | [`Bounds`], [`Bound`], [`BoundsError`], [`MAX_BOUND`] |
//! | the swarm | [`Pso`], [`Topology`], [`Stagnation`], [`PsoError`]; [`Observer`], [`Progress`]; [`MAX_PARTICLES`], [`MAX_EVALUATIONS`], [`MAX_COORDINATES`], [`MAX_HISTORY`] |
//! | what it found | [`Search`], [`Run`], [`Best`], [`Reason`] |
//! | the polish | [`Polish`], [`Polished`], [`PolishReason`], [`PolishError`]; [`MAX_STARTS`], [`MAX_POLISH_DIMENSION`], [`MAX_POLISH_EVALUATIONS`] |

#![warn(clippy::wildcard_enum_match_arm)]

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
