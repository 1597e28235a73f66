//! Boundaries from files: curves in, a ready experiment out.

use exchange::{Assembly, AssemblyError, Sentence, read_curves};
use plateau::{Fill, MAX_DEGREE};

use crate::Plan;

mod control;
mod error;
mod filling;
mod limits;
mod nearness;
mod options;
mod printed;
mod sides;

pub use error::{CornerGap, ImportError};
pub use filling::Filling;
pub use options::ImportOptions;

use sides::Sides;

/// Largest size in bytes of a file that is imported.
pub const MAX_IMPORT_SIZE: u64 = 16 * 1024 * 1024;

/// Reads the boundary in a file (`bytes`; `name` is that of the file or `-`) and prints an experiment over it.
///
/// It is a boundary of loops or faces over curves, polylines between corners being samples to be met within the tolerance, and its method
/// the least area: what [`plateau::Fill`] fills. Three or four curves of points under the names of sides of experiments are control
/// points, and become the sides of a triangular or a tensor boundary. So do others that form a loop where something is said of their
/// points: with a degree they are samples, and each side is the Bernstein curve of that degree nearest to them in the sense of
/// least squares, its ends on theirs; how near is said in comments. Straight sides are straight whatever the degree.
///
/// # Errors
/// [`ImportError`]; the file itself is not named in it.
pub fn import(bytes: &[u8], name: &str, options: &ImportOptions) -> Result<String, ImportError> {
    options.check()?;
    if options.degree.is_some() && options.control_points {
        let why = "--degree says that the points are on the curves, --control-points that they are not: give one of them";
        return Err(ImportError::Option(why.into()));
    }
    let mut file = read_curves(bytes, name)?;
    if options.control_points {
        file = file.parted();
    }
    if !options.says_what_points_are() && sides::names(&file).is_some() {
        control::ask(&file, MAX_DEGREE)?;
    }
    let (title, output) = (title(name), printed::output(file.unit));
    let said = |more: &[Sentence]| -> Vec<String> {
        file.notes.iter().chain(more).map(Sentence::to_string).collect()
    };
    let apart = match Sides::of_file(&file, options) {
        Ok(Some(sides)) => return checked(sides.printed(&title, &said(&[])) + &output),
        Ok(None) => None,
        // Under names of their own they may be two loops, or branch.
        Err(ImportError::Corner(apart)) if !apart.named => Some(ImportError::Corner(apart)),
        Err(error) => return Err(error),
    };
    let (curves, _) = control::taken(file.clone(), options)?;
    let assembly = Assembly::new(&curves, &options.assembly).map_err(|error| match (error, apart) {
        (AssemblyError::Gap(why), _) => ImportError::Assembly(AssemblyError::Gap(why)),
        (_, Some(apart)) => apart,
        (error, None) => error.into(),
    })?;
    let notes = said(&assembly.notes);
    match Sides::of_assembly(&assembly, options)? {
        Some(sides) => checked(sides.printed(&title, &notes) + &output),
        None => {
            limits::check(&assembly)?;
            let fill =
                options.degree.map_or_else(Fill::default, |degree| Fill::default().with_degree(degree));
            checked(printed::assembly(&title, &assembly, options, &fill, &notes) + &output)
        }
    }
}

/// What a file is called without its folder and ending.
fn title(name: &str) -> String {
    let stem = std::path::Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| stem != "-").unwrap_or_else(|| "boundary".into())
}

/// The text of an experiment, if it is sound.
fn checked(text: String) -> Result<String, ImportError> {
    match Plan::parse("imported.toml", &text) {
        Ok(_) => Ok(text),
        Err(refusal) => Err(ImportError::Plan(
            refusal.diagnostics().iter().map(|fault| fault.message()).collect::<Vec<_>>().join("; "),
        )),
    }
}
