//! What areas are estimated to lie above the least.

mod estimates;

use estimates::{Told, frames};
use plateau::{Fill, Loop, Warning, excess_of_net, least_area_raised};
use surfaces::{Net, Point, discrete_coons};

#[test]
fn estimates_are_as_large_as_what_they_estimate() {
    let mut inside = 0;
    // Frames of every kind; the example `effectivity` prints all.
    for frame in frames().iter().step_by(4) {
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
    assert!(inside >= 9, "{inside}");
}

#[test]
fn newtons_method_tells_what_a_coons_patch_lacks() {
    // Three corners of a square and one above it; K(¾)/K(¼) is the least area over a unit cube's edges.
    for (height, least) in [(1.0, Some(1.279_261_571_171_006)), (0.6, None)] {
        let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., height], [0., 1., 0.]].map(Point::from);
        let bilinear = Net::new(2, 2, vec![a, d, b, c]).expect("four points");
        let (_, found) = least_area_raised(&bilinear, 8, &[], 1e-11, &()).expect("a least area");
        let truth = least.unwrap_or(found.area.value);
        let line = |p: Point, q: Point| vec![p, (p + q) * 0.5, q];
        let coons = discrete_coons(&line(a, d), &line(b, c), &line(a, b), &line(d, c)).expect("a net");
        let area = energy::area(&surfaces::TensorPatch::bernstein(coons.clone()).expect("a patch"))
            .expect("an area");
        let excess = excess_of_net(&coons).expect("a system").expect("near a minimum");
        let effectivity = excess / (area.value - truth);
        assert!((0.9..=1.2).contains(&effectivity), "{height}: {excess} of {}", area.value - truth);
    }
}

#[test]
fn the_degree_rises_to_the_accuracy() {
    let corners =
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]].map(Point::from);
    let hexagon = [Loop::polygon(&corners).expect("a polygon")];
    let least = 1.5 * 1.279_261_571_171_006;
    let mut degrees = Vec::new();
    for accuracy in [1e-3, 1e-9] {
        let fill = Fill::default().with_degree(2).with_accuracy(accuracy);
        let film = fill.loops(&hexagon, &()).expect("a film");
        assert!(film.warnings.is_empty(), "{:?}", film.warnings);
        assert!(
            (film.figures.area.value - least).abs() <= 1.5 * accuracy * least,
            "{}",
            film.figures.area.value
        );
        degrees.push(film.complex().degree());
    }
    assert!(degrees[0] < degrees[1], "{degrees:?}");
    // What is not reached is said.
    let fill = Fill::default().with_degree(14).with_accuracy(1e-12);
    let film = fill.loops(&hexagon, &()).expect("a film");
    let is_told = film.warnings.iter().any(|warning| matches!(warning, Warning::Inaccurate { .. }));
    assert_eq!(is_told, film.estimate.is_none_or(|estimate| estimate > 1e-12 * film.figures.area.value));
}
