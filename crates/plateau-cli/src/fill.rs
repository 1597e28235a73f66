//! `fill`: curves of files in, the surface of least area over them out.

use std::io::Write;
use std::path::{Path, PathBuf};

use exchange::{Assembly, AssemblyOptions, CurveFile, Format, Frame, LengthUnit, Shape, Side, read_curves};
use experiment::{ImportError, ImportOptions, Options, Plan};
use plateau::{Fill, Film, MethodError, Progress};
use record::{Destination, ExportError, ResultFile};
use show::{RimSource, film_figures};

use crate::bars::Bars;
use crate::command::FillArguments;
use crate::conversion::contents;
use crate::failure::Failure;
use crate::interrupt::listen;
use crate::terminal::{line, say};

/// What is written at the end.
enum Wanted {
    Surface(Format),
    Experiment,
    /// What `run` makes of the experiment.
    Result,
    /// The page of that.
    Page,
}

/// Fills, prints the figures, writes the files; one that is refused keeps none of the others back.
pub(crate) fn fill(arguments: &FillArguments, stdout: &mut impl Write) -> Result<(), Failure> {
    listen();
    let outputs = arguments.out.iter().map(|path| output(path, &arguments.files));
    let outputs = outputs.collect::<Result<Vec<_>, Failure>>()?;
    let options = ImportOptions {
        degree: arguments.degree.map(usize::from),
        control_points: false,
        tolerance: arguments.tolerance,
        assembly: AssemblyOptions { weld: arguments.weld, corner_angle: arguments.corner_angle },
    };
    let name = names(&arguments.files);
    let refuse = |error: &dyn std::fmt::Display| {
        say(&format!("error: {name}: {error}"));
        Failure::Input
    };
    let file = curves(&arguments.files)?;
    options.check().map_err(|error| refuse(&error))?;
    let assembly = Assembly::new(&file, &options.assembly).map_err(|error| refuse(&error))?;
    let notes: Vec<&str> = file.notes.iter().chain(&assembly.notes).map(String::as_str).collect();
    notes.iter().for_each(|note| say(&format!("note: {note}")));
    let tolerance = options.tolerance.unwrap_or(ImportOptions::TOLERANCE * assembly.size);
    let frame = assembly.frame(tolerance).map_err(|error| refuse(&error))?;
    let fill = filling(arguments);
    let film = spanned(&frame, &fill, &name, arguments.quiet).map_err(|error| match error {
        MethodError::Cutting(error) => refuse(&error),
        MethodError::Interrupted => Failure::Interrupted,
        error => {
            say(&format!("error: {name}: {error}"));
            Failure::Result
        }
    })?;
    for (name, value) in film_figures(&film, rim_source(&assembly)) {
        line(stdout, &format!("{name:<16}{value}"))?;
    }
    stdout.flush()?;
    let title = title(&arguments.files[0]);
    let experiment = || experiment::import_assembly(&assembly, &title, &options, &fill, &notes);
    let mut sound = true;
    for (wanted, to) in &outputs {
        let written = match wanted {
            Wanted::Surface(format) => record::export_complex(
                *format,
                &title,
                (&film.complex, &film.mesh.mesh),
                arguments.unit.0,
                to,
            )
            .map(|form| form.map(|form| form.description + &unit(*format, arguments.unit.0))),
            Wanted::Experiment => {
                let text = experiment().map_err(|error| refuse(&error))?;
                record::write_text(&text, to).map(|()| None).map_err(ExportError::from)
            }
            Wanted::Result | Wanted::Page => {
                let text = experiment().map_err(|error| refuse(&error))?;
                let text = result(&title, &text, wanted).map_err(|error| refuse(&*error))?;
                record::write_text(&text, to).map(|()| None).map_err(ExportError::from)
            }
        };
        sound &= told(written, to);
    }
    if sound { Ok(()) } else { Err(Failure::Result) }
}

/// What a program that reads the file takes its numbers for, where that is not left open.
fn unit(format: Format, unit: LengthUnit) -> String {
    match unit {
        _ if format != Format::Step => String::new(),
        LengthUnit::Millimetre => {
            "; CAD programs take its numbers for millimetres, --unit says what they are".into()
        }
        LengthUnit::Centimetre | LengthUnit::Metre | LengthUnit::Inch | LengthUnit::Foot => {
            format!("; its numbers are {}", unit.plural())
        }
    }
}

