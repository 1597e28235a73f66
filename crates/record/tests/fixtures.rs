//! Every file in `fixtures/` is run, and every number it expects is met.

use std::path::PathBuf;

use experiment::{Finished, Options, Plan, run};
use plateau::Quantity;
use record::ResultFile;

/// Those of the papers, and the gallery.
fn fixtures() -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = ["", "/gallery"]
        .iter()
        .map(|part| format!("{}/../../fixtures{part}", env!("CARGO_MANIFEST_DIR")))
        .flat_map(|folder| {
            std::fs::read_dir(folder).expect("the folder of fixtures is part of the repository")
        })
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    assert!(files.len() >= 18, "{files:?}");
    files
}

fn fixture(name: &str) -> Plan {
    let path = fixtures().into_iter().find(|path| path.ends_with(name)).expect("a fixture of that name");
    Plan::read(path).expect("a sound fixture")
}

fn finish(plan: &Plan) -> Finished {
    run(plan, Options::default(), &()).expect("a kind of experiment that is offered")
}

#[test]
fn every_fixture_meets_the_numbers_it_states() {
    for file in fixtures() {
        let plan = Plan::read(&file).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
        let finished = finish(&plan);
        assert!(finished.expected() > 0, "{} expects nothing", file.display());
        assert_eq!(finished.missed(), [], "{}", file.display());
        let failures: Vec<_> = finished.results.failures().collect();
        assert!(failures.is_empty(), "{}: {failures:?}", file.display());
    }
}

#[test]
fn a_record_that_is_read_back_is_the_one_that_was_written() {
    for file in fixtures() {
        let plan = Plan::read(&file).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
        let record = ResultFile::new(&plan, &finish(&plan));
        let written = record.to_json().expect("every record has a JSON form");
        let read =
            ResultFile::parse(written.as_bytes()).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        assert!(read == record, "{}", file.display());
        // Bit for bit, for zeros have signs.
        assert!(read.to_json().expect("every record has a JSON form") == written, "{}", file.display());
    }
}

#[test]
fn a_wrong_expectation_is_missed() {
    let text = fixture("gt-5.1.toml").text.replace("dirichlet = 38.3538462", "dirichlet = 38.3538463");
    let missed = finish(&Plan::parse("wrong.toml", &text).unwrap()).missed();
    assert_eq!(missed.len(), 1);
    assert_eq!(
        (missed[0].method.as_str(), missed[0].expected.quantity),
        ("Bernstein Dirichlet", Quantity::Dirichlet)
    );
    assert!((missed[0].ours.unwrap() - 38.353846154).abs() < 1e-8);
}

#[test]
fn all_runs_of_the_papers_searches_end_at_the_minimum() {
    for name in ["gt-5.1.toml", "gt-5.2.toml", "gt-5.1-local.toml", "gt-5.2-local.toml"] {
        let finished = finish(&fixture(name));
        let done = finished.results.methods()[0].outcome.as_ref().expect("the search succeeds");
        let search = done.solved.search().expect("a search");
        let minimum = if name.contains("5.1") { 37.439_561_196_6 } else { 37.790_336_581 };
        assert_eq!(search.runs().len(), 10);
        for run in search.runs() {
            assert!(
                (run.value() / minimum - 1.0).abs() < 1e-6,
                "{name}, run {}: {}",
                run.index(),
                run.value()
            );
            assert_eq!(run.history().len(), 101);
            assert!(run.history().windows(2).all(|pair| pair[1] <= pair[0]));
        }
        // The energy of the patch, by quadrature of its jets, is the minimum of the reduced energy.
        assert!((done.figures.dirichlet.value - search.minimum()).abs() < 1e-11);
    }
}

#[test]
fn results_are_the_same_bytes_for_any_number_of_threads() {
    for name in ["gt-5.1.toml", "gt-5.2-local.toml", "degree-5-4.toml", "helicoid-deformation.toml"] {
        let plan = fixture(name);
        let json = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| ResultFile::new(&plan, &finish(&plan)).to_json().unwrap())
        };
        let one = json(1);
        assert!(one.contains("plateau-result/1") && !one.contains("null"));
        for threads in [2, 3, 8] {
            assert!(one == json(threads), "{name} on {threads} threads");
        }
    }
}
