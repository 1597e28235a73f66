//! `[helicoid]` and `[trapezium-helicoid]`.

use plateau::MAX_DEGREE;

use crate::text::{Interval, Key, Name, Section, Ways, Whole};

/// Largest weight: with cosh u ≤ cosh 100 the squares of area densities stay below overflow.
const LARGEST_WEIGHT: f64 = 1e30;

/// The larger weight is at least this: the fourth powers of lengths stay above underflow.
pub(crate) const SMALLEST_WEIGHT: f64 = 1e-30;

/// Shortest interval: on a shorter one the surface drowns in the rounding of its coordinates, its derivatives first.
pub(crate) const SHORTEST: f64 = 1e-6;

/// Longest intervals: cosh u stays far below overflow, the number of patches within thousands.
const LONGEST: [f64; 2] = [100.0, 1000.0];

const WEIGHT: Interval = Interval::between(-LARGEST_WEIGHT, LARGEST_WEIGHT);
const BOTH: &str = "x = a sinh u cos v - b cosh u sin v, y = a sinh u sin v + b cosh u cos v, z = a v + b u: give both a and b";
const PIECES: &str =
    "it is the length of a parameter interval that begins at 0; beyond 7.775 it is cut into several patches";

/// How (a, b) moves, without its degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Path {
    Trigonometric,
    Linear,
    Bernstein,
}

pub(crate) static A: Key<Interval> =
    Key::new("a", WEIGHT, "the weight of the right helicoid").required().hint(BOTH);
pub(crate) static B: Key<Interval> =
    Key::new("b", WEIGHT, "the weight of the catenoid").required().hint(BOTH);
pub(crate) static U_SPAN: Key<Interval> =
    Key::new("u-span", Interval::between(SHORTEST, LONGEST[0]), "the length of the u interval")
        .required()
        .hint(PIECES);
pub(crate) static V_SPAN: Key<Interval> =
    Key::new("v-span", Interval::between(SHORTEST, LONGEST[1]), "the length of the v interval")
        .required()
        .hint(PIECES);
pub(crate) static FRAMES: Key<Whole<usize>> = Key::new(
    "frames",
    Whole::between(2, 1000),
    "the number of surfaces of the deformation from (a, b) = (1, 0) to (0, 1), both ends included; left out, there is none",
)
.such_as("11");
pub(crate) static PATH: Key<Name<Path>> = Key::new(
    "path",
    Name(&[("trigonometric", Path::Trigonometric), ("linear", Path::Linear), ("bernstein", Path::Bernstein)]),
    "how (a, b) moves: along (cos λπ/2, sin λπ/2), an isometric bending, along (1 − λ, λ), or along ((1 − λ)ⁿ, λⁿ)",
)
.or("\"trigonometric\"");
pub(crate) static PATH_DEGREE: Key<Whole<u32>> =
    Key::new("path-degree", Whole::between(1, MAX_DEGREE as u64), "the degree n of the bernstein path")
        .such_as("3")
        .hint("path = \"bernstein\" moves (a, b) along ((1 - λ)^n, λ^n): give the degree n, path-degree = 3");

pub(crate) static SECTION: Section = Section {
    doc: "a generalized helicoid, exact in the AHT basis: x = a sinh u cos v − b cosh u sin v, y = a sinh u sin v + b cosh u \
          cos v, z = a v + b u",
    keys: &[&A, &B, &U_SPAN, &V_SPAN, &FRAMES, &PATH, &PATH_DEGREE],
    ways: Ways::Free,
};

/// `[trapezium-helicoid]`.
pub(crate) mod trapezium {
    use plateau::Construction;

    use super::{LONGEST, SHORTEST, WEIGHT};
    use crate::text::{Interval, Key, Name, Reals, Section, Ways};

    const SIDES: &str = "w runs from γ0 + β0 v to γ1 + β1 v: give gamma = [γ0, γ1] and beta = [β0, β1]";

    const PIECES: &str = "it is the length of a parameter interval that begins at 0; beyond 6.220 it is cut into several patches";

    pub(crate) static SPAN: Key<Interval> =
        Key::new("span", Interval::between(SHORTEST, LONGEST[1]), "the length of the v interval")
            .required()
            .hint(PIECES);
    pub(crate) static GAMMA: Key<Reals> =
        Key::new("gamma", Reals::exactly(2, WEIGHT), "where the two sides begin: [γ0, γ1]")
            .required()
            .hint(SIDES);
    pub(crate) static BETA: Key<Reals> =
        Key::new("beta", Reals::exactly(2, WEIGHT), "the slopes of the two sides: [β0, β1]")
            .required()
            .hint(SIDES);
    pub(crate) static CONSTRUCTION: Key<Name<Construction>> = Key::new(
        "construction",
        Name(&[("endpoint-rule", Construction::EndpointRule), ("geometric", Construction::Geometric)]),
        "where the control points come from: the derivatives at the ends, or right angles and lengths in the plane (AT Theorems 1–3); \
         the two agree to rounding",
    )
    .or("\"endpoint-rule\"");

    pub(crate) static SECTION: Section = Section {
        doc: "the helicoid (w cos v, w sin v, v) over the trapezium 0 ≤ v ≤ span, γ0 + β0 v ≤ w ≤ γ1 + β1 v, exact in the AT \
              basis",
        keys: &[&SPAN, &GAMMA, &BETA, &CONSTRUCTION],
        ways: Ways::Free,
    };
}
