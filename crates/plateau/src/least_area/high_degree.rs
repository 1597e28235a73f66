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
/// `patch`. Not above `starts`.
pub(super) fn least_of_displaced(
    patch: &TensorPatch,
    lower: Option<Found>,
    mut starts: &[TensorPatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<Found, MethodError> {
    let (m, n) = patch.net().degrees();
    let largest = m.max(n);
    let first =
        lower.as_ref().and_then(|(_, found)| found.displacement).map_or(0, |d| d.degrees.0.max(d.degrees.1));
    let mut best = lower;
    let (mut gained, mut missing) = (0.0, None);
    for degree in Displacement::tried(largest).filter(|&degree| first < degree) {
        let degrees = (m.min(degree), n.min(degree));
        match (&best, memory::holds(memory::of_displacement(degrees))) {
            (_, Ok(())) => {}
            (Some(_), Err(MethodError::OutOfMemory { bytes })) => {
                missing = Some(bytes);
                break;
            }
            (_, Err(error)) => return Err(error),
        }
        let space = Displaced::new(patch, degrees)?;
        let near = best.as_ref().map(|(patch, _)| patch);
        let (next, mut found) = minimise(&space, near, std::mem::take(&mut starts), tolerance, progress)?;
        found.displacement =
            (degree < largest).then_some(Displacement { degrees, end: DisplacementEnd::Tolerance });
        let Some((before, lower)) = best else {
            best = Some((next, found));
            continue;
        };
        gained = (lower.area.value - found.area.value) / lower.area.value;
        let rounding = BEYOND_ROUNDING * space.rounding(&next);
        let end = if gained <= tolerance {
            Some(DisplacementEnd::Tolerance)
        } else if lower.area.settled && !found.area.settled {
            Some(DisplacementEnd::Folds)
        } else {
            (gained <= rounding).then_some(DisplacementEnd::Rounding { gained })
        };
        let iterations = lower.iterations + found.iterations;
        let evaluations = lower.evaluations + found.evaluations;
        if let Some(end) = end {
            let displacement = lower.displacement.map(|displacement| Displacement { end, ..displacement });
            return Ok((before, AreaExtremal { displacement, iterations, evaluations, ..lower }));
        }
        let (start, from, left_saddle) = (lower.start, lower.from, lower.left_saddle || found.left_saddle);
        best = Some((next, AreaExtremal { start, from, iterations, evaluations, left_saddle, ..found }));
    }
    let (patch, mut found) = best.expect("the lowest degree is below that of every net of high degree");
    if let Some(displacement) = &mut found.displacement {
        displacement.end = match missing {
            Some(bytes) => DisplacementEnd::OutOfMemory { bytes },
            None => DisplacementEnd::Largest { gained },
        };
    }
    Ok((patch, found))
}
