//! Two loops.

use super::blueprint::Blueprint;
use super::rim::Rim;
use super::{Cutting, CuttingError, Loop, Quads, Way};

pub(super) fn cut(first: &Loop, second: &Loop, cutting: &Cutting) -> Result<Quads, CuttingError> {
    match cutting.way {
        None | Some(Way::Annulus) => {}
        Some(Way::Grid | Way::Midpoint | Way::Ring | Way::TurnedRing | Way::Parts | Way::Faces) => {
            return Err(CuttingError::Unsuitable {
                asked: "cutting a disc or faces",
                needs: "one loop or a graph",
            });
        }
    }
    let [first, second] = [Rim::uncrossed(first, cutting)?, Rim::uncrossed(second, cutting)?];
    let corners = first.corner_vertices().len() + second.corner_vertices().len();
    // Two edges between the same vertices are one: at least three pieces a loop.
    let count = first.len().max(second.len()).max(4);
    let (first, second) = (first.with_at_least(count), second.with_at_least(count));
    let second = matched(&first, second);
    let deviation = first.deviation.and(second.deviation);
    let mut blueprint = Blueprint::default();
    let outer = blueprint.ring(&first.pieces, |k| format!("a{k}"));
    let inner = blueprint.ring(&second.pieces, |k| format!("b{k}"));
    for k in 0..count {
        let next = (k + 1) % count;
        blueprint.faces.push([outer[k], outer[next], inner[next], inner[k]]);
    }
    Ok(Quads { blueprint, way: Way::Annulus, corners, deviation })
}

/// The second ring from the vertex and in the direction with the least sum of squared distances of its vertices from those
/// of the first; the first such, its own direction before the other.
fn matched(first: &Rim, second: Rim) -> Rim {
    let apart = |ring: &Rim| -> f64 {
        let squared = |k: usize| (first.pieces[k].start() - ring.pieces[k].start()).norm().powi(2);
        (0..first.len()).map(squared).sum()
    };
    let mut best = (apart(&second), second.clone());
    for direction in [second.clone(), second.reversed()] {
        for start in 0..first.len() {
            let turned = direction.clone().begun_at(start);
            let apart = apart(&turned);
            // Symmetric frames have several that are equal but for rounding.
            if apart < best.0 * (1.0 - 1e-12) {
                best = (apart, turned);
            }
        }
    }
    best.1
}
