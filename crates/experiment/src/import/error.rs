use std::io;

use exchange::{AssemblyError, CurveFileError, FrameError, Sentence, Setting};
use thiserror::Error;

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
    /// Its boundary cannot be filled.
    #[error("{0}")]
    Frame(#[from] FrameError),
    /// A number of the options.
    #[error("{0}")]
    Option(Sentence),
    /// A side has many points, and nothing says what they are.
    #[error(
        "{side} has {count} points, and what they are has to be said: points on the curve, then `--degree 6`, with which curves are laid \
         through them; {}; under other names than those of the sides of an experiment they are points on the curve without a word",
        as_control_points(*count, *highest)
    )]
    Ask {
        /// The side.
        side: String,
        /// How many points.
        count: usize,
        /// The highest degree of a curve whose control points they may be.
        highest: usize,
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
    /// More of a boundary than is offered.
    #[error("{0}")]
    TooMany(Sentence),
    /// The boundary is not one of an experiment.
    #[error("the points make no sound experiment: {0}")]
    Plan(String),
}

impl ImportError {
    /// What is wrong, with settings of the joining of curves spelled like this.
    #[must_use]
    pub fn told(&self, spelled: &dyn Fn(Setting, Option<&str>) -> String) -> String {
        match self {
            Self::Assembly(error) => error.told(spelled),
            Self::Option(sentence) | Self::TooMany(sentence) => sentence.told(spelled),
            Self::Corner(gap) => gap.sentence().told(spelled),
            Self::Io(_)
            | Self::File(_)
            | Self::Frame(_)
            | Self::Ask { .. }
            | Self::Fit { .. }
            | Self::Plan(_) => self.to_string(),
        }
    }
}

/// What is to be done where points are control points, if they may be.
fn as_control_points(count: usize, highest: usize) -> String {
    let degree = count - 1;
    if degree > highest {
        return format!(
            "control points they cannot be, of a curve of degree {degree}, for {highest} is the highest"
        );
    }
    format!("or control points of a curve of degree {degree}, then `--control-points`")
}

/// Two sides that should meet and do not.
#[derive(Debug, Error)]
#[error("{}", self.sentence())]
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
    /// One that welds them, unless it is more than may be given.
    pub wide: Option<String>,
    /// Whether they have the names of sides of experiments, which say how they run.
    pub named: bool,
}

impl CornerGap {
    fn sentence(&self) -> Sentence {
        let Self { first, second, end, begin, gap, tolerance, wide, named } = self;
        let mut sentence = Sentence::from(format!(
            "{first} and {second} should meet in a corner, but {first} ends at {end:?} and {second} begins at {begin:?}, {gap:.3e} apart: \
             ends within {tolerance:.1e} are welded"
        ));
        if let Some(wide) = wide {
            sentence = sentence.text(", `").value(Setting::Weld, wide.as_str()).text("` joins these");
        }
        match named {
            true => sentence.text(
                "; sides of these names run as in an experiment, under other names they are chained by their ends, in any order and sense",
            ),
            false => sentence,
        }
    }
}
