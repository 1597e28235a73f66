//! The command line: what may be typed, and the small steps behind `check`, `new` and `completions`.

use std::collections::HashMap;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use clap::builder::PossibleValue;
use clap::{CommandFactory, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use clap_mangen::Man;
use experiment::{Experiment, Plan, Refusal, Source, Template};
use record::{folder_key, folder_of};
use show::Printable;
use sweep::Asked;

use crate::costs::costs;

/// Patches of least energy and least area over a given boundary.
///
/// Control points of a boundary in, the best patch that spans them out, with figures that say how
/// good it is. Begin with `plateau new tensor > first.toml`.
#[derive(Debug, Parser)]
#[command(name = "plateau", version, arg_required_else_help = true, after_help = EXIT_STATUS)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_STATUS: &str = "Exit status: 0 done; 1 it ran, but an expected number was missed, a solve failed or a \
                           verified result differs; 2 bad usage or bad input; 130 interrupted.";

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run experiments: a table for each on stdout, and DIR/<file stem>/result.json; of a sweep, a folder for each cell
    Run(RunArguments),
    /// Check experiment files without running them
    Check {
        /// Experiment files (TOML); - for stdin
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
    },
    /// Make one table of the cells of a sweep, from the folders of all its shards
    Merge(MergeArguments),
    /// Compute results again from the experiments in them, and compare every number
    Verify(VerifyArguments),
    /// Reproduce the tables of the papers: every printed number beside ours
    Reproduce {
        /// Print the comparison as JSON instead of a table
        #[arg(long)]
        json: bool,
        /// No progress on stderr
        #[arg(long, short)]
        quiet: bool,
    },
    /// Write the surfaces of a result.json as files for other programs
    Export(ExportArguments),
    /// Fill the curves of files with the surface of least area, and write it
    Fill(FillArguments),
    /// Print an experiment over a boundary from a file of curves
    Import(ImportArguments),
    /// Print a commented experiment file to begin with
    New {
        /// The kind of experiment
        kind: Kind,
    },
    /// Draw what the papers draw of their functions, as SVG
    #[command(subcommand)]
    Draw(Drawing),
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page, for `man -l -`
    Man,
    /// Print the JSON Schema of experiment files, by which editors complete and explain keys
    Schema,
}

/// What `run` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct RunArguments {
    /// Experiment files (TOML); - for stdin
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// Folder of the results
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// Seed instead of the files' own, at most 2^63 - 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(..=i64::MAX as u64))]
    pub(crate) seed: Option<u64>,
    /// Threads to use; by default one per processor. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Of a sweep, only the cells of shard K of N; /N takes K from SLURM_ARRAY_TASK_ID or HQ_TASK_ID. Without it, a task of a Slurm
    /// array runs its share, everybody else all cells
    #[arg(long, value_name = "K/N")]
    pub(crate) shard: Option<Asked>,
    /// Go on after an interruption: experiments whose results are there are not run again, finished search runs are taken
    /// from checkpoints. The results are those of an undisturbed run. Cells of a sweep always go on
    #[arg(long)]
    pub(crate) resume: bool,
    /// Least time between two checkpoints of finished search runs, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 1.0, value_parser = seconds)]
    pub(crate) checkpoint_every: f64,
    /// Print each result.json on stdout instead of the table
    #[arg(long)]
    pub(crate) json: bool,
    /// No progress on stderr
    #[arg(long, short)]
    pub(crate) quiet: bool,
    /// Instructions of the search: portable ones give the same bits on every processor
    #[arg(long, value_name = "SET", default_value = "auto")]
    pub(crate) arithmetic: Arithmetic,
}

/// What `draw` draws.
#[derive(Debug, Subcommand)]
pub(crate) enum Drawing {
    /// The functions of a basis over their parameter; a panel for each shape or span. `plateau draw basis aht > aht.svg` is AHT Figure 2
    Basis(BasisArguments),
    /// The geometric construction of the net of a helicoid over a trapezium, AT Theorems 1 to 3; by default that of AT Figure 6
    Construction(ConstructionArguments),
}

/// What `draw construction` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct ConstructionArguments {
    /// Length of the interval of v, below 2π [default: 5π/4]
    #[arg(long, value_name = "S")]
    pub(crate) span: Option<f64>,
    /// Where the two sides begin, γ0,γ1 [default: 2π,4π]
    #[arg(long, value_name = "G0,G1", value_parser = pair, allow_negative_numbers = true)]
    pub(crate) gamma: Option<[f64; 2]>,
    /// Their slopes, β0,β1 [default: 1,1]
    #[arg(long, value_name = "B0,B1", value_parser = pair, allow_negative_numbers = true)]
    pub(crate) beta: Option<[f64; 2]>,
    /// The file to write; by default stdout
    #[arg(long, short, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

