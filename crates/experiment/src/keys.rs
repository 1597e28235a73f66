//! The keys of experiment files, all of them: what each is called, takes and means.

pub(crate) mod boundary;
pub(crate) mod boundary_curve;
pub(crate) mod curve;
pub(crate) mod expect;
pub(crate) mod face;
pub(crate) mod helicoid;
pub(crate) mod method;
pub(crate) mod net;
pub(crate) mod output;
pub(crate) mod search;
pub(crate) mod shape;
pub(crate) mod sweep;

use crate::text::{Inner, Key, OneOrSeveral, Section, Several, Text, Ways, Whole};

pub(crate) static TITLE: Key<Text> = Key::new("title", Text::Named, "the heading of the table of results")
    .required()
    .hint("begin the file with title = \"…\": it heads the table of results");

pub(crate) static SEED: Key<Whole<u64>> = Key::new(
    "seed",
    Whole::between(0, i64::MAX as u64),
    "the seed of every random choice; the same seed gives the same result",
)
.or("0");

pub(crate) static BOUNDARY: Key<Inner> = Key::table("boundary", Inner(&boundary::SECTION));
pub(crate) static METHOD: Key<Several> = Key::table("method", Several(&method::SECTION));
pub(crate) static SEARCH: Key<Inner> = Key::table("search", Inner(&search::SECTION));
pub(crate) static HELICOID: Key<Inner> = Key::table("helicoid", Inner(&helicoid::SECTION));
pub(crate) static TRAPEZIUM: Key<Inner> =
    Key::table("trapezium-helicoid", Inner(&helicoid::trapezium::SECTION));
pub(crate) static CURVE: Key<OneOrSeveral> =
    Key::table("curve", OneOrSeveral { one: &curve::SECTION, several: &boundary_curve::SECTION });
pub(crate) static NET: Key<Inner> = Key::table("net", Inner(&net::SECTION));
pub(crate) static FACE: Key<Several> = Key::table("face", Several(&face::SECTION));
pub(crate) static VERTEX: Key<Several> = Key::table("vertex", Several(&face::vertex::SECTION));
pub(crate) static EXPECT: Key<Inner> = Key::table("expect", Inner(&expect::SECTION));
pub(crate) static OUTPUT: Key<Inner> = Key::table("output", Inner(&output::SECTION));
pub(crate) static SWEEP: Key<Inner> = Key::table("sweep", Inner(&sweep::SECTION));

/// The tables that say where a surface lies: with another value in one of them two surfaces cannot be compared.
pub(crate) static GEOMETRY: [&str; 7] = [
    BOUNDARY.name(),
    CURVE.name(),
    VERTEX.name(),
    FACE.name(),
    NET.name(),
    HELICOID.name(),
    TRAPEZIUM.name(),
];

/// The file as a whole.
pub(crate) static EXPERIMENT: Section = Section {
    doc: "an experiment file of plateau: one of [boundary] or [[face]] with [[method]] tables, [helicoid], [trapezium-helicoid], [net], [curve]",
    keys: &[
        &TITLE, &SEED, &BOUNDARY, &METHOD, &SEARCH, &HELICOID, &TRAPEZIUM, &NET, &CURVE, &FACE, &VERTEX,
        &EXPECT, &OUTPUT, &SWEEP,
    ],
    ways: Ways::Any(&[
        &["boundary", "method"],
        &["face", "method"],
        &["helicoid"],
        &["trapezium-helicoid"],
        &["net"],
        &["curve"],
    ]),
};
