//! From a file, or a text, to a [`Plan`].

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use super::Plan;
use super::experiment::plan;
use crate::diagnostic::{Diagnostic, Fault, Refusal};
use crate::keys::EXPERIMENT;
use crate::limits::MAX_FILE_SIZE;
use crate::text::{self, Faults, Table};

impl Plan {
    /// Reads and checks an experiment file.
    ///
    /// # Errors
    ///
    /// A [`Refusal`] with every fault that could be told apart: the file cannot be opened, is larger
    /// than [`MAX_FILE_SIZE`], is not UTF-8 or not TOML, or asks for something that does not make sense.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Refusal> {
        Self::parse(&path.as_ref().display().to_string(), &text_of(path.as_ref())?)
    }

    /// Reads and checks an experiment from a stream; `file` names it in messages, and its stem names the output folder.
    ///
    /// # Errors
    ///
    /// As [`Self::read`].
    pub fn read_from(file: &str, stream: &mut dyn Read) -> Result<Self, Refusal> {
        Self::parse(file, &text_from(file, stream)?)
    }

    /// Checks the text of an experiment file; `file` names it in messages, and its stem names the output folder.
    ///
    /// ```
    /// let text = r#"
    /// title = "Half a turn of a helicoid"
    /// [trapezium-helicoid]
    /// span = 3.14159
    /// gamma = [0.0, 1.0]
    /// beta = [0.0, 0.0]
    /// "#;
    /// let plan = experiment::Plan::parse("half-turn.toml", text).unwrap();
    /// assert_eq!((plan.stem.as_str(), plan.seed), ("half-turn", 0));
    ///
    /// let refusal = experiment::Plan::parse("half-turn.toml", &text.replace("span", "spam")).unwrap_err();
    /// assert!(refusal.to_string().contains("half-turn.toml:4:1"));
    /// assert!(refusal.to_string().contains("did you mean `span`?"));
    /// ```
    ///
    /// # Errors
    ///
    /// A [`Refusal`] with every fault that could be told apart.
    pub fn parse(file: &str, text: &str) -> Result<Self, Refusal> {
        if text.len() as u64 > MAX_FILE_SIZE {
            return Err(Refusal::new(file, "", vec![too_large(text.len() as u64)]));
        }
        let document = text::parse(text, &EXPERIMENT)
            .map_err(|diagnostics| Refusal::new(file, text, of_curves(file, text, diagnostics)))?;
        let faults = Faults::new(text);
        let plan = plan(&Table::root(&faults, &EXPERIMENT, &document), file);
        let diagnostics = faults.finish();
        match plan {
            Some(plan) if diagnostics.is_empty() => Ok(plan),
            _ => Err(Refusal::new(file, text, diagnostics)),
        }
    }
}

/// What is wrong with a text that is not TOML; of a file of curves, also what to do with it.
fn of_curves(file: &str, text: &str, mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let named_experiment =
        Path::new(file).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if named_experiment || exchange::read_curves(text.as_bytes(), file).is_err() {
        return diagnostics;
    }
    if !diagnostics.is_empty() {
        let help = format!(
            "this is a file of curves: `plateau fill {} -o surface.step` spans them, `plateau import` makes an experiment of them",
            show::Printable(file)
        );
        let first = diagnostics.remove(0).help(help);
        diagnostics.insert(0, first);
    }
    diagnostics
}

/// The text of a file that is not too large.
pub(crate) fn text_of(path: &Path) -> Result<String, Refusal> {
    text_from(&path.display().to_string(), &mut open(path)?)
}

/// A file that is there, and not larger than is read.
fn open(path: &Path) -> Result<File, Refusal> {
    let name = path.display().to_string();
    let unreadable = |error| unreadable(&name, &error);
    let file = File::open(path).map_err(unreadable)?;
    let metadata = file.metadata().map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(unreadable(ErrorKind::IsADirectory.into()));
    }
    if metadata.len() > MAX_FILE_SIZE {
        return Err(too_large_file(&name, metadata.len()));
    }
    Ok(file)
}

/// The text of a stream that is not too large; a pipe or a device has no length beforehand.
pub(crate) fn text_from(name: &str, stream: &mut dyn Read) -> Result<String, Refusal> {
    let mut bytes = Vec::new();
    stream.take(MAX_FILE_SIZE + 1).read_to_end(&mut bytes).map_err(|error| unreadable(name, &error))?;
    if bytes.len() as u64 > MAX_FILE_SIZE {
        return Err(too_large_file(name, bytes.len() as u64));
    }
    String::from_utf8(bytes).map_err(|error| {
        // Shown with what is no text replaced; the place is the same, since everything before it is text.
        let text = String::from_utf8_lossy(error.as_bytes());
        let at = error.utf8_error().valid_up_to();
        let line = 1 + text[..at].matches('\n').count();
        let (message, help) = not_utf8();
        let diagnostic = Diagnostic::at(
            Fault::File,
            at..at + char::REPLACEMENT_CHARACTER.len_utf8(),
            format!("{name}: {message}, from line {line} on"),
            format!("the byte 0x{:02X} begins no character", error.as_bytes()[at]),
        );
        Refusal::new(name, &text, vec![diagnostic.help(help)])
    })
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the kinds of input and output errors are open")]
fn unreadable(name: &str, error: &std::io::Error) -> Refusal {
    let (message, help) = match error.kind() {
        ErrorKind::NotFound => ("there is no such file".to_owned(), "check the name and the folder"),
        ErrorKind::IsADirectory => is_directory(),
        ErrorKind::PermissionDenied => {
            ("the file may not be read".to_owned(), "ask for the permission to read it, or copy it elsewhere")
        }
        ErrorKind::InvalidData => not_utf8(),
        _ => (format!("the file cannot be read: {error}"), "check the file and the disk it lies on"),
    };
    let diagnostic = Diagnostic::whole_file(Fault::File, format!("{name}: {message}")).help(help);
    Refusal::new(name, "", vec![diagnostic])
}

fn is_directory() -> (String, &'static str) {
    ("this is a folder".to_owned(), "name the experiment files inside it, as in folder/*.toml")
}

fn not_utf8() -> (String, &'static str) {
    ("the file is not UTF-8 text".to_owned(), "save it as UTF-8; an experiment file is a TOML text")
}

fn too_large_file(name: &str, size: u64) -> Refusal {
    let diagnostic = too_large(size);
    let named = Diagnostic::whole_file(Fault::File, format!("{name}: {}", diagnostic.message()));
    Refusal::new(name, "", vec![named.help(diagnostic.remedies().join("; "))])
}

fn too_large(size: u64) -> Diagnostic {
    Diagnostic::whole_file(
        Fault::File,
        format!("the file has {size} bytes or more, above the limit of {MAX_FILE_SIZE} (1 MiB)"),
    )
    .help("split it into several experiments; the sides of a net of the highest degree take 20 kilobytes")
}
