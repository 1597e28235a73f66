//! Which corner of a triangle comes first: it matters over the right triangle, and over the equilateral one it does not.

use experiment::{Options, Plan, run};
use plateau::Figures;
use surfaces::Point;

const SIDES: [[[f64; 3]; 4]; 3] = [
    [[0.0, 0.0, 0.0], [2.0, -1.0, 3.0], [4.0, 0.5, -1.0], [6.0, 0.0, 0.0]],
    [[6.0, 0.0, 0.0], [5.0, 2.0, 2.0], [3.5, 4.0, 2.0], [2.0, 6.0, 1.0]],
    [[2.0, 6.0, 1.0], [1.0, 4.0, -2.0], [0.5, 2.0, 0.0], [0.0, 0.0, 0.0]],
];

/// The figures and the middle of the surface with side `first` as ab, backwards if `turned`.
fn found(first: usize, turned: bool, method: &str) -> (Figures, Point) {
    let side = |k: usize| {
        let mut points = SIDES[k % 3].to_vec();
        if turned {
            points.reverse();
        }
        format!("{points:?}")
    };
    let order = if turned { [first, first + 2, first + 1] } else { [first, first + 1, first + 2] };
    let [ab, bc, ca] = order.map(side);
    let text = format!(
        "title = \"t\"\n[boundary]\nab = {ab}\nbc = {bc}\nca = {ca}\n[[method]]\nname = \"m\"\n{method}\n[output]\nmesh = 2\n"
    );
    let plan = Plan::parse("t.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
    let finished = run(&plan, Options::default(), &()).unwrap();
    let done =
        finished.results.methods()[0].outcome.as_ref().unwrap_or_else(|error| panic!("{method}: {error}"));
    (done.figures, done.solved.surface().patch().expect("one patch").point(1.0 / 3.0, 1.0 / 3.0))
}

#[test]
fn over_the_equilateral_triangle_every_corner_may_come_first() {
    for energy in ["dirichlet", "laplacian", "bending", "coons"] {
        for raise in [0, 3] {
            let keys = format!("energy = \"{energy}\"\nraise = {raise}");
            let symmetric = format!("{keys}\ndomain = \"equilateral\"");
            let (figures, middle) = found(0, false, &symmetric);
            let mut depends = false;
            let right = found(0, false, &keys).1;
            for (first, turned) in [(1, false), (2, false), (0, true), (1, true)] {
                let (other, there) = found(first, turned, &symmetric);
                let change = (figures.area.value / other.area.value - 1.0).abs();
                assert!(
                    change < 1e-12,
                    "{symmetric}, first {first}: {} {}",
                    figures.area.value,
                    other.area.value
                );
                assert!(middle.distance(there) < 1e-12, "{symmetric}, first {first}: {middle:?} {there:?}");
                depends |= right.distance(found(first, turned, &keys).1) > 1e-3;
            }
            assert!(depends, "{keys}: the test would not see a dependence");
        }
    }
}

#[test]
fn metric_corrections_begin_where_the_domain_says() {
    let keys = "energy = \"dirichlet\"\ndomain = \"equilateral\"\nmetric-steps = 2";
    let (first, second) = (found(0, false, keys), found(2, true, keys));
    assert!((first.0.area.value / second.0.area.value - 1.0).abs() < 1e-12);
    assert!(first.1.distance(second.1) < 1e-11);
}

#[test]
fn the_mask_of_the_cubic_coons_patch_is_singular_at_degrees_4_and_10() {
    for raise in 0..=8 {
        let sides = SIDES.map(|side| format!("{side:?}"));
        let text = format!(
            "title = \"t\"\n[boundary]\nab = {}\nbc = {}\nca = {}\n[[method]]\nname = \"m\"\nmask = {}\nraise = {raise}\n[output]\nmesh = 2\n",
            sides[0],
            sides[1],
            sides[2],
            -2.0 / 3.0
        );
        let plan = Plan::parse("t.toml", &text).unwrap_or_else(|refusal| panic!("{}", refusal.render(false)));
        let finished = run(&plan, Options::default(), &()).unwrap();
        let outcome = &finished.results.methods()[0].outcome;
        match (outcome, raise) {
            (Err(error), 1 | 7) => assert!(error.to_string().contains("singular"), "{error}"),
            (Ok(_), 0 | 2..=6 | 8) => {}
            (other, _) => panic!("degree {}: {other:?}", raise + 3),
        }
    }
}
