//! `[[method]]`.

use plateau::{
    DegreeLimit, Energy, Fill, MAX_COORDINATE, MAX_DEGREE, MAX_METRIC_STEPS, ReferenceTriangle, SearchEnergy,
    SearchMode, ShapedFamily, SolverChoice, TOLERANCES, TriangleMask,
};
use serde_json::{Map, Value as Json, json};

use super::shape::SHAPES;
use super::{expect, shape};
use crate::text::{
    Flag, Form, Inner, Interval, Key, Kind, Name, OneOrSeveral, Place, Reals, Section, Text, Value, Ways,
    Whole,
};

static MODES: [(&str, SearchMode); 3] =
    [("pso", SearchMode::Pso), ("polish", SearchMode::Polish), ("pso-polish", SearchMode::PsoPolish)];

static MASKS: [(&str, TriangleMask); 2] =
    [("dirichlet", TriangleMask::Dirichlet), ("coons", TriangleMask::Coons)];

/// Nets given by a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Construction {
    DiscreteCoons,
    Harmonic,
}

/// What a file may say of the linear solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Solver {
    /// That of an extremal; of masks, the only one.
    Of(SolverChoice),
    /// The one of masks.
    Sparse,
}

/// Highest degree of the patches of a surface over loops or faces: a face of degree p has 3(p − 1)² unknowns.
const MOST_OF_A_COMPLEX: u64 = DegreeLimit::Patches.degree() as u64;

/// A boundary of four sides, or of two opposite ones.
pub(crate) const TENSOR: &str = "tensor";
/// A boundary of three sides.
pub(crate) const TRIANGLE: &str = "triangle";
/// A boundary of loops or faces.
pub(crate) const LOOPS: &str = "loops";

const NETS: &[&str] = &[TENSOR, TRIANGLE];

/// Whether shape parameters are searched, and how.
#[derive(Clone, Copy)]
pub(crate) struct Searching;

/// What a file says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Searched {
    /// They are not.
    Not,
    /// As suits what one shape costs.
    AsSuits,
    /// In this way.
    By(SearchMode),
}

impl Form for Searching {
    fn expected(&self) -> String {
        "true, false, \"pso\", \"polish\" or \"pso-polish\"".to_owned()
    }

    fn admits(&self) -> String {
        format!("`true`, `false`, {}", Name(&MODES).admits())
    }

    fn schema(&self) -> Map<String, Json> {
        let words = MODES.iter().map(|(name, _)| json!(name));
        let all: Vec<Json> = [json!(true), json!(false)].into_iter().chain(words).collect();
        [("enum".to_owned(), json!(all))].into_iter().collect()
    }
}

impl Kind for Searching {
    type Value = Searched;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        if let Some(truth) = value.get_ref().as_bool() {
            return Some(if truth { Searched::AsSuits } else { Searched::Not });
        }
        match value.get_ref().as_str() {
            Some(word) => place.one_of(word, value, &MODES).map(Searched::By),
            None => {
                place.wrong_type(value, &self.expected());
                None
            }
        }
    }
}

/// The weights of a mask.
#[derive(Clone, Copy)]
pub(crate) struct Weights;

/// The corner weights that are admitted.
const ALPHA: Interval = Interval::between(-1e6, 1e6);

impl Form for Weights {
    fn expected(&self) -> String {
        "the corner weight, a number, or \"dirichlet\" or \"coons\"".to_owned()
    }

    fn admits(&self) -> String {
        format!("a number, {}, or {}", ALPHA.admits(), Name(&MASKS).admits())
    }

    fn schema(&self) -> Map<String, Json> {
        let forms = [Json::Object(ALPHA.schema()), Json::Object(Name(&MASKS).schema())];
        [("anyOf".to_owned(), json!(forms))].into_iter().collect()
    }
}

