//! Laws of the mode of the second variation.

use plateau::{
    AreaExtremal, Loop, Mode, Surface, fill, least_area, least_area_complex, least_area_raised,
    least_area_triangle,
};
use proptest::prelude::*;
use surfaces::{
    Bezier, Complex, EllipseArc, FixedEdge, Net, Point, TensorPatch, TriangleNet, TrianglePatch, Vertex,
    tb_coons,
};

/// That a mode belongs to the value told with it, that it is one mode of all that are like it, and that no change of its
/// coefficients has less.
fn hold(surface: &Surface, found: &AreaExtremal) {
    let (sigma, mode) = (found.second_variation.expect("a value"), found.mode.as_ref().expect("a mode"));
    let quotient = |mode: &Mode| mode.second_variation(surface).expect("a quotient").expect("no singularity");
    let own = quotient(mode);
    // The value is told by the rule of the last step, which gives the area to 1e-11 and the curvature's part to a little less.
    assert!((own - sigma).abs() <= 1e-6 * (1.0 + sigma.abs()), "{own} {sigma}");
    let all = mode.coefficients();
    let largest = all.iter().copied().fold(0.0, |largest: f64, c| largest.max(c.abs()));
    let first = all.iter().find(|c| c.abs() >= 1.0 - 1e-6).copied();
    assert!(largest == 1.0 && first.is_some_and(|c| c > 0.0), "{all:?}");
    // The same line of displacements is the same mode.
    let turned = Mode::new(all.iter().map(|c| -0.3 * c).collect()).expect("a mode");
    let distance = turned.coefficients().iter().zip(all).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(distance <= 1e-15, "{distance}");
    // What stays, stays; of the others none has less.
    for k in (0..all.len()).filter(|&k| all[k] != 0.0).step_by(1 + all.len() / 12) {
        for by in [1e-2, -1e-2] {
            let mut other = all.to_vec();
            other[k] += by;
            let other = quotient(&Mode::new(other).expect("a mode"));
            assert!(other >= own - 1e-9, "{k}: {other} {own}");
        }
    }
}

fn net(bumps: &[[f64; 3]]) -> Net {
    let point = |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[4 * i + j]);
    let row = |i: usize| (0..4).map(|j| point(i, j)).collect::<Vec<_>>();
    let col = |j: usize| (0..4).map(|i| point(i, j)).collect::<Vec<_>>();
    Net::from_boundary(&row(0), &row(3), &col(0), &col(3)).unwrap()
}

fn triangle(bumps: &[[f64; 3]]) -> TriangleNet {
    let n = 4;
    let at = TriangleNet::new(n, vec![Point::ZERO; 15]).unwrap();
    let point =
        |i: usize, j: usize| Point::new(i as f64, j as f64, 0.0) + Point::from(bumps[at.position(i, j)]);
    let ab: Vec<Point> = (0..=n).map(|k| point(n - k, k)).collect();
    let bc: Vec<Point> = (0..=n).map(|k| point(0, n - k)).collect();
    let ca: Vec<Point> = (0..=n).map(|k| point(k, 0)).collect();
    TriangleNet::from_boundary(&ab, &bc, &ca).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn modes_of_single_patches(
        bumps in prop::collection::vec([-0.1..0.1f64, -0.1..0.1, -0.4..0.4], 16), kind in 0..4,
        shape in [0.5..3.5f64, 0.5..3.5, 0.5..3.5, 0.5..3.5],
    ) {
        if kind == 3 {
            let patch = TrianglePatch::new(triangle(&bumps)).unwrap();
            let (patch, found) = least_area_triangle(&patch, 1e-10, &()).unwrap();
            hold(&Surface::Triangle(patch), &found);
        } else {
            let patch = match kind {
                0 => TensorPatch::bernstein(net(&bumps).raised(1)).unwrap(),
                1 => TensorPatch::gt(net(&bumps), shape).unwrap(),
                _ => tb_coons(net(&bumps), shape).unwrap(),
            };
            let (patch, found) = least_area(&patch, 1e-10, &()).unwrap();
            hold(&Surface::Tensor(patch), &found);
        }
    }
}

#[test]
fn modes_of_high_degrees_are_as_exact() {
    let bumps: Vec<[f64; 3]> = (0..16).map(|k| [0.0, 0.0, 0.3 * f64::from(k * k % 7)]).collect();
    for raise in [9, 21] {
        let (patch, found) = least_area_raised(&net(&bumps), raise, &[], 1e-10, &()).unwrap();
        hold(&Surface::Tensor(patch), &found);
    }
}

/// Two coaxial unit circles 2h apart: below h = 0.6627 a catenoid spans them, near it barely.
fn rings(h: f64) -> [Loop; 2] {
    [-h, h].map(|z| {
        let circle = EllipseArc::circle(Point::new(0.0, 0.0, z), Point::new(0.0, 0.0, 1.0), 1.0).unwrap();
        Loop::new(vec![circle.into()], None).unwrap()
    })
}

