//! `[search]`.

use plateau::Search;

use super::shape::{SHAPES, advice_of_a_box};
use crate::text::{Interval, Key, Name, Reals, Section, Ways, Whole};

/// Who informs a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Topology {
    Global,
    Local,
}

pub(crate) static VARIANT: Key<Name<Topology>> = Key::new(
    "variant",
    Name(&[("global", Topology::Global), ("local", Topology::Local)]),
    "who informs a particle: every other, or its ring neighbours",
)
.or("\"global\"");
pub(crate) static PARTICLES: Key<Whole<usize>> = Key::new(
    "particles",
    Whole::between(1, optim::MAX_PARTICLES as u64),
    "the number of particles of a swarm",
)
.or("50");
pub(crate) static ITERATIONS: Key<Whole<usize>> = Key::new(
    "iterations",
    Whole::between(1, Search::MOST_ITERATIONS as u64),
    "the number of iterations of a run",
)
.or("100");
pub(crate) static RUNS: Key<Whole<usize>> = Key::new(
    "runs",
    Whole::between(1, Search::MOST_RUNS as u64),
    "the number of independent runs, or of starts of a polish",
)
.or("10");
pub(crate) static INERTIA: Key<Interval> =
    Key::new("inertia", Interval::between(0.0, 1.0), "the inertia w of the velocity").or("0.7");
pub(crate) static SOCIAL: Key<Interval> = Key::new(
    "social",
    Interval::between(0.0, 10.0),
    "the pull c1 towards the best of those who inform the particle",
)
.or("1.5");
pub(crate) static COGNITIVE: Key<Interval> =
    Key::new("cognitive", Interval::between(0.0, 10.0), "the pull c2 towards the particle's own best")
        .or("1.5");
pub(crate) static BOX: Key<Reals> =
    Key::new("box", Reals::exactly(2, SHAPES.each), "the lower and the upper bound of every shape parameter")
        .or("[0.5, 3.5]")
        .advice(advice_of_a_box);
pub(crate) static NEIGHBOURS: Key<Whole<usize>> = Key::new(
    "neighbours",
    Whole::between(1, 500_000),
    "the number of ring neighbours on each side that inform a particle of the local variant",
)
.or("2");

pub(crate) static SECTION: Section = Section {
    doc: "the search for shape parameters: a swarm in a box; what is left out keeps its default (GT §5)",
    keys: &[&VARIANT, &PARTICLES, &ITERATIONS, &RUNS, &INERTIA, &SOCIAL, &COGNITIVE, &BOX, &NEIGHBOURS],
    ways: Ways::Free,
};
