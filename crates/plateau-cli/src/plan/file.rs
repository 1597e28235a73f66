//! From a file, or a text, to a [`Plan`].

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use serde_spanned::Spanned;

use super::boundary::{Sides, boundary};
use super::check::{Check, Table, top};
use super::curve::curve;
use super::helicoid::{helicoid, trapezium};
use super::memory::fits;
use super::method::methods;
use super::search::search;
use super::{Experiment, Format, LARGEST_MESH, MAX_FILE_SIZE, Output, PatchExperiment, Plan, Wanted};
use crate::diagnostic::{Diagnostic, Fault, Refusal};
use crate::spec::{self, OutputSpec, Reading, Section, Spec};
use plateau::Search;

const KINDS: &str =
    "an experiment holds one of [boundary] with [[method]] tables, [helicoid], [trapezium-helicoid], [curve]";

impl Plan {
    /// Reads and checks an experiment file.
    ///
    /// # Errors
    ///
    /// A [`Refusal`] with every fault that could be told apart: the file cannot be opened, is larger
    /// than [`MAX_FILE_SIZE`], is not UTF-8 or not TOML, or asks for something that does not make sense.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Refusal> {
        let path = path.as_ref();
        let file = path.display().to_string();
        let text = load(path)?;
        Self::parse(&file, &text)
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
    /// let plan = plateau_cli::Plan::parse("half-turn.toml", text).unwrap();
    /// assert_eq!((plan.stem.as_str(), plan.seed), ("half-turn", 0));
    ///
    /// let refusal = plateau_cli::Plan::parse("half-turn.toml", &text.replace("span", "spam")).unwrap_err();
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
        let Reading { spec, diagnostics, removed } = spec::read(text);
        let Some(spec) = spec else { return Err(Refusal::new(file, text, diagnostics)) };
        let mut check = Check::new(text, diagnostics, removed);
        let plan = plan(&mut check, &spec, file);
        let diagnostics = check.finish();
        match plan {
            Some(plan) if diagnostics.is_empty() => Ok(plan),
            _ => Err(Refusal::new(file, text, diagnostics)),
        }
    }
}

/// The text of a file that is not too large.
fn load(path: &Path) -> Result<String, Refusal> {
    let refuse = |diagnostic| Refusal::new(&path.display().to_string(), "", vec![diagnostic]);
    let unreadable = |error: std::io::Error| {
        let (message, help) = match error.kind() {
            ErrorKind::NotFound => ("there is no such file".to_owned(), "check the name and the folder"),
            ErrorKind::IsADirectory => is_directory(),
            ErrorKind::PermissionDenied => (
                "the file may not be read".to_owned(),
                "ask for the permission to read it, or copy it elsewhere",
            ),
            ErrorKind::InvalidData => not_utf8(),
            _ => (format!("the file cannot be read: {error}"), "check the file and the disk it lies on"),
        };
        refuse(Diagnostic::whole_file(Fault::File, format!("{}: {message}", path.display())).help(help))
    };
    let file = File::open(path).map_err(unreadable)?;
    let metadata = file.metadata().map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(unreadable(ErrorKind::IsADirectory.into()));
    }
    if metadata.len() > MAX_FILE_SIZE {
        return Err(refuse(too_large_file(path, metadata.len())));
    }
    // A pipe or a device has no length beforehand.
    let mut bytes = Vec::new();
    file.take(MAX_FILE_SIZE + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > MAX_FILE_SIZE {
        return Err(refuse(too_large_file(path, bytes.len() as u64)));
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
            format!("{}: {message}, from line {line} on", path.display()),
            format!("the byte 0x{:02X} begins no character", error.as_bytes()[at]),
        );
        Refusal::new(&path.display().to_string(), &text, vec![diagnostic.help(help)])
    })
}

fn is_directory() -> (String, &'static str) {
    ("this is a folder".to_owned(), "name the experiment files inside it, as in folder/*.toml")
}

fn not_utf8() -> (String, &'static str) {
    ("the file is not UTF-8 text".to_owned(), "save it as UTF-8; an experiment file is a TOML text")
}

