//! `[boundary]`.

use plateau::{MAX_COORDINATE, MAX_DEGREE};

use crate::text::{Key, Points, Section, Ways, Whole};

pub(crate) const SIDES_OF_A_NET: &str = "a tensor boundary has four lists of points: u0 (row i = 0), u1 (row i = m), \
     v0 (column j = 0), v1 (column j = n), with the corners repeated";
pub(crate) const SIDES_OF_A_TRIANGLE: &str =
    "a triangular boundary has three lists of points: ab from A to B, bc from B to C, ca from C to A";

const SIDE: Points = Points::between(2, MAX_DEGREE + 1, MAX_COORDINATE);
const DEGREE: Whole<usize> = Whole::between(1, MAX_DEGREE as u64);
const FREE_DEGREE: &str = "it is the degree of the net in the direction whose sides are not given";

pub(crate) static U0: Key<Points> = Key::new("u0", SIDE, "row P_0j of the net, j = 0…n").hint(SIDES_OF_A_NET);
pub(crate) static U1: Key<Points> =
    Key::new("u1", SIDE, "row P_mj of the net, with as many points as `u0`").hint(SIDES_OF_A_NET);
pub(crate) static V0: Key<Points> = Key::new(
    "v0",
    SIDE,
    "column P_i0 of the net, i = 0…m, which begins where `u0` begins and ends where `u1` begins",
)
.hint(SIDES_OF_A_NET);
pub(crate) static V1: Key<Points> =
    Key::new("v1", SIDE, "column P_in of the net, which begins where `u0` ends and ends where `u1` ends")
        .hint(SIDES_OF_A_NET);
pub(crate) static U_DEGREE: Key<Whole<usize>> =
    Key::new("u-degree", DEGREE, "the degree m in u, for harmonic nets from `u0` and `u1` alone")
        .hint(FREE_DEGREE);
pub(crate) static V_DEGREE: Key<Whole<usize>> =
    Key::new("v-degree", DEGREE, "the degree n in v, for harmonic nets from `v0` and `v1` alone")
        .hint(FREE_DEGREE);
pub(crate) static AB: Key<Points> =
    Key::new("ab", SIDE, "the side of a triangle from A = P_n00 to B = P_0n0, n + 1 points")
        .hint(SIDES_OF_A_TRIANGLE);
pub(crate) static BC: Key<Points> =
    Key::new("bc", SIDE, "the side from B = P_0n0 to C = P_00n").hint(SIDES_OF_A_TRIANGLE);
pub(crate) static CA: Key<Points> =
    Key::new("ca", SIDE, "the side from C = P_00n back to A").hint(SIDES_OF_A_TRIANGLE);

pub(crate) static SECTION: Section = Section {
    doc: "the control points that stay fixed: four sides of a tensor net (`u0`, `u1`, `v0`, `v1`), two opposite sides and a \
          degree, or three sides of a triangle (`ab`, `bc`, `ca`)",
    keys: &[&U0, &U1, &V0, &V1, &U_DEGREE, &V_DEGREE, &AB, &BC, &CA],
    ways: Ways::Any(&[
        &["u0", "u1", "v0", "v1"],
        &["u0", "u1", "u-degree"],
        &["v0", "v1", "v-degree"],
        &["ab", "bc", "ca"],
    ]),
};
