//! Broken experiment files: each mutant has one fault, and the refusal must name it, point at it and
//! say what to do. «…» marks the place the refusal must point at, exactly.

use experiment::{Fault, Plan, Refusal};

const TENSOR: &str = r#"title = "Net"
seed = 7

[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]

[[method]]
name = "first"
basis = "gt"
energy = "dirichlet"
search = true

[[method]]
name = "second"
basis = "bernstein"
energy = "bending"

[method.expect]
dirichlet = 38.35

[method.published]
source = "GT Table 1"
quantity = "dirichlet"
printed = 38.0000

[search]
variant = "global"
particles = 50
iterations = 100
runs = 10
inertia = 0.7
box = [0.5, 3.5]
neighbours = 2

[output]
mesh = 48
formats = ["obj"]
"#;

const BILINEAR: &str = r#"title = "Bilinear"
[boundary]
u0 = [[0, 0, 0], [1, 0, 1]]
u1 = [[0, 1, 0], [1, 1, 0]]
v0 = [[0, 0, 0], [0, 1, 0]]
v1 = [[1, 0, 1], [1, 1, 0]]
[[method]]
name = "only"
energy = "dirichlet"
"#;

const ROWS: &str = r#"title = "Rows"
[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
u-degree = 3
[[method]]
name = "only"
construction = "harmonic"
"#;

const TRIANGLE: &str = r#"title = "Triangle"
[boundary]
ab = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]
bc = [[3, 0, 0], [2, 1, 1], [1, 2, 1], [0, 3, 0]]
ca = [[0, 3, 0], [0, 2, 0], [0, 1, 0], [0, 0, 0]]
[[method]]
name = "only"
mask = "dirichlet"
"#;

const HELICOID: &str = r#"title = "Helicoid"
[helicoid]
a = 1.0
b = 2.0
u-span = 1.5
v-span = 6.0
frames = 11
path = "linear"
[expect]
deviation = 0.000
"#;

const TRAPEZIUM: &str = r#"title = "Trapezium"
[trapezium-helicoid]
span = 3.9
gamma = [6.2, 12.5]
beta = [1.0, 0.5]
"#;

const NET: &str = r#"title = "Net of its own"
[net]
basis = "at"
v-span = 3.0
v-cuts = [1.0, 2.0]
points = [
  [[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0], [0, 4, 0], [0, 5, 0]],
  [[1, 0, 1], [1, 1, 1], [1, 2, 0], [1, 3, 0], [1, 4, 1], [1, 5, 1]],
]
[expect]
area = { value = 6.0, tolerance = 1.0 }
"#;

const CURVE: &str = r#"title = "Curve"
[curve]
basis = "gt"
shape = [1.0, 2.0]
points = [[0, 0], [1, 2], [3, 2], [4, 0]]
samples = [0.0, 0.25, 1.0]
"#;

const POLYGON: &str = r#"title = "Polygon"
[boundary]
polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0.5, 1.5, 0.5], [0, 1, 0]]
[[method]]
name = "least area"
energy = "area"
degree = 6
"#;

const SIDES: &str = r#"title = "Sides"
[boundary]
sides = [
  [[0, 0, 0], [1, 0, 1], [2, 0, 0]],
  [[2, 0, 0], [2, 2, 0]],
  [[2, 2, 0], [1, 1, 0], [0, 0, 0]],
]
[[method]]
name = "least area"
energy = "area"
"#;

const RINGS: &str = r#"title = "Two loops"
[boundary]
loops = [["low", "-high"], ["ring"]]
[[curve]]
name = "low"
ends = ["a", "b"]
points = [[0, 0, 0], [1, -1, 0], [2, 0, 0]]
[[curve]]
name = "high"
ends = ["a", "b"]
spline = { degree = 2, knots = [0, 0, 0, 1, 1, 1], points = [[0, 0, 0], [1, 1, 0], [2, 0, 0]], weights = [1, 2, 1] }
[[curve]]
name = "ring"
circle = { center = [1, 0, 1], normal = [0, 0, 1], radius = 0.5 }
[[method]]
name = "least area"
energy = "area"
"#;

const FACES: &str = r#"title = "Faces"
[[curve]]
name = "south"
ends = ["a", "b"]
polyline = [[0, 0, 0], [1, 0, 0]]
[[curve]]
name = "east"
ends = ["b", "c"]
through = { points = [[1, 0, 0], [1, 0.5, 0.1], [1, 1, 0]], tolerance = 1e-6 }
[[curve]]
name = "north"
ends = ["c", "a"]
circle = { center = [0.5, 0.5, 0], normal = [0, 0, 1], radius = 0.7071067811865476, from = [1, 1, 0], arc = [0, 180] }
[[face]]
vertices = ["a", "b", "o"]
[[face]]
vertices = ["b", "c", "o"]
[[face]]
vertices = ["c", "a", "o"]
[[vertex]]
name = "o"
point = [0.5, 0.5, 0.25]
[[method]]
name = "Dirichlet"
energy = "dirichlet"
layers = 0
"#;

struct Mutant {
    name: &'static str,
    base: &'static str,
    /// Each `old` stands once in the base.
    edits: &'static [(&'static str, &'static str)],
    fault: Fault,
    says: &'static [&'static str],
}

const fn mutant(
    name: &'static str,
    base: &'static str,
    edits: &'static [(&'static str, &'static str)],
    fault: Fault,
    says: &'static [&'static str],
) -> Mutant {
    Mutant { name, base, edits, fault, says }
}

use Fault::{Conflict, Inadmissible, Missing, Syntax, UnknownKey, WrongType};

