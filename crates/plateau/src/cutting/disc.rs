//! One loop.

use super::blueprint::Blueprint;
use super::polygon::Cut;
use super::rim::Rim;
use super::{Cutting, CuttingError, Loop, Quads, Way, parts};

/// Most pieces of a side of a grid or of midpoint subdivision that is chosen, not asked for: the number of quads grows with
/// its square, that of a ring in proportion.
const MOST_PIECES: usize = 4;

pub(super) fn cut(around: &Loop, cutting: &Cutting) -> Result<Quads, CuttingError> {
    let rim = Rim::uncrossed(around, cutting)?;
    let corners = rim.corner_vertices();
    // A way that was asked for is refused with what it needs rather than replaced by another.
    let way = cutting.way.unwrap_or_else(|| chosen(&rim, &corners));
    if way == Way::Parts {
        return parts::cut(rim, cutting);
    }
    let (deviation, count) = (rim.deviation, corners.len());
    let blueprint = match way {
        Way::Grid if count == 4 => grid(rim, &corners),
        Way::Midpoint if count >= 3 => midpoint(rim, &corners),
        Way::Ring | Way::TurnedRing => ring(rim, way),
        Way::Grid => {
            return Err(CuttingError::Unsuitable { asked: "one patch", needs: "a loop with four corners" });
        }
        Way::Midpoint => {
            let (asked, needs) = ("midpoint subdivision", "a loop with three corners or more");
            return Err(CuttingError::Unsuitable { asked, needs });
        }
        Way::Annulus => return Err(CuttingError::Unsuitable { asked: "an annulus", needs: "two loops" }),
        Way::Faces | Way::Parts => {
            return Err(CuttingError::Unsuitable { asked: "cutting by faces", needs: "a graph of curves" });
        }
    };
    Ok(Quads { blueprint, way, corners: count, deviation })
}

fn chosen(rim: &Rim, corners: &[usize]) -> Way {
    let most = (0..corners.len()).map(|k| side_len(rim, corners, k)).max().unwrap_or(rim.len());
    match corners.len() {
        4 if rim.is_tame() && most <= MOST_PIECES => Way::Grid,
        3.. if rim.is_tame() && most <= MOST_PIECES => Way::Midpoint,
        _ => Way::Ring,
    }
}

/// Number of pieces from corner k to the next.
fn side_len(rim: &Rim, corners: &[usize], k: usize) -> usize {
    let next = if k + 1 < corners.len() { corners[k + 1] } else { corners[0] + rim.len() };
    next - corners[k]
}

/// The rim from its first corner on, side k in `wanted(k)` pieces, at least as many as it has.
fn with_sides(mut rim: Rim, corners: &[usize], wanted: impl Fn(usize) -> usize) -> Rim {
    let have: Vec<usize> = (0..corners.len()).map(|k| side_len(&rim, corners, k)).collect();
    rim = rim.begun_at(corners[0]);
    let mut start = 0;
    for (k, have) in have.into_iter().enumerate() {
        for count in have..wanted(k) {
            rim.halve_longest(start..start + count);
        }
        start += wanted(k);
    }
    rim
}

fn grid(rim: Rim, corners: &[usize]) -> Blueprint {
    let have: Vec<usize> = (0..4).map(|k| side_len(&rim, corners, k)).collect();
    // Opposite sides of a grid have the same number of pieces.
    let wanted = |k: usize| have[k].max(have[(k + 2) % 4]);
    let (columns, rows) = (wanted(0), wanted(1));
    let rim = with_sides(rim, corners, wanted);
    let mut blueprint = Blueprint::default();
    let ring = blueprint.ring(&rim.pieces, |k| format!("v{k}"));
    let count = ring.len();
    let run = |from: usize, to: usize| (from..=to).map(|k| ring[k % count]).collect::<Vec<_>>();
    let back = |from: usize, to: usize| run(from, to).into_iter().rev().collect::<Vec<_>>();
    let (v0, u1) = (run(0, columns), run(columns, columns + rows));
    let (v1, u0) = (back(columns + rows, 2 * columns + rows), back(2 * columns + rows, count));
    blueprint.grid([&v0, &u1, &v1, &u0]);
    blueprint
}

fn midpoint(rim: Rim, corners: &[usize]) -> Blueprint {
    let most = (0..corners.len()).map(|k| side_len(&rim, corners, k)).max().unwrap_or(1);
    // Each side is halved at a vertex: its number of pieces must be even.
    let half = most.div_ceil(2);
    let rim = with_sides(rim, corners, |_| 2 * half);
    let mut blueprint = Blueprint::default();
    let ring = blueprint.ring(&rim.pieces, |k| format!("v{k}"));
    blueprint.polygon(&ring, half, Cut::Fan);
    blueprint
}

fn ring(rim: Rim, way: Way) -> Blueprint {
    let mut rim = rim.with_at_least(4);
    let mut blueprint = Blueprint::default();
    // Four pieces are a ring as they are; turned, or with more, every piece is halved so that the inner polygon conforms.
    if rim.len() == 4 && way == Way::Ring {
        let ring = blueprint.ring(&rim.pieces, |k| format!("v{k}"));
        blueprint.ring_of_four([ring[0], ring[1], ring[2], ring[3]]);
        return blueprint;
    }
    for k in 0..rim.len() {
        // All pieces before it are two by now: piece k stands at 2 k.
        rim.halve(2 * k);
    }
    let ring = blueprint.ring(&rim.pieces, |k| format!("v{k}"));
    blueprint.polygon(&ring, 1, if way == Way::Ring { Cut::Ring } else { Cut::TurnedRing });
    blueprint
}
