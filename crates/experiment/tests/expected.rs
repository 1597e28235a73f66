//! What `check` admits in an `expect` table, the result has.

use experiment::{Options, Plan, run};
use plateau::Quantity;

const TENSOR: &str = "[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]
[[method]]
name = 'm'
";

const TRIANGLE: &str = "[boundary]
ab = [[0, 0, 0], [1, 0.2, 1], [2, -0.3, -1], [3, 0, 0.5]]
bc = [[3, 0, 0.5], [2.5, 1, 1], [1.5, 2, 0], [1, 3, 0]]
ca = [[1, 3, 0], [0.5, 2, -1], [0.2, 1, 0.5], [0, 0, 0]]
[[method]]
name = 'm'
";

/// Two rings, so that every figure of a film exists.
const RINGS: &str = "[boundary]
loops = [['low'], ['high']]
[[curve]]
name = 'low'
circle = { center = [0, 0, -0.3], normal = [0, 0, 1], radius = 1 }
[[curve]]
name = 'high'
circle = { center = [0, 0, 0.3], normal = [0, 0, 1], radius = 1 }
[[method]]
name = 'm'
degree = 4
";

/// A loop of six sides.
const HEXAGON: &str = "[boundary]
polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1], [0, 0, 1]]
[[method]]
name = 'm'
degree = 4
";

const HELICOID: &str = "[helicoid]
a = 1.0
b = 0.5
u-span = 1.5
v-span = 3.0
";

/// Experiments of one method each.
fn experiments() -> Vec<String> {
    let every_net = [
        "energy = 'dirichlet'",
        "energy = 'bending'",
        "energy = 'coons'",
        "energy = 'area'",
        "energy = 'dirichlet'\nmetric-steps = 2",
        "construction = 'discrete-coons'",
    ];
    let of_tensor = [
        "mask = -0.25",
        "energy = 'area'\nbound = true",
        "energy = 'dirichlet'\nbasis = 'gt'\nshape = [1, 1, 1, 1]",
        "energy = 'dirichlet'\nbasis = 'gt'\nsearch = 'polish'",
        "energy = 'dirichlet'\npatch = 'tb-coons'\nbasis = 'gt'\nshape = [1, 1, 1, 1]",
    ];
    let tensor = every_net.iter().chain(&of_tensor).map(|keys| format!("{TENSOR}{keys}\n"));
    let triangle = every_net.iter().chain(&["mask = 'dirichlet'"]).map(|keys| format!("{TRIANGLE}{keys}\n"));
    let of_films = ["energy = 'area'", "energy = 'dirichlet'", "energy = 'area'\nbound = true"];
    let films = [RINGS, HEXAGON].into_iter();
    let films = films.flat_map(|film| of_films.iter().map(move |keys| format!("{film}{keys}\n")));
    tensor.chain(triangle).chain(films).chain([HELICOID.to_owned()]).collect()
}

#[test]
fn a_figure_that_is_admitted_exists() {
    for experiment in experiments() {
        let text = format!("title = 't'\n{experiment}");
        let plan = |expect: &str| {
            // A helicoid has its table at the top, methods have theirs within.
            let text = if text.contains("[[method]]") {
                format!("{text}expect = {{ {expect} }}\n")
            } else {
                format!("{text}[expect]\n{expect}\n")
            };
            Plan::parse("t.toml", &text)
        };
        let plain = Plan::parse("t.toml", &text)
            .unwrap_or_else(|refusal| panic!("{}\n{text}", refusal.render(false)));
        let finished = run(&plain, Options::default(), &()).unwrap();
        let method = &finished.results.methods()[0];
        assert!(method.outcome.is_ok(), "{text}");
        for &quantity in Quantity::ALL {
            let admitted = plan(&format!("{} = 1.0", quantity.name())).is_ok();
            let exists = method.figure(quantity).is_some();
            // Estimates and proofs may be withheld, with the reason; what exists is admitted all the same.
            let may_be_withheld = matches!(quantity, Quantity::AreaEstimate | Quantity::LowerBound);
            assert!(exists == admitted || admitted && may_be_withheld, "`{}` of\n{text}", quantity.name());
        }
    }
}
