//! `draw`: pictures that need no experiment.

use std::f64::consts::{PI, TAU};
use std::fmt::Display;
use std::io::Write;
use std::path::Path;

use plateau::CurveBasis;
use record::Destination;

use crate::command::{
    BasisArguments, ConditioningArguments, ConstructionArguments, Drawing, RegionArguments,
};
use crate::failure::Failure;
use crate::terminal::say;
use crate::values::FamilyName;

/// Draws to the file that was asked for, or to stdout.
pub(crate) fn draw(drawing: &Drawing, stdout: &mut impl Write) -> Result<(), Failure> {
    let (picture, out) = match drawing {
        Drawing::Basis(arguments) => (basis(arguments), &arguments.out),
        Drawing::Construction(arguments) => (construction(arguments), &arguments.out),
        Drawing::Conditioning(arguments) => (conditioning(arguments), &arguments.out),
        Drawing::Region(arguments) => (region(arguments), &arguments.out),
    };
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

fn construction(arguments: &ConstructionArguments) -> Result<String, String> {
    let span = arguments.span.unwrap_or(1.25 * PI);
    let (gamma, beta) = (arguments.gamma.unwrap_or([TAU, 2.0 * TAU]), arguments.beta.unwrap_or([1.0, 1.0]));
    show::construction(span, gamma, beta).map_err(|error| error.to_string())
}

fn conditioning(arguments: &ConditioningArguments) -> Result<String, String> {
    show::conditioning(arguments.energy.0, arguments.degree.into()).map_err(|error| error.to_string())
}

fn region(arguments: &RegionArguments) -> Result<String, String> {
    let degrees: Vec<usize> = match arguments.degree.as_slice() {
        [] => vec![2, 3, 4, 6, 10],
        given => given.iter().map(|&degree| degree.into()).collect(),
    };
    show::nonnegativity_region(&degrees).map_err(|error| error.to_string())
}

fn basis(arguments: &BasisArguments) -> Result<String, String> {
    show::basis_functions(&bases(arguments)?, arguments.degree.into()).map_err(|error| error.to_string())
}

/// The bases that the arguments name, at least one.
fn bases(arguments: &BasisArguments) -> Result<Vec<CurveBasis>, &'static str> {
    let BasisArguments { family, shape, span, .. } = arguments;
    let spans = |default: f64| if span.is_empty() { vec![default] } else { span.clone() };
    match family {
        FamilyName::Bernstein | FamilyName::Gt if !span.is_empty() => {
            Err("--span is for aht and at; Bernstein and GT functions live on [0, 1]")
        }
        FamilyName::Bernstein | FamilyName::Aht | FamilyName::At if !shape.is_empty() => {
            Err("--shape is for gt; the other functions have no shape parameters")
        }
        FamilyName::Bernstein => Ok(vec![CurveBasis::Bernstein]),
        FamilyName::Gt if shape.is_empty() => Ok(vec![CurveBasis::Gt { shape: [1.0, 1.0] }]),
        FamilyName::Gt => Ok(shape.iter().map(|&shape| CurveBasis::Gt { shape }).collect()),
        FamilyName::Aht => Ok(spans(TAU).into_iter().map(|span| CurveBasis::Aht { span }).collect()),
        FamilyName::At => Ok(spans(PI).into_iter().map(|span| CurveBasis::At { span }).collect()),
    }
}