impl Kind for Weights {
    type Value = TriangleMask;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<TriangleMask> {
        match value.get_ref().as_str() {
            Some(word) => place.one_of(word, value, &MASKS),
            None if value.get_ref().is_float() || value.get_ref().is_integer() => {
                place.real_in(value, ALPHA).map(TriangleMask::Symmetric)
            }
            None => {
                place.wrong_type(value, &self.expected());
                None
            }
        }
    }
}

pub(crate) static NAME: Key<Text> = Key::new("name", Text::Named, "the label of the row, unique in the file")
    .required()
    .hint("write name = \"…\": it labels the row of the table");
pub(crate) static PATCH: Key<Name<Option<ShapedFamily>>> = Key::new(
    "patch",
    Name(&ShapedFamily::PATCHES),
    "the kind of patch over a tensor boundary; triangles need no such key",
)
.or("\"tensor\"")
.over(&[TENSOR]);
pub(crate) static BASIS: Key<Name<Option<ShapedFamily>>> = Key::new(
    "basis",
    Name(&ShapedFamily::BASES),
    "the basis in which the net is read; of a TB–Coons patch it is \"gt\"",
)
.or("\"bernstein\"")
.over(NETS);
pub(crate) static SHAPE: Key<Reals> =
    Key::new("shape", SHAPES, "").meaning(shape::meaning).advice(shape::advice).over(&[TENSOR]);
pub(crate) static SEARCH: Key<Searching> = Key::new(
    "search",
    Searching,
    "whether the shape parameters are tuned by [search], and how: \"pso-polish\" is a swarm and then descent from each run's best, \
     \"pso\" the swarm alone, \"polish\" descents from random starts; `true` is \"polish\" for energy = \"area\", where every shape costs a least area, and for \
     search-energy = \"conformality\", else \"pso-polish\"",
)
.or("false")
.such_as("\"pso\"")
.over(NETS);
pub(crate) static ENERGY: Key<Name<Energy>> =
    Key::new("energy", Name(&Energy::NAMED), "the energy whose extremal the interior is")
        .such_as("\"dirichlet\"");
pub(crate) static RAISE: Key<Whole<usize>> = Key::new(
    "raise",
    Whole::between(0, MAX_DEGREE as u64),
    "the number of degrees by which the boundary is raised before solving, exactly for Bernstein",
)
.or("0")
.over(NETS);
pub(crate) static DOMAIN: Key<Name<ReferenceTriangle>> = Key::new(
    "domain",
    Name(&[("right", ReferenceTriangle::Right), ("equilateral", ReferenceTriangle::Equilateral)]),
    "the plane triangle over which the energy of a triangular extremal is taken: over the \"right\" one of the papers the corner C is apart, \
     over the \"equilateral\" one all corners are alike",
)
.or("\"right\"")
.over(&[TRIANGLE]);
pub(crate) static METRIC_STEPS: Key<Whole<usize>> = Key::new(
    "metric-steps",
    Whole::between(0, MAX_METRIC_STEPS as u64),
    "the number of metric corrections after the Dirichlet extremal, towards least area: one is the Dirichlet correction of \
     TRI §7, 20 come near the limit",
)
.or("0")
.over(NETS);
pub(crate) static MASK: Key<Weights> = Key::new(
    "mask",
    Weights,
    "the weights that make each interior point a fixed combination of its neighbours: the corner weight α, or a named mask of \
     triangles",
)
.such_as("-0.25")
.hint("give the corner weight; the edge weight follows from it: 3α + 6β = 1 on triangles, 4α + 4β = 1 on tensor nets")
.over(NETS);
pub(crate) static CONSTRUCTION: Key<Name<Construction>> = Key::new(
    "construction",
    Name(&[("discrete-coons", Construction::DiscreteCoons), ("harmonic", Construction::Harmonic)]),
    "the closed formula that gives the net: no energy is minimised",
)
.such_as("\"discrete-coons\"")
.over(NETS);
pub(crate) static SEARCH_ENERGY: Key<Name<SearchEnergy>> = Key::new(
    "search-energy",
    Name(&SearchEnergy::NAMED),
    "what the shape parameters minimise, \"conformality\" being (D − A)/A; left out, it is `energy`, and \"laplacian\" for harmonic nets",
)
.such_as("\"dirichlet\"")
.over(&[TENSOR]);
pub(crate) static SOLVER: Key<Name<Solver>> = Key::new(
    "solver",
    Name(&[
        ("auto", Solver::Of(SolverChoice::Auto)),
        ("dense", Solver::Of(SolverChoice::Dense)),
        ("separable", Solver::Of(SolverChoice::Separable)),
        ("sparse", Solver::Sparse),
    ]),
    "the linear solver; \"separable\" serves Dirichlet extremals of tensor patches, \"sparse\" serves masks",
)
.or("\"auto\"")
.over(NETS);
pub(crate) static TOLERANCE: Key<Interval> = Key::new(
    "tolerance",
    Interval::between(*TOLERANCES.start(), *TOLERANCES.end()),
    "the relative decrease of the area that counts as none, for energy = \"area\"; 1e-7 is quick",
)
.or("1e-10");
pub(crate) static DEGREE: Key<Whole<usize>> = Key::new(
    "degree",
    Whole::between(1, MOST_OF_A_COMPLEX),
    "the degree of every patch of the surface; left out, 6 or that of its curves, where it is higher",
)
.such_as("6")
.over(&[LOOPS]);
pub(crate) static LAYERS: Key<Whole<usize>> =
    Key::new("layers", Whole::between(0, 1), "for energy = \"area\": layers of smaller patches around corners where the surface is not smooth, all but those of 180°/k between straight sides; without the key `accuracy` sets one where raising the degree gains little")
        .or("0")
        .over(&[TENSOR, LOOPS]);
