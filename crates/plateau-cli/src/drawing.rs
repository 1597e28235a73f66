//! `draw`: pictures that need no experiment.

use std::fmt::Display;
use std::io::Write;
use std::path::Path;

use plateau::CurveBasis;
use record::Destination;

use crate::command::{BasisArguments, Drawing};
use crate::failure::Failure;
use crate::terminal::say;

/// Draws to the file that was asked for, or to stdout.
pub(crate) fn draw(drawing: &Drawing, stdout: &mut impl Write) -> Result<(), Failure> {
    match drawing {
        Drawing::Basis(arguments) => {
            let BasisArguments { family, shape, span, .. } = arguments;
            let bases = CurveBasis::of_family(*family, shape, span);
            let picture = bases.and_then(|bases| show::basis_functions(&bases, arguments.degree.into()));
            deliver(picture, arguments.out.as_deref(), stdout)
        }
        Drawing::Construction(arguments) => {
            let (span, gamma, beta) = show::AT_FIGURE_6;
            let picture = show::construction(
                arguments.span.unwrap_or(span),
                arguments.gamma.unwrap_or(gamma),
                arguments.beta.unwrap_or(beta),
            );
            deliver(picture, arguments.out.as_deref(), stdout)
        }
        Drawing::Conditioning(arguments) => {
            let picture = show::conditioning(arguments.energy, arguments.degree.into());
            deliver(picture, arguments.out.as_deref(), stdout)
        }
        Drawing::Region(arguments) => {
            let degrees: Vec<usize> = arguments.degree.iter().map(|&degree| degree.into()).collect();
            deliver(show::nonnegativity_region(&degrees), arguments.out.as_deref(), stdout)
        }
    }
}

fn deliver(
    picture: Result<String, impl Display>,
    out: Option<&Path>,
    stdout: &mut impl Write,
) -> Result<(), Failure> {
    let picture = picture.map_err(|why| refused(&why))?;
    match out {
        None => Ok(stdout.write_all(picture.as_bytes())?),
        Some(path) => write(&picture, path),
    }
}

fn write(picture: &str, path: &Path) -> Result<(), Failure> {
    let to = Destination::named(path)
        .map_err(|error| refused(&format_args!("{} cannot be written: {error}", path.display())))?;
    record::write_text(picture, &to).map_err(|error| {
        say(&format!("error: {error}"));
        Failure::Result
    })
}

fn refused(why: &dyn Display) -> Failure {
    say(&format!("error: {why}"));
    Failure::Input
}
