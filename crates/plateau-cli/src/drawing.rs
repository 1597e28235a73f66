//! `draw`: pictures that need no experiment.

use std::f64::consts::{PI, TAU};
use std::io::Write;

use plateau::CurveBasis;
use record::Destination;

use crate::command::{BasisArguments, Drawing, Failure, FamilyName, say};

/// Draws to the file that was asked for, or to stdout.
pub(crate) fn draw(drawing: &Drawing, stdout: &mut impl Write) -> Result<(), Failure> {
    let Drawing::Basis(arguments) = drawing;
    let refuse = |why: String| {
        say(&format!("error: {why}"));
        Failure::Input
    };
    let bases = bases(arguments).map_err(|why| refuse(why.into()))?;
    let picture =
        show::basis_functions(&bases, arguments.degree.into()).map_err(|error| refuse(error.to_string()))?;
    let Some(path) = &arguments.out else { return Ok(stdout.write_all(picture.as_bytes())?) };
    let cannot =
        |error: &dyn std::fmt::Display| refuse(format!("{} cannot be written: {error}", path.display()));
    let to = Destination::named(path).map_err(|error| cannot(&error))?;
    record::write_text(&picture, &to).map_err(|error| {
        say(&format!("error: {error}"));
        Failure::Result
    })
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
