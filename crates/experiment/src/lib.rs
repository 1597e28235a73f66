//! Experiments: files in, checked plans out, and what comes of them.
//!
//! A [`Plan`] is an experiment file, read and checked ([`Diagnostic`]s point at what is wrong with it). [`run()`] computes every
//! method of a plan by the engine and sets beside it what the file wants of the figures. A [`Sweep`] is many plans of one file.
//!
//! ```
//! use experiment::{Options, Plan, run};
//! use plateau::Quantity;
//!
//! let text = r#"
//!     title = "A bilinear saddle, degree 2"
//!     [boundary]
//!     u0 = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]
//!     u1 = [[2, 0, 0], [2, 1, 1], [2, 2, 2]]
//!     v0 = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
//!     v1 = [[0, 2, 0], [1, 2, 1], [2, 2, 2]]
//!     [[method]]
//!     name = "Dirichlet"
//!     basis = "bernstein"
//!     energy = "dirichlet"
//! "#;
//! let plan = Plan::parse("saddle.toml", text)?;
//! let finished = run(&plan, Options::default(), &())?;
//! let area = finished.results.methods()[0].figure(Quantity::Area).expect("the method succeeds");
//! assert!((area - 5.123).abs() < 1e-2 && show::table(&finished.results, show::WIDTH).contains("Dirichlet"), "{area}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | plans | [`Plan`], [`Experiment`]: [`PatchExperiment`], [`FilmExperiment`] with [`FilmMethod`]s over a [`Rim`]; [`Output`], [`stem()`] |
//! | what a file wants of its figures | [`Wanted`], [`Expected`], [`Published`], [`Missed`] |
//! | running | [`run()`], [`run_kept()`], [`Options`], [`Finished`], [`shortfall()`] |
//! | sweeps | [`Sweep`]: [`Axis`], its [`Source`]; [`Cell`], its [`Setting`]s |
//! | refusals | [`Refusal`], [`Diagnostic`], [`Fault`]; [`MAX_FILE_SIZE`], [`MAX_KEYS`], [`MAX_TOKENS`] |
//! | files of other programs as experiments | [`import()`], [`Filling`], [`ImportOptions`], [`ImportError`], [`CornerGap`], [`MAX_IMPORT_SIZE`] |
//! | the language | [`key_list()`], [`experiment_schema()`], [`Template`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod advice;
mod diagnostic;
mod import;
mod key_list;
mod keys;
mod limits;
mod outlook;
mod plan;
mod run;
mod schema;
mod sweep;
mod template;
mod text;

pub use diagnostic::{Diagnostic, Fault, Refusal};
pub use import::{CornerGap, Filling, ImportError, ImportOptions, MAX_IMPORT_SIZE, import};
pub use key_list::key_list;
pub use limits::{MAX_FILE_SIZE, MAX_KEYS, MAX_TOKENS};
pub use plan::{
    Expected, Experiment, FilmExperiment, FilmMethod, Output, PatchExperiment, Plan, Published, Rim, Wanted,
    stem,
};
pub use run::{Finished, Missed, Options, run, run_kept, shortfall};
pub use schema::experiment_schema;
pub use sweep::{Axis, Cell, Setting, Source, Sweep};
pub use template::Template;
