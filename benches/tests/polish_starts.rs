//! Descents from random starts all end in the one minimum of J, within a handful of evaluations.

use optim::{Polish, PolishReason};
use plateau_benches::{example_5_1, example_5_2, gt_dirichlet, search_box};
use solve::Path;
use surfaces::Net;

const STARTS: usize = 100;

fn descents_agree(net: &Net, minimum: f64) {
    for path in [Path::Portable, Path::detect()] {
        let reduced = gt_dirichlet(net).unwrap().with_path(path).unwrap();
        let bounds = search_box().unwrap();
        let mut evaluations = Vec::new();
        let mut values = Vec::new();
        for descent in Polish::default().run_starts(&reduced, &bounds, STARTS, 20).unwrap() {
            assert_ne!(descent.reason, PolishReason::Budget, "{path}: {descent}");
            evaluations.push(descent.evaluations);
            values.push(descent.value);
        }
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = values.iter().copied().fold(0.0, f64::max);
        assert!((least - minimum).abs() < 1e-7, "{path}: {least}");
        assert!(largest - least <= 1e-12 * least, "{path}: {least} to {largest}");
        evaluations.sort_unstable();
        let (median, most) = (evaluations[STARTS / 2], evaluations[STARTS - 1]);
        assert!(median <= 20, "{path}: {median} evaluations in the median, {most} at most");
    }
}

#[test]
fn every_start_of_example_5_1_reaches_the_minimum() {
    descents_agree(&example_5_1().unwrap(), 37.439_561_2);
}

#[test]
fn every_start_of_example_5_2_reaches_the_minimum() {
    descents_agree(&example_5_2().unwrap(), 37.790_336_6);
}
