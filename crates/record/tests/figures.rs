//! The figures of a result stand in its record where the table of figures says, and an extremal records what it minimised.

use experiment::{Options, Plan, run};
use plateau::{Energy, Quantity};
use record::ResultFile;
use serde_json::Value;

const NETS: [&str; 2] = [
    r#"
[boundary]
u0 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]]
u1 = [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
v0 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]]
v1 = [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]
"#,
    r#"
[boundary]
ab = [[0, 0, 0], [1, 0.2, 1], [2, -0.3, -1], [3, 0, 0.5]]
bc = [[3, 0, 0.5], [2.5, 1, 1], [1.5, 2, 0], [1, 3, 0]]
ca = [[1, 3, 0], [0.5, 2, -1], [0.2, 1, 0.5], [0, 0, 0]]
"#,
];

const RINGS: &str = r#"
title = "rings"
[boundary]
loops = [["low"], ["high"]]
[[curve]]
name = "low"
circle = { center = [0, 0, -0.3], normal = [0, 0, 1], radius = 1 }
[[curve]]
name = "high"
circle = { center = [0, 0, 0.3], normal = [0, 0, 1], radius = 1 }
[[method]]
name = "area"
energy = "area"
degree = 4
"#;

const ROWS: &str = r#"
[[method]]
name = "Dirichlet"
energy = "dirichlet"
[[method]]
name = "Laplacian"
energy = "laplacian"
[[method]]
name = "bending"
energy = "bending"
[[method]]
name = "Coons"
energy = "coons"
[[method]]
name = "corrected"
metric-steps = 3
energy = "dirichlet"
[[method]]
name = "area"
energy = "area"
"#;

fn record(text: &str) -> (experiment::Finished, Value) {
    let plan = Plan::parse("rows.toml", text).unwrap();
    let finished = run(&plan, Options::default(), &()).unwrap();
    let json = ResultFile::new(&plan, &finished).to_json().unwrap();
    (finished, serde_json::from_str(&json).unwrap())
}

/// Over a tensor and a triangular boundary.
fn records() -> Vec<(experiment::Finished, Value)> {
    let searched = "[[method]]\nname = \"searched\"\nbasis = \"gt\"\nenergy = \"dirichlet\"\nsearch = \"polish\"\n\
                    [[method]]\nname = \"bounded\"\nenergy = \"area\"\nbound = true\n";
    let [tensor, triangle] = NETS.map(|net| format!("title = \"rows\"{net}{ROWS}"));
    vec![record(&(tensor + searched)), record(&triangle)]
}

#[test]
fn every_figure_stands_where_its_row_says() {
    let mut seen = Vec::new();
    for (finished, json) in records().into_iter().chain([record(RINGS)]) {
        for (k, method) in finished.results.methods().iter().enumerate() {
            let done = method.outcome.as_ref().unwrap();
            for &quantity in Quantity::ALL {
                let at = json["methods"][k].pointer(&format!("/{}", quantity.key().replace('.', "/")));
                match quantity.of(done) {
                    Some(figure) => {
                        let at = at.unwrap_or_else(|| panic!("{}: no {quantity}", method.name));
                        let at = if at.is_array() { &at[0] } else { at };
                        assert_eq!(at.as_f64(), Some(figure.value), "{}: {quantity}", method.name);
                        seen.push(quantity);
                    }
                    None => assert_eq!(at, None, "{}: {quantity}", method.name),
                }
            }
        }
    }
    let unseen: Vec<_> = Quantity::ALL.iter().filter(|quantity| !seen.contains(quantity)).collect();
    assert_eq!(unseen, [&Quantity::Deviation, &Quantity::Curvature(0)], "figures of closed forms and curves");
}

/// The extremal of an energy over nets of some degree has none above it: no other row over the same boundary has less of it.
#[test]
fn what_a_row_minimises_is_recorded_and_least() {
    for (finished, json) in records() {
        for (_, energy) in Energy::NAMED {
            let quantity = Quantity::of_energy(energy);
            let k = finished
                .results
                .methods()
                .iter()
                .position(|method| {
                    let solved = &method.outcome.as_ref().unwrap().solved;
                    let corrected = solved.solve().is_some_and(|solve| solve.metric.is_some());
                    solved.minimised() == Some(energy) && !corrected
                })
                .unwrap();
            let least = json["methods"][k][quantity.key()].as_f64().unwrap();
            let error = json["methods"][k][format!("{}_error", quantity.key())].as_f64().unwrap();
            // A Coons functional may vanish: then its error is measured by what the boundary spans.
            let scale = json["methods"][k]["dirichlet"].as_f64().unwrap();
            assert!(error <= 1e-9 * least.max(scale), "{quantity}: {least} ± {error}");
            for method in finished.results.methods().iter().filter(|method| method.name != "searched") {
                let Some(value) = method.figure(quantity) else { continue };
                assert!(least <= value * (1.0 + 1e-9), "{quantity} of {}: {value} < {least}", method.name);
            }
        }
    }
}

/// D^g(x) ≥ 2A(x), with equality where x is conformal to the metric: after some corrections the two are near.
#[test]
fn the_metric_energy_of_a_correction_lies_above_twice_its_area() {
    for (_, json) in records() {
        let row = json["methods"].as_array().unwrap().iter().find(|row| row["name"] == "corrected").unwrap();
        let [metric, error, area] =
            ["metric_dirichlet", "metric_dirichlet_error", "area"].map(|key| row[key].as_f64().unwrap());
        assert!((0.0..1e-9 * metric).contains(&error), "± {error}");
        assert!((2.0 * area - error..2.0 * area * 1.01).contains(&metric), "{metric} for twice {area}");
    }
}

/// A record whose surface is not what its family says is refused, never read as another family's.
#[test]
fn pieces_of_another_family_are_refused() {
    let plan = Plan::read(std::path::Path::new(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fixtures/helicoid-ten-turns.toml"
    )))
    .unwrap();
    let json = ResultFile::new(&plan, &run(&plan, Options::default(), &()).unwrap()).to_json().unwrap();
    assert!(json.contains("\"pieces\"") && record::StoredResult::parse(json.as_bytes()).is_ok());
    let forged = json.replace("\"basis\": \"aht\"", "\"basis\": \"bernstein\"");
    let error = record::StoredResult::parse(forged.as_bytes()).unwrap_err().to_string();
    assert!(error.contains("`methods[0].net` is missing"), "{error}");
}
