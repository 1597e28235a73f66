//! The unit of what a search minimises.

use experiment::{Options, Plan, run};
use plateau::{Quantity, SearchEnergy};

/// A saddle frame `scale` times as large, its shape searched by `energy`.
fn searched(scale: f64, energy: &str) -> plateau::Results {
    let s = scale;
    let text = format!(
        "title = \"t\"\nseed = 3\n[boundary]\n\
         u0 = [[0, 0, 0], [0, {s}, {s}], [0, {}, 0]]\nu1 = [[{}, 0, 0], [{}, {s}, {s}], [{}, {}, 0]]\n\
         v0 = [[0, 0, 0], [{s}, 0, -{s}], [{}, 0, 0]]\nv1 = [[0, {}, 0], [{s}, {}, -{s}], [{}, {}, 0]]\n\
         [[method]]\nname = \"m\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\nsearch = \"polish\"\nsearch-energy = \"{energy}\"\n",
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
        2.0 * s,
    );
    let plan = Plan::parse("t.toml", &text).unwrap_or_else(|refusal| panic!("{refusal}"));
    run(&plan, Options::default(), &()).unwrap().results
}

#[test]
fn a_minimum_scales_as_what_was_searched_for() {
    for (word, energy) in SearchEnergy::NAMED.into_iter().filter(|(word, _)| *word != "area") {
        let [one, four] = [1.0, 4.0].map(|scale| searched(scale, word));
        let done = one.methods()[0].outcome.as_ref().unwrap_or_else(|error| panic!("{word}: {error}"));
        let power = Quantity::SearchMinimum.power_in(done).expect("a search");
        assert_eq!(Some(power), Quantity::of_search(energy).power(), "{word}");
        let [a, b] =
            [&one, &four].map(|results| results.methods()[0].figure(Quantity::SearchMinimum).unwrap());
        // The polish ends within its own tolerance.
        assert!((b / a / 4f64.powi(power) - 1.0).abs() <= 1e-6, "{word}: {a} {b} {power}");
    }
    let conformality = SearchEnergy::NAMED.into_iter().find(|(word, _)| *word == "conformality");
    assert_eq!(conformality.and_then(|(_, energy)| Quantity::of_search(energy).power()), Some(0));
}
