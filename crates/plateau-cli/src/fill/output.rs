//! The files that `fill` writes.

use std::path::{Path, PathBuf};

use exchange::{Format, LengthUnit, Lengths, SurfaceForm};
use experiment::{Filling, Options, Plan};
use plateau::{Fill, Film};
use record::{Destination, ExportError, ResultFile};

use crate::descriptors::{stdin, stdout};
use crate::failure::Failure;
use crate::interrupt::waiting;
use crate::terminal::say;

/// A surface with how it came about.
pub(super) struct Filled<'a> {
    pub(super) filling: &'a Filling,
    pub(super) fill: &'a Fill,
    pub(super) film: &'a Film,
    pub(super) title: &'a str,
    /// The files of its curves, without their folders.
    pub(super) files: &'a str,
}

/// What is written.
enum Wanted {
    Surface(Format),
    Experiment,
    /// What `run` makes of the experiment.
    Result,
    /// The page of that.
    Page,
}

/// A file to write.
pub(super) struct Output {
    wanted: Wanted,
    to: Destination,
}

impl Output {
    /// What the extension of `path` asks for; its place is none of the files that are read.
    pub(super) fn named(path: &Path, inputs: &[PathBuf]) -> Result<Self, Failure> {
        let refused = |why: String| Failure::of_input(path.display(), why);
        let extension =
            path.extension().map(|end| end.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let wanted = match Format::of_file(&name) {
            Some(format) => Wanted::Surface(format),
            None if extension == "toml" => Wanted::Experiment,
            None if extension == "json" => Wanted::Result,
            None if extension == "html" => Wanted::Page,
            None => {
                let known: Vec<&str> = Format::ALL.iter().map(|format| format.ending()).collect();
                let known = known.join(", ");
                let why = format!(
                    "files are written by their extension: {known}, stp for a surface, toml for the experiment, json for its result, \
                     html for its page; pictures are made by `plateau run` of the experiment"
                );
                return Err(refused(why));
            }
        };
        let to = Destination::named(path).map_err(|error| refused(format!("cannot be written: {error}")))?;
        if inputs.iter().any(|input| is_replaced(input, &to)) {
            return Err(refused(
                "is a file that is read, and would be replaced: give -o another name".into(),
            ));
        }
        Ok(Self { wanted, to })
    }

    /// Whether it is written to a reader at once, for whom it may wait.
    pub(super) fn is_stream(&self) -> bool {
        self.to.is_stream()
    }

    /// Whether it is written to stdout, by whatever name.
    pub(super) fn is_stdout(&self) -> bool {
        stdout().is_some_and(|stdout| self.to.is_open_as(&stdout))
    }

    /// Writes the file and says so, or why not; whether it is written.
    pub(super) fn written(&self, filled: &Filled<'_>, name: &str) -> Result<bool, Failure> {
        let Self { wanted, to } = self;
        let text = |text: String| {
            placed(to, || record::write_text(&text, to)).map(|()| Vec::new()).map_err(ExportError::from)
        };
        let experiment = || filled.filling.experiment(filled.title, filled.fill);
        let experiment = || experiment().map_err(|error| Failure::of_input(name, error));
        let written = match wanted {
            Wanted::Surface(format) => {
                let surface = (filled.film.complex(), &filled.film.mesh.mesh);
                let unit = filled.filling.unit();
                let form = placed(to, || record::export_complex(*format, filled.title, surface, unit, to));
                let told = |form: Option<SurfaceForm>| form.map(|form| form.description).into_iter();
                form.map(|form| told(form).chain(said(format.lengths(), unit)).collect::<Vec<_>>())
            }
            Wanted::Experiment => text(experiment()?),
            Wanted::Result | Wanted::Page => {
                text(ran(filled, &experiment()?, wanted).map_err(|error| Failure::of_input(name, error))?)
            }
        };
        match written {
            Ok(told) if told.is_empty() => say(&to.path().display().to_string()),
            Ok(told) => say(&format!("{}: {}", to.path().display(), told.join("; "))),
            Err(error @ (ExportError::Refused { .. } | ExportError::Failed(_))) => {
                say(&format!("error: {error}"));
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Whether writing to a place would replace an input, which is stdin if it is `-`.
fn is_replaced(input: &Path, to: &Destination) -> bool {
    if input == Path::new("-") {
        stdin().is_some_and(|stdin| to.replaces_open(&stdin))
    } else {
        to.replaces(input)
    }
}

/// Writes to a place; a reader may never come, or stop reading.
fn placed<T>(to: &Destination, write: impl FnOnce() -> T) -> T {
    if to.is_stream() { waiting(write) } else { write() }
}

/// What a program that reads the file takes its numbers for, where that is not left open.
fn said(lengths: Lengths, unit: Option<LengthUnit>) -> Option<String> {
    match (lengths, unit) {
        (lengths, Some(unit)) => lengths.told(unit),
        (Lengths::Named, None) => {
            Some("CAD programs take its numbers for millimetres, --unit says what they are".into())
        }
        (Lengths::Metres, None) => {
            Some("viewers take its numbers for metres, --unit says what they are".into())
        }
        (Lengths::Unsaid, None) => None,
    }
}

/// What comes of an experiment that is run: its record, or the page.
fn ran(filled: &Filled<'_>, text: &str, wanted: &Wanted) -> Result<String, Box<dyn std::error::Error>> {
    let plan = Plan::parse(&format!("{}.toml", filled.title), text)?;
    let finished = experiment::run(&plan, Options::default(), &())?;
    match wanted {
        Wanted::Page => Ok(record::report(&plan, &finished, show::Source::Curves(filled.files))),
        Wanted::Surface(_) | Wanted::Experiment | Wanted::Result => {
            Ok(ResultFile::new(&plan, &finished).to_json()?)
        }
    }
}
