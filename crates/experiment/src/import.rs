//! Boundaries from files: curves in, a ready experiment out.

use std::io;

use exchange::{Assembly, AssemblyError, AssemblyOptions, CurveFile, CurveFileError, Shape, read_curves};
use surfaces::Point;
use thiserror::Error;

use crate::Plan;
use plateau::MAX_DEGREE;

mod fit;
mod printed;
mod sides;

use sides::Sides;

/// Largest size in bytes of a file that is imported.
pub const MAX_IMPORT_SIZE: u64 = 16 * 1024 * 1024;

/// Most samples of a side that is fitted.
const MOST_SAMPLES: usize = 5000;

/// Most points of a side that are taken as control points without a word.
const MANY: usize = 13;

/// Why no boundary could be made of a file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The file system.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// The file is not understood.
    #[error("{0}")]
    File(#[from] CurveFileError),
    /// Its curves make no boundary.
    #[error("{0}")]
    Assembly(#[from] AssemblyError),
    /// A number of the options.
    #[error("{0}")]
    Option(String),
    /// A side has many points, and nothing says what they are.
    #[error(
        "{side} has {count} points, and what they are has to be said: points on the curve, then `--degree 6` fits curves of degree 6 to \
         the points of every side; or control points of a curve of degree {}, then `--control-points`",
        count - 1
    )]
    Ask {
        /// The side.
        side: String,
        /// How many points.
        count: usize,
    },
    /// The ends of two sides are apart.
    #[error("{0}")]
    Corner(Box<CornerGap>),
    /// A side cannot be fitted.
    #[error("{side}: {why}")]
    Fit {
        /// Its name.
        side: String,
        /// Why, and what to do.
        why: String,
    },
    /// The boundary is not one of an experiment.
    #[error("the points make no sound experiment: {0}")]
    Plan(String),
}

/// Two sides that should meet and do not.
#[derive(Debug, Error)]
#[error(
    "{first} and {second} should meet in a corner, but {first} ends at {end:?} and {second} begins at {begin:?}, {gap:.3e} apart: \
     ends within {tolerance:.1e} are welded, `--weld {wide}` joins these{}",
    if *named { "; sides of these names run as in an experiment, under other names they are chained by their ends, in any order \
     and sense" } else { "" }
)]
#[non_exhaustive]
pub struct CornerGap {
    /// One side.
    pub first: String,
    /// The other.
    pub second: String,
    /// The end of the first.
    pub end: [f64; 3],
    /// The beginning of the second.
    pub begin: [f64; 3],
    /// Their distance.
    pub gap: f64,
    /// The largest that is welded.
    pub tolerance: f64,
    /// One that welds them.
    pub wide: String,
    /// Whether they have the names of sides of experiments, which say how they run.
    pub named: bool,
}

/// What a file of curves leaves open.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ImportOptions {
    /// The points of polylines are samples: each side is the curve of this degree nearest to them.
    pub degree: Option<usize>,
    /// The points of polylines are control points, however many.
    pub control_points: bool,
    /// How far the curve of a side of many samples may pass from them; by default [`Self::TOLERANCE`] of the size.
    pub tolerance: Option<f64>,
    /// Welding and corners.
    pub assembly: AssemblyOptions,
}

impl ImportOptions {
    /// Share of the size (the diagonal of the box around all curves) by which curves may pass from samples.
    pub const TOLERANCE: f64 = 1e-4;

    fn check(&self) -> Result<(), ImportError> {
        if self.degree.is_some() && self.control_points {
            let why = "--degree says that the points are on the curves, --control-points that they are not: give one of them";
            return Err(ImportError::Option(why.into()));
        }
        if let Some(degree) = self.degree.filter(|degree| !(1..=MAX_DEGREE).contains(degree)) {
            return Err(ImportError::Option(format!(
                "degree {degree} is not offered; 1 to {MAX_DEGREE} are"
            )));
        }
        match self.tolerance.filter(|tolerance| !(*tolerance > 0.0 && tolerance.is_finite())) {
            Some(tolerance) => {
                Err(ImportError::Option(format!("--tolerance {tolerance}: it is a length above 0")))
            }
            None => Ok(()),
        }
    }
}

/// Reads the boundary in a file (`bytes`; `name` is that of the file or `-`) and prints an experiment over it.
///
/// Three or four curves of points that form a loop become the sides of a triangular or a tensor boundary. Without a degree their points
/// are control points; with one they are samples, and each side is the Bernstein curve of that degree nearest to them in the sense of
/// least squares, its ends on theirs; how near is said in comments. Straight sides are straight whatever the degree. So do loops of
/// three or four straight lines and Bézier curves, which stay as they are. All else becomes a boundary of loops or faces
/// over curves, sampled ones to be met within the tolerance.
///
/// # Errors
/// [`ImportError`]; the file itself is not named in it.
pub fn import(bytes: &[u8], name: &str, options: &ImportOptions) -> Result<String, ImportError> {
    options.check()?;
    let file = read_curves(bytes, name)?;
    let title = title(name);
    let notes: Vec<&str> = file.notes.iter().map(String::as_str).collect();
    let apart = match Sides::of_file(&file, options) {
        Ok(Some(sides)) => return checked(sides.printed(&title, &notes)),
        Ok(None) => None,
        // Under names of their own they may be two loops, or branch.
        Err(ImportError::Corner(apart)) if !apart.named => Some(ImportError::Corner(apart)),
        Err(error) => return Err(error),
    };
    let assembly = Assembly::new(&file, &options.assembly).map_err(|error| match (error, apart) {
        (AssemblyError::Gap(why), _) => ImportError::Assembly(AssemblyError::Gap(why)),
        (_, Some(apart)) => apart,
        (error, None) => error.into(),
    })?;
    let notes: Vec<&str> = notes.into_iter().chain(assembly.notes.iter().map(String::as_str)).collect();
    match Sides::of_assembly(&assembly, options)? {
        Some(sides) => checked(sides.printed(&title, &notes)),
        None => printed::assembly(&title, &assembly, options, &notes),
    }
}

/// What a file is called without its folder and ending.
fn title(name: &str) -> String {
    let stem = std::path::Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| stem != "-").unwrap_or_else(|| "boundary".into())
}

/// The text of an experiment, if it is sound.
fn checked(text: String) -> Result<String, ImportError> {
    match Plan::parse("imported.toml", &text) {
        Ok(_) => Ok(text),
        Err(refusal) => Err(ImportError::Plan(
            refusal.diagnostics().iter().map(|fault| fault.message()).collect::<Vec<_>>().join("; "),
        )),
    }
}

/// The polylines of a file, if it has nothing else.
fn polylines(file: &CurveFile) -> Option<Vec<(&str, &[Point])>> {
    file.curves
        .iter()
        .map(|curve| match &curve.shape {
            Shape::Polyline(points) if !curve.closes => Some((curve.name.as_str(), points.as_slice())),
            Shape::Polyline(_) | Shape::Spline(_) | Shape::Arc(_) => None,
        })
        .collect()
}
