//! What areas are estimated to lie above the least.

mod estimates;

use estimates::{Told, frames};

#[test]
fn estimates_are_as_large_as_what_they_estimate() {
    let mut inside = 0;
    // Frames of every kind; the example `effectivity` prints all.
    for frame in frames().iter().step_by(3) {
        let told = frame.told();
        let Told { above, ref estimate, .. } = told;
        let Ok(estimate) = *estimate else { continue };
        assert!(estimate > 0.0, "{}: {estimate}", frame.name);
        if told.is_converged() {
            assert!(estimate <= 1e-11 * told.area, "{}: {estimate}", frame.name);
            continue;
        }
        let effectivity = estimate / above;
        assert!((0.7..=1.5).contains(&effectivity), "{}: {estimate} of {above}", frame.name);
        inside += 1;
    }
    assert!(inside >= 12, "{inside}");
}
