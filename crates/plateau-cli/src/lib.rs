//! The plateau workbench: experiment files in, surfaces and tables out.
//!
//! A [`Plan`] is an experiment file, read and checked ([`Diagnostic`]s point at what is wrong with it). [`run()`] computes
//! every method of a plan: the boundary net, the extremal of an energy, the search for shape parameters, the figures
//! of the patch found. [`table()`] prints them, [`deliver()`] writes `result.json` and the files for other programs.
//! The library touches neither the terminal nor the command line.
//!
//! ```
//! use plateau::Quantity;
//! use plateau_cli::{Options, Plan, run, table};
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
//! let area = finished.results.methods[0].figure(Quantity::Area).expect("the method succeeds");
//! assert!((area - 5.123).abs() < 1e-2 && table(&finished.results).contains("Dirichlet"), "{area}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod atomic;
mod checkpoint;
mod colour;
mod deliver;
mod destination;
mod diagnostic;
mod earlier;
mod export;
mod file_name;
mod folder;
mod format;
mod import;
mod keys;
mod limits;
mod manifest;
mod number;
mod picture;
mod plan;
mod printable;
mod report;
mod report_html;
mod reproduce;
mod result;
mod result_reader;
mod result_size;
mod run;
mod scene;
mod schema;
mod template;
mod text;
mod verification;

pub use atomic::Claim;
pub use checkpoint::{CHECKPOINT_FILE, Checkpoint, CheckpointError};
pub use deliver::{DeliverError, Delivered, deliver, deliver_watched, prepare};
pub use destination::Destination;
pub use diagnostic::{Diagnostic, Fault, Refusal};
pub use earlier::{Earlier, earlier};
pub use export::{DEFAULT_TOLERANCE, ExportError, SurfaceForm};
pub use folder::{folder, folder_key};
pub use format::Format;
pub use import::{CornerGap, ImportError, ImportOptions, MAX_IMPORT_SIZE, import};
pub use limits::{MAX_FILE_SIZE, MAX_KEYS, MAX_TOKENS};
pub use manifest::{Manifest, Origin};
pub use plan::{Expected, Experiment, Output, PatchExperiment, Plan, Published, Wanted};
pub use printable::{Printable, width_of_names};
pub use report::table;
pub use reproduce::{REPRODUCTION_SCHEMA, Reproduced, Reproduction, Verdict, reproduce};
pub use result::{ResultFile, SCHEMA};
pub use result_reader::{ReadError, StoredMethod, StoredResult};
pub use run::{Finished, Missed, Options, run, run_kept};
pub use schema::experiment_schema;
pub use template::Template;
pub use verification::{Difference, Level, Verification, Verified, VerifyError, verify};
