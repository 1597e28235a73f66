//! Slender quads cut across.

use surfaces::{Complex, ComplexError, Face};

use super::CuttingError;
use super::blueprint::Blueprint;
use super::rim::length;

/// A quad longer than this many times its width is cut across, into four.
const SLENDER: f64 = 4.0;

/// One that is longer than this is no quad: the boundary runs back along itself there, and cutting across helps nothing.
const DEGENERATE: f64 = 1e4;

/// Times as many quads as there were, and that many more, beyond which nothing is cut.
const MOST_TIMES: usize = 4;
const MOST_MORE: usize = 40;

/// Cuts slender quads, with the strips across which they lie, and makes the complex.
pub(super) fn cut_across(blueprint: &mut Blueprint, degree: usize) -> Result<Complex, CuttingError> {
    let mut complex = blueprint.complex(degree)?;
    let most = MOST_TIMES * blueprint.faces.len() + MOST_MORE;
    while let Some([a, b]) = slenderest(&complex) {
        let before = blueprint.clone();
        // In two, then both halves.
        let Some(middle) = blueprint.halve_strip(a, b) else { break };
        blueprint.halve_strip(a, middle);
        blueprint.halve_strip(middle, b);
        if blueprint.faces.len() > most {
            *blueprint = before;
            break;
        }
        complex = blueprint.complex(degree)?;
    }
    Ok(complex)
}

/// The complex with every slender face cut across in halves until none is slender.
///
/// # Errors
/// [`ComplexError::TooLarge`](surfaces::ComplexError::TooLarge).
pub(crate) fn cut_slender(complex: &Complex) -> Result<Complex, ComplexError> {
    let most = MOST_TIMES * complex.faces().len() + MOST_MORE;
    let mut cut = complex.clone();
    while cut.faces().len() < most {
        let slender: Vec<usize> = slender(&cut).map(|(_, edge)| edge).collect();
        if slender.is_empty() {
            break;
        }
        cut = cut.halved_across(&slender)?;
    }
    Ok(cut)
}

/// The largest ratio of length to width of the slender faces; none where no face is slender.
pub(crate) fn slenderness(complex: &Complex) -> Option<f64> {
    slender(complex).map(|(ratio, _)| ratio).reduce(f64::max)
}

/// The vertices of a long side of the face with the largest ratio of length to width, if that is slender.
fn slenderest(complex: &Complex) -> Option<[usize; 2]> {
    let larger = |a: (f64, usize), b: (f64, usize)| if b.0 > a.0 { b } else { a };
    slender(complex).reduce(larger).map(|(_, edge)| complex.edges()[edge].ends())
}

/// Of every slender face the ratio of length to width, and a long side.
fn slender(complex: &Complex) -> impl Iterator<Item = (f64, usize)> + '_ {
    let edges = 0..complex.edges().len();
    let lengths: Vec<f64> = edges.map(|edge| length(&complex.edge_curve(edge))).collect();
    let of_face = move |face: &Face| {
        let [v0, u1, v1, u0] = face.edges();
        let (along, across) = (lengths[v0] + lengths[v1], lengths[u0] + lengths[u1]);
        if along > across { (along / across, v0) } else { (across / along, u1) }
    };
    complex.faces().iter().map(of_face).filter(|(ratio, _)| *ratio > SLENDER && *ratio < DEGENERATE)
}
