//! A file that is one experiment, or a sweep of many.

use std::io::Read;
use std::path::Path;

use super::cell::Sweep;
use super::segment::segments;
use crate::diagnostic::Refusal;
use crate::plan::{Plan, text_from, text_of};

/// What a file holds.
#[derive(Clone, Debug)]
pub enum Source {
    /// One experiment.
    Experiment(Box<Plan>),
    /// Many.
    Sweep(Box<Sweep>),
}

impl Source {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// As [`Plan::read`] and [`Sweep::parse`].
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Refusal> {
        let path = path.as_ref();
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::parse(&path.display().to_string(), &text_of(path)?, folder)
    }

    /// Reads and checks what comes from a stream; `file` names it in messages, and its stem names the output folder. Folders of
    /// boundaries are seen from the folder in which the program runs.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_from(file: &str, stream: &mut dyn Read) -> Result<Self, Refusal> {
        Self::parse(file, &text_from(file, stream)?, Path::new(""))
    }

    /// Checks a text; `file` names it in messages, folders of boundaries are seen from `folder`.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn parse(file: &str, text: &str, folder: &Path) -> Result<Self, Refusal> {
        if text.contains("sweep") && segments(text).iter().any(|segment| segment.table == "sweep") {
            return Sweep::parse(file, text, folder).map(|sweep| Self::Sweep(Box::new(sweep)));
        }
        Plan::parse(file, text).map(|plan| Self::Experiment(Box::new(plan)))
    }

    /// The name of its output folder: the file name without its last extension, never empty.
    #[must_use]
    pub fn stem(&self) -> String {
        match self {
            Self::Experiment(plan) => plan.stem.clone(),
            Self::Sweep(sweep) => sweep.stem(),
        }
    }

    /// The file name as it was given, for messages.
    #[must_use]
    pub fn file(&self) -> &str {
        match self {
            Self::Experiment(plan) => &plan.file,
            Self::Sweep(sweep) => sweep.file(),
        }
    }
}