/// What `draw basis` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct BasisArguments {
    /// The family
    pub(crate) family: FamilyName,
    /// Degree of the Bernstein or GT functions; AHT and AT have six
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=plateau::MAX_DEGREE as i64))]
    pub(crate) degree: u16,
    /// Shape parameters θ1,θ2 of GT functions, each from 0 to 4; may be given several times [default: 1,1]
    #[arg(long, value_name = "T1,T2", value_parser = pair)]
    pub(crate) shape: Vec<[f64; 2]>,
    /// Length of the interval of AHT functions, below 7.853, or AT functions, below 2π; may be given several times [default: 2π of AHT, π of AT]
    #[arg(long, value_name = "S")]
    pub(crate) span: Vec<f64>,
    /// The file to write; by default stdout
    #[arg(long, short, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

/// A family of functions of one variable.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum FamilyName {
    Bernstein,
    Gt,
    Aht,
    At,
}

/// Two numbers with a comma between them.
fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| format!("{text:?} is not a number"));
    match text.split_once(',') {
        Some((first, second)) => Ok([number(first)?, number(second)?]),
        None => Err("two numbers are needed, as in 1,2".to_owned()),
    }
}

/// What `merge` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct MergeArguments {
    /// Folders that shards of one sweep were run into: DIR/<file stem> of `plateau run`
    #[arg(required = true, value_name = "DIR")]
    pub(crate) folders: Vec<PathBuf>,
    /// Folder of merged.csv, merged.json, plots.svg and index.html; by default the first DIR
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print merged.json on stdout instead of the table
    #[arg(long)]
    pub(crate) json: bool,
}

/// What `import` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct ImportArguments {
    /// A table of points (CSV), OBJ lines or curves, STEP, ASCII DXF; - for stdin
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Degree of the patches; of three or four sides, the degree of the curves that are fitted to their points
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=plateau::MAX_DEGREE as i64))]
    pub(crate) degree: Option<u16>,
    /// The points of three or four sides are control points, however many
    #[arg(long, conflicts_with = "degree")]
    pub(crate) control_points: bool,
    /// Turn in degrees above which a polyline has a corner
    #[arg(long, value_name = "DEG", default_value_t = exchange::AssemblyOptions::CORNER_ANGLE)]
    pub(crate) corner_angle: f64,
    /// How far curves may pass from samples (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T")]
    pub(crate) tolerance: Option<f64>,
    /// How far apart ends of curves may lie to be one point (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T")]
    pub(crate) weld: Option<f64>,
}

/// What `fill` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct FillArguments {
    /// Files of curves: OBJ lines or curves, a table of points (CSV), STEP, ASCII DXF; - for stdin
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// The file to write, by its extension: step, stp, glb, ply, obj, stl, vtu; toml for the experiment, json for its result. May be given several times
    #[arg(long, short, value_name = "OUT")]
    pub(crate) out: Vec<PathBuf>,
    /// Degree of the patches; by default 6, or that of the curves where it is higher
    #[arg(long, value_name = "P", value_parser = clap::value_parser!(u16).range(1..=plateau::MAX_DEGREE as i64))]
    pub(crate) degree: Option<u16>,
    /// Layers of smaller patches around corners where the surface is not smooth
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=1))]
    pub(crate) layers: u16,
    /// Raise the degree until the area is estimated to lie less than this share above the least; corners that hold it up get a layer
    #[arg(long, value_name = "SHARE", value_parser = accuracy)]
    pub(crate) accuracy: Option<f64>,
    /// Prove a lower bound of the area, where the rim bounds a graph over a plane
    #[arg(long)]
    pub(crate) bound: bool,
    /// Turn in degrees above which a polyline has a corner
    #[arg(long, value_name = "DEG", default_value_t = exchange::AssemblyOptions::CORNER_ANGLE)]
    pub(crate) corner_angle: f64,
    /// How far the rim may pass from samples (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T")]
    pub(crate) tolerance: Option<f64>,
    /// How far apart ends of curves may lie to be one point (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T")]
    pub(crate) weld: Option<f64>,
    /// Subdivisions of each side of a patch in meshes
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u16).range(1..=100))]
    pub(crate) mesh: u16,
}