pub(crate) static RIM_TOLERANCE: Key<Interval> = Key::new(
    "rim-tolerance",
    Interval::above(0.0, MAX_COORDINATE),
    "how far the rim may pass from curves that patches cannot meet exactly (circles, rational splines), a length; left out, 1e-6 of the size; samples have a tolerance of their own",
)
.such_as("1e-9")
.over(&[LOOPS]);
pub(crate) static ACCURACY: Key<Interval> = Key::new(
    "accuracy",
    Interval::between(*Fill::ACCURACIES.start(), *Fill::ACCURACIES.end()),
    "for energy = \"area\": the degree rises, to 14 at most, until the area is estimated to lie less than this share above the least; corners that hold it up get a layer",
)
.such_as("1e-8")
.over(&[LOOPS]);
pub(crate) static BOUND: Key<Flag> = Key::new(
    "bound",
    Flag,
    "whether a lower bound of the area is proved, where the rim bounds a graph over a plane; for energy = \"area\" in the Bernstein basis",
)
.or("false")
.over(&[TENSOR, LOOPS]);
pub(crate) static EXPECT: Key<Inner> = Key::table("expect", Inner(&expect::SECTION));
pub(crate) static PUBLISHED: Key<OneOrSeveral> =
    Key::table("published", OneOrSeveral { one: &expect::PUBLISHED, several: &expect::PUBLISHED });

pub(crate) static SECTION: Section = Section {
    doc: "one row of the table, a way to fill the boundary: exactly one of `energy`, `mask`, `construction`",
    keys: &[
        &NAME,
        &PATCH,
        &BASIS,
        &SHAPE,
        &SEARCH,
        &ENERGY,
        &RAISE,
        &DOMAIN,
        &METRIC_STEPS,
        &MASK,
        &CONSTRUCTION,
        &SEARCH_ENERGY,
        &SOLVER,
        &TOLERANCE,
        &DEGREE,
        &LAYERS,
        &RIM_TOLERANCE,
        &ACCURACY,
        &BOUND,
        &EXPECT,
        &PUBLISHED,
    ],
    ways: Ways::One(&[&["energy"], &["mask"], &["construction"]]),
};
