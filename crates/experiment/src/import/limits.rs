//! How large a boundary may be: as large as an experiment has it.

use exchange::{Assembly, Form, Sentence, Setting};

use super::ImportError;
use crate::keys::boundary_curve::MOST_CORNERS;
use crate::keys::face::{MOST_CORNERS as MOST_OF_A_FACE, MOST_FACES};

/// Refuses boundaries of more than is offered before anything is computed.
///
/// # Errors
/// [`ImportError::TooMany`].
pub(super) fn check(assembly: &Assembly) -> Result<(), ImportError> {
    match &assembly.form {
        Form::Loops(loops) => match loops.iter().map(Vec::len).find(|count| *count > MOST_CORNERS) {
            Some(count) => Err(many("a loop", count, MOST_CORNERS)),
            None => Ok(()),
        },
        Form::Faces(faces) if faces.len() > MOST_FACES => {
            let why = format!(
                "the curves bound {} faces, and at most {MOST_FACES} are filled together: fill parts of them, each from a file of its own",
                faces.len()
            );
            Err(ImportError::TooMany(why.into()))
        }
        Form::Faces(faces) => match faces.iter().map(Vec::len).find(|count| *count > MOST_OF_A_FACE) {
            Some(count) => Err(many("a face", count, MOST_OF_A_FACE)),
            None => Ok(()),
        },
    }
}

fn many(whose: &str, count: usize, most: usize) -> ImportError {
    let why = format!(
        "{whose} has {count} sides between its corners, and at most {most} are filled: give fewer points; or, if they are samples of a smooth \
         curve, a larger "
    );
    let sentence = Sentence::from(why).setting(Setting::CornerAngle);
    let sentence = sentence.text(", above which a turn is a corner, and a ").setting(Setting::Tolerance);
    ImportError::TooMany(sentence.text(" within which the samples are met"))
}