/// Says what was written, or why nothing was; whether it was.
fn told(written: Result<Option<String>, ExportError>, to: &Destination) -> bool {
    match written {
        Ok(Some(form)) => say(&format!("{}: {form}", to.path().display())),
        Ok(None) => say(&to.path().display().to_string()),
        Err(error @ (ExportError::Refused { .. } | ExportError::Failed(_))) => {
            say(&format!("error: {error}"));
            return false;
        }
    }
    true
}

/// The record of an experiment that is run, or its page.
fn result(title: &str, text: &str, wanted: &Wanted) -> Result<String, Box<dyn std::error::Error>> {
    let plan = Plan::parse(&format!("{title}.toml"), text)?;
    let finished = experiment::run(&plan, Options::default(), &())?;
    match wanted {
        Wanted::Page => Ok(record::report(&plan, &finished)),
        Wanted::Surface(_) | Wanted::Experiment | Wanted::Result => {
            Ok(ResultFile::new(&plan, &finished).to_json()?)
        }
    }
}

/// A file to write: what its extension asks for, and its place, which is none of the files that are read.
fn output(path: &Path, inputs: &[PathBuf]) -> Result<(Wanted, Destination), Failure> {
    let refuse = |why: String| {
        say(&format!("error: {}: {why}", path.display()));
        Failure::Input
    };
    let extension =
        path.extension().map(|end| end.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let wanted = match Format::of_extension(&extension) {
        Some(format) => Wanted::Surface(format),
        None if extension == "toml" => Wanted::Experiment,
        None if extension == "json" => Wanted::Result,
        None if extension == "html" => Wanted::Page,
        None => {
            let known: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
            let known = known.join(", ");
            return Err(refuse(format!(
                "files are written by their extension: {known}, stp for a surface, toml for the experiment, json for its result, \
                 html for its page; pictures are made by `plateau run` of the experiment"
            )));
        }
    };
    let to = Destination::named(path).map_err(|error| refuse(format!("cannot be written: {error}")))?;
    match inputs.iter().find(|input| to.replaces(input)) {
        Some(_) => Err(refuse("is a file that is read, and would be replaced: give -o another name".into())),
        None => Ok((wanted, to)),
    }
}

/// The curves of all files together.
fn curves(files: &[PathBuf]) -> Result<CurveFile, Failure> {
    let mut all: Option<CurveFile> = None;
    for path in files {
        let read = contents(path).map_err(ImportError::from);
        let read = read.and_then(|bytes| Ok(read_curves(&bytes, &path.to_string_lossy())?));
        let file = read.map_err(|error| {
            say(&format!("error: {}: {error}", path.display()));
            Failure::Input
        })?;
        all = Some(match all {
            Some(all) => all.with(file),
            None => file,
        });
    }
    // The command line wants a file.
    all.ok_or(Failure::Input)
}

/// What was asked for.
fn filling(arguments: &FillArguments) -> Fill {
    let fill = Fill::default()
        .with_layers(arguments.layers.into())
        .with_accuracy(arguments.accuracy)
        .with_bound(arguments.bound)
        .with_mesh(arguments.mesh.into());
    arguments.degree.map_or(fill, |degree| fill.with_degree(degree.into()))
}

/// The surface over a frame of these files; how far it is, is told on stderr unless that is to be quiet.
fn spanned(frame: &Frame, fill: &Fill, files: &str, quiet: bool) -> Result<Film, MethodError> {
    let bars = Bars::new(quiet);
    bars.begin(&format!("surface over {files}"), None);
    let film = match frame {
        Frame::Loops(loops) => fill.loops(loops, &bars),
        Frame::Graph(graph) => fill.graph(graph, &bars),
    };
    bars.end();
    film
}

/// What the curves were before they were filled.
fn rim_source(assembly: &Assembly) -> RimSource {
    let is_sampled = |side: &Side| matches!(&side.shape, Shape::Polyline(points) if points.len() > 2);
    let weld = assembly.weld;
    RimSource { sampled: assembly.sides.iter().any(is_sampled), welded: weld.count, moved: weld.largest }
}

fn names(files: &[PathBuf]) -> String {
    files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>().join(", ")
}

/// What a file is called without its folder and ending.
fn title(file: &Path) -> String {
    let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| stem != "-").unwrap_or_else(|| "surface".into())
}
