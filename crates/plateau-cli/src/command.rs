//! The command line: what may be typed.

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use clap_complete::Shell;
use exchange::{Format, LengthUnit};
use experiment::Template;
use plateau::{BasisFamily, DegreeLimit, Functional};
use sweep::Asked;

use crate::values::{Arithmetic, accuracy, energy, format, one_of, pair, seconds, share, template};

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

pub(crate) const EXIT_STATUS: &str = "Exit status: 0 done; 1 it ran, but an expected number was missed, a solve failed or a \
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
        #[arg(value_parser = template())]
        kind: Template,
    },
    /// Draw what there is to see of the papers' functions, as SVG
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
    /// The condition number of the matrix of extremals in the GT basis over its shapes: a map of two slices, and how it grows with the degree
    Conditioning(ConditioningArguments),
    /// The shapes for which the GT functions of a degree are nonnegative
    Region(RegionArguments),
}

/// What `draw conditioning` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct ConditioningArguments {
    /// Degree of the net in both directions
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(3..=plateau::Conditioning::MAX_DEGREE as i64))]
    pub(crate) degree: u16,
    /// The energy of the extremals
    #[arg(long, value_name = "ENERGY", default_value = Functional::Dirichlet.name(), value_parser = energy())]
    pub(crate) energy: Functional,
    /// The file to write; by default stdout
    #[arg(long, short, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

/// What `draw region` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct RegionArguments {
    /// Degree of the functions; may be given several times
    #[arg(long, value_name = "N", default_values_t = show::REGION_DEGREES)]
    pub(crate) degree: Vec<u16>,
    /// The file to write; by default stdout
    #[arg(long, short, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
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
    #[arg(value_parser = one_of(BasisFamily::NAMES))]
    pub(crate) family: BasisFamily,
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
    /// The points of polylines are control points of Bézier curves, however many; those of sides u0, u1, v0, v1 or ab, bc, ca are without it
    #[arg(long, conflicts_with = "degree")]
    pub(crate) control_points: bool,
    /// Turn in degrees above which a polyline has a corner
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, default_value_t = exchange::AssemblyOptions::CORNER_ANGLE)]
    pub(crate) corner_angle: f64,
    /// How far curves may pass from samples (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// How far apart ends of curves may lie to be one point (a length); by default 1e-4 of the size, at most a quarter of the shortest edge there
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub(crate) weld: Option<f64>,
}

/// What `fill` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct FillArguments {
    /// Files of curves: OBJ lines or curves, a table of points (CSV), STEP, ASCII DXF; - for stdin
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// The file to write, by its extension: step, stp, glb, ply, obj, stl, vtu, bezier.vtu; toml for the experiment, json for its result, html for its page. May be given several times
    #[arg(long, short, value_name = "OUT")]
    pub(crate) out: Vec<PathBuf>,
    /// Degree of the patches, at most 24; by default 6, or that of the curves where it is higher
    #[arg(long, value_name = "P", value_parser = clap::value_parser!(u16).range(1..=DegreeLimit::Patches.degree() as i64))]
    pub(crate) degree: Option<u16>,
    /// The points of polylines are control points of Bézier curves, however many; those of sides u0, u1, v0, v1 or ab, bc, ca are, unless --degree is given
    #[arg(long)]
    pub(crate) control_points: bool,
    /// Layers of smaller patches around corners where the surface is not smooth: 0 or 1
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=1))]
    pub(crate) layers: u16,
    /// Raise the degree until the area is estimated to lie less than this share above the least; corners that hold it up get a layer. How near the rim is to samples is said by --tolerance
    #[arg(long, value_name = "SHARE", value_parser = accuracy)]
    pub(crate) accuracy: Option<f64>,
    /// Prove a lower bound of the area, where the rim bounds a graph over a plane
    #[arg(long)]
    pub(crate) bound: bool,
    /// Turn in degrees above which a polyline has a corner
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, default_value_t = exchange::AssemblyOptions::CORNER_ANGLE)]
    pub(crate) corner_angle: f64,
    /// How far the rim may pass from samples (a length); by default 1e-4 of the size
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// How far apart ends of curves may lie to be one point (a length); by default 1e-4 of the size, at most a quarter of the shortest edge there
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub(crate) weld: Option<f64>,
    /// What the numbers are: STEP files say so, GLB is scaled to its metres; by default what the files say, else CAD programs take them for millimetres
    #[arg(long, value_name = "UNIT", value_parser = one_of(LengthUnit::NAMED))]
    pub(crate) unit: Option<LengthUnit>,
    /// Subdivisions of each side of a patch in meshes
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u16).range(1..=100))]
    pub(crate) mesh: u16,
    /// No progress on stderr
    #[arg(long, short)]
    pub(crate) quiet: bool,
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
    #[arg(long, value_name = "FORMAT", value_parser = format())]
    pub(crate) format: Format,
    /// The one method to write; by default all of them
    #[arg(long, value_name = "NAME")]
    pub(crate) method: Option<String>,
    /// Subdivisions of each side of a mesh
    #[arg(long, value_name = "N", default_value_t = 48, value_parser = clap::value_parser!(u16).range(2..=2000))]
    pub(crate) mesh: u16,
    /// step, vtu-bezier: largest distance between a fitted surface and the patch, as a share of the size
    #[arg(long, value_name = "T", default_value_t = exchange::DEFAULT_TOLERANCE, value_parser = share)]
    pub(crate) tolerance: f64,
    /// What the numbers are: STEP files say so, GLB is scaled to its metres; by default what the experiment of the result says, else CAD programs take them for millimetres
    #[arg(long, value_name = "UNIT", value_parser = one_of(LengthUnit::NAMED))]
    pub(crate) unit: Option<LengthUnit>,
    /// The file to write, for a single method; by default files beside the result, named after their methods, and after a result that is not called result.json
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}
