//! The plateau workbench: experiment files in, surfaces and tables out.
//!
//! A [`Plan`] is an experiment file, read and checked ([`Diagnostic`]s point at what is wrong with it). [`run()`] computes
//! every method of a plan: the boundary net, the extremal of an energy, the search for shape parameters, the [`Figures`]
//! of the patch found. [`table()`] prints them, [`deliver()`] writes `result.json` and the files for other programs.
//! The library touches neither the terminal nor the command line.
//!
//! ```
//! use plateau::{Options, Plan, Quantity, run, table};
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
//! let area = finished.methods[0].figure(Quantity::Area).expect("the method succeeds");
//! assert!((area - 5.123).abs() < 1e-2 && table(&finished).contains("Dirichlet"), "{area}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arithmetic;
mod atomic;
mod boundary_figures;
mod checkpoint;
mod closed_form;
mod colour;
mod curve;
mod degeneracy;
mod deliver;
mod destination;
mod diagnostic;
mod earlier;
mod export;
mod family;
mod figures;
mod file_name;
mod folder;
mod helicoid;
mod import;
mod manifest;
mod method;
mod picture;
mod plan;
mod printable;
mod progress;
mod report;
mod report_html;
mod reproduce;
mod result;
mod result_reader;
mod run;
mod scene;
mod schema;
mod spec;
mod template;
mod verification;

pub use arithmetic::Arithmetic;
pub use atomic::Claim;
pub use boundary_figures::BoundaryFigures;
pub use checkpoint::{CHECKPOINT_FILE, Checkpoint, CheckpointError};
pub use closed_form::ClosedForm;
pub use curve::CurveResult;
pub use deliver::{DeliverError, Delivered, deliver, deliver_watched, prepare};
pub use destination::Destination;
pub use diagnostic::{Diagnostic, Fault, Refusal};
pub use earlier::{Earlier, earlier};
pub use export::{DEFAULT_TOLERANCE, ExportError, SurfaceForm};
pub use family::Family;
pub use figures::Figures;
pub use folder::{folder, folder_key};
pub use import::{ImportError, import};
pub use manifest::{Manifest, Origin};
pub use method::{
    AreaExtremal, MethodError, SearchOutcome, SearchRun, SolveFigures, Solved, Surface, least_area,
    least_area_triangle,
};
pub use plan::{
    Basis, Boundary, Curve, CurveBasis, Deformation, DeformationPath, Energy, Expected, Experiment, Format,
    Helicoid, Interior, MAX_COORDINATE, MAX_DEGREE, MAX_FILE_SIZE, MAX_KEYS, MAX_SEARCH_BUDGET, MAX_TOKENS,
    MIN_SIZE, Mask, Method, Output, Patch, PatchExperiment, Plan, Published, Quantity, Search, SearchMode,
    Shape, SolverChoice, TrapeziumHelicoid, Variant,
};
pub use printable::{Printable, width_of_names};
pub use progress::Progress;
pub use report::table;
pub use reproduce::{REPRODUCTION_SCHEMA, Reproduced, Reproduction, Verdict, reproduce};
pub use result::{ResultFile, SCHEMA};
pub use result_reader::{ReadError, StoredMethod, StoredResult};
pub use run::{Done, Finished, MethodResult, Missed, Options, run, run_kept};
pub use schema::EXPERIMENT_SCHEMA;
pub use template::Template;
pub use verification::{Difference, Level, Verification, Verified, VerifyError, verify};