#[rustfmt::skip]
const MUTANTS: &[Mutant] = &[
    // Syntax.
    mutant("unclosed list", BILINEAR, &[("[1, 1, 0]]\nv0", "[1, 1, 0]\n«»v0")], Syntax, &["TOML", "not closed"]),
    mutant("missing value", TENSOR, &[("seed = 7", "seed =«»")], Syntax, &["a value is missing"]),
    mutant("unclosed text", TENSOR, &[("title = \"Net\"", "title = \"Net«»")], Syntax, &["TOML"]),
    mutant("unquoted text", TENSOR, &[("basis = \"gt\"", "basis = «gt»")], Syntax, &["quotes"]),
    mutant("duplicate key", TENSOR, &[("basis = \"gt\"", "basis = \"gt\"\n«basis» = \"gt\"")], Syntax, &["second time", "keep one"]),
    mutant("second boundary", TENSOR, &[("[output]", "[«boundary»]\nu0 = []\n[output]")], Syntax, &["boundary", "second time"]),
    // Unknown keys.
    mutant("unknown table", TENSOR, &[("[search]", "[«serach»]")], UnknownKey, &["serach", "did you mean `search`?"]),
    mutant("unknown root key", TENSOR, &[("seed = 7", "«colour» = 7")], UnknownKey, &["colour", "may hold", "title"]),
    mutant("misspelt title", TENSOR, &[("title", "«titel»")], UnknownKey, &["did you mean `title`?"]),
    mutant("misspelt energy", TENSOR, &[("energy = \"bending\"", "«engery» = \"bending\"")], UnknownKey, &["[[method]]", "did you mean `energy`?"]),
    mutant("unknown side", TENSOR, &[("v1 =", "«v2» =")], UnknownKey, &["[boundary]", "v2", "the keys of [boundary] are"]),
    mutant("capitals", TENSOR, &[("particles", "«Particles»")], UnknownKey, &["did you mean `particles`?"]),
    mutant("snake case", TENSOR, &[("energy = \"dirichlet\"\nsearch", "energy = \"dirichlet\"\n«search_energy» = \"area\"\nsearch")], UnknownKey, &["did you mean `search-energy`?"]),
    mutant("american spelling", TENSOR, &[("neighbours", "«neighbors»")], UnknownKey, &["did you mean `neighbours`?"]),
    mutant("unknown expectation", TENSOR, &[("dirichlet = 38.35", "«dirichlett» = 38.35")], UnknownKey, &["[method.expect]", "did you mean `dirichlet`?"]),
    mutant("unknown published key", TENSOR, &[("source =", "«sauce» =")], UnknownKey, &["did you mean `source`?"]),
    mutant("unknown toleranced key", TENSOR, &[("dirichlet = 38.35", "dirichlet = { value = 38.35, «tol» = 1e-3 }")], UnknownKey, &["did you mean `tolerance`?"]),
    mutant("unknown output key", TENSOR, &[("mesh", "«meshes»")], UnknownKey, &["[output]", "did you mean `mesh`?"]),
    mutant("unknown helicoid key", HELICOID, &[("u-span", "«uspan»")], UnknownKey, &["did you mean `u-span`?"]),
    mutant("unknown curve key", CURVE, &[("samples", "«sample»")], UnknownKey, &["did you mean `samples`?"]),
    // Wrong types.
    mutant("title a number", TENSOR, &[("\"Net\"", "«3»")], WrongType, &["title", "text in quotes"]),
    mutant("seed a text", TENSOR, &[("seed = 7", "seed = «\"7\"»")], WrongType, &["seed", "a whole number"]),
    mutant("seed a float", TENSOR, &[("seed = 7", "seed = «7.0»")], WrongType, &["seed", "without a decimal point"]),
    mutant("coordinate a text", TENSOR, &[("[2, 0, 2]", "[2, «\"0\"», 2]")], WrongType, &["u0", "expected a number"]),
    mutant("point a number", TENSOR, &[("[[0, 0, 0], [2, 0, 2]", "[[0, 0, 0], «2»")], WrongType, &["u0", "a point"]),
    mutant("side a text", TENSOR, &[("[[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]", "«\"row\"»")], WrongType, &["u1", "list of points"]),
    mutant("search a number", TENSOR, &[("search = true", "search = «1»")], WrongType, &["search", "pso-polish"]),
    mutant("method with single brackets", BILINEAR, &[("[[method]]", "«[method]»")], WrongType, &["[[method]]", "two brackets"]),
    mutant("search with two brackets", TENSOR, &[("[search]", "«[[search]]»")], WrongType, &["single brackets"]),
    mutant("particles a list", TENSOR, &[("particles = 50", "particles = «[50]»")], WrongType, &["particles", "a whole number"]),
    mutant("box a number", TENSOR, &[("box = [0.5, 3.5]", "box = «3.5»")], WrongType, &["box", "list of numbers"]),
    mutant("mask true", TRIANGLE, &[("mask = \"dirichlet\"", "mask = «true»")], WrongType, &["mask", "corner weight"]),
    mutant("samples a float", CURVE, &[("samples = [0.0, 0.25, 1.0]", "samples = «3.5»")], WrongType, &["samples", "list of parameters"]),
    mutant("expected text", TENSOR, &[("dirichlet = 38.35", "dirichlet = «\"38.35\"»")], WrongType, &["dirichlet", "a number"]),
    mutant("boundary a number", "title = \"x\"\nboundary = 3\n[[method]]\nname = \"a\"\nenergy = \"area\"\n", &[("3", "«3»")], WrongType, &["boundary", "a table"]),
    mutant("overflowing coordinate", TENSOR, &[("[2, 0, 2]", "[2, «1e999», 2]")], Inadmissible, &["too large"]),
    mutant("overflowing seed", TENSOR, &[("seed = 7", "seed = «99999999999999999999999999999999999999999»")], Inadmissible, &["seed", "too large"]),
    // Title, seed.
    mutant("no title", TENSOR, &[("title = \"Net\"", "«»")], Missing, &["title", "begin the file with title"]),
    mutant("empty title", TENSOR, &[("\"Net\"", "«\" \"»")], Inadmissible, &["title", "empty"]),
    mutant("negative seed", TENSOR, &[("seed = 7", "seed = «-7»")], Inadmissible, &["seed", "between 0 and 2^63"]),
    mutant("seed of 2^63", TENSOR, &[("seed = 7", "seed = «9223372036854775808»")], Inadmissible, &["seed", "9223372036854775807"]),
    // Subjects.
    mutant("no subject", "title = \"x\"\n", &[("title", "«»title")], Missing, &["[boundary]", "[helicoid]", "[curve]"]),
    mutant("methods without boundary", "title = \"x\"\n[[method]]\nname = \"a\"\nenergy = \"area\"\n", &[("title", "«»title")], Missing, &["[boundary]", "u0"]),
    mutant("boundary without methods", "title = \"x\"\n[boundary]\nab = [[0,0,0],[1,0,0]]\nbc = [[1,0,0],[0,1,0]]\nca = [[0,1,0],[0,0,0]]\n", &[("[boundary]", "«[boundary]»")], Missing, &["[[method]]", "add a table"]),
    mutant("two subjects", HELICOID, &[("[expect]", "«[curve]»\nbasis = \"bernstein\"\n[expect]")], Conflict, &["[helicoid]", "[curve]", "two files"]),
    mutant("method beside helicoid", HELICOID, &[("[expect]", "«[[method]]»\nname = \"a\"\n[expect]")], Conflict, &["[[method]]", "[helicoid]", "take"]),
    mutant("search beside curve", CURVE, &[("samples = [0.0, 0.25, 1.0]\n", "«[search]»\nruns = 3\n")], Conflict, &["[search]", "[curve]"]),
    mutant("expect beside methods", TENSOR, &[("[output]", "«[expect]»\narea = 1.0\n[output]")], Conflict, &["[expect]", "[method.expect]"]),
    mutant("no method in the list", "title = \"x\"\nmethod = []\n[boundary]\nab = [[0,0,0],[1,0,0]]\nbc = [[1,0,0],[0,1,0]]\nca = [[0,1,0],[0,0,0]]\n", &[("[]", "«[]»")], Inadmissible, &["empty", "add a table [[method]]"]),
    // Boundary.
    mutant("empty boundary", "title = \"x\"\n[boundary]\n[[method]]\nname = \"a\"\nenergy = \"area\"\n", &[("[boundary]", "«[boundary]»")], Missing, &["u0", "ab from A to B"]),
    mutant("missing column", TENSOR, &[("[boundary]", "«[boundary]»"), ("v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]\n", "")], Missing, &["v1", "four lists"]),
    mutant("missing triangle side", TRIANGLE, &[("[boundary]", "«[boundary]»"), ("ca = [[0, 3, 0], [0, 2, 0], [0, 1, 0], [0, 0, 0]]\n", "")], Missing, &["ca", "three lists"]),
    mutant("rows of different lengths", TENSOR, &[("[[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]", "«[[0, 6, 0], [2, 6, 2], [6, 6, 0]]»")], Conflict, &["u0", "u1", "4 and 3 points"]),
    mutant("triangle sides of different lengths", TRIANGLE, &[("[[3, 0, 0], [2, 1, 1], [1, 2, 1], [0, 3, 0]]", "«[[3, 0, 0], [2, 1, 1], [0, 3, 0]]»")], Conflict, &["ab", "bc", "4 and 3"]),
    mutant("corner P00", TENSOR, &[("v0 = [[0, 0, 0]", "v0 = [«[0, 0, 1]»")], Conflict, &["u0", "v0", "P_00", "[0, 0, 0]", "[0, 0, 1]"]),
    mutant("corner P0n", TENSOR, &[("v1 = [[6, 0, 0]", "v1 = [«[6, 0.5, 0]»")], Conflict, &["u0", "v1", "P_0n", "[6, 0.5, 0]"]),
    mutant("a format without a likeness", TENSOR, &[("formats = [\"obj\"]", "formats = [«\"dxf\"»]")], Inadmissible, &["formats = [\"obj\"]"]),
    mutant("a side reversed", BILINEAR, &[("u1 = [[0, 1, 0], [1, 1, 0]]", "u1 = «[[1, 1, 0], [0, 1, 0]]»")], Conflict, &["`u1` in [boundary] runs in the wrong direction", "other order"]),
    mutant("sides around", BILINEAR, &[("u1 = [[0, 1, 0], [1, 1, 0]]", "u1 = «[[1, 1, 0], [0, 1, 0]]»"), ("v0 = [[0, 0, 0], [0, 1, 0]]", "v0 = [[0, 1, 0], [0, 0, 0]]")], Conflict, &["`u1` and `v0` in [boundary] run", "other order"]),
    mutant("rows and columns exchanged", BILINEAR, &[("u0 = [[0, 0, 0], [1, 0, 1]]", "u0 = «[[0, 0, 0], [0, 1, 0]]»"), ("v0 = [[0, 0, 0], [0, 1, 0]]", "v0 = [[0, 0, 0], [1, 0, 1]]")], Conflict, &["`u0` and `v0` in [boundary] are exchanged", "write these points as `v0`"]),
    mutant("sides of two degrees exchanged", BILINEAR, &[("u0 = [[0, 0, 0], [1, 0, 1]]", "u0 = [[0, 0, 0], [0.5, 0, 0], [1, 0, 1]]"), ("u1 = [[0, 1, 0], [1, 1, 0]]", "u1 = «[[0, 0, 0], [0, 1, 0]]»"), ("v0 = [[0, 0, 0], [0, 1, 0]]", "v0 = [[0, 1, 0], [0.5, 1, 0], [1, 1, 0]]")], Conflict, &["`u1` and `v0` in [boundary] are exchanged"]),
    mutant("a side of a triangle under another name", TRIANGLE, &[("ab = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]", "ab = «[[0, 3, 0], [0, 2, 0], [0, 1, 0], [0, 0, 0]]»"), ("ca = [[0, 3, 0], [0, 2, 0], [0, 1, 0], [0, 0, 0]]", "ca = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]")], Conflict, &["`ab` and `ca` in [boundary] are exchanged"]),
    mutant("a domain of a net", TENSOR, &[("basis = \"bernstein\"", "domain = «\"equilateral\"»")], Conflict, &["`domain`", "not for a tensor boundary", "triangle"]),
    mutant("a domain of a mask", TRIANGLE, &[("mask = \"dirichlet\"", "mask = \"dirichlet\"\ndomain = «\"equilateral\"»")], Conflict, &["`domain`", "no extremal"]),
    mutant("another domain", TRIANGLE, &[("mask = \"dirichlet\"", "energy = \"dirichlet\"\ndomain = «\"regular\"»")], Inadmissible, &["\"right\"", "\"equilateral\""]),
    mutant("a triangle of a high degree", TRIANGLE, &[("mask = \"dirichlet\"", "energy = «\"bending\"»\nraise = 22")], Conflict, &["degree 25", "offered to degree 24", "raise by at most 21"]),
    mutant("a least area of a high degree", TENSOR, &[("basis = \"bernstein\"", "basis = \"gt\"\nshape = [1, 1, 1, 1]"), ("energy = \"bending\"", "energy = «\"area\"»\nraise = 30")], Conflict, &["degree 33", "to degree 32", "raise by at most 29", "leave out `basis`", "energy = \"dirichlet\""]),
    mutant("a least area of blends of a high degree", TENSOR, &[("basis = \"bernstein\"", "patch = \"tb-coons\"\nshape = [1, 1, 1, 1]"), ("energy = \"bending\"", "energy = «\"area\"»\nraise = 10")], Conflict, &["degree 13", "to degree 12", "raise by at most 9", "leave out `patch`"]),
    mutant("a least area of a high degree over a triangle", TRIANGLE, &[("mask = \"dirichlet\"", "energy = «\"area\"»\nraise = 16")], Conflict, &["degree 19", "to degree 18", "raise by at most 15", "mask = \"dirichlet\""]),
    mutant("metric steps of a high degree", TENSOR, &[("energy = \"bending\"", "energy = \"dirichlet\"\nraise = 11\nmetric-steps = «1»")], Conflict, &["degree 14", "to degree 13", "energy = \"area\""]),
    mutant("a harmonic net of a high degree", ROWS, &[("u-degree = 3", "u-degree = 21"), ("construction = \"harmonic\"", "construction = «\"harmonic\"»")], Conflict, &["degree 21", "to degree 20"]),
    mutant("a search for another energy at a high degree", TENSOR, &[("search = true", "search = true\nraise = 14\nsearch-energy = «\"bending\"»")], Conflict, &["degree 17", "to degree 16", "leave out `search-energy`"]),
    mutant("round brackets", BILINEAR, &[("u1 = [[0, 1, 0],", "u1 = [«(0», 1, 0),")], Syntax, &["square brackets"]),
    mutant("corner Pm0", TENSOR, &[("[0, 4, -2], [0, 6, 0]", "[0, 4, -2], «[0, 6, 2]»")], Conflict, &["u1", "v0", "P_m0", "[0, 6, 2]", "the same"]),
    mutant("corner Pmn", TENSOR, &[("[6, 4, -2], [6, 6, 0]", "[6, 4, -2], «[6, 6, 1e-4]»")], Conflict, &["u1", "v1", "P_mn", "0.0001", "a millionth of the size"]),
    mutant("corner B", TRIANGLE, &[("bc = [[3, 0, 0]", "bc = [«[3, 0, 1]»")], Conflict, &["ab", "bc", "corner B"]),
    mutant("corner A", TRIANGLE, &[("[0, 1, 0], [0, 0, 0]]", "[0, 1, 0], «[0, 0, 5]»]")], Conflict, &["ab", "ca", "corner A"]),
    mutant("planar boundary point", TENSOR, &[("[2, 0, 2]", "«[2, 0]»")], Inadmissible, &["2 coordinates", "third coordinate"]),
    mutant("four coordinates", TENSOR, &[("[2, 6, 2]", "«[2, 6, 2, 1]»")], Inadmissible, &["4 coordinates instead of 3", "[x, y, z]"]),
    mutant("nan", TENSOR, &[("[2, 6, 2]", "[2, 6, «nan»]")], Inadmissible, &["z of point 1", "u1", "not finite"]),
    mutant("infinity", TENSOR, &[("[2, 6, 2]", "[«-inf», 6, 2]")], Inadmissible, &["x of point 1", "not finite"]),
    mutant("huge coordinate", TENSOR, &[("[2, 6, 2]", "[2, «1e61», 2]")], Inadmissible, &["y of point 1", "1e60"]),
    mutant("largest double", TENSOR, &[("[2, 6, 2]", "[2, 6, «-1.7e308»]")], Inadmissible, &["z of point 1", "1e60"]),
    mutant("tiny boundary", BILINEAR, &[("u0 = [[0, 0, 0], [1, 0, 1]]", "u0 = [[0, 0, 0], [«1e-61», 0, 0]]"), ("u1 = [[0, 1, 0], [1, 1, 0]]", "u1 = [[0, 0, 0], [0, 0, 0]]"), ("v0 = [[0, 0, 0], [0, 1, 0]]", "v0 = [[0, 0, 0], [0, 0, 0]]"), ("v1 = [[1, 0, 1], [1, 1, 0]]", "v1 = [[1e-61, 0, 0], [0, 0, 0]]")], Inadmissible, &["too small", "x of point 1 of `u0`", "1e-61", "smaller unit"]),
    mutant("denormal boundary", BILINEAR, &[("u0 = [[0, 0, 0], [1, 0, 1]]", "u0 = [[0, 0, 0], [«5e-324», 0, 0]]"), ("u1 = [[0, 1, 0], [1, 1, 0]]", "u1 = [[0, 0, 0], [0, 0, 0]]"), ("v0 = [[0, 0, 0], [0, 1, 0]]", "v0 = [[0, 0, 0], [0, 0, 0]]"), ("v1 = [[1, 0, 1], [1, 1, 0]]", "v1 = [[5e-324, 0, 0], [0, 0, 0]]")], Inadmissible, &["too small", "5e-324"]),
    mutant("tiny helicoid", HELICOID, &[("a = 1.0", "a = 1e-40"), ("b = 2.0", "b = «-1e-300»")], Inadmissible, &["too small", "1e-30"]),
    mutant("one point", BILINEAR, &[("[[0, 0, 0], [1, 0, 1]]", "«[[0, 0, 0]]»")], Inadmissible, &["1 point", "at least 2"]),
    mutant("triangle and net", TRIANGLE, &[("ab = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]", "ab = «[[0, 0, 0], [3, 0, 0]]»\nu0 = [[0, 0, 0]]")], Conflict, &["ab", "u0", "keep one kind"]),
    mutant("false degree", TENSOR, &[("[boundary]", "[boundary]\nu-degree = «4»")], Conflict, &["u-degree", "leave out"]),
    mutant("degree of zero", ROWS, &[("u-degree = 3", "u-degree = «0»")], Inadmissible, &["u-degree", "between 1 and 64"]),
    mutant("huge degree", ROWS, &[("u-degree = 3", "u-degree = «1000000000»")], Inadmissible, &["u-degree", "64"]),
    mutant("one row", ROWS, &[("[boundary]", "«[boundary]»"), ("u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]\n", "")], Missing, &["u1"]),
    // Methods.
    mutant("method without name", TENSOR, &[("[[method]]\nname = \"second\"", "«[[method]]»")], Missing, &["method 2", "name"]),
    mutant("blank name", TENSOR, &[("\"second\"", "«\"\"»")], Inadmissible, &["name", "empty"]),
    mutant("same name twice", TENSOR, &[("\"second\"", "«\"first\"»")], Conflict, &["\"first\"", "its own name"]),
    mutant("no interior", TENSOR, &[("[[method]]\nname = \"second\"", "«[[method]]»\nname = \"second\""), ("energy = \"bending\"\n", "")], Missing, &["\"second\"", "energy", "mask", "construction"]),
    mutant("unknown energy", TENSOR, &[("\"bending\"", "«\"bend\"»")], Inadmissible, &["bend", "did you mean \"bending\"?"]),
    mutant("unrecognisable energy", TENSOR, &[("\"bending\"", "«\"willmore\"»")], Inadmissible, &["willmore", "\"laplacian\"", "energy = \"dirichlet\""]),
    mutant("unknown basis", TENSOR, &[("\"gt\"", "«\"gta\"»")], Inadmissible, &["basis", "did you mean \"gt\"?"]),
    mutant("unknown patch", TENSOR, &[("basis = \"gt\"", "patch = «\"coons\"»\nbasis = \"gt\"")], Inadmissible, &["patch", "did you mean \"tb-coons\"?"]),
    mutant("unknown search", TENSOR, &[("search = true", "search = «\"swarm\"»")], Inadmissible, &["search", "pso"]),
    mutant("shape outside", TENSOR, &[("search = true", "shape = [1, 1, «4.5», 1]")], Inadmissible, &["[0, 4]", "4.5"]),
    mutant("shape negative", TENSOR, &[("search = true", "shape = [«-0.1», 1, 1, 1]")], Inadmissible, &["[0, 4]", "-0.1"]),
    mutant("shape nan", TENSOR, &[("search = true", "shape = [1, 1, 1, «nan»]")], Inadmissible, &["[0, 4]", "NaN"]),
    mutant("first pair zero", TENSOR, &[("search = true", "shape = [«0, 0.0», 1, 1]")], Inadmissible, &["(0, 0)", "dependent"]),
    mutant("second pair zero", TENSOR, &[("search = true", "shape = [1, 1, «0, 0»]")], Inadmissible, &["second pair"]),
    mutant("short shape", TENSOR, &[("search = true", "shape = «[1, 1]»")], Inadmissible, &["2 numbers instead of 4", "α1, α2, β1, β2"]),
    mutant("shape and search", TENSOR, &[("search = true", "search = «true»\nshape = [1, 1, 1, 1]")], Conflict, &["gives and searches", "keep `shape`"]),
    mutant("gt without shape", TENSOR, &[("[[method]]\nname = \"first\"", "«[[method]]»\nname = \"first\""), ("search = true\n", "")], Missing, &["shape", "search = true"]),
    mutant("search = false without shape", TENSOR, &[("[[method]]\nname = \"first\"", "«[[method]]»\nname = \"first\""), ("search = true\n", "search = false\n")], Missing, &["shape"]),
    mutant("shape for bernstein", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nshape = «[1, 1, 1, 1]»")], Conflict, &["shape", "Bernstein", "basis = \"gt\""]),
    mutant("search for bernstein", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nsearch = «\"pso\"»")], Conflict, &["search", "no shape parameters"]),
    mutant("tb-coons in bernstein", TENSOR, &[("basis = \"bernstein\"", "patch = \"tb-coons\"\nbasis = «\"bernstein\"»")], Conflict, &["TB–Coons", "leave out `basis`"]),
    mutant("mask and energy", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nmask = «-0.25»")], Conflict, &["`energy` and `mask`", "keep one"]),
    mutant("construction and energy", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nconstruction = «\"harmonic\"»")], Conflict, &["`energy` and `construction`"]),
    mutant("named mask on a net", TENSOR, &[("energy = \"bending\"", "mask = «\"coons\"»")], Conflict, &["tensor", "mask = -0.25"]),
    mutant("infinite mask", TENSOR, &[("energy = \"bending\"", "mask = «inf»")], Inadmissible, &["mask", "corner weight"]),
    mutant("unknown mask", TRIANGLE, &[("\"dirichlet\"", "«\"dirichlt\"»")], Inadmissible, &["did you mean \"dirichlet\"?"]),
    mutant("unknown construction", TENSOR, &[("energy = \"bending\"", "construction = «\"coons\"»")], Inadmissible, &["construction", "did you mean \"discrete-coons\"?"]),
    mutant("metric steps without dirichlet", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nmetric-steps = «2»")], Conflict, &["metric-steps", "energy = \"dirichlet\""]),
    mutant("a tolerance of a linear solve", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\ntolerance = «1e-7»")], Conflict, &["tolerance", "energy = \"area\""]),
    mutant("too loose a tolerance", TENSOR, &[("energy = \"bending\"", "energy = \"area\"\ntolerance = «0.5»")], Inadmissible, &["tolerance", "between 1e-12 and 0.01"]),
    mutant("negative metric steps", TENSOR, &[("energy = \"bending\"", "energy = \"dirichlet\"\nmetric-steps = «-1»")], Inadmissible, &["metric-steps", "between 0 and 1000"]),
    mutant("degree raised too far", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nraise = «62»")], Conflict, &["degree 65", "limit 64", "at most 61"]),
    mutant("negative raise", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nraise = «-1»")], Inadmissible, &["raise", "between 0 and 64"]),
    mutant("gt of degree 1", BILINEAR, &[("energy", "shape = [1, 1, 1, 1]\nbasis = «\"gt\"»\nenergy")], Conflict, &["degree 1", "raise = 1"]),
    mutant("patch on a triangle", TRIANGLE, &[("mask", "patch = «\"tensor\"»\nmask")], Conflict, &["patch", "triangular", "leave out", "tensor"]),
    mutant("gt on a triangle", TRIANGLE, &[("mask", "basis = «\"gt\"»\nmask")], Conflict, &["GT", "triang"]),
    mutant("harmonic on a triangle", TRIANGLE, &[("mask = \"dirichlet\"", "construction = «\"harmonic\"»")], Conflict, &["harmonic", "triangle"]),
    mutant("harmonic tb-coons", TENSOR, &[("energy = \"dirichlet\"", "patch = \"tb-coons\"\nconstruction = «\"harmonic\"»")], Conflict, &["harmonic", "TB–Coons"]),
    mutant("energy on two rows", ROWS, &[("[[method]]", "«[[method]]»"), ("construction = \"harmonic\"", "energy = \"dirichlet\"")], Conflict, &["all four sides", "harmonic"]),
    mutant("raised harmonic net", ROWS, &[("construction = \"harmonic\"", "construction = \"harmonic\"\nraise = «1»")], Conflict, &["raise", "harmonic"]),
    mutant("search energy without search", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nsearch-energy = «\"area\"»")], Conflict, &["search-energy", "search = true"]),
    mutant("searched mask without energy", TENSOR, &[("[[method]]\nname = \"first\"", "«[[method]]»\nname = \"first\""), ("energy = \"dirichlet\"", "mask = 0.1")], Missing, &["search-energy", "dirichlet"]),
    mutant("separable bending", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nsolver = «\"separable\"»")], Conflict, &["separable", "auto"]),
    mutant("sparse extremal", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nsolver = «\"sparse\"»")], Conflict, &["sparse", "masks"]),
    mutant("unknown solver", TENSOR, &[("energy = \"bending\"", "energy = \"bending\"\nsolver = «\"cholesky\"»")], Inadmissible, &["solver", "\"dense\""]),
    // Search.
    mutant("unknown variant", TENSOR, &[("\"global\"", "«\"ring\"»")], Inadmissible, &["variant", "\"local\""]),
    mutant("no particles", TENSOR, &[("particles = 50", "particles = «0»")], Inadmissible, &["particles", "between 1 and"]),
    mutant("negative iterations", TENSOR, &[("iterations = 100", "iterations = «-100»")], Inadmissible, &["iterations", "between 1 and"]),
    mutant("too many particles", TENSOR, &[("particles = 50", "particles = «1000000000000»")], Inadmissible, &["particles", "100000"]),
    mutant("too large a budget", TENSOR, &[("particles = 50", "particles = 100000"), ("iterations = 100", "iterations = «1000000»")], Inadmissible, &["100000 particles × 1000000 iterations × 10 runs", "lower"]),
    mutant("runs a billion", TENSOR, &[("runs = 10", "runs = «1000000000»")], Inadmissible, &["runs", "10000"]),
    mutant("inertia above one", TENSOR, &[("inertia = 0.7", "inertia = «1.7»")], Inadmissible, &["inertia", "between 0 and 1"]),
    mutant("inertia nan", TENSOR, &[("inertia = 0.7", "inertia = «nan»")], Inadmissible, &["inertia", "finite"]),
    mutant("box reversed", TENSOR, &[("[0.5, 3.5]", "«[3.5, 0.5]»")], Inadmissible, &["box", "3.5 is not below 0.5"]),
    mutant("box outside", TENSOR, &[("[0.5, 3.5]", "[0.5, «4.5»]")], Inadmissible, &["box", "[0, 4]", "4.5"]),
    mutant("box of three", TENSOR, &[("[0.5, 3.5]", "«[0.5, 3.5, 4]»")], Inadmissible, &["box", "3 numbers instead of 2"]),
    mutant("no neighbours", TENSOR, &[("neighbours = 2", "neighbours = «0»")], Inadmissible, &["neighbours"]),
    // Expected and published numbers.
    mutant("expected nan", TENSOR, &[("dirichlet = 38.35", "dirichlet = «nan»")], Inadmissible, &["dirichlet", "finite"]),
    mutant("expected list", TENSOR, &[("dirichlet = 38.35", "dirichlet = «[38.35]»")], Inadmissible, &["dirichlet", "one number"]),
    mutant("expected shape of bernstein", TENSOR, &[("dirichlet = 38.35", "shape = «0.87»")], Conflict, &["shape", "Bernstein"]),
    mutant("expected search of bernstein", TENSOR, &[("dirichlet = 38.35", "search-minimum = «37.4»")], Conflict, &["search-minimum", "search = true"]),
    mutant("expected deviation of a patch", TENSOR, &[("dirichlet = 38.35", "deviation = «0.0»")], Conflict, &["deviation", "boundary-deviation"]),
    mutant("tolerance missing", TENSOR, &[("dirichlet = 38.35", "dirichlet = «{ value = 38.35 }»")], Missing, &["tolerance"]),
    mutant("negative tolerance", TENSOR, &[("dirichlet = 38.35", "dirichlet = { value = 38.35, tolerance = «-1e-3» }")], Inadmissible, &["tolerance", "0 or positive"]),
    mutant("published without source", TENSOR, &[("[method.published]", "«[method.published]»"), ("source = \"GT Table 1\"\n", "")], Missing, &["source", "GT Table 1"]),
    mutant("published unknown quantity", TENSOR, &[("quantity = \"dirichlet\"", "quantity = «\"Dirichlet energy\"»")], Inadmissible, &["quantity", "did you mean \"dirichlet\"?"]),
    mutant("printed infinity", TENSOR, &[("printed = 38.0000", "printed = «inf»")], Inadmissible, &["printed", "finite"]),
    // Output.
    mutant("mesh of one", TENSOR, &[("mesh = 48", "mesh = «1»")], Inadmissible, &["mesh", "between 2 and 2000"]),
    mutant("mesh of 10^10", TENSOR, &[("mesh = 48", "mesh = «10000000000»")], Inadmissible, &["mesh", "2000"]),
    mutant("unknown format", TENSOR, &[("[\"obj\"]", "[«\"objs\"»]")], Inadmissible, &["formats", "did you mean \"obj\"?"]),
    mutant("pictures by number", TENSOR, &[("formats = [", "pictures = «1»\nformats = [")], WrongType, &["pictures", "true or false"]),
    mutant("STEP tolerance of nothing", TENSOR, &[("formats = [", "step-tolerance = «0»\nformats = [")], Inadmissible, &["step-tolerance", "above 0", "1e-6"]),
    // Helicoids.
    mutant("helicoid without b", HELICOID, &[("[helicoid]", "«[helicoid]»"), ("b = 2.0\n", "")], Missing, &["`b`"]),
    mutant("helicoid of nothing", HELICOID, &[("a = 1.0", "a = 0"), ("b = 2.0", "b = «0»")], Inadmissible, &["catenoid"]),
    mutant("negative u-span", HELICOID, &[("u-span = 1.5", "u-span = «-1.5»")], Inadmissible, &["u-span", "between 1e-6 and 100"]),
    mutant("infinite v-span", HELICOID, &[("v-span = 6.0", "v-span = «inf»")], Inadmissible, &["v-span", "finite"]),
    mutant("huge u-span", HELICOID, &[("u-span = 1.5", "u-span = «1e6»")], Inadmissible, &["u-span", "between 1e-6 and 100"]),
    mutant("one frame", HELICOID, &[("frames = 11", "frames = «1»")], Inadmissible, &["frames", "between 2 and 1000"]),
    mutant("path without frames", HELICOID, &[("frames = 11\n", ""), ("\"linear\"", "«\"linear\"»")], Conflict, &["path", "frames = 11"]),
    mutant("unknown path", HELICOID, &[("\"linear\"", "«\"lineal\"»")], Inadmissible, &["did you mean \"linear\"?"]),
    mutant("expected shape of a helicoid", HELICOID, &[("deviation = 0.000", "shape = «1.0»")], Conflict, &["shape", "deviation"]),
    mutant("path without its degree", HELICOID, &[("[helicoid]", "«[helicoid]»"), ("\"linear\"", "\"bernstein\"")], Missing, &["path-degree = 3"]),
    mutant("degree of a linear path", HELICOID, &[("\"linear\"", "\"linear\"\npath-degree = «3»")], Conflict, &["path-degree", "bernstein"]),
    mutant("path of degree zero", HELICOID, &[("\"linear\"", "\"bernstein\"\npath-degree = «0»")], Inadmissible, &["between 1 and 64"]),
    mutant("frames times mesh", HELICOID, &[("frames = 11", "frames = «1000»"), ("deviation = 0.000", "deviation = 0.000\n[output]\nmesh = 100")], Inadmissible, &["10201000 vertices", "mesh = 62"]),
    mutant("frames times patches", HELICOID, &[("frames = 11", "frames = «100»"), ("v-span = 6.0", "v-span = 1000"), ("u-span = 1.5", "u-span = 14")], Inadmissible, &["100 frames of 284 patches", "at most 20000"]),
    mutant("helicoid smaller than rounding", HELICOID, &[("u-span = 1.5", "u-span = «1e-7»")], Inadmissible, &["between 1e-6 and 100"]),
    mutant("trapezium of no length", TRAPEZIUM, &[("span = 3.9", "span = «0.0»")], Inadmissible, &["span", "between 1e-6 and 1000"]),
    mutant("trapezium of a thousand turns", TRAPEZIUM, &[("span = 3.9", "span = «6283.2»")], Inadmissible, &["between 1e-6 and 1000", "6.220"]),
    mutant("gamma of one", TRAPEZIUM, &[("gamma = [6.2, 12.5]", "gamma = «[6.2]»")], Inadmissible, &["gamma", "1 number instead of 2"]),
    mutant("crossing sides", TRAPEZIUM, &[("beta = [1.0, 0.5]", "beta = «[3.0, 0.0]»")], Conflict, &["cross at v = 2.1", "keep apart"]),
    mutant("coinciding sides", TRAPEZIUM, &[("gamma = [6.2, 12.5]", "gamma = [1, 1]"), ("beta = [1.0, 0.5]", "beta = «[1, 1]»")], Conflict, &["coincide"]),
    mutant("unknown construction of a helicoid", TRAPEZIUM, &[("span = 3.9", "span = 3.9\nconstruction = «\"geometry\"»")], Inadmissible, &["did you mean \"geometric\"?"]),
    // Nets of one's own.
    mutant("net without a basis", NET, &[("[net]", "«[net]»"), ("basis = \"at\"\n", "")], Missing, &["`basis`"]),
    mutant("net without its span", NET, &[("[net]", "«[net]»"), ("v-span = 3.0\n", "")], Missing, &["`v-span`", "2π"]),
    mutant("net of more than a turn", NET, &[("v-span = 3.0", "v-span = «6.5»")], Inadmissible, &["v-span", "below 6.28", "cut"]),
    mutant("span of a linear direction", NET, &[("v-span = 3.0", "v-span = 3.0\nu-span = «1.0»")], Conflict, &["u-span", "linear"]),
    mutant("cuts of a linear direction", NET, &[("v-span = 3.0", "v-span = 3.0\nu-cuts = «[0.5]»")], Conflict, &["u-cuts", "linear"]),
    mutant("cut at the end", NET, &[("[1.0, 2.0]", "[1.0, «3.0»]")], Inadmissible, &["v-cuts", "leaves no interval", "ascend"]),
    mutant("cuts that descend", NET, &[("[1.0, 2.0]", "[«2.0», 1.0]")], Inadmissible, &["v-cuts", "ascend"]),
    mutant("cut at zero", NET, &[("[1.0, 2.0]", "[«0.0», 1.0]")], Inadmissible, &["v-cuts"]),
    mutant("own net with rows of different length", NET, &[("[[1, 0, 1], [1, 1, 1], [1, 2, 0], [1, 3, 0], [1, 4, 1], [1, 5, 1]]", "«[[1, 0, 1], [1, 1, 1], [1, 2, 0], [1, 3, 0], [1, 4, 1]]»")], Conflict, &["row 1", "5 points", "row 0 has 6"]),
    mutant("net in a polynomial basis with a span", NET, &[("basis = \"at\"", "basis = \"bernstein\""), ("v-span = 3.0", "v-span = «3.0»")], Conflict, &["v-span", "\"bernstein\"", "\"aht\" and \"at\""]),
    mutant("gt net of two rows", NET, &[("basis = \"at\"\nv-span = 3.0\nv-cuts = [1.0, 2.0]\n", "basis = \"gt\"\nshape = [1, 1, 1, 1]\n"), ("points = [\n  [[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0], [0, 4, 0], [0, 5, 0]],\n  [[1, 0, 1], [1, 1, 1], [1, 2, 0], [1, 3, 0], [1, 4, 1], [1, 5, 1]],\n]", "points = «[\n  [[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0], [0, 4, 0], [0, 5, 0]],\n  [[1, 0, 1], [1, 1, 1], [1, 2, 0], [1, 3, 0], [1, 4, 1], [1, 5, 1]],\n]»")], Inadmissible, &["2 × 6", "3 or more"]),
    mutant("net with nan", NET, &[("[1, 4, 1]", "[1, «nan», 1]")], Inadmissible, &["y of point 4", "not finite"]),
    mutant("net and helicoid", HELICOID, &[("[helicoid]", "«[net]»\nbasis = \"at\"\n[helicoid]")], Conflict, &["both [helicoid] and [net]"]),
    mutant("expected deviation of a net", NET, &[("area = {", "deviation = «0.0»\narea = {")], Conflict, &["deviation", "no closed form"]),
    // Loops.
    mutant("polygon of two", POLYGON, &[("[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0.5, 1.5, 0.5], [0, 1, 0]]", "«[[0, 0, 0], [1, 0, 0]]»")], Inadmissible, &["polygon", "2 points", "3 to 200 corners"]),
    mutant("polygon closed twice", POLYGON, &[("[0, 1, 0]]", "[0, 1, 0], «[0, 0, 0]»]")], Inadmissible, &["polygon", "leave out the last corner"]),
    mutant("polygon with a corner twice", POLYGON, &[("[1, 1, 1],", "[1, 1, 1], «[1, 1, 1]»,")], Inadmissible, &["two neighbouring corners", "[1, 1, 1]"]),
    mutant("polygon with nan", POLYGON, &[("[1, 1, 1]", "[1, «nan», 1]")], Inadmissible, &["y of point 2", "not finite"]),
    mutant("polygon and net", POLYGON, &[("polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0.5, 1.5, 0.5], [0, 1, 0]]", "polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1]]\nu0 = «[[0, 0, 0], [1, 0, 0]]»")], Conflict, &["polygon", "u0", "keep one kind"]),
    mutant("polygon and sides", SIDES, &[("sides = [", "polygon = «[[0, 0, 0], [1, 0, 0], [1, 1, 1]]»\nsides = [")], Conflict, &["polygon", "sides", "keep one kind"]),
    mutant("gt over a polygon", POLYGON, &[("degree = 6", "basis = «\"gt\"»")], Conflict, &["basis", "loops or faces", "leave out"]),
    mutant("raise over a polygon", POLYGON, &[("degree = 6", "raise = «2»")], Conflict, &["raise", "loops or faces"]),
    mutant("bending over a polygon", POLYGON, &[("\"area\"", "«\"bending\"»")], Conflict, &["energy of single patches", "energy = \"area\""]),
    mutant("no energy over a polygon", POLYGON, &[("[[method]]", "«[[method]]»"), ("energy = \"area\"\n", "")], Missing, &["energy", "least area"]),
    mutant("degree over a net", TENSOR, &[("basis = \"bernstein\"", "basis = \"bernstein\"\ndegree = «6»")], Conflict, &["degree", "tensor", "loops"]),
    mutant("layers on a triangle", TRIANGLE, &[("mask", "layers = «1»\nmask")], Conflict, &["layers", "triangular", "loops"]),
    mutant("layers of a Dirichlet extremal", TENSOR, &[("basis = \"bernstein\"", "basis = \"bernstein\"\nlayers = «1»")], Conflict, &["layers", "not of least area"]),
    mutant("degree of nothing", POLYGON, &[("degree = 6", "degree = «0»")], Inadmissible, &["degree", "between 1 and 24"]),
    mutant("a bound of a Dirichlet energy", POLYGON, &[("\"area\"", "\"dirichlet\""), ("degree = 6", "bound = «true»")], Conflict, &["bound", "energy = \"area\""]),
    mutant("an accuracy of a Dirichlet energy", POLYGON, &[("\"area\"", "\"dirichlet\""), ("degree = 6", "accuracy = «1e-6»")], Conflict, &["accuracy", "energy = \"area\""]),
    mutant("a great accuracy", POLYGON, &[("degree = 6", "accuracy = «0.5»")], Inadmissible, &["accuracy", "0.01"]),
    mutant("three layers", POLYGON, &[("degree = 6", "layers = «3»")], Inadmissible, &["layers", "between 0 and 1"]),
    mutant("a layer of a Dirichlet energy", POLYGON, &[("\"area\"", "\"dirichlet\""), ("degree = 6", "layers = «1»")], Conflict, &["layers", "energy = \"area\""]),
    mutant("tolerance of a Dirichlet energy", POLYGON, &[("\"area\"", "\"dirichlet\""), ("degree = 6", "tolerance = «1e-6»")], Conflict, &["tolerance", "energy = \"area\""]),
    mutant("expected shape over a polygon", POLYGON, &[("degree = 6", "expect.shape = «1.0»")], Conflict, &["shape", "loops"]),
    mutant("curve beside a polygon", POLYGON, &[("[[method]]", "«[[curve]]»\nname = \"x\"\npoints = [[0, 0, 0], [1, 1, 1]]\nends = [\"a\", \"b\"]\n[[method]]")], Conflict, &["[[curve]]", "loops"]),
    mutant("curve beside a net", BILINEAR, &[("[[method]]", "«[[curve]]»\nname = \"x\"\npoints = [[0, 0, 0], [1, 1, 1]]\nends = [\"a\", \"b\"]\n[[method]]")], Conflict, &["[[curve]]", "loops"]),
    mutant("sides with a gap", SIDES, &[("[[2, 0, 0], [2, 2, 0]]", "[«[2, 0, 0.5]», [2, 2, 0]]")], Conflict, &["side 1", "side 0", "0.5", "a millionth"]),
    mutant("side of one point", SIDES, &[("[[2, 0, 0], [2, 2, 0]]", "«[[2, 0, 0]]»")], Inadmissible, &["sides", "1 point"]),
    mutant("side in one place", SIDES, &[("[[2, 0, 0], [2, 2, 0]]", "«[[2, 0, 0], [2, 0, 0]]»")], Inadmissible, &["sides", "side 1", "same point"]),
    mutant("sides a list of points", SIDES, &[("  [[0, 0, 0], [1, 0, 1], [2, 0, 0]],\n", "  «3»,\n")], WrongType, &["sides", "a list of points"]),
    mutant("loop of an unknown curve", RINGS, &[("[\"ring\"]]", "[«\"rnig\"»]]"), ("name = \"low\"", "name = \"low\"")], Conflict, &["rnig", "did you mean \"ring\"?"]),
    mutant("loop in the wrong sense", RINGS, &[("[\"low\", \"-high\"]", "[\"low\", «\"high\"»]")], Conflict, &["goes on at \"a\"", "come to \"b\"", "`-` before a name"]),
    mutant("curve in two loops", RINGS, &[("[\"ring\"]]", "[«\"low\"»]]")], Conflict, &["low", "twice"]),
    mutant("closed curve among others", RINGS, &[("[[\"low\", \"-high\"], [\"ring\"]]", "[[\"low\", \"-high\", «\"ring\"»]]")], Conflict, &["ring", "no `ends`", "loop of its own"]),
    mutant("curve in no loop", RINGS, &[("loops = [[\"low\", \"-high\"], [\"ring\"]]", "loops = [[\"low\", \"-high\"]]"), ("[[curve]]\nname = \"ring\"", "«[[curve]]»\nname = \"ring\"")], Conflict, &["ring", "no loop"]),
    mutant("no loop at all", RINGS, &[("[[\"low\", \"-high\"], [\"ring\"]]", "«[]»")], Inadmissible, &["loops", "at least 1", "[[face]]"]),
    mutant("three loops", RINGS, &[("[[\"low\", \"-high\"], [\"ring\"]]", "«[[\"low\", \"-high\"], [\"ring\"], [\"x\"]]»")], Inadmissible, &["loops", "at most 2", "[[face]]"]),
    mutant("two curves of one name", RINGS, &[("name = \"high\"", "name = «\"low\"»")], Conflict, &["two curves", "\"low\""]),
    mutant("curve called backwards", RINGS, &[("name = \"ring\"", "name = «\"-ring\"»")], Inadmissible, &["-ring", "other way"]),
    mutant("curve without a form", RINGS, &[("[[curve]]\nname = \"low\"", "«[[curve]]»\nname = \"low\""), ("points = [[0, 0, 0], [1, -1, 0], [2, 0, 0]]\n", "")], Missing, &["curve \"low\"", "polyline", "circle"]),
    mutant("curve of two forms", RINGS, &[("points = [[0, 0, 0], [1, -1, 0], [2, 0, 0]]", "points = [[0, 0, 0], [1, -1, 0], [2, 0, 0]]\npolyline = «[[0, 0, 0], [2, 0, 0]]»")], Conflict, &["points", "polyline", "keep one"]),
    mutant("curve with one end", RINGS, &[("name = \"low\"\nends = [\"a\", \"b\"]", "name = \"low\"\nends = «[\"a\"]»")], Inadmissible, &["ends", "1 element instead of 2", "closed curve"]),
    mutant("curve from a to a", RINGS, &[("name = \"low\"\nends = [\"a\", \"b\"]", "name = \"low\"\nends = «[\"a\", \"a\"]»")], Inadmissible, &["\"a\"", "closed curve"]),
    mutant("open curve without ends", RINGS, &[("[[curve]]\nname = \"low\"\nends = [\"a\", \"b\"]", "«[[curve]]»\nname = \"low\"")], Conflict, &["no `ends`", "2 from where it begins", "ends = [\"a\", \"b\"]"]),
    mutant("closed curve with ends", RINGS, &[("[1, -1, 0], [2, 0, 0]]", "[1, -1, 0], [0, 0, 0]]"), ("name = \"low\"\nends = [\"a\", \"b\"]", "name = \"low\"\nends = [«\"a\", \"b\"»]")], Conflict, &["ends where it begins", "leave out `ends`"]),
    mutant("loop with a gap", RINGS, &[("\"-high\"", "«\"-high\"»"), ("[1, 1, 0], [2, 0, 0]]", "[1, 1, 0], [2, 0, 0.5]]")], Conflict, &["same vertex", "0.5 from one another"]),
    mutant("too few knots", RINGS, &[("[0, 0, 0, 1, 1, 1]", "«[0, 0, 1, 1, 1]»")], Inadmissible, &["curve \"high\"", "6 knots, got 5"]),
    mutant("descending knots", RINGS, &[("[0, 0, 0, 1, 1, 1]", "«[0, 0, 0, 1, 0.5, 1]»")], Inadmissible, &["knot 4", "never descend"]),
    mutant("too few weights", RINGS, &[("weights = [1, 2, 1]", "weights = «[1, 2]»")], Inadmissible, &["2 weights for 3"]),
    mutant("negative weight", RINGS, &[("weights = [1, 2, 1]", "weights = [1, «-2», 1]")], Inadmissible, &["weights", "above 0"]),
    mutant("spline without knots", RINGS, &[("spline = { degree = 2, knots = [0, 0, 0, 1, 1, 1], points = [[0, 0, 0], [1, 1, 0], [2, 0, 0]], weights = [1, 2, 1] }", "spline = «{ degree = 2, points = [[0, 0, 0], [1, 1, 0], [2, 0, 0]] }»")], Missing, &["`spline` of curve \"high\"", "knots"]),
    mutant("spline key misspelt", RINGS, &[("knots =", "«konts» =")], UnknownKey, &["[curve.spline]", "did you mean `knots`?"]),
    mutant("circle without radius", RINGS, &[("circle = { center = [1, 0, 1], normal = [0, 0, 1], radius = 0.5 }", "circle = «{ center = [1, 0, 1], normal = [0, 0, 1] }»")], Missing, &["radius"]),
    mutant("circle of negative radius", RINGS, &[("radius = 0.5", "radius = «-0.5»")], Inadmissible, &["radius", "above 0"]),
    mutant("circle without a plane", RINGS, &[("normal = [0, 0, 1]", "normal = «[0, 0, 0]»")], Inadmissible, &["curve \"ring\"", "axes"]),
    mutant("planar center", RINGS, &[("center = [1, 0, 1]", "center = «[1, 0]»")], Inadmissible, &["2 coordinates instead of 3", "[x, y, z]"]),
    mutant("arc of a whole circle", RINGS, &[("radius = 0.5 }", "radius = 0.5, arc = «[0, 90]» }")], Conflict, &["arc", "no `ends`"]),
    // Faces.
    mutant("arc without from", FACES, &[("circle = { center = [0.5, 0.5, 0], normal = [0, 0, 1], radius = 0.7071067811865476, from = [1, 1, 0], arc = [0, 180] }", "circle = «{ center = [0.5, 0.5, 0], normal = [0, 0, 1], radius = 0.7071067811865476, arc = [0, 180] }»")], Missing, &["from", "arc = [0, 180]"]),
    mutant("from beside the circle", FACES, &[("from = [1, 1, 0]", "from = «[1, 2, 0]»")], Inadmissible, &["does not lie on the circle", "0.70710678"]),
    mutant("arc of nothing", FACES, &[("arc = [0, 180]", "arc = «[90, 90]»")], Inadmissible, &["must turn"]),
    mutant("arc of two turns", FACES, &[("arc = [0, 180]", "arc = «[-360, 360]»")], Inadmissible, &["full turn"]),
    mutant("vertex misspelt", FACES, &[("vertices = [\"c\", \"a\", \"o\"]", "vertices = [\"c\", «\"aa\"», \"o\"]")], Conflict, &["nothing holds", "\"aa\"", "did you mean \"a\"?"]),
    mutant("face of two", FACES, &[("vertices = [\"a\", \"b\", \"o\"]", "vertices = «[\"a\", \"b\"]»"), ("[[face]]\nvertices = [\"b\", \"c\", \"o\"]\n", ""), ("[[face]]\nvertices = [\"c\", \"a\", \"o\"]", "[[face]]\nvertices = [\"a\", \"b\", \"c\"]"), ("[[vertex]]\nname = \"o\"\npoint = [0.5, 0.5, 0.25]\n", "")], Inadmissible, &["2 corners", "three or more"]),
    mutant("face of one", FACES, &[("vertices = [\"a\", \"b\", \"o\"]", "vertices = «[\"a\"]»")], Inadmissible, &["vertices", "1 element instead of at least 2"]),
    mutant("face left open", FACES, &[("[[face]]\nvertices = [\"c\", \"a\", \"o\"]\n", ""), ("vertices = [\"a\", \"b\", \"o\"]", "vertices = [\"a\", \"b\", «\"o\"»]")], Conflict, &["nothing holds the side from \"o\" to \"a\"", "[[curve]]"]),
    mutant("curve of no face", FACES, &[("[[face]]\nvertices = [\"a\", \"b\", \"o\"]", "«[[curve]]»\nname = \"wire\"\nends = [\"x\", \"y\"]\npoints = [[0, 0, 0], [0, 0, 1]]\n[[face]]\nvertices = [\"a\", \"b\", \"o\"]")], Inadmissible, &["\"wire\"", "neighbours in no face"]),
    mutant("curve apart from its vertex", FACES, &[("[[curve]]\nname = \"east\"", "«[[curve]]»\nname = \"east\""), ("points = [[1, 0, 0], [1, 0.5, 0.1]", "points = [[1, 0, 0.25], [1, 0.5, 0.1]")], Inadmissible, &["\"east\"", "\"b\"", "0.25"]),
    mutant("closed curve of faces", FACES, &[("[[face]]\nvertices = [\"a\", \"b\", \"o\"]", "«[[curve]]»\nname = \"ring\"\ncircle = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }\n[[face]]\nvertices = [\"a\", \"b\", \"o\"]")], Conflict, &["\"ring\"", "no `ends`"]),
    mutant("vertex of no face", FACES, &[("name = \"o\"", "name = «\"oo\"»")], Conflict, &["\"oo\"", "corner of no face"]),
    mutant("vertex without point", FACES, &[("[[vertex]]", "«[[vertex]]»"), ("point = [0.5, 0.5, 0.25]\n", "")], Missing, &["point"]),
    mutant("vertex fixed by a word", FACES, &[("point = [0.5, 0.5, 0.25]", "point = [0.5, 0.5, 0.25]\nfixed = «\"yes\"»")], WrongType, &["fixed", "true or false"]),
    mutant("faces and a polygon", FACES, &[("[[face]]\nvertices = [\"a\", \"b\", \"o\"]", "«[[face]]»\nvertices = [\"a\", \"b\", \"o\"]"), ("title = \"Faces\"", "title = \"Faces\"\nboundary.polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]")], Conflict, &["[[face]]", "polygon", "keep one"]),
    mutant("vertex beside loops", RINGS, &[("[[method]]", "«[[vertex]]»\nname = \"o\"\npoint = [0, 0, 0]\n[[method]]")], Conflict, &["[[vertex]]", "[[face]]"]),
    mutant("a later key", RINGS, &[("[[curve]]\nname = \"ring\"", "[[curve]]\n«tension» = 1\nname = \"ring\"")], UnknownKey, &["[[curve]]", "tension"]),
    mutant("a later method key", POLYGON, &[("degree = 6", "«volume» = 1.0")], UnknownKey, &["volume"]),
    // Curves.
    mutant("curve without basis", CURVE, &[("[curve]", "«[curve]»"), ("basis = \"gt\"\n", "")], Missing, &["basis", "\"aht\""]),
    mutant("curve without points", CURVE, &[("[curve]", "«[curve]»"), ("points = [[0, 0], [1, 2], [3, 2], [4, 0]]\n", "")], Missing, &["points"]),
    mutant("curve without shape", CURVE, &[("[curve]", "«[curve]»"), ("shape = [1.0, 2.0]\n", "")], Missing, &["shape"]),
    mutant("bernstein curve with shape", CURVE, &[("\"gt\"", "\"bernstein\""), ("[1.0, 2.0]", "«[1.0, 2.0]»")], Conflict, &["shape", "bernstein"]),
    mutant("gt curve with span", CURVE, &[("shape", "span = «1.5»\nshape")], Conflict, &["span", "gt"]),
    mutant("aht curve of four points", CURVE, &[("\"gt\"", "\"aht\""), ("shape = [1.0, 2.0]", "span = 1.5"), ("[[0, 0], [1, 2], [3, 2], [4, 0]]", "«[[0, 0], [1, 2], [3, 2], [4, 0]]»")], Inadmissible, &["4 points", "exactly 6"]),
    mutant("aht span beyond the sharp bound", CURVE, &[("\"gt\"", "\"aht\""), ("shape = [1.0, 2.0]", "span = «7.85321»"), ("[[0, 0], [1, 2], [3, 2], [4, 0]]", "[[0, 0], [1, 2], [3, 2], [4, 0], [5, 0], [6, 0]]")], Inadmissible, &["7.853204624", "split"]),
    mutant("at span of zero", CURVE, &[("\"gt\"", "\"at\""), ("shape = [1.0, 2.0]", "span = «0»"), ("[[0, 0], [1, 2], [3, 2], [4, 0]]", "[[0, 0], [1, 2], [3, 2], [4, 0], [5, 0], [6, 0]]")], Inadmissible, &["span", "at least 1e-100"]),
    mutant("gt curve of two points", CURVE, &[("[[0, 0], [1, 2], [3, 2], [4, 0]]", "«[[0, 0], [1, 2]]»")], Inadmissible, &["2 points", "at least 3"]),
    mutant("mixed dimensions", CURVE, &[("[1, 2], [3", "«[1, 2, 0]», [3")], Conflict, &["planar and space"]),
    mutant("one coordinate", CURVE, &[("[1, 2], [3", "«[1]», [3")], Inadmissible, &["1 coordinate instead of 2 or 3"]),
    mutant("sample outside", CURVE, &[("0.25, 1.0]", "0.25, «1.5»]")], Inadmissible, &["1.5", "domain [0, 1]"]),
    mutant("sample nan", CURVE, &[("0.25, 1.0]", "«nan», 1.0]")], Inadmissible, &["NaN", "domain"]),
    mutant("no samples", CURVE, &[("[0.0, 0.25, 1.0]", "«[]»")], Inadmissible, &["samples", "0 numbers instead of at least 1"]),
    mutant("one sample by count", CURVE, &[("[0.0, 0.25, 1.0]", "«1»")], Inadmissible, &["samples", "between 2 and"]),
    mutant("curve shape of four", CURVE, &[("[1.0, 2.0]", "«[1, 2, 3, 4]»")], Inadmissible, &["4 numbers instead of 2", "θ1"]),
    mutant("curve of points and a function", CURVE, &[("points", "function = \"circle\"\npoints"), ("[[0, 0], [1, 2], [3, 2], [4, 0]]", "[[0, 0], [1, 2], [3, 2], [4, 0]]"), ("\"circle\"", "«\"circle\"»")], Conflict, &["`points`", "`function`", "keep one"]),
    mutant("gt curve by formula", CURVE, &[("points = [[0, 0], [1, 2], [3, 2], [4, 0]]", "function = «\"circle\"»")], Conflict, &["does not hold", "\"aht\" and \"at\""]),
    mutant("spiral in the other basis", CURVE, &[("\"gt\"", "\"aht\""), ("shape = [1.0, 2.0]", "span = 1.5"), ("points = [[0, 0], [1, 2], [3, 2], [4, 0]]", "function = «\"spiral\"»")], Conflict, &["does not hold", "in \"at\""]),
    mutant("unknown curve by formula", CURVE, &[("\"gt\"", "\"at\""), ("shape = [1.0, 2.0]", "span = 1.5"), ("points = [[0, 0], [1, 2], [3, 2], [4, 0]]", "function = «\"conical\"»")], Inadmissible, &["\"conical-spiral\""]),
    mutant("one end of a curve", CURVE, &[("\"gt\"", "\"at\""), ("shape = [1.0, 2.0]", "span = 1.5"), ("points = [[0, 0], [1, 2], [3, 2], [4, 0]]", "ends = «[[[1, 0], [0, 1], [-1, 0]]]»")], Inadmissible, &["1 element instead of 2", "derivative"]),
    mutant("end of a curve without its second derivative", CURVE, &[("\"gt\"", "\"at\""), ("shape = [1.0, 2.0]", "span = 1.5"), ("points = [[0, 0], [1, 2], [3, 2], [4, 0]]", "ends = [[[1, 0], [0, 1], [-1, 0]], «[[1, 0], [0, 1]]»]")], Inadmissible, &["2 points", "give 3 points"]),
    mutant("no shape of several", CURVE, &[("shape = [1.0, 2.0]", "shape = [[1.0, 2.0], «[1.0]»]")], Inadmissible, &["1 number instead of 2"]),
    mutant("a shape among pairs", CURVE, &[("shape = [1.0, 2.0]", "shape = [[1.0, 2.0], «1.0»]")], WrongType, &["list of numbers"]),
    mutant("shapes of another basis", CURVE, &[("\"gt\"", "\"bernstein\""), ("shape = [1.0, 2.0]", "shape = «[[1.0, 2.0], [1, 1]]»")], Conflict, &["shape", "bernstein"]),
    mutant("a shape of zeros among several", CURVE, &[("shape = [1.0, 2.0]", "shape = [[1.0, 2.0], [«0, 0»]]")], Inadmissible, &["(0, 0)", "dependent"]),
    mutant("expected area of a curve", CURVE, &[("samples = [0.0, 0.25, 1.0]\n", "[expect]\narea = «1.0»\n")], Conflict, &["area", "curvature"]),
    mutant("expected curvature too short", CURVE, &[("samples = [0.0, 0.25, 1.0]\n", "samples = [0.0, 1.0]\n[expect]\ncurvature = «[1.0]»\n")], Inadmissible, &["curvature", "expected 2 numbers"]),
];