#[test]
fn the_catenoid_gives_way_at_its_waist() {
    let mut before = f64::INFINITY;
    for h in [0.5, 0.6, 0.65, 0.662] {
        let film = fill(&rings(h), 8).unwrap();
        let found = film.extremal.as_ref().unwrap();
        hold(&Surface::Complex(film.complex().clone()), found);
        let sigma = found.second_variation.unwrap();
        assert!(sigma > 0.0 && sigma < before, "{h}: {sigma}");
        before = sigma;
        // All round to the same side: a neck that narrows as a whole.
        let all = found.mode.as_ref().unwrap().coefficients();
        assert!(all.iter().all(|c| *c > -1e-3), "{h}: {all:?}");
    }
    assert!(before < 0.1, "{before}");
}

/// The faces of two squares side by side, the second walked the other way round.
fn squares(turned: bool) -> Complex {
    let p: Vec<Point> = (0..6)
        .map(|k| Point::new((k % 3) as f64, (k / 3) as f64, [0.0, 0.4, 0.0, 0.5, 0.0, 0.7][k]))
        .collect();
    let rim = [[0, 1], [1, 2], [2, 5], [5, 4], [4, 3], [3, 0]]
        .map(|ends| FixedEdge { ends, curve: Bezier::new(ends.map(|k| p[k]).to_vec()).unwrap() });
    let vertices: Vec<Vertex> = p.iter().map(|&p| Vertex::Fixed(p)).collect();
    let second = if turned { [1, 4, 5, 2] } else { [1, 2, 5, 4] };
    Complex::new(4, &vertices, &[[0, 1, 4, 3], second], &rim).unwrap()
}

#[test]
fn modes_do_not_ask_which_way_faces_are_walked() {
    let [plain, turned] = [false, true].map(|turned| {
        let (complex, found) = least_area_complex(&squares(turned), &[], 1e-11, &()).unwrap();
        hold(&Surface::Complex(complex), &found);
        found
    });
    let [a, b] = [&plain, &turned].map(|found| found.second_variation.unwrap());
    assert!((a - b).abs() <= 1e-9, "{a} {b}");
    // Points on the edge between are numbered alike, and so is their displacement.
    let edge = |found: &AreaExtremal| found.mode.as_ref().unwrap().coefficients()[6..6 + 7 * 3].to_vec();
    for (a, b) in edge(&plain).iter().zip(edge(&turned)) {
        assert!((a - b).abs() <= 1e-5, "{a} {b}");
    }
}

#[test]
fn a_line_where_three_films_meet_is_held() {
    let far = |k: usize, z: f64| {
        let angle = std::f64::consts::TAU * k as f64 / 3.0;
        Point::new(angle.cos(), angle.sin(), z)
    };
    let mut p = vec![Point::ZERO, Point::new(0.0, 0.0, 1.0)];
    p.extend((0..3).flat_map(|k| [far(k, 0.0), far(k, 1.0)]));
    let line = |a: usize, b: usize| FixedEdge { ends: [a, b], curve: Bezier::new(vec![p[a], p[b]]).unwrap() };
    let rim: Vec<FixedEdge> =
        (0..3).flat_map(|k| [line(0, 2 + 2 * k), line(2 + 2 * k, 3 + 2 * k), line(3 + 2 * k, 1)]).collect();
    let vertices: Vec<Vertex> = p.iter().map(|&p| Vertex::Fixed(p)).collect();
    let faces: Vec<[usize; 4]> = (0..3).map(|k| [0, 2 + 2 * k, 3 + 2 * k, 1]).collect();
    let complex = Complex::new(4, &vertices, &faces, &rim).unwrap();
    let (complex, found) = least_area_complex(&complex, &[], 1e-11, &()).unwrap();
    let joint = complex.orientation().joints().to_vec();
    assert_eq!(joint.len(), 1);
    let mode = found.mode.as_ref().expect("a mode");
    assert!(complex.edge_nodes(joint[0]).iter().all(|&node| mode.coefficients()[node] == 0.0));
    // Flat films: nothing but the gradient.
    assert!(found.second_variation.is_some_and(|sigma| (sigma - 1.0).abs() <= 1e-12), "{found:?}");
}

#[test]
fn numbers_that_are_no_mode_are_refused() {
    assert!(Mode::new(vec![0.0; 4]).is_none() && Mode::new(vec![1.0, f64::NAN]).is_none());
    assert!(Mode::new(Vec::new()).is_none());
    let patch = TensorPatch::bernstein(net(&[[0.0; 3]; 16])).unwrap();
    let other = Mode::new(vec![1.0; 9]).unwrap();
    assert_eq!(other.second_variation(&Surface::Tensor(patch)).unwrap(), None);
}
