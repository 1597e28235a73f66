//! What is kept of the modes of least areas.

use experiment::{Options, Plan, run};
use record::{Level, ResultFile, verify_text};
use serde_json::Value;

/// The saddle frame of the fixtures.
const SADDLE: &str = include_str!("../../../fixtures/area-saddle.toml");

const LEAST: &str = "\n[[method]]\nname = \"least\"\nenergy = \"area\"\nraise = 2\n";

const TRIANGLE: &str = r#"
title = "triangle"
[boundary]
ab = [[1, 0, 0], [0.7, 0.4, 0.5], [0.3, 0.8, 0.4], [0, 1, 0]]
bc = [[0, 1, 0], [0, 0.6, -0.5], [0, 0.3, -0.3], [0, 0, 0]]
ca = [[0, 0, 0], [0.3, 0, 0.6], [0.7, 0, 0.2], [1, 0, 0]]
[[method]]
name = "least"
energy = "area"
raise = 2
"#;

const HEXAGON: &str = include_str!("../../../fixtures/gallery/hexagon.toml");

/// The record of an experiment as if another program had written it, so that it is compared by figures.
fn foreign(text: &str) -> Value {
    let plan = Plan::parse("experiment.toml", text).unwrap_or_else(|refusal| panic!("{refusal}"));
    let finished = run(&plan, Options::default(), &()).unwrap();
    let mut record = serde_json::to_value(ResultFile::new(&plan, &finished)).unwrap();
    record["manifest"]["version"] = "0.0.1".into();
    record
}

/// The keys at which a record and its repetition differ.
fn differences(record: &Value) -> Vec<String> {
    let found = verify_text(record.to_string().as_bytes(), &()).unwrap();
    assert!(matches!(found.level, Level::Figures { .. }), "{found:?}");
    found.entries.iter().flat_map(|entry| entry.differences.iter().map(|d| d.key.clone())).collect()
}

#[test]
fn modes_are_kept_as_their_surfaces_are_and_checked_by_their_quotient() {
    let (boundary, _) = SADDLE.split_once("\n[[method]]").unwrap();
    let frame = format!("{boundary}{LEAST}");
    for (text, net) in [(frame.as_str(), "net"), (TRIANGLE, "net"), (HEXAGON, "faces")] {
        let mut record = foreign(text);
        assert_eq!(differences(&record), Vec::<String>::new());
        let points = record["methods"][0][net].as_array().unwrap().len();
        let mode = record["methods"][0]["area_extremal"]["mode"].as_array_mut().expect("a mode");
        assert_eq!(mode.len(), points);
        // One number of the middle changed.
        let mut number = &mut mode[points / 2];
        while let Value::Array(inner) = number {
            let middle = inner.len() / 2;
            number = &mut inner[middle];
        }
        *number = (number.as_f64().unwrap() - 3.0).into();
        assert_eq!(differences(&record), ["area_extremal.mode"]);
        record["methods"][0]["area_extremal"]["mode"] = serde_json::json!([1.0, 0.5]);
        assert_eq!(differences(&record), ["area_extremal.mode"], "what is laid out otherwise");
    }
}
