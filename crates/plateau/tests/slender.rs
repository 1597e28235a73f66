//! A single patch over a border many times as long as wide says what cutting it across gains.

use plateau::{
    Boundary, Context, CutGain, Done, Fill, Functions, Loop, Method, TensorBoundary, TensorInterior, Warning,
    solve,
};
use surfaces::Point;

/// The long sides of a ribbon of width 1 that swings up and down, `height` at most, and its short ones, of this degree along.
fn ribbon(length: f64, height: f64, degree: usize) -> [Vec<Point>; 4] {
    let at = |k: usize, y: f64| {
        let s = k as f64 / degree as f64;
        Point::new(length * s, y, height * (7.0 * s).sin() + 0.4 * s * y)
    };
    let [v0, v1] = [0.0, 1.0].map(|y| (0..=degree).map(|k| at(k, y)).collect::<Vec<_>>());
    [vec![v0[0], v1[0]], vec![v0[degree], v1[degree]], v0, v1]
}

fn least([u0, u1, v0, v1]: [Vec<Point>; 4], raise: usize) -> Done {
    let interior = TensorInterior::LeastArea { tolerance: 1e-10, bound: false, layers: 0 };
    let method = Method::tensor("a", Functions::Bernstein, interior).unwrap().raised(raise).unwrap();
    let boundary = Boundary::Tensor(TensorBoundary::new(u0, u1, v0, v1).unwrap());
    solve(&boundary, &method, &Context::new(0)).unwrap()
}

/// What is said of slenderness: how slender, and what cutting gains.
fn slender(done: &Done) -> Option<(f64, Option<CutGain>)> {
    done.warnings.iter().find_map(|warning| match warning {
        Warning::Slender { ratio, cut } => Some((*ratio, *cut)),
        _ => None,
    })
}

#[test]
fn what_cutting_gains_is_what_a_loop_has_less() {
    let sides = ribbon(20.0, 3.0, 5);
    let done = least(sides.clone(), 1);
    let (ratio, cut) = slender(&done).expect("a ribbon is slender");
    let cut = cut.expect("a few patches are computed");
    assert!(ratio > 19.0 && ratio < 40.0, "{ratio}");
    assert!(cut.pieces as f64 >= ratio / 4.0 && cut.degree == 6, "{ratio} {cut:?}");
    let area = done.figures.area.value;
    assert!(
        (area - cut.area - cut.gained).abs() <= 1e-12 * area && cut.gained > 1e-7 * area,
        "{area} {cut:?}"
    );
    // As a loop the border is cut in quarters of quarters, which hold these pieces.
    let [u0, u1, v0, v1] = sides;
    let back = |side: &[Point]| side.iter().rev().copied().collect::<Vec<_>>();
    let around = Loop::sides(vec![v0, u1, back(&v1), back(&u0)]).unwrap();
    let film = Fill::default().with_degree(6).loops(&[around], &()).unwrap();
    let finer = film.figures.area.value;
    assert!(finer <= cut.area * (1.0 + 1e-9), "{finer} {cut:?}");
    assert!(area - finer <= 2.0 * cut.gained, "{area} {finer} {cut:?}");
}

#[test]
fn nothing_is_said_where_nothing_is_gained() {
    assert_eq!(slender(&least(ribbon(3.0, 0.5, 3), 2)), None, "not slender");
    assert_eq!(slender(&least(ribbon(20.0, 0.0, 3), 2)), None, "flat");
}

#[test]
fn what_would_take_long_is_said_in_words() {
    let done = least(ribbon(100.0, 3.0, 6), 4);
    let (ratio, cut) = slender(&done).expect("a ribbon is slender");
    assert!(ratio > 90.0 && cut.is_none(), "{cut:?}");
    let said = done.warnings.iter().map(ToString::to_string).find(|said| said.contains("as long as wide"));
    assert!(said.is_some_and(|said| said.contains("was not computed")));
}
