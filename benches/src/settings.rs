use std::time::Duration;

use criterion::Criterion;

/// Criterion with the arguments of the command line, set so that all groups together take a few minutes: less than a
/// second of warm-up and measurement each, 20 samples.
pub fn criterion() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(900))
        .sample_size(20)
        .nresamples(5_000)
        .configure_from_args()
}
