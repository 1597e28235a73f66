//! The JSON Schema of experiment files says what the parser does: the same tables, keys, names; and it admits every
//! sound file. The validator here knows only the keywords that the schema uses, and panics at any other.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use experiment::{Source, Template, experiment_schema};
use serde_json::Value;

fn schema() -> Value {
    serde_json::from_str(&experiment_schema()).expect("the schema is JSON")
}

fn follow<'a>(root: &'a Value, schema: &'a Value) -> &'a Value {
    let Some(target) = schema.get("$ref") else { return schema };
    let pointer =
        target.as_str().and_then(|text| text.strip_prefix('#')).expect("a reference inside the schema");
    root.pointer(pointer).expect("the target of a reference")
}

fn validate(root: &Value, schema: &Value, value: &Value, path: &str) -> Result<(), String> {
    let fail = |what: String| Err(format!("{path}: {what}"));
    for (keyword, rule) in schema.as_object().expect("a schema is an object") {
        let number = || value.as_f64().zip(rule.as_f64());
        let length = value.as_array().map(Vec::len).zip(rule.as_u64());
        match keyword.as_str() {
            "$schema"
            | "$defs"
            | "title"
            | "description"
            | "default"
            | "examples"
            | "additionalProperties" => {}
            "$ref" => validate(root, follow(root, schema), value, path)?,
            "type" => {
                let fits = match rule.as_str().unwrap() {
                    "object" => value.is_object(),
                    "array" => value.is_array(),
                    "string" => value.is_string(),
                    "number" => value.is_number(),
                    "integer" => value.is_i64() || value.is_u64(),
                    "boolean" => value.is_boolean(),
                    other => panic!("unknown type {other}"),
                };
                if !fits {
                    return fail(format!("{value} is no {rule}"));
                }
            }
            "enum" if !rule.as_array().unwrap().contains(value) => {
                return fail(format!("{value} is none of {rule}"));
            }
            "enum" => {}
            "minimum" if number().is_some_and(|(x, bound)| x < bound) => {
                return fail(format!("{value} < {rule}"));
            }
            "maximum" if number().is_some_and(|(x, bound)| x > bound) => {
                return fail(format!("{value} > {rule}"));
            }
            "exclusiveMinimum" if number().is_some_and(|(x, bound)| x <= bound) => {
                return fail(format!("{value} ≤ {rule}"));
            }
            "exclusiveMaximum" if number().is_some_and(|(x, bound)| x >= bound) => {
                return fail(format!("{value} ≥ {rule}"));
            }
            "minItems" if length.is_some_and(|(n, bound)| (n as u64) < bound) => {
                return fail("too short".into());
            }
            "maxItems" if length.is_some_and(|(n, bound)| (n as u64) > bound) => {
                return fail("too long".into());
            }
            "minLength" if value.as_str().is_some_and(str::is_empty) => return fail("empty".into()),
            "minimum" | "maximum" | "exclusiveMinimum" | "exclusiveMaximum" | "minItems" | "maxItems"
            | "minLength" => {}
            "items" => {
                for (k, item) in value.as_array().into_iter().flatten().enumerate() {
                    validate(root, rule, item, &format!("{path}[{k}]"))?;
                }
            }
            "properties" => {
                for (key, inner) in value.as_object().into_iter().flatten() {
                    match rule.get(key) {
                        Some(rule) => validate(root, rule, inner, &format!("{path}.{key}"))?,
                        None => return fail(format!("unknown key {key}")),
                    }
                }
            }
            "required" => {
                let missing = |key: &&Value| value.get(key.as_str().unwrap()).is_none();
                if let Some(key) = rule.as_array().unwrap().iter().find(missing) {
                    return fail(format!("{key} is missing"));
                }
            }
            "anyOf" | "oneOf" => {
                let fitting = rule
                    .as_array()
                    .unwrap()
                    .iter()
                    .filter(|rule| validate(root, rule, value, path).is_ok())
                    .count();
                if fitting == 0 || (keyword == "oneOf" && fitting > 1) {
                    return fail(format!("{fitting} alternatives fit"));
                }
            }
            other => panic!("the validator of this test does not know {other}"),
        }
    }
    Ok(())
}

fn valid(text: &str) -> Result<(), String> {
    let value: Value = toml::from_str(text).expect("TOML");
    let schema = schema();
    validate(&schema, &schema, &value, "")
}

#[test]
fn every_fixture_and_template_is_valid() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut count = 0;
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            assert_eq!(valid(&fs::read_to_string(&path).unwrap()), Ok(()), "{}", path.display());
            count += 1;
        }
    }
    assert!(count >= 20);
    for template in Template::ALL {
        assert_eq!(valid(template.text()), Ok(()), "{}", template.name());
    }
}

