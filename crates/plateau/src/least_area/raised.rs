//! Least areas of one border at one degree after the other.

use surfaces::{Net, TensorPatch, TriangleNet, TrianglePatch};

use super::displacement::{Displacement, DisplacementEnd};
use super::high_degree::least_of_displaced;
use super::tensor::Separated;
use super::triangle::Triangular;
use super::{AreaExtremal, minimise};
use crate::{MethodError, Progress};

/// Raisings one by one, after which each is larger by a quarter.
const ONE_BY_ONE: usize = 6;

/// The raisings solved on the way to `raise`, which is the last: the same first ones for every raise.
fn levels(raise: usize) -> Vec<usize> {
    let mut levels = vec![0];
    let mut next = 1;
    while next < raise {
        levels.push(next);
        next += if next < ONE_BY_ONE { 1 } else { next / 4 + 1 };
    }
    if raise > 0 {
        levels.push(raise);
    }
    levels
}

/// The Bernstein–Bézier patch of least area on the border of `net` with its degrees raised by `raise`. Every raising on the way
/// is solved from the one before, which it holds: raising does not enlarge the area. Beyond degree 16 what is inside is sought as displacements of
/// lower degrees ([`Displacement`]). `starts` are nets of the raised degrees
/// at hand.
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn least_area_raised(
    net: &Net,
    raise: usize,
    starts: &[TensorPatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TensorPatch, AreaExtremal), MethodError> {
    let solve = |lower: Option<&(usize, TensorPatch)>, level: usize| {
        let patch = TensorPatch::bernstein(net.raised(level))?;
        let lower =
            lower.map(|(at, lower)| TensorPatch::bernstein(lower.net().raised(level - at))).transpose()?;
        let starts = if level == raise { starts } else { &[] };
        minimise(&Separated::new(&patch, &patch.products()[0])?, lower.as_ref(), starts, tolerance, progress)
    };
    let (m, n) = net.degrees();
    let given = m.max(n);
    if given + raise <= Displacement::WHOLE {
        return one_after_the_other(raise, solve);
    }
    let patch = TensorPatch::bernstein(net.raised(raise))?;
    if given > Displacement::WHOLE {
        return least_of_displaced(&patch, None, starts, tolerance, progress);
    }
    let level = Displacement::LOWEST.saturating_sub(given);
    let (lower, found) = one_after_the_other(level, solve)?;
    let displacement = Displacement { degrees: lower.net().degrees(), end: DisplacementEnd::Tolerance };
    let found = AreaExtremal { displacement: Some(displacement), ..found };
    let patch_of_lower = TensorPatch::bernstein(lower.net().raised(raise - level))?;
    least_of_displaced(&patch, Some((patch_of_lower, found)), starts, tolerance, progress)
}

/// The triangular patch of least area on the border of `net` with its degree raised by `raise`: as [`least_area_raised`].
///
/// # Errors
/// As [`least_area`](super::least_area).
pub fn least_area_triangle_raised(
    net: &TriangleNet,
    raise: usize,
    starts: &[TrianglePatch],
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<(TrianglePatch, AreaExtremal), MethodError> {
    let solve = |lower: Option<&(usize, TrianglePatch)>, level: usize| {
        let space = Triangular::new(&net.raised(level)?)?;
        let lower = lower
            .map(|(at, lower)| Ok::<_, MethodError>(TrianglePatch::new(lower.net().raised(level - at)?)?))
            .transpose()?;
        let starts = if level == raise { starts } else { &[] };
        minimise(&space, lower.as_ref(), starts, tolerance, progress)
    };
    one_after_the_other(raise, solve)
}

fn one_after_the_other<P>(
    raise: usize,
    solve: impl Fn(Option<&(usize, P)>, usize) -> Result<(P, AreaExtremal), MethodError>,
) -> Result<(P, AreaExtremal), MethodError> {
    let (patch, mut found) = solve(None, 0)?;
    let mut lower = (0, patch);
    for &level in levels(raise).iter().skip(1) {
        let (patch, next) = solve(Some(&lower), level)?;
        found = AreaExtremal {
            start: found.start,
            from: found.from,
            iterations: found.iterations + next.iterations,
            evaluations: found.evaluations + next.evaluations,
            left_saddle: found.left_saddle || next.left_saddle,
            ..next
        };
        lower = (level, patch);
    }
    Ok((lower.1, found))
}
