//! Any bytes as an experiment file: a plan, or a refusal that says where; and what small plans compute is finite.

#![no_main]

use experiment::{Experiment, Options, Plan};
use libfuzzer_sys::fuzz_target;
use plateau::{Boundary, Filling, TensorInterior, TriangleInterior};
use record::{ResultFile, StoredResult};

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Plan::parse("fuzz.toml", text) {
        Err(refusal) => {
            assert!(!refusal.diagnostics().is_empty());
            let page = refusal.render(false);
            assert!(page.contains("fuzz.toml:"), "no place: {page}");
            for diagnostic in refusal.diagnostics() {
                assert!(diagnostic.span().is_none_or(|span| span.end <= text.len()));
            }
        }
        Ok(plan) if is_small(&plan) => {
            let Ok(finished) = experiment::run(&plan, Options::default(), &()) else { return };
            let record = ResultFile::new(&plan, &finished).to_json().expect("every record has a JSON form");
            assert!(!record.contains("null"), "a number that is not finite: {record}");
            if finished.results.curves().is_empty() {
                StoredResult::parse(record.as_bytes()).expect("what is written can be read");
            }
        }
        Ok(_) => {}
    }
});

/// Whether the plan runs in a few milliseconds: thousands of them a minute find more than one that takes a minute.
fn is_small(plan: &Plan) -> bool {
    let Experiment::Patch(patch) = &plan.experiment else { return false };
    if matches!(patch.boundary, Boundary::Opposite(_)) {
        return false;
    }
    let (m, n) = patch.boundary.degrees();
    m.max(n) < 5
        && plan.output.mesh <= 12
        && patch.methods.len() <= 3
        && patch.methods.iter().all(|method| {
            let is_linear = match method.filling() {
                Filling::Tensor { functions, interior } => {
                    let linear = matches!(
                        interior,
                        TensorInterior::Extremal { .. } | TensorInterior::DiscreteCoons | TensorInterior::Mask { .. }
                    );
                    linear && functions.searched().is_none()
                }
                Filling::Triangle(interior) => matches!(
                    interior,
                    TriangleInterior::Extremal { .. } | TriangleInterior::DiscreteCoons | TriangleInterior::Mask(_)
                ),
            };
            is_linear && method.raise() <= 2
        })
}