/// The mutated text without marks, and the place between them in bytes.
fn mutate(mutant: &Mutant) -> (String, std::ops::Range<usize>) {
    let mut text = mutant.base.to_owned();
    for (old, new) in mutant.edits {
        assert_eq!(text.matches(old).count(), 1, "{}: {old:?} must stand once in the base", mutant.name);
        text = text.replace(old, new);
    }
    let start = text.find('«').unwrap_or_else(|| panic!("{}: no mark", mutant.name));
    let text = text.replacen('«', "", 1);
    let end = text.find('»').unwrap_or_else(|| panic!("{}: no end mark", mutant.name));
    (text.replacen('»', "", 1), start..end)
}

fn refuse(text: &str) -> Refusal {
    match Plan::parse("mutant.toml", text) {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(refusal) => refusal,
    }
}

/// Line and column from 1, computed apart from the library.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let lines: Vec<&str> = text[..offset].split('\n').collect();
    (lines.len(), lines[lines.len() - 1].chars().count() + 1)
}

#[test]
fn every_mutant_is_refused_at_its_place_with_a_remedy() {
    let mut failures = Vec::new();
    for mutant in MUTANTS {
        let (text, place) = mutate(mutant);
        let refusal = match Plan::parse("mutant.toml", &text) {
            Err(refusal) => refusal,
            Ok(_) => {
                failures.push(format!("{}: accepted", mutant.name));
                continue;
            }
        };
        let mut fault = |what: String| failures.push(format!("{}: {what}\n{refusal}\n", mutant.name));
        if mutant.fault != Syntax && refusal.diagnostics().len() != 1 {
            fault(format!("{} diagnostics instead of 1", refusal.diagnostics().len()));
        }
        let first = &refusal.diagnostics()[0];
        if first.fault() != mutant.fault {
            fault(format!("a fault of kind {:?} instead of {:?}", first.fault(), mutant.fault));
        }
        if first.span() != Some(place.clone()) {
            fault(format!("points at {:?} instead of {place:?}", first.span()));
        }
        let position = line_and_column(&text, place.start);
        if refusal.position(first) != Some(position) {
            fault(format!("at {:?} instead of {position:?}", refusal.position(first)));
        }
        let rendered = refusal.to_string();
        if !rendered.contains(&format!("mutant.toml:{}:{}", position.0, position.1)) {
            fault(format!("does not show mutant.toml:{}:{}", position.0, position.1));
        }
        let words = format!("{} {} {}", first.message(), first.label(), first.remedies().join(" "));
        for word in mutant.says {
            if !words.contains(word) {
                fault(format!("does not say {word:?}"));
            }
        }
        if first.remedies().is_empty() || first.remedies().iter().any(|help| help.trim().len() < 10) {
            fault("offers no remedy".to_owned());
        }
    }
    assert!(failures.is_empty(), "{} failures\n\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn the_bases_are_sound_and_mutants_many() {
    for base in
        [TENSOR, BILINEAR, ROWS, TRIANGLE, HELICOID, TRAPEZIUM, NET, CURVE, POLYGON, SIDES, RINGS, FACES]
    {
        if let Err(refusal) = Plan::parse("base.toml", base) {
            panic!("{refusal}");
        }
    }
    assert!(MUTANTS.len() >= 60, "{}", MUTANTS.len());
    let mut names: Vec<&str> = MUTANTS.iter().map(|mutant| mutant.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), MUTANTS.len());
}

