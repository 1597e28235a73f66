//! `[boundary]`.

use plateau::{MAX_COORDINATE, MAX_DEGREE};

use super::boundary_curve::MOST_CORNERS;
use crate::text::{Key, List, Points, Section, Text, Ways, Whole};

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

pub(crate) static POLYGON: Key<Points> = Key::new(
    "polygon",
    Points::between(3, MOST_CORNERS, MAX_COORDINATE).counting("corners"),
    "the corners of a closed polygon, in order round, the first not repeated",
)
.hint("write polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1]]: three corners or more, in order round, the first not repeated");
pub(crate) static SIDES: Key<List<Points>> = Key::new(
    "sides",
    List { each: SIDE, least: 1, most: MOST_CORNERS, example: "[[[0, 0, 0], [1, 1, 0]], [[1, 1, 0], [2, 0, 1], [0, 0, 0]]]" },
    "the Bézier sides of a loop in order round, each the list of its control points, which begins where the side before ends",
)
.hint("write sides = [[[0, 0, 0], [1, 1, 0]], …]: lists of control points, in order round");
pub(crate) static LOOPS: Key<List<List<Text>>> = Key::new(
    "loops",
    List {
        each: List { each: Text::Named, least: 1, most: MOST_CORNERS, example: "[\"rim\", \"-back\"]" },
        least: 1,
        most: 2,
        example: "[[\"rim\", \"-back\"]]",
    },
    "loops of [[curve]]s by their names, `-` before one that runs the other way: one loop is spanned by a disc, two by an annulus",
)
.such_as("[[\"rim\", \"-back\"]]")
.hint("write loops = [[\"rim\", \"-back\"]], one loop or two, each a list of names of curves; more loops need [[face]] tables");

pub(crate) static SECTION: Section = Section {
    doc: "what the surface spans: four sides of a tensor net (`u0`, `u1`, `v0`, `v1`), two opposite sides and a degree, three sides \
          of a triangle (`ab`, `bc`, `ca`), a `polygon`, `sides` of any number, or `loops` of curves",
    keys: &[&U0, &U1, &V0, &V1, &U_DEGREE, &V_DEGREE, &AB, &BC, &CA, &POLYGON, &SIDES, &LOOPS],
    ways: Ways::Any(&[
        &["u0", "u1", "v0", "v1"],
        &["u0", "u1", "u-degree"],
        &["v0", "v1", "v-degree"],
        &["ab", "bc", "ca"],
        &["polygon"],
        &["sides"],
        &["loops"],
    ]),
};
