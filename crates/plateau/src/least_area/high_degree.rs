//! Least areas of high degree, by displacements of rising degrees.
//!
//! A displacement of degree n that hardly shows has control points 2ⁿ times as large: from some degree on they are no more than rounding. So the Coons
//! patch of the border, which has its degrees, is displaced by lower ones, and by higher ones as long as these gain.

use surfaces::TensorPatch;

use super::displaced::Displaced;
use super::displacement::{Displacement, DisplacementEnd};
use super::tensor::is_polynomial;
use super::{AreaExtremal, minimise};
use crate::{MethodError, Progress, memory};

/// Times the rounding of its control points that a displacement must gain to be taken.
const BEYOND_ROUNDING: f64 = 16.0;

/// A patch, and what is known of it.
type Found = (TensorPatch, AreaExtremal);

/// Whether the net of a patch is sought by displacements: it is of polynomials of high degree.
pub(super) fn is_of_high_degree(patch: &TensorPatch) -> Result<bool, MethodError> {
    let (m, n) = patch.net().degrees();
    Ok(m.max(n) > Displacement::WHOLE && is_polynomial(patch)?)
}

/// The patch of least area over the border of `patch`, of high degree, with displacements from `lower` on, a surface of lower degrees in those of
/// `patch`. The first of them begins at the best of `starts`, where that is better than its own start.
pub(super) fn least_of_displaced(
    patch: &TensorPatch,
    lower: Option<Found>,
    mut starts: &[TensorPatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<Found, MethodError> {
    let (m, n) = patch.net().degrees();
    let known =
        lower.as_ref().and_then(|(_, found)| found.displacement).map_or(0, |d| d.degrees.0.max(d.degrees.1));
    let mut tried = Displacement::tried(m.max(n)).filter(|&degree| known < degree);
    let mut sought = |degree: usize, near: Option<&TensorPatch>| {
        sought(patch, degree, (near, std::mem::take(&mut starts)), tolerance, progress)
    };
    let mut best = match lower {
        Some(lower) => lower,
        None => sought(tried.next().unwrap_or(m.max(n)), None)?.0,
    };
    let mut gained = 0.0;
    for degree in tried {
        let ((next, found), rounding) = match sought(degree, Some(&best.0)) {
            // What was found stays.
            Err(MethodError::OutOfMemory { bytes }) => {
                return Ok(ended(best, DisplacementEnd::OutOfMemory { bytes }));
            }
            sought => sought?,
        };
        let (before, lower) = best;
        gained = (lower.area.value - found.area.value) / lower.area.value;
        let iterations = lower.iterations + found.iterations;
        let evaluations = lower.evaluations + found.evaluations;
        let end = if gained <= tolerance {
            Some(DisplacementEnd::Tolerance)
        } else if lower.area.settled && !found.area.settled {
            Some(DisplacementEnd::Folds)
        } else {
            (gained <= BEYOND_ROUNDING * rounding).then_some(DisplacementEnd::Rounding { gained })
        };
        if let Some(end) = end {
            return Ok(ended((before, AreaExtremal { iterations, evaluations, ..lower }), end));
        }
        let (start, from, left_saddle) = (lower.start, lower.from, lower.left_saddle || found.left_saddle);
        best = (next, AreaExtremal { start, from, iterations, evaluations, left_saddle, ..found });
    }
    Ok(ended(best, DisplacementEnd::Largest { gained }))
}

/// The patch of least area among displacements of a degree, `near` a surface if there is one, and how far rounding of its control points moves it, as
/// a share of its size.
fn sought(
    patch: &TensorPatch,
    degree: usize,
    (near, starts): (Option<&TensorPatch>, &[TensorPatch]),
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(Found, f64), MethodError> {
    let (m, n) = patch.net().degrees();
    let degrees = (m.min(degree), n.min(degree));
    memory::holds(memory::of_displacement(degrees))?;
    let space = Displaced::new(patch, degrees)?;
    let (least, found) = minimise(&space, near, starts, tolerance, progress)?;
    let displacement = Displacement { degrees, end: DisplacementEnd::Tolerance };
    let displacement = (degree < m.max(n)).then_some(displacement);
    let rounding = space.rounding(&least);
    Ok(((least, AreaExtremal { displacement, ..found }), rounding))
}

/// What was found, with why its displacement has no higher degree, if it has a lower one than the net.
fn ended((patch, found): Found, end: DisplacementEnd) -> Found {
    let displacement = found.displacement.map(|displacement| Displacement { end, ..displacement });
    (patch, AreaExtremal { displacement, ..found })
}