#[test]
fn independent_faults_are_reported_together() {
    let text = TENSOR
        .replace("seed = 7", "seed = -1")
        .replace("[2, 6, 2]", "[2, nan, 2]")
        .replace("\"bending\"", "\"bendung\"")
        .replace("particles", "particels")
        .replace("runs = 10", "runs = \"ten\"")
        .replace("mesh = 48", "mesh = 1");
    let refusal = refuse(&text);
    let lines: Vec<usize> =
        refusal.diagnostics().iter().filter_map(|d| refusal.position(d)).map(|(line, _)| line).collect();
    assert_eq!(lines, [2, 6, 19, 31, 33, 39], "{refusal}");
}

#[test]
fn a_fault_does_not_make_others_appear() {
    // Each unreadable key is one the rest would miss.
    for (old, new) in [
        ("basis = \"gt\"", "basis = 3"),
        ("u1 =", "w1 ="),
        ("energy = \"dirichlet\"\nsearch", "enregy = \"dirichlet\"\nsearch"),
        ("title =", "titel ="),
        ("search = true", "search = 1.5"),
        ("source =", "sauce ="),
        ("quantity =", "quality ="),
    ] {
        let text = TENSOR.replace(old, new);
        assert_ne!(text, TENSOR);
        let refusal = refuse(&text);
        assert_eq!(refusal.diagnostics().len(), 1, "{refusal}");
    }
}

#[test]
fn at_most_ten_faults_are_shown_and_the_rest_counted() {
    let text = TENSOR.replace("6", "nan");
    let refusal = refuse(&text);
    assert_eq!(refusal.diagnostics().len(), 10);
    assert!(refusal.omitted() >= 1);
    assert!(refusal.to_string().contains("further"), "{refusal}");
    let unknown: String = (0..100).map(|k| format!("key{k} = 1\n")).collect();
    let refusal = refuse(&format!("{unknown}{TENSOR}"));
    assert_eq!(refusal.diagnostics().len(), 10);
}