fn too_large_file(path: &Path, size: u64) -> Diagnostic {
    let diagnostic = too_large(size);
    Diagnostic::whole_file(Fault::File, format!("{}: {}", path.display(), diagnostic.message()))
        .help(diagnostic.remedies().join("; "))
}

fn too_large(size: u64) -> Diagnostic {
    Diagnostic::whole_file(
        Fault::File,
        format!("the file has {size} bytes or more, above the limit of {MAX_FILE_SIZE} (1 MiB)"),
    )
    .help("split it into several experiments; the sides of a net of the highest degree take 20 kilobytes")
}

fn plan(check: &mut Check<'_>, spec: &Spec, file: &str) -> Option<Plan> {
    let root = check.table("the experiment", 0..0, &[]);
    let title_help = "begin the file with title = \"…\": it heads the table of results";
    let title = check
        .required(&root, "title", &spec.title, title_help)
        .and_then(|key| check.name(&root, "title", key, title_help));
    let seed = seed(check, spec);
    let output = match &spec.output {
        Some(key) => output(check, key),
        None => Some(Output::default()),
    };
    let experiment = experiment(check, spec, &root);
    if let (Some((experiment, _)), Some(output)) = (&experiment, &output) {
        fits(check, spec, experiment, output.mesh);
    }
    let (experiment, wanted) = experiment?;
    Some(Plan {
        title: title?,
        seed: seed?,
        stem: stem(file),
        file: file.to_owned(),
        experiment,
        wanted,
        output: output?,
        text: check.text.to_owned(),
    })
}

/// The file name without its folders and its last extension; never empty, and no name of a folder above (`...toml`).
pub(crate) fn stem(file: &str) -> String {
    Path::new(file)
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned())
        .filter(|stem| !matches!(stem.as_str(), "" | "." | ".."))
        .unwrap_or_else(|| "experiment".to_owned())
}

fn seed(check: &mut Check<'_>, spec: &Spec) -> Option<u64> {
    let Some(key) = &spec.seed else { return Some(0) };
    let value = key.get_ref().0;
    match i64::try_from(value).ok().and_then(|seed| u64::try_from(seed).ok()) {
        Some(seed) => Some(seed),
        None => {
            check.inadmissible(
                key.span(),
                "`seed` must lie between 0 and 2^63 - 1 = 9223372036854775807",
                format!("this is {value}"),
                "any whole number will do: the same seed gives the same result; without one the seed is 0",
            );
            None
        }
    }
}

fn output(check: &mut Check<'_>, key: &Spanned<Section<OutputSpec>>) -> Option<Output> {
    let table = check.table("[output]", key.span(), &top("output"));
    let spec = key.get_ref();
    let mut output = Output::default();
    let mut sound = true;
    if let Some(key) = &spec.mesh {
        let help = "it is the number of subdivisions of each side of the surface mesh; 48 is the default";
        match check.count(&table, "mesh", key, 2..=LARGEST_MESH, help) {
            Some(mesh) => output.mesh = mesh,
            None => sound = false,
        }
    }
    if let Some(key) = &spec.pictures {
        output.pictures = key.get_ref().0;
    }
    if let Some(key) = &spec.step_tolerance {
        let help = "it is the largest distance between a fitted surface in a STEP file and the patch, as a share of the patch's \
                    size; 1e-6 is the default";
        let admitted = (|x| x > 0.0 && x <= 1.0, "above 0 and at most 1");
        match check.number(&table, "step-tolerance", key, admitted, help) {
            Some(tolerance) => output.step_tolerance = tolerance,
            None => sound = false,
        }
    }
    let names = Format::ALL.map(|format| (format.name(), format));
    for name in spec.formats.iter().flat_map(|key| &key.get_ref().0) {
        match check.choice(&table, "formats", name, &names) {
            Some(format) if output.formats.contains(&format) => {}
            Some(format) => output.formats.push(format),
            None => sound = false,
        }
    }
    sound.then_some(output)
}

