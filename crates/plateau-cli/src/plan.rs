//! The plan: what an experiment file asks for, checked, typed, with every default filled in.
//!
//! A [`Plan`] exists only if its file was sound, so whoever runs one has nothing left to check except
//! what only the mathematics can tell (a singular mask system, rows that admit no harmonic net).
//! Points are plain `[x, y, z]`, finite, with |coordinate| ≤ [`MAX_COORDINATE`].

use std::fmt;

mod boundary;
mod check;
mod curve;
mod expected;
mod file;
mod helicoid;
mod interior;
mod memory;
mod method;
mod number;
mod patch;
mod search;
mod shape;

pub(crate) use file::stem;

pub use expected::{Expected, Published, Quantity};
pub use surfaces::DeformationPath;

pub use patch::{
    Basis, Boundary, Energy, Interior, Mask, Method, Patch, PatchExperiment, Search, SearchMode, Shape,
    SolverChoice, Variant,
};

/// Highest degree of a control net, in each direction, after `raise`.
///
/// Gram matrices of Bernstein-like bases are singular in `f64` long before this degree; the limit
/// keeps the time and memory of a solve bounded, it promises no accuracy.
pub const MAX_DEGREE: usize = 64;

/// Largest admissible |coordinate| of a control point.
///
/// Areas are roots of products of four lengths, curvatures quotients of such products: within the limits all of them are
/// finite, at any degree, and none is lost to underflow.
pub const MAX_COORDINATE: f64 = 1e60;

/// Least admissible size of a boundary: the largest |coordinate| of its control points, unless all are 0.
pub const MIN_SIZE: f64 = 1e-60;

/// Most subdivisions of a mesh per side.
const LARGEST_MESH: usize = 2000;

/// Largest size in bytes of an experiment file.
///
/// Four sides of degree 64 with 17 digits a number take 20 kB, a thousand expected numbers 60 kB, 40 000 samples of a
/// curve 1 MB.
pub const MAX_FILE_SIZE: u64 = 1024 * 1024;

/// Most keys, dots of dotted keys, headers and inline tables of an experiment file, all together.
pub const MAX_KEYS: usize = 10_000;

/// Most tokens (names, numbers, texts, commas, brackets, line ends, …) of an experiment file.
pub const MAX_TOKENS: usize = 300_000;

/// Largest `particles × iterations × runs` of a search.
pub const MAX_SEARCH_BUDGET: u64 = 1_000_000_000;

/// One experiment, checked and ready to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Title of the table; not empty.
    pub title: String,
    /// Seed of every random stream of the experiment, at most 2⁶³ − 1.
    pub seed: u64,
    /// Name of the output folder: the file name without its last extension, never empty.
    pub stem: String,
    /// The file name as it was given, for messages.
    pub file: String,
    /// What is to be computed.
    pub experiment: Experiment,
    /// What is to be written beside `result.json`.
    pub output: Output,
    /// The file as read, byte for byte.
    pub text: String,
}

/// What an experiment computes: exactly one of these tables stands in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Experiment {
    /// `[boundary]` and `[[method]]`: patches over a fixed boundary net.
    Patch(PatchExperiment),
    /// `[helicoid]`: a generalized helicoid, exact in AHT ⊗ AHT (AHT).
    Helicoid(Helicoid),
    /// `[trapezium-helicoid]`: a right helicoid over a trapezium, exact in AT ⊗ degree 1 (AT).
    TrapeziumHelicoid(TrapeziumHelicoid),
    /// `[curve]`: one curve, sampled.
    Curve(Curve),
}

/// The generalized helicoid `x = a sinh u cos v − b cosh u sin v`, `y = a sinh u sin v + b cosh u cos v`,
/// `z = a v + b u` over `[0, u_span] × [0, v_span]` (AHT, with the chart of spec §7).
#[derive(Clone, Debug, PartialEq)]
pub struct Helicoid {
    /// Weight of the right helicoid; finite, |a| ≤ 1e30; a and b are not both zero.
    pub a: f64,
    /// Weight of the catenoid; finite, |b| ≤ 1e30.
    pub b: f64,
    /// Length of the u interval, in [1e-6, 100]. May exceed `bases::Aht::SUPREMUM`: then several patches are needed.
    pub u_span: f64,
    /// Length of the v interval, in [1e-6, 1000]. May exceed `bases::Aht::SUPREMUM`: then several patches are needed.
    pub v_span: f64,
    /// The deformation from (a, b) = (1, 0) to (0, 1), if `frames` was given.
    pub deformation: Option<Deformation>,
    /// Numbers the result must reproduce, from the top-level `[expect]`.
    pub expect: Vec<Expected>,
}

