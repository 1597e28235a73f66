//! The degree of patches where none is asked for.

use surfaces::BoundaryCurve;

use crate::{CutBoundary, Cutting, CuttingError};

/// The degree of patches unless their curves need a higher one.
const USUAL: usize = 6;

/// The highest degree that curves are met exactly with, unless it is asked for.
const HIGHEST: usize = 14;

/// The degree of patches over some curves: 6, or that of the polynomial curves among them where it is higher, at most 14.
pub(super) fn usual<'a>(curves: impl Iterator<Item = &'a BoundaryCurve>) -> usize {
    let of = |curve: &BoundaryCurve| match curve {
        BoundaryCurve::Bezier(curve) => curve.degree(),
        BoundaryCurve::Spline(curve) if curve.weights().is_none() => curve.degree(),
        BoundaryCurve::Spline(_)
        | BoundaryCurve::Polyline(_)
        | BoundaryCurve::Through(_)
        | BoundaryCurve::Arc(_) => 1,
    };
    curves.map(of).fold(USUAL, usize::max).min(HIGHEST)
}

/// Edges of the rim above which a higher degree is tried: it may need fewer pieces.
const MANY_EDGES: usize = 12;

/// Edges that belong to one face.
pub(super) fn edges_of_rim(
    cutting: &Cutting,
    cut: impl Fn(&Cutting) -> Result<CutBoundary, CuttingError>,
) -> Result<usize, CuttingError> {
    Ok(cut(cutting)?.complex().edges().iter().filter(|edge| edge.uses().len() == 1).count())
}

/// The cutting with a degree raised by steps of 2, up to [`HIGHEST`], as long as the rim has many edges and that takes a
/// quarter of them away.
pub(super) fn raised(
    cutting: impl Fn(usize) -> Result<Cutting, CuttingError>,
    cut: impl Fn(&Cutting) -> Result<CutBoundary, CuttingError>,
    usual: usize,
) -> Result<Cutting, CuttingError> {
    let edges = |cutting: &Cutting| edges_of_rim(cutting, &cut);
    let mut best = cutting(usual)?;
    let mut count = edges(&best)?;
    for degree in (usual + 2..=HIGHEST).step_by(2) {
        if count <= MANY_EDGES {
            break;
        }
        let next = cutting(degree)?;
        let fewer = edges(&next)?;
        if 4 * fewer > 3 * count {
            break;
        }
        (best, count) = (next, fewer);
    }
    Ok(best)
}
