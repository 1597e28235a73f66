//! `[net]`: a surface of which every control point is given.

use bases::{Aht, At, BasisFamily};
use plateau::{MAX_COORDINATE, MAX_DEGREE};

use super::curve::FAMILIES;
use super::helicoid::SHORTEST;
use super::shape::{self, SHAPES};
use crate::text::{Interval, Key, List, Name, Points, Reals, Section, Ways};

/// Most cuts of one direction.
const MOST_CUTS: usize = 1000;

/// Longest interval in any family; each has a bound of its own.
const LONGEST: f64 = Aht::SUPREMUM.max(At::SUPREMUM);

const SPAN: Interval = Interval::below(SHORTEST, LONGEST);
const CUTS: Reals = Reals { least: 1, most: MOST_CUTS, each: Interval::above(0.0, LONGEST) };
pub(crate) const BOUNDS: &str = "the functions live on [0, span]; beyond 7.853204624 for \"aht\" and 2π for \"at\" they become negative: cut a longer surface into several";

pub(crate) static BASIS: Key<Name<BasisFamily>> = Key::new(
    "basis",
    FAMILIES,
    "the functions in which the net is read; \"aht\" and \"at\" take 6 points in a direction, or 2 where the surface is linear",
)
.required()
.such_as("\"aht\"");
pub(crate) static POINTS: Key<List<Points>> = Key::new(
    "points",
    List {
        each: Points::between(2, MAX_DEGREE + 1, MAX_COORDINATE),
        least: 2,
        most: MAX_DEGREE + 1,
        example: "[[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]",
    },
    "the control points `P_ij`, row by row: i with u, j with v",
)
.required()
.hint(
    "write points = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]: a list of rows, each a list of points",
);
pub(crate) static SHAPE: Key<Reals> =
    Key::new("shape", SHAPES, "").meaning(shape::meaning_of_a_net).advice(shape::advice_of_a_net);
pub(crate) static U_SPAN: Key<Interval> = Key::new(
    "u-span",
    SPAN,
    "the length of the u interval, for \"aht\" (below 7.853204624) and \"at\" (below 2π) with 6 rows",
)
.such_as("1.5")
.hint(BOUNDS);
pub(crate) static V_SPAN: Key<Interval> =
    Key::new("v-span", SPAN, "the length of the v interval, with 6 points in each row")
        .such_as("6.0")
        .hint(BOUNDS);
pub(crate) static U_CUTS: Key<Reals> = Key::new(
    "u-cuts",
    CUTS,
    "the parameters u, ascending, at which the surface is subdivided; each part has a net of its own. For \"aht\" and \"at\"",
)
.such_as("[0.75]")
.hint("write u-cuts = [0.5, 1.0]: parameters of the lines along which the surface is cut, ascending");
pub(crate) static V_CUTS: Key<Reals> =
    Key::new("v-cuts", CUTS, "the parameters v at which it is subdivided, likewise")
        .such_as("[2.0, 4.0]")
        .hint("write v-cuts = [0.5, 1.0]: parameters of the lines along which the surface is cut, ascending");

pub(crate) static SECTION: Section = Section {
    doc: "the surface of a net of one's own, every control point given",
    keys: &[&BASIS, &POINTS, &SHAPE, &U_SPAN, &V_SPAN, &U_CUTS, &V_CUTS],
    ways: Ways::Free,
};