#[test]
fn slips_are_invalid() {
    let sound = Template::Tensor.text();
    for (from, to) in [
        ("particles", "particle"),
        ("particles = 50", "particles = 0"),
        ("energy = \"dirichlet\"", "energy = \"dirichlets\""),
        ("box = [0.5, 3.5]", "box = [0.5, 4.5]"),
        ("title", "# title"),
        ("[0, 0, 0], [2, 0, 2]", "[0, 0], [2, 0, 2]"),
        ("formats = [\"obj\"", "formats = [\"objs\""),
        ("construction = \"discrete-coons\"", "construction = \"discrete-coons\"\nmask = 0"),
    ] {
        let slip = sound.replacen(from, to, 1);
        assert_ne!(slip, sound, "{from}");
        assert!(valid(&slip).is_err(), "{from} → {to}");
    }
}

/// What the parser says of a file with `stray` in it, in one line.
fn complaint(text: &str) -> String {
    Source::parse("probe.toml", text, Path::new(""))
        .expect_err("a stray word is refused")
        .to_string()
        .replace('\n', " ")
}

/// A file in which `line` stands in one table.
fn probe(table: &str, line: &str) -> String {
    let sides =
        "u0 = [[0,0,0],[0,1,0]]\nu1 = [[1,0,0],[1,1,0]]\nv0 = [[0,0,0],[1,0,0]]\nv1 = [[0,1,0],[1,1,0]]";
    let boundary = if table == "boundary" { line } else { sides };
    let tables = match table {
        "" => return format!("title = \"probe\"\n{line}\n"),
        "helicoid" | "trapezium-helicoid" | "net" | "curve" => {
            return format!("title = \"probe\"\n[{table}]\n{line}\n");
        }
        "[curve]" | "[face]" | "[vertex]" => {
            return format!(
                "title = \"probe\"\n[{table}]\n{line}\n[[method]]\nname = \"probe\"\nenergy = \"area\"\n"
            );
        }
        "curve.spline" | "curve.through" | "curve.circle" => {
            return format!(
                "title = \"probe\"\n[[curve]]\nname = \"probe\"\n[{table}]\n{line}\n[boundary]\nloops = [[\"probe\"]]\n"
            );
        }
        "method over loops" => {
            return format!(
                "title = \"probe\"\n[boundary]\npolygon = [[0,0,0],[1,0,0],[0,1,1]]\n[[method]]\nname = \"probe\"\n{line}\n"
            );
        }
        "boundary" => String::new(),
        "method" => line.to_owned(),
        "method.expect" => format!("energy = \"dirichlet\"\nexpect = {{ {line} }}"),
        "method.published" => format!("energy = \"dirichlet\"\n[[method.published]]\n{line}"),
        "method.expect.area" => format!("energy = \"dirichlet\"\nexpect.area = {{ {line} }}"),
        other => format!("energy = \"dirichlet\"\n[{other}]\n{line}"),
    };
    format!("title = \"probe\"\n[boundary]\n{boundary}\n[[method]]\nname = \"probe\"\n{tables}\n")
}

/// The tables of the schema, by the names of [`probe`].
fn tables(schema: &Value) -> Vec<(&'static str, &Value)> {
    let at = |pointer: &str| schema.pointer(pointer).unwrap_or_else(|| panic!("{pointer}"));
    vec![
        ("", schema),
        ("boundary", at("/properties/boundary")),
        ("method", at("/properties/method/items")),
        ("search", at("/properties/search")),
        ("helicoid", at("/properties/helicoid")),
        ("trapezium-helicoid", at("/properties/trapezium-helicoid")),
        ("net", at("/properties/net")),
        ("curve", at("/properties/curve/anyOf/0")),
        ("[curve]", at("/properties/curve/anyOf/1/items")),
        ("curve.spline", at("/properties/curve/anyOf/1/items/properties/spline")),
        ("curve.through", at("/properties/curve/anyOf/1/items/properties/through")),
        ("curve.circle", at("/properties/curve/anyOf/1/items/properties/circle")),
        ("[face]", at("/properties/face/items")),
        ("[vertex]", at("/properties/vertex/items")),
        ("output", at("/properties/output")),
        ("sweep", at("/properties/sweep")),
        ("[sweep.axis]", at("/properties/sweep/properties/axis/items")),
        ("method.expect", at("/properties/method/items/properties/expect")),
        ("method.published", at("/properties/method/items/properties/published/anyOf/0")),
        ("method.expect.area", at("/properties/expect/properties/area/anyOf/2")),
    ]
}

