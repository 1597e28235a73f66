//! The published tables: all of them are run, all numbers are accounted for, the output never varies.

use std::collections::BTreeSet;
use std::fs;

use experiment::{Experiment, Options, Plan};
use record::{Verdict, reproduce};

#[test]
fn every_published_number_agrees_or_is_a_known_misprint() {
    let reproduction = reproduce(Options::default(), &());
    assert!(reproduction.is_sound(), "{}", reproduction.table());
    let misprints =
        reproduction.entries.iter().filter(|entry| matches!(entry.verdict, Verdict::Misprint { .. }));
    let misprints: Vec<&str> = misprints.map(|entry| entry.printed.as_str()).collect();
    assert_eq!(
        misprints,
        ["38.0000", "37.7905", "4.67834", "0.99685", "0.99563", "0.99546", "1.33623", "1.33625"]
    );
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let again = pool.install(|| reproduce(Options::default(), &()));
    assert_eq!(again.table(), reproduction.table());
    assert_eq!(again.to_json().unwrap(), reproduction.to_json().unwrap());
}

/// Both ways: no fixture with published numbers is forgotten, and no reason explains a number that agrees.
#[test]
fn every_fixture_with_published_numbers_is_reproduced() {
    let mut published = BTreeSet::new();
    for file in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures")).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let plan = Plan::read(&path).unwrap();
        if let Experiment::Patch(patches) = &plan.experiment {
            for (method, wanted) in patches.methods.iter().zip(&plan.wanted) {
                for number in &wanted.published {
                    published.insert((
                        format!("{}.toml", plan.stem),
                        method.name().to_owned(),
                        number.text.clone(),
                    ));
                }
            }
        }
    }
    let reproduction = reproduce(Options::default(), &());
    let reproduced: BTreeSet<_> = reproduction
        .entries
        .iter()
        .map(|entry| (entry.file.clone(), entry.method.clone(), entry.printed.clone()))
        .collect();
    assert_eq!(reproduced, published);
}