/// A family of helicoids from (a, b) = (1, 0), the right helicoid, to (0, 1), the catenoid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deformation {
    /// Number of frames, both ends included, in 2..=1000.
    pub frames: usize,
    /// How (a, b) moves with λ ∈ [0, 1]; trigonometric, an isometric bending, unless the file says otherwise.
    pub path: DeformationPath,
}

/// The right helicoid `(w cos v, w sin v, v)` over the trapezium `0 ≤ v ≤ span`,
/// `γ0 + β0 v ≤ w ≤ γ1 + β1 v` (AT, with the corrections of spec §7).
#[derive(Clone, Debug, PartialEq)]
pub struct TrapeziumHelicoid {
    /// Length α of the v interval, in [1e-6, 1000]. May exceed 2π: then several patches are needed.
    pub span: f64,
    /// Offsets (γ0, γ1) of the two sides.
    pub gamma: [f64; 2],
    /// Slopes (β0, β1) of the two sides, which do not cross inside (0, span).
    pub beta: [f64; 2],
    /// Numbers the result must reproduce, from the top-level `[expect]`.
    pub expect: Vec<Expected>,
}

/// One planar or space curve with control points, and the parameters at which it is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The basis of the control points.
    pub basis: CurveBasis,
    /// Control points: at least 2 (Bernstein), at least 3 (GT), exactly 6 (AHT, AT); at most
    /// [`MAX_DEGREE`] + 1. Planar points carry z = 0.
    pub points: Vec<[f64; 3]>,
    /// Coordinates of a point in the file: 2 (signed curvature) or 3.
    pub dimension: usize,
    /// Parameters of the samples, inside [`CurveBasis::domain`], in the file's order; a count was
    /// replaced by that many equally spaced parameters, both ends included. Never empty.
    pub samples: Vec<f64>,
    /// Numbers the result must reproduce, from the top-level `[expect]`.
    pub expect: Vec<Expected>,
}

/// The basis of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveBasis {
    /// Bernstein polynomials on [0, 1].
    Bernstein,
    /// GT functions on [0, 1] (GT).
    Gt {
        /// Shape parameters (θ1, θ2), each in [0, 4], not both zero.
        shape: [f64; 2],
    },
    /// Algebraic–hyperbolic–trigonometric functions of order 6 on [0, span] (AHT).
    Aht {
        /// Right end of the domain, below `bases::Aht::SUPREMUM`.
        span: f64,
    },
    /// Algebraic–trigonometric functions of order 6 on [0, span] (AT).
    At {
        /// Right end of the domain, below `bases::At::SUPREMUM`, 2π.
        span: f64,
    },
}

impl CurveBasis {
    /// The interval on which the basis lives.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        match *self {
            Self::Bernstein | Self::Gt { .. } => [0.0, 1.0],
            Self::Aht { span } | Self::At { span } => [0.0, span],
        }
    }
}

/// What is written beside `result.json`.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Subdivisions of the surface mesh per side, in 2..=2000.
    pub mesh: usize,
    /// Formats to export, in the file's order, without repetition.
    pub formats: Vec<Format>,
    /// Whether pictures and the report are written.
    pub pictures: bool,
    /// Largest distance between a fitted surface in a STEP file and the patch, as a share of its size, in (0, 1].
    pub step_tolerance: f64,
}

impl Default for Output {
    /// 48 subdivisions, no export, pictures and report.
    fn default() -> Self {
        Self { mesh: 48, formats: Vec::new(), pictures: true, step_tolerance: crate::DEFAULT_TOLERANCE }
    }
}

/// A file format for surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY with colours.
    Ply,
    /// STL.
    Stl,
    /// Binary glTF.
    Glb,
    /// VTK unstructured grid, for ParaView.
    Vtu,
    /// STEP AP214, the patch itself as one B-spline face.
    Step,
}

impl Format {
    /// Every format, in the order of the documentation.
    pub const ALL: [Self; 6] = [Self::Obj, Self::Ply, Self::Stl, Self::Glb, Self::Vtu, Self::Step];

    /// The format's name in experiment files, which is also its file extension.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Glb => "glb",
            Self::Vtu => "vtu",
            Self::Step => "step",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
