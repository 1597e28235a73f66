//! What a surface is above the least area of its boundary, where that is estimated unasked.

use surfaces::Complex;

use crate::{
    AreaEstimate, AreaExtremal, Family, MethodError, NoEstimate, Progress, Surface, Warning, costs_less,
    estimate_complex, estimate_net, estimate_triangle, excess_of_complex, excess_of_net, excess_of_triangle,
    memory, odd_corners,
};

/// Degree above which what a surface lacks is not looked for unasked.
const MOST: usize = 20;

/// The estimate for a surface: of least areas from those of the next degrees, where that costs less than the surface did; of all others by
/// what Newton's method promises. Why there is none, is said of least areas alone.
pub(crate) fn estimated(
    (surface, family, area): (&Surface, Family, Option<&AreaExtremal>),
    warnings: &mut Vec<Warning>,
    progress: &dyn Progress,
) -> Result<Option<f64>, MethodError> {
    // What is sought inside decides what it costs.
    let sought = area.and_then(|found| found.displacement);
    let (m, n) = sought.map_or(surface.degrees(), |displacement| displacement.degrees);
    let (faces, at_corners) = match surface {
        Surface::Complex(complex) => cells(complex),
        Surface::Tensor(patch) if family == Family::Bernstein => cells(&Complex::of_net(patch.net())?),
        Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_) => (1, 0),
    };
    match area {
        Some(found) if costs_less(m.max(n), faces, at_corners, found) => {
            if let Err(MethodError::OutOfMemory { bytes }) =
                memory::holds(memory::of_estimate(m.max(n), faces, at_corners))
            {
                warnings.push(Warning::NoEstimate(NoEstimate::OutOfMemory { bytes }));
                return Ok(None);
            }
            let estimate = of_least_area((surface, family), found, progress)?;
            Ok(estimate.and_then(|estimate| told(estimate, warnings)))
        }
        Some(_) => Ok(None),
        None if m.max(n) > MOST => Ok(None),
        // Surfaces that are none to a Newton step are no failure of the method.
        None => Ok(of_any(surface, family).ok().flatten()),
    }
}

/// The faces of a complex once none has two odd corners, and how many of them have one.
fn cells(complex: &Complex) -> (usize, usize) {
    let corners = odd_corners(complex);
    let of_face = |face: &surfaces::Face| face.vertices().iter().filter(|v| corners.contains(v)).count();
    let counts: Vec<usize> = complex.faces().iter().map(of_face).collect();
    let cut = counts.iter().filter(|count| **count > 1).map(|count| if *count > 2 { 3 } else { 1 });
    (complex.faces().len() + cut.sum::<usize>(), counts.iter().sum())
}

/// An estimate, if it was made; else it is told why not.
pub(crate) fn told(estimate: AreaEstimate, warnings: &mut Vec<Warning>) -> Option<f64> {
    match estimate {
        Ok(estimate) => Some(estimate),
        // That it was not reached is said as such.
        Err(NoEstimate::NotReached) => None,
        Err(why) => {
            warnings.push(Warning::NoEstimate(why));
            None
        }
    }
}

fn of_least_area(
    (surface, family): (&Surface, Family),
    found: &AreaExtremal,
    progress: &dyn Progress,
) -> Result<Option<AreaEstimate>, MethodError> {
    Ok(match surface {
        Surface::Tensor(patch) if family == Family::Bernstein => {
            Some(estimate_net(patch.net(), found, progress)?)
        }
        Surface::Triangle(patch) => Some(estimate_triangle(patch.net(), found, progress)?),
        Surface::Complex(complex) => Some(estimate_complex(complex, found, progress)?),
        // Functions of a shape are not among those of a higher degree.
        Surface::Tensor(_) | Surface::Pieces(_) => None,
    })
}

fn of_any(surface: &Surface, family: Family) -> Result<Option<f64>, MethodError> {
    match surface {
        Surface::Tensor(patch) if family == Family::Bernstein => excess_of_net(patch.net()),
        Surface::Triangle(patch) => excess_of_triangle(patch.net()),
        Surface::Complex(complex) => excess_of_complex(complex),
        Surface::Tensor(_) | Surface::Pieces(_) => Ok(None),
    }
}
