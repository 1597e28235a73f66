//! `[[curve]]`: the curves of loops and faces.

use plateau::{MAX_COORDINATE, MAX_DEGREE};
use surfaces::SplineCurve;

use crate::text::{Inner, Interval, Key, List, Points, Reals, Section, Text, Vector, Ways, Whole};

/// Most corners of a polyline: each is the end of an edge of the surface.
pub(crate) const MOST_CORNERS: usize = 200;

/// Most samples of a curve, and most control points of a spline.
const MOST_POINTS: usize = 10_000;

const PLACE: Vector = Vector::up_to(MAX_COORDINATE);
const LENGTH: Interval = Interval::above(0.0, MAX_COORDINATE);

const ONE_FORM: &str =
    "a curve is given by one of points (Bézier), polyline, spline, through (samples), circle";

pub(crate) static NAME: Key<Text> =
    Key::new("name", Text::Named, "the name by which loops call it; unique, and not beginning with `-`")
        .required()
        .such_as("\"rim\"")
        .hint("write name = \"rim\": loops and faces call a curve by it");
pub(crate) static ENDS: Key<List<Text>> = Key::new(
    "ends",
    List { each: Text::Named, least: 2, most: 2, example: "[\"a\", \"b\"]" },
    "the names of the vertices in which it begins and ends; left out, the curve is closed",
)
.such_as("[\"a\", \"b\"]")
.hint("write ends = [\"a\", \"b\"], the names of the vertices where the curve begins and ends; leave it out for a closed curve");
pub(crate) static POINTS: Key<Points> = Key::new(
    "points",
    Points::between(2, MAX_DEGREE + 1, MAX_COORDINATE),
    "the control points of a Bézier curve",
)
.hint(ONE_FORM);
pub(crate) static POLYLINE: Key<Points> = Key::new(
    "polyline",
    Points::between(2, MOST_CORNERS, MAX_COORDINATE).counting("corners"),
    "the corners of a chain of straight segments",
)
.hint(ONE_FORM);
pub(crate) static SPLINE: Key<Inner> = Key::table("spline", Inner(&spline::SECTION));
pub(crate) static THROUGH: Key<Inner> = Key::table("through", Inner(&through::SECTION));
pub(crate) static CIRCLE: Key<Inner> = Key::table("circle", Inner(&circle::SECTION));

pub(crate) static SECTION: Section = Section {
    doc: "a curve of the boundary, for loops and faces",
    keys: &[&NAME, &ENDS, &POINTS, &POLYLINE, &SPLINE, &THROUGH, &CIRCLE],
    ways: Ways::One(&[&["points"], &["polyline"], &["spline"], &["through"], &["circle"]]),
};

/// `spline = { … }`.
pub(crate) mod spline {
    use super::*;

    pub(crate) static DEGREE: Key<Whole<usize>> =
        Key::new("degree", Whole::between(1, SplineCurve::MAX_DEGREE as u64), "the degree of the B-spline")
            .required()
            .such_as("3");
    pub(crate) static KNOTS: Key<Reals> = Key::new(
        "knots",
        Reals { least: 4, most: MOST_POINTS + SplineCurve::MAX_DEGREE + 1, each: Interval::FINITE },
        "the knots, as many as points and degree + 1 together, none below the one before",
    )
    .required()
    .such_as("[0, 0, 0, 0, 1, 1, 1, 1]");
    pub(crate) static POINTS: Key<Points> = Key::new(
        "points",
        Points::between(2, MOST_POINTS, MAX_COORDINATE).counting("control points"),
        "the control points",
    )
    .required();
    pub(crate) static WEIGHTS: Key<Reals> = Key::new(
        "weights",
        Reals { least: 2, most: MOST_POINTS, each: Interval::above(0.0, f64::INFINITY) },
        "the weights of a rational spline, one for each point",
    )
    .such_as("[1, 0.5, 1]");

    pub(crate) static SECTION: Section = Section {
        doc: "a B-spline curve, rational with weights",
        keys: &[&DEGREE, &KNOTS, &POINTS, &WEIGHTS],
        ways: Ways::Free,
    };
}

/// `through = { … }`.
pub(crate) mod through {
    use super::*;

    pub(crate) static POINTS: Key<Points> = Key::new(
        "points",
        Points::between(2, MOST_POINTS, MAX_COORDINATE).counting("samples"),
        "samples along the curve, in order",
    )
    .required();
    pub(crate) static TOLERANCE: Key<Interval> = Key::new(
        "tolerance",
        LENGTH,
        "the largest distance by which the curve may miss a sample, a length; left out, a millionth of the size",
    )
    .such_as("1e-6");
    pub(crate) static CORNER_ANGLE: Key<Interval> = Key::new(
        "corner-angle",
        Interval::between(1.0, 179.0),
        "the turn of direction in degrees above which a sample is a corner",
    )
    .or("44");

    pub(crate) static SECTION: Section = Section {
        doc: "a curve through samples, smooth but for corners where they turn sharply",
        keys: &[&POINTS, &TOLERANCE, &CORNER_ANGLE],
        ways: Ways::Free,
    };
}

/// `circle = { … }`.
pub(crate) mod circle {
    use super::*;

    pub(crate) static CENTER: Key<Vector> =
        Key::new("center", PLACE, "the center").required().such_as("[0, 0, 1]");
    pub(crate) static NORMAL: Key<Vector> = Key::new(
        "normal",
        PLACE,
        "the direction perpendicular to its plane, of any length; seen against it the circle turns to the left",
    )
    .required()
    .such_as("[0, 0, 1]");
    pub(crate) static RADIUS: Key<Interval> =
        Key::new("radius", LENGTH, "the radius").required().such_as("1.0");
    pub(crate) static FROM: Key<Vector> =
        Key::new("from", PLACE, "the point of the circle from which angles are counted; an arc needs it")
            .such_as("[1, 0, 1]");
    pub(crate) static ARC: Key<Reals> = Key::new(
        "arc",
        Reals::exactly(2, Interval::between(-360.0, 360.0)),
        "where an arc begins and ends, in degrees from the point `from`; for curves with ends",
    )
    .such_as("[0, 180]")
    .hint("write arc = [0, 180], where it begins and ends in degrees from the point `from`");

    pub(crate) static SECTION: Section = Section {
        doc: "a circle, or an arc of it",
        keys: &[&CENTER, &NORMAL, &RADIUS, &FROM, &ARC],
        ways: Ways::Free,
    };
}
