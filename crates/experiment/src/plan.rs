//! The plan: what an experiment file asks for, checked, typed, with every default filled in.
//!
//! A [`Plan`] exists only if its file was sound, so whoever runs one has nothing left to check except
//! what only the mathematics can tell (a singular mask system, rows that admit no harmonic net).
//! Points are plain `[x, y, z]`, finite, with |coordinate| ≤ [`MAX_COORDINATE`](plateau::MAX_COORDINATE).

mod arrangement;
mod boundary;
mod built;
mod curve;
mod curves;
mod draft;
mod expected;
mod experiment;
mod faces;
mod family;
mod file;
mod film;
mod helicoid;
mod interior;
mod loops;
mod memory;
mod method;
mod net;
mod patch;
mod search;
mod settings;
mod shape;
mod side;

pub use self::experiment::stem;
pub(crate) use file::{text_from, text_of};

use plateau::{Construction, Curve, Helicoid, OwnNet};
use surfaces::TrapeziumHelicoid;

use exchange::{Format, StepForm};
pub use expected::{Expected, Published, Wanted};
pub use film::{FilmExperiment, FilmMethod, Rim};
pub use patch::PatchExperiment;

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
    /// What the file wants of the results: one entry per method, or one for the helicoid or the curve.
    pub wanted: Vec<Wanted>,
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
    /// Loops or `[[face]]`, and `[[method]]`: surfaces of several patches.
    Film(FilmExperiment),
    /// `[helicoid]`: a generalized helicoid, exact in AHT ⊗ AHT (AHT).
    Helicoid(Helicoid),
    /// `[trapezium-helicoid]`: a right helicoid over a trapezium, exact in AT ⊗ degree 1 (AT).
    TrapeziumHelicoid(TrapeziumHelicoid, Construction),
    /// `[net]`: a surface of which every control point is given.
    Net(OwnNet),
    /// `[curve]`: one curve, sampled; with several shapes, one curve for each, all else the same.
    Curve(Vec<Curve>),
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
    /// How STEP files hold the surface; the tolerance is in (0, 1].
    pub step: StepForm,
}