fn experiment(check: &mut Check<'_>, spec: &Spec, root: &Table) -> Option<(Experiment, Vec<Wanted>)> {
    let headers: Vec<(&str, std::ops::Range<usize>)> = [
        spec.boundary.as_ref().map(|key| ("[boundary]", key.span())),
        spec.helicoid.as_ref().map(|key| ("[helicoid]", key.span())),
        spec.trapezium_helicoid.as_ref().map(|key| ("[trapezium-helicoid]", key.span())),
        spec.curve.as_ref().map(|key| ("[curve]", key.span())),
    ]
    .into_iter()
    .flatten()
    .collect();
    if let [(first, first_span), (second, second_span), ..] = headers.as_slice() {
        check.conflict(
            (second_span.clone(), "a second subject"),
            (first_span.clone(), "the first subject"),
            format!("one experiment holds both {first} and {second}"),
            format!("put them into two files; {KINDS}"),
        );
        return None;
    }
    if let (Some((subject, at)), None) = (headers.first(), &spec.boundary) {
        let strays = [
            spec.method.as_ref().map(|key| ("[[method]]", key.span())),
            spec.search.as_ref().map(|key| ("[search]", key.span())),
        ];
        for (stray, span) in strays.into_iter().flatten() {
            check.conflict(
                (span, "only beside [boundary]"),
                (at.clone(), "the subject of this experiment"),
                format!("{stray} does not belong to a {subject} experiment"),
                format!("take {stray} out: {subject} says everything by itself"),
            );
        }
    }
    if let Some(key) = &spec.helicoid {
        return helicoid(check, key, &spec.expect)
            .map(|(it, wanted)| (Experiment::Helicoid(it), vec![wanted]));
    }
    if let Some(key) = &spec.trapezium_helicoid {
        return trapezium(check, key, &spec.expect)
            .map(|(it, wanted)| (Experiment::TrapeziumHelicoid(it), vec![wanted]));
    }
    if let Some(key) = &spec.curve {
        return curve(check, key, &spec.expect).map(|(it, wanted)| (Experiment::Curve(it), vec![wanted]));
    }
    patches(check, spec, root).map(|(it, wanted)| (Experiment::Patch(it), wanted))
}

fn nothing(check: &mut Check<'_>, root: &Table) {
    if !root.damaged {
        let label = "the experiment has no subject";
        check.report(
            Diagnostic::at(Fault::Missing, root.span.clone(), "there is nothing to compute", label)
                .help(KINDS),
        );
    }
}

fn patches(check: &mut Check<'_>, spec: &Spec, root: &Table) -> Option<(PatchExperiment, Vec<Wanted>)> {
    if let Some(key) = &spec.expect {
        let help = "write [method.expect] below the [[method]] it belongs to";
        check.report(
            Diagnostic::at(
                Fault::Conflict,
                key.span(),
                "[expect] stands beside methods",
                "expected by which method?",
            )
            .help(help),
        );
    }
    let search = match &spec.search {
        Some(key) => search(check, key),
        None => Some(Search::default()),
    };
    let sides = match &spec.boundary {
        Some(key) => boundary(check, key),
        None => {
            if spec.method.is_some() {
                check.missing(
                    root,
                    "[boundary]",
                    "the methods need a boundary: give u0, u1, v0, v1, or ab, bc, ca",
                );
            } else {
                nothing(check, root);
            }
            Sides { kind: None, header: 0..0, boundary: None }
        }
    };
    let example =
        "add a table [[method]] with name = \"…\", basis = \"bernstein\" and energy = \"dirichlet\"";
    let methods = match &spec.method {
        Some(key) if key.get_ref().is_empty() => {
            check.inadmissible(key.span(), "the list of methods is empty", "no method", example);
            None
        }
        Some(key) => methods(check, key, &sides),
        None => {
            if spec.boundary.is_some() && !check.was_removed(&top("method")) {
                let table = check.table("the experiment", sides.header.clone(), &top("method"));
                check.missing(&table, "[[method]]", example);
            }
            None
        }
    };
    let (boundary, search) = (sides.boundary?, search?);
    let (methods, wanted) = methods?.into_iter().unzip();
    Some((PatchExperiment { boundary, methods, search }, wanted))
}
