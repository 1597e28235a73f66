//! `export` and `import`: surfaces of a result as files for other programs, boundaries from theirs.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use exchange::{AssemblyOptions, StepForm};
use experiment::{ImportError, ImportOptions, MAX_IMPORT_SIZE};
use record::{Destination, ExportError, StoredMethod, StoredResult};

use crate::command::{ExportArguments, ImportArguments};
use crate::failure::Failure;
use crate::spelling::spelled;
use crate::terminal::{line, say};

/// Writes the files; one that is refused keeps none of the others back.
pub(crate) fn export(arguments: &ExportArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let result = &arguments.result;
    let refuse = |message: String| {
        say(&format!("error: {}: {message}", result.display()));
        Failure::Input
    };
    let stored = StoredResult::read(result).map_err(|error| refuse(error.to_string()))?;
    let chosen = chosen(&stored, arguments.method.as_deref()).map_err(refuse)?;
    if arguments.out.is_some() && chosen.len() > 1 {
        return Err(refuse(format!(
            "--out is one file and there are {} methods: choose one with --method",
            chosen.len()
        )));
    }
    let format = arguments.format;
    let step = StepForm { tolerance: arguments.tolerance, unit: arguments.unit.or(stored.unit) };
    let (folder, prefix) = (result.parent().unwrap_or(Path::new("")), prefix(result));
    let mut sound = true;
    for method in chosen {
        let to = match &arguments.out {
            Some(path) => named(path, result)?,
            None => {
                Destination::own(folder.join(format!("{prefix}{}.{}", method.file_name, format.ending())))
            }
        };
        let path = to.path().display();
        let written = method.export(format, arguments.mesh.into(), step, &to);
        // Of what is not known there is nothing to say.
        let lengths = step.unit.and_then(|unit| format.lengths().told(unit));
        match written.map(|form| {
            let told: Vec<String> = form.map(|form| form.description).into_iter().chain(lengths).collect();
            if told.is_empty() { format!("{path}") } else { format!("{path}: {}", told.join("; ")) }
        }) {
            // What is read at once may be read from stdout.
            Ok(told) if to.is_stream() => say(&told),
            Ok(told) => line(stdout, &told)?,
            Err(error @ (ExportError::Refused { .. } | ExportError::Failed(_))) => {
                say(&format!("error: {error}"));
                sound = false;
            }
        }
    }
    if sound { Ok(()) } else { Err(Failure::Result) }
}

/// What the files of a result begin with, so that results in one folder keep theirs apart: nothing for the one that `run` writes.
fn prefix(result: &Path) -> String {
    let stem = result.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|_| result.file_name().is_some_and(|name| name != "result.json"))
        .map_or_else(String::new, |stem| stem + ".")
}

/// The file a person asked for; never the result itself.
fn named(path: &Path, result: &Path) -> Result<Destination, Failure> {
    let refuse = |why: String| {
        say(&format!("error: {}: {why}", path.display()));
        Failure::Input
    };
    let to = Destination::named(path).map_err(|error| refuse(format!("cannot be written: {error}")))?;
    if to.replaces(result) {
        let why = "is the result that is read, and would be replaced: give --out another name";
        return Err(refuse(why.into()));
    }
    Ok(to)
}

/// Prints an experiment over the boundary in a file.
pub(crate) fn import(arguments: &ImportArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    let file = &arguments.file;
    let options = ImportOptions {
        degree: arguments.degree.map(usize::from),
        control_points: arguments.control_points,
        tolerance: arguments.tolerance,
        assembly: AssemblyOptions { weld: arguments.weld, corner_angle: arguments.corner_angle },
    };
    let text = contents(file)
        .map_err(ImportError::from)
        .and_then(|bytes| experiment::import(&bytes, &file.to_string_lossy(), &options));
    match text {
        Ok(experiment) => Ok(stdout.write_all(experiment.as_bytes())?),
        Err(error) => {
            say(&format!("error: {}: {}", file.display(), error.told(&spelled)));
            Err(Failure::Input)
        }
    }
}

/// The bytes of a file, or of stdin for `-`; no more than are read and one.
pub(crate) fn contents(file: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let from: &mut dyn Read =
        if file == Path::new("-") { &mut io::stdin().lock() } else { &mut File::open(file)? };
    from.take(MAX_IMPORT_SIZE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn chosen<'a>(stored: &'a StoredResult, name: Option<&str>) -> Result<Vec<&'a StoredMethod>, String> {
    let methods: Vec<&StoredMethod> =
        stored.methods.iter().filter(|method| name.is_none_or(|name| method.name == name)).collect();
    if !methods.is_empty() {
        return Ok(methods);
    }
    let names: Vec<String> = stored.methods.iter().map(|method| format!("{:?}", method.name)).collect();
    Err(match name {
        Some(name) if !names.is_empty() => format!("has no method {name:?}; it has {}", names.join(", ")),
        _ => "holds no surface: curves have no files but their curve.csv".to_owned(),
    })
}