#[test]
fn the_keys_are_those_of_the_parser() {
    let schema = schema();
    for (name, table) in tables(&schema) {
        let text = complaint(&probe(name, "stray-key = 1"));
        let list = ["may hold: ", " are: "].iter().find_map(|lead| Some(text.split_once(lead)?.1));
        let list = list.unwrap_or_else(|| panic!("no list of keys in: {text}"));
        let words = list.split(' ').map_while(|word| match word.strip_suffix(',') {
            Some(word) => Some((word, true)),
            None => Some((word, false)),
        });
        let mut known = BTreeSet::new();
        for (word, more) in words {
            known.insert(word);
            if !more {
                break;
            }
        }
        let keys: BTreeSet<&str> =
            table["properties"].as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(keys, known, "[{name}]: {text}");
        assert_eq!(table["additionalProperties"], false, "[{name}]");
    }
}

#[test]
fn the_names_are_those_of_the_parser() {
    let schema = schema();
    let mut checked = 0;
    for (name, table) in tables(&schema) {
        for (key, rule) in table["properties"].as_object().unwrap() {
            let rules = std::iter::once(rule).chain(rule["anyOf"].as_array().into_iter().flatten());
            let Some(names) = rules.chain(rule.get("items")).find_map(|rule| rule["enum"].as_array()) else {
                continue;
            };
            let names: BTreeSet<&str> = names.iter().filter_map(Value::as_str).collect();
            let line = match (name, key.as_str()) {
                (_, "formats") => "formats = [\"stray\"]".to_owned(),
                (_, "search-energy") => "basis = \"gt\"\nenergy = \"dirichlet\"\nsearch = true\nsearch-energy = \"stray\"\nraise = 1".to_owned(),
                ("method", "solver") => "energy = \"dirichlet\"\nsolver = \"stray\"".to_owned(),
                ("method", "search") => "basis = \"gt\"\nenergy = \"dirichlet\"\nsearch = \"stray\"".to_owned(),
                _ => format!("{key} = \"stray\""),
            };
            let text = complaint(&probe(name, &line));
            let list = text.split_once("expected \"").map(|(_, list)| list);
            let list = list.unwrap_or_else(|| panic!("no list of names for {name}.{key} in: {text}"));
            // `a", "b" or "c"`: the names stand at every second quote.
            let list = list.split("  ").next().unwrap_or(list);
            let known: BTreeSet<&str> = list.split('"').step_by(2).collect();
            assert_eq!(names, known, "{name}.{key}: {text}");
            checked += 1;
        }
    }
    assert!(checked >= 11, "{checked}");
}

#[test]
fn every_key_is_explained() {
    let schema = schema();
    for (name, table) in tables(&schema) {
        for (key, rule) in table["properties"].as_object().unwrap() {
            let described =
                |rule: &Value| rule["description"].as_str().is_some_and(|text| text.ends_with('.'));
            assert!(described(rule) || described(follow(&schema, rule)), "{name}.{key}");
        }
    }
}

/// The program's bounds: at each bound of the schema a value is not refused for its size, and beyond it, it is.
#[test]
fn the_bounds_are_those_of_the_parser() {
    let schema = schema();
    let mut checked = 0;
    for (name, table) in tables(&schema) {
        for (key, rule) in table["properties"].as_object().unwrap() {
            let beyond = |bound: f64, out: f64| bound + out * (1e-9 * bound.abs()).max(1e-9);
            for (keyword, out) in [("minimum", -1.0), ("maximum", 1.0)] {
                let Some(bound) = rule[keyword].as_f64() else { continue };
                let whole = rule["type"] == "integer";
                let (at, past) = match whole {
                    true => (
                        rule[keyword].to_string(),
                        (rule[keyword].as_i64().unwrap() as i128 + out as i128).to_string(),
                    ),
                    false => (format!("{bound:e}"), format!("{:e}", beyond(bound, out))),
                };
                let faults = |value: &str| {
                    let table = match (name, key.as_str()) {
                        ("method", "degree" | "layers" | "accuracy" | "rim-tolerance") => "method over loops",
                        (name, _) => name,
                    };
                    let probe = probe(table, &format!("{key} = {value}"));
                    let found = Source::parse("probe.toml", &probe, Path::new("")).err();
                    let named = format!("`{key}`");
                    let refused = |d: &experiment::Diagnostic| {
                        d.message().starts_with(&named) && d.message().contains(" must ")
                    };
                    found.is_some_and(|refusal| refusal.diagnostics().iter().any(refused))
                };
                assert!(!faults(&at), "{name}.{key} = {at} is refused");
                assert!(faults(&past), "{name}.{key} = {past} is not refused");
                checked += 1;
            }
        }
    }
    assert!(checked >= 40, "{checked}");
}
