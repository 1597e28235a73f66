//! `fill`: curves of files in, the surface of least area over them out.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use exchange::{AssemblyOptions, CurveFile, read_curves};
use experiment::{Filling, ImportError, ImportOptions};
use plateau::{Fill, Film, MethodFailure, Progress};
use show::film_figures;

use crate::bars::Bars;
use crate::command::FillArguments;
use crate::conversion::contents;
use crate::failure::Failure;
use crate::interrupt::{listen, waiting};
use crate::spelling::{ESTIMATE, spelled};
use crate::terminal::{line, say};

mod output;

use output::{Filled, Output};

/// Fills, prints the figures, writes the files; one that is refused keeps none of the others back.
pub(crate) fn fill(arguments: &FillArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    listen();
    let outputs = arguments.out.iter().map(|path| Output::named(path, &arguments.files));
    let mut outputs = outputs.collect::<Result<Vec<_>, Failure>>()?;
    // Files first: whoever ends the wait for a reader has them.
    outputs.sort_by_key(Output::is_stream);
    let name = names(&arguments.files);
    let files = arguments.files.iter().map(|path| curves(path)).collect::<Result<Vec<_>, Failure>>()?;
    let filling = Filling::new(files, &options(arguments))
        .map_err(|error| Failure::of_input(&name, error.told(&spelled)))?;
    let filling = match arguments.unit {
        Some(unit) => filling.with_unit(unit),
        None => filling,
    };
    filling.notes().iter().for_each(|note| say(&format!("note: {}", note.told(&spelled))));
    let fill = method(arguments);
    let film = spanned(&filling, &fill, &name, arguments.quiet)?;
    if outputs.iter().any(Output::is_stdout) {
        figures(&film, &filling, &mut io::stderr())?;
    } else {
        figures(&film, &filling, stdout)?;
    }
    filling.advice(&fill, &film).iter().for_each(|note| say(&format!("note: {note}")));
    let title = title(&arguments.files[0]);
    let files = file_names(&arguments.files);
    let filled = Filled { filling: &filling, fill: &fill, film: &film, title: &title, files: &files };
    let mut sound = true;
    for output in &outputs {
        sound &= output.written(&filled, &name)?;
    }
    if sound { Ok(()) } else { Err(Failure::Result) }
}

/// The figures of the surface, for a person.
fn figures(film: &Film, filling: &Filling, out: &mut impl Write) -> io::Result<()> {
    for (name, value) in film_figures(film, filling.rim_source(), ESTIMATE) {
        line(out, &format!("{name:<16}{value}"))?;
    }
    out.flush()
}

/// The curves of a file; what it says of itself is told.
fn curves(path: &Path) -> Result<CurveFile, Failure> {
    let read = waiting(|| contents(path)).map_err(ImportError::from);
    let read = read.and_then(|bytes| Ok(read_curves(&bytes, &path.to_string_lossy())?));
    let file = read.map_err(|error| Failure::of_input(path.display(), error.told(&spelled)))?;
    file.notes.iter().for_each(|note| say(&format!("note: {}", note.told(&spelled))));
    Ok(file)
}

/// How the curves are taken.
fn options(arguments: &FillArguments) -> ImportOptions {
    ImportOptions {
        degree: arguments.degree.map(usize::from),
        control_points: arguments.control_points,
        tolerance: arguments.tolerance,
        assembly: AssemblyOptions { weld: arguments.weld, corner_angle: arguments.corner_angle },
    }
}

/// What is done with them.
fn method(arguments: &FillArguments) -> Fill {
    let fill = Fill::default()
        .with_layers(arguments.layers.into())
        .with_accuracy(arguments.accuracy)
        .with_bound(arguments.bound)
        .with_mesh(arguments.mesh.into());
    arguments.degree.map_or(fill, |degree| fill.with_degree(degree.into()))
}

/// The surface over the curves; how far it is, is told on stderr unless that is to be quiet.
fn spanned(filling: &Filling, fill: &Fill, name: &str, quiet: bool) -> Result<Film, Failure> {
    let bars = Bars::new(quiet);
    bars.begin(&format!("surface over {name}"), None);
    let film = filling.span(fill, &bars);
    bars.end();
    film.map_err(|error| match error.failure() {
        MethodFailure::Boundary => Failure::of_input(name, error),
        MethodFailure::Interrupted => Failure::Interrupted,
        MethodFailure::Memory | MethodFailure::Method => {
            say(&format!("error: {name}: {error}"));
            Failure::Result
        }
    })
}

fn names(files: &[PathBuf]) -> String {
    files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>().join(", ")
}

/// What files are called without their folders.
fn file_names(files: &[PathBuf]) -> String {
    let name = |file: &PathBuf| file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
    files.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// What a file is called without its folder and ending.
fn title(file: &Path) -> String {
    let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| stem != "-").unwrap_or_else(|| "surface".into())
}