/// What `verify` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct VerifyArguments {
    /// Files result.json of `plateau run`
    #[arg(required = true, value_name = "RESULT")]
    pub(crate) results: Vec<PathBuf>,
    /// Threads to use; by default one per processor. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Print the comparison as JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// No progress on stderr
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// What `export` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct ExportArguments {
    /// A result.json of `plateau run`
    #[arg(value_name = "RESULT")]
    pub(crate) result: PathBuf,
    /// The format of the files
    #[arg(long, value_name = "FORMAT")]
    pub(crate) format: FileFormat,
    /// The one method to write; by default all of them
    #[arg(long, value_name = "NAME")]
    pub(crate) method: Option<String>,
    /// Subdivisions of each side of a mesh
    #[arg(long, value_name = "N", default_value_t = 48, value_parser = clap::value_parser!(u16).range(2..=2000))]
    pub(crate) mesh: u16,
    /// STEP: largest distance between a fitted surface and the patch, as a share of the size
    #[arg(long, value_name = "T", default_value_t = exchange::DEFAULT_TOLERANCE, value_parser = share)]
    pub(crate) tolerance: f64,
    /// The file to write, for a single method; by default files beside the result, named after their methods
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

/// A time that is no more than a year.
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if (0.0..=3.2e7).contains(&seconds) => Ok(seconds),
        _ => Err("this is no number of seconds from 0 to 3.2e7".to_owned()),
    }
}

/// A share of the area.
fn accuracy(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if (1e-12..=1e-2).contains(&share) => Ok(share),
        Ok(share) => {
            Err(format!("{share} is not from 1e-12 to 1e-2: 1e-8 is a hundred millionth of the area"))
        }
        Err(_) => Err("this is not a number; 1e-8 is a hundred millionth of the area".to_owned()),
    }
}

/// A share of something: above 0, at most 1.
fn share(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        Ok(share) => Err(format!("{share} is not above 0 and at most 1: 1e-6 is a millionth of the size")),
        Err(_) => Err("this is not a number; 1e-6 is a millionth of the size".to_owned()),
    }
}

/// A file format by its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FileFormat(pub(crate) exchange::Format);

impl ValueEnum for FileFormat {
    fn value_variants<'a>() -> &'a [Self] {
        static FORMATS: [FileFormat; exchange::Format::ALL.len()] = {
            let mut formats = [FileFormat(exchange::Format::ALL[0]); exchange::Format::ALL.len()];
            let mut k = 0;
            while k < formats.len() {
                formats[k] = FileFormat(exchange::Format::ALL[k]);
                k += 1;
            }
            formats
        };
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()))
    }
}

/// Which instructions the search may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Arithmetic {
    /// The fastest this processor has
    Auto,
    /// None beyond the baseline
    Portable,
    /// Fused multiply-add; an error where the processor lacks it
    Fma,
}

impl From<Arithmetic> for plateau::Arithmetic {
    fn from(choice: Arithmetic) -> Self {
        match choice {
            Arithmetic::Auto => Self::Auto,
            Arithmetic::Portable => Self::Portable,
            Arithmetic::Fma => Self::Fma,
        }
    }
}

/// A template's name; `patch` is another word for `tensor`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind(pub(crate) Template);

impl ValueEnum for Kind {
    fn value_variants<'a>() -> &'a [Self] {
        static KINDS: [Kind; Template::ALL.len()] = {
            let mut kinds = [Kind(Template::Tensor); Template::ALL.len()];
            let mut k = 0;
            while k < kinds.len() {
                kinds[k] = Kind(Template::ALL[k]);
                k += 1;
            }
            kinds
        };
        &KINDS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let value = PossibleValue::new(self.0.name()).help(self.0.summary());
        Some(if self.0 == Template::Tensor { value.alias("patch") } else { value })
    }
}

