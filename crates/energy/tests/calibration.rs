//! Lower bounds by calibrations: below every area over the rim, and close to the least.

use energy::{Calibration, Plane, Unproved, area, certify};
use solve::solve_spd;
use surfaces::{Bezier, Complex, FixedEdge, Point, Vertex};

/// A surface of one face over the square [−1, 1]², with the heights of its rim given as Bézier ordinates of each side.
fn graph(height: impl Fn(f64, f64) -> f64, degree: usize) -> Complex {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let at = |[x, y]: [f64; 2]| Point::new(x, y, height(x, y));
    let vertices: Vec<Vertex> = corners.iter().map(|&c| Vertex::Fixed(at(c))).collect();
    let sides = (0..4).map(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 4]);
        // Quadratic along a side: the middle ordinate from the height in the middle.
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let (first, last, half) = (at(a), at(b), at(middle));
        let points = vec![first, half * 2.0 + (first + last) * -0.5, last];
        FixedEdge { ends: [k, (k + 1) % 4], curve: Bezier::new(points).expect("three points") }
    });
    Complex::new(degree, &vertices, &[[0, 1, 2, 3]], &sides.collect::<Vec<_>>()).expect("a sound complex")
}

/// The best potential by Newton's method from the fit to the flux.
fn potential(calibration: &Calibration) -> Vec<f64> {
    let solved = |matrix: &bases::Matrix, rhs: &[f64]| -> Vec<f64> {
        let n = rhs.len() - 1;
        let reduced: Vec<f64> = (1..=n).flat_map(|i| matrix.row(i)[1..].to_vec()).collect();
        let solution = solve_spd(n, &reduced, 1, &rhs[1..]).expect("positive definite");
        std::iter::once(0.0).chain(solution.x).collect()
    };
    let (matrix, rhs) = calibration.fit();
    let mut psi = solved(&matrix, &rhs);
    while calibration.value(&psi).is_none() {
        psi.iter_mut().for_each(|c| *c *= 0.95);
    }
    for _ in 0..12 {
        let value = calibration.value(&psi).expect("admissible");
        let (gradient, hessian) = calibration.derivatives(&psi);
        let step = solved(&hessian, &gradient);
        let mut length = 1.0;
        loop {
            let next: Vec<f64> = psi.iter().zip(&step).map(|(c, s)| c + length * s).collect();
            if calibration.value(&next).is_some_and(|reached| reached >= value) {
                psi = next;
                break;
            }
            length *= 0.5;
            if length < 1e-3 {
                return psi;
            }
        }
    }
    psi
}

fn horizontal() -> Plane {
    Plane::with_normal(Point::ZERO, Point::new(0.0, 0.0, 1.0)).expect("a normal")
}

#[test]
fn the_bound_of_the_saddle_frame_is_just_below_its_least_area() {
    let saddle = graph(|x, y| x * x - y * y, 2);
    let least = 7.383505602602;
    let mut gaps = Vec::new();
    for degree in [5, 7, 9, 11] {
        let calibration =
            Calibration::new(&saddle, &horizontal(), degree, 3 * degree).expect("offered").expect("a graph");
        let psi = potential(&calibration);
        let proved = certify(&saddle, &horizontal(), degree, &psi).expect("proved");
        let found = calibration.value(&psi).expect("admissible");
        assert!(proved <= least && (found - proved).abs() < 1e-6, "{degree}: {proved} {found}");
        gaps.push(least - proved);
    }
    assert!(gaps.windows(2).all(|pair| pair[1] < pair[0]) && gaps[3] < 1e-7, "{gaps:?}");
}

#[test]
fn a_plane_is_its_own_bound() {
    let slope = graph(|x, y| 0.5 * x - 0.25 * y, 2);
    let exact = 4.0 * (1.0_f64 + 0.25 + 0.0625).sqrt();
    let calibration = Calibration::new(&slope, &horizontal(), 2, 6).expect("offered").expect("a graph");
    let proved = certify(&slope, &horizontal(), 2, &potential(&calibration)).expect("proved");
    assert!(proved <= exact && exact - proved < 1e-11, "{proved} {exact}");
}

#[test]
fn the_bound_does_not_depend_on_where_the_frame_lies() {
    let saddle = graph(|x, y| x * x - y * y, 2);
    let turned = |p: Point| Point::new(0.6 * p.x - 0.8 * p.z, p.y, 0.8 * p.x + 0.6 * p.z);
    let shift = Point::new(100.0, -50.0, 25.0);
    let moved = saddle.points().iter().map(|&p| turned(p) + shift).collect::<Vec<_>>();
    let vertices: Vec<Vertex> = moved[..4].iter().map(|&p| Vertex::Fixed(p)).collect();
    let edges: Vec<FixedEdge> = (0..4)
        .map(|k| {
            let ends = saddle.edges()[k].ends();
            let points = saddle.edge_nodes(k).into_iter().map(|node| moved[node]).collect();
            FixedEdge { ends, curve: Bezier::new(points).expect("a curve") }
        })
        .collect();
    let elsewhere = Complex::new(2, &vertices, &[[0, 1, 2, 3]], &edges).expect("a sound complex");
    let plane = Plane::with_normal(shift, turned(Point::new(0.0, 0.0, 1.0))).expect("a normal");
    let bound = |complex: &Complex, plane: &Plane| {
        let calibration = Calibration::new(complex, plane, 8, 14).expect("offered").expect("a graph");
        certify(complex, plane, 8, &potential(&calibration)).expect("proved")
    };
    let (here, there) = (bound(&saddle, &horizontal()), bound(&elsewhere, &plane));
    assert!((here - there).abs() < 1e-9, "{here} {there}");
    let patch = elsewhere.patch(0).expect("a patch");
    assert!(there <= area(&patch).expect("integrable").value);
}

#[test]
fn forged_potentials_are_refused() {
    let saddle = graph(|x, y| x * x - y * y, 2);
    let calibration = Calibration::new(&saddle, &horizontal(), 6, 12).expect("offered").expect("a graph");
    let psi = potential(&calibration);
    let steep: Vec<f64> = psi.iter().map(|c| 3.0 * c).collect();
    assert_eq!(certify(&saddle, &horizontal(), 6, &steep), Err(Unproved::Steep { face: 0 }));
    assert_eq!(certify(&saddle, &horizontal(), 5, &psi), Err(Unproved::Mismatch));
    let below = Plane::with_normal(Point::ZERO, Point::new(0.0, 0.0, -1.0)).expect("a normal");
    assert_eq!(certify(&saddle, &below, 6, &psi), Err(Unproved::NoGraph { face: 0 }));
}
