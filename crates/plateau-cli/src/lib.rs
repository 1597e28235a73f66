//! The plateau workbench: experiment files in, surfaces and tables out.

mod plan;

pub use plan::{
    AHT_SPAN_BOUND, AT_SPAN_BOUND, Basis, Boundary, Curve, CurveBasis, Deformation, DeformationPath, Energy,
    Expected, Experiment, Format, Helicoid, Interior, MAX_COORDINATE, MAX_DEGREE, MAX_FILE_SIZE,
    MAX_SEARCH_BUDGET, Mask, Method, Output, Patch, PatchExperiment, Plan, Published, Quantity, Search,
    SearchMode, Shape, SolverChoice, TrapeziumHelicoid, Variant,
};