/// Why a command ends with a status other than 0.
pub(crate) enum Failure {
    /// Bad usage or bad input, already told on stderr: status 2.
    Input,
    /// It ran, but something is not as it should be; already told on stderr: status 1.
    Result,
    /// Ctrl-C: what was done is written; status 130.
    Interrupted,
    /// The output could not be written.
    Output(io::Error),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// Every file, or every refusal on stderr.
pub(crate) fn read_sources(files: &[PathBuf]) -> Result<Vec<Source>, Failure> {
    let mut sources = Vec::new();
    for file in files {
        match read_source(file) {
            Ok(source) => sources.push(source),
            Err(refusal) => tell(&refusal),
        }
    }
    if sources.len() == files.len() { Ok(sources) } else { Err(Failure::Input) }
}

/// A file as an experiment or a sweep; `-` is stdin, whose results go to the folder `stdin`.
fn read_source(file: &Path) -> Result<Source, Refusal> {
    if file == Path::new("-") {
        Source::read_from("stdin", &mut io::stdin().lock())
    } else {
        Source::read(file)
    }
}

/// The threads that were asked for.
pub(crate) fn start_threads(threads: Option<u16>) -> Result<(), Failure> {
    let Some(threads) = threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global().map_err(|error| {
        say(&format!("error: {threads} threads cannot be started: {error}"));
        Failure::Input
    })
}

/// Two files whose results would lie in the same folder are bad usage.
pub(crate) fn distinct_stems(sources: &[Source], out: &Path) -> Result<(), Failure> {
    let mut first: HashMap<String, &Source> = HashMap::new();
    for source in sources {
        if let Some(other) = first.insert(folder_key(&source.stem()), source) {
            let [mine, theirs] = [source, other].map(|source| folder_of(&source.stem(), out));
            let but = if mine == theirs { "" } else { ", where a disk does not tell capitals apart" };
            say(&format!(
                "error: {} and {} would both write to {}{but}: rename one, or run them with different --out",
                other.file(),
                source.file(),
                theirs.display()
            ));
            return Err(Failure::Input);
        }
    }
    Ok(())
}

/// `check`: one line for each sound file on stdout.
pub(crate) fn check(files: &[PathBuf], stdout: &mut impl Write) -> Result<(), Failure> {
    let mut sound = true;
    for file in files {
        match read_source(file) {
            Ok(source) => {
                line(stdout, &format!("{}: sound, {}", source.file(), what_it_is(&source)))?;
                for cost in costs(&source) {
                    line(stdout, &format!("  {cost}"))?;
                }
            }
            Err(refusal) => {
                stdout.flush()?;
                tell(&refusal);
                sound = false;
            }
        }
    }
    if sound { Ok(()) } else { Err(Failure::Input) }
}

/// What a file asks for.
fn what_it_is(source: &Source) -> String {
    match source {
        Source::Experiment(plan) => subject(plan),
        Source::Sweep(sweep) => {
            let axes: Vec<String> = sweep
                .axes()
                .iter()
                .filter(|axis| axis.with().is_none())
                .map(|axis| format!("{} of {}", axis.settings().len(), axis.name()))
                .collect();
            format!("a sweep of {} cells ({})", sweep.cells(), axes.join(" × "))
        }
    }
}

/// `completions`.
pub(crate) fn completions(shell: Shell, stdout: &mut impl Write) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "plateau", &mut script);
    Ok(stdout.write_all(&script)?)
}

/// `man`: one page for the command and all its subcommands.
pub(crate) fn man(stdout: &mut impl Write) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    let mut page = Vec::new();
    let whole = Man::new(command.clone());
    whole.render_title(&mut page)?;
    whole.render_name_section(&mut page)?;
    whole.render_synopsis_section(&mut page)?;
    whole.render_description_section(&mut page)?;
    whole.render_options_section(&mut page)?;
    for subcommand in command.get_subcommands().filter(|subcommand| subcommand.get_name() != "help") {
        let mut section = Vec::new();
        let part = Man::new(subcommand.clone());
        part.render_description_section(&mut section)?;
        part.render_synopsis_section(&mut section)?;
        part.render_options_section(&mut section)?;
        writeln!(page, ".SH \"PLATEAU {}\"", subcommand.get_name().to_uppercase())?;
        page.extend(
            String::from_utf8_lossy(&section).replace(".SH DESCRIPTION\n", "").replace(".SH", ".SS").bytes(),
        );
    }
    writeln!(page, ".SH \"EXIT STATUS\"\n{}", EXIT_STATUS.trim_start_matches("Exit status: "))?;
    whole.render_version_section(&mut page)?;
    Ok(stdout.write_all(&page)?)
}

fn subject(plan: &Plan) -> String {
    let methods = |count: usize| if count == 1 { "1 method".to_owned() } else { format!("{count} methods") };
    match &plan.experiment {
        Experiment::Patch(patches) => methods(patches.methods.len()),
        Experiment::Film(film) => methods(film.methods.len()),
        Experiment::Helicoid(_) => "a helicoid".to_owned(),
        Experiment::TrapeziumHelicoid(_) => "a helicoid over a trapezium".to_owned(),
        Experiment::Net(_) => "a net of its own".to_owned(),
        Experiment::Curve(curves) => {
            let samples = curves.first().map_or(0, |curve| curve.samples.len());
            match curves.len() {
                1 => format!("a curve at {samples} samples"),
                count => format!("{count} curves at {samples} samples each"),
            }
        }
    }
}

/// A refusal on stderr, coloured only on a terminal that wants colours.
pub(crate) fn tell(refusal: &Refusal) {
    let wanted = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let report = refusal.render(wanted && io::stderr().is_terminal());
    let _ = writeln!(io::stderr().lock(), "{report}");
}

/// A line on stderr, whatever names it quotes; if stderr is closed there is nobody left to tell.
pub(crate) fn say(message: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", Printable(message));
}

/// A line on stdout, whatever names it quotes.
pub(crate) fn line(stdout: &mut impl Write, text: &str) -> io::Result<()> {
    writeln!(stdout, "{}", Printable(text))
}
