//! Cells: derivatives of the area against differences, products against samples, forms against their sums.

use std::sync::Arc;

use bases::{Matrix, Nodal};
use energy::{Cell, Freedom, PiecedCell, Pieces, ProductCell, SampledCell};
use surfaces::Point;

fn cell() -> (ProductCell, SampledCell) {
    let cell = ProductCell::new(&Nodal::new(4).unwrap(), &Nodal::new(3).unwrap(), 9).unwrap();
    let sampled = cell.sampled().unwrap();
    (cell, sampled)
}

/// A bent quadrilateral with wrinkles.
fn surface() -> Vec<Point> {
    let at = |k: usize| {
        let (s, t) = ((k / 4) as f64 / 4.0, (k % 4) as f64 / 3.0);
        let wrinkle = 0.05 * ((7 * k % 11) as f64 / 11.0 - 0.5);
        Point::new(2.0 * s + 0.2 * t, t + wrinkle, s * s - t * s + 2.0 * wrinkle)
    };
    (0..20).map(at).collect()
}

/// All kinds of freedom: the first row stays, one column moves along directions.
fn freedoms() -> Vec<Freedom> {
    let kind = |k: usize| match (k / 4, k % 4) {
        (0, _) => Freedom::Fixed,
        (i, 2) => Freedom::Along(Point::new(0.3 * i as f64, -0.5, 1.0)),
        (4, 3) => Freedom::Fixed,
        _ => Freedom::Free,
    };
    (0..20).map(kind).collect()
}

fn unknowns(freedoms: &[Freedom]) -> Vec<(usize, Point)> {
    let of = |(k, f): (usize, &Freedom)| f.directions().iter().map(move |&d| (k, d)).collect::<Vec<_>>();
    freedoms.iter().enumerate().flat_map(of).collect()
}

fn moved(x: &[Point], (node, direction): (usize, Point), step: f64) -> Vec<Point> {
    let mut x = x.to_vec();
    x[node] += direction * step;
    x
}

fn close(a: &Matrix, b: &Matrix, tolerance: f64) {
    assert_eq!((a.rows(), a.cols()), (b.rows(), b.cols()));
    for (x, y) in a.as_slice().iter().zip(b.as_slice()) {
        assert!((x - y).abs() <= tolerance * b.max_abs(), "{x} {y}");
    }
}

#[test]
fn gradients_and_hessians_are_those_of_differences() {
    let (cell, _) = cell();
    let (x, freedoms) = (surface(), freedoms());
    let (unknowns, step) = (unknowns(&freedoms), 1e-5);
    let gradient = |x: &[Point]| cell.area_gradient(&cell.tangents(x)).unwrap();
    let exact = gradient(&x);
    let hessian = cell.hessian(&freedoms, &cell.tangents(&x)).unwrap();
    assert_eq!(hessian.rows(), unknowns.len());
    for (a, &(node, d)) in unknowns.iter().enumerate() {
        let area = |step| cell.area(&cell.tangents(&moved(&x, (node, d), step)));
        let slope = (area(step) - area(-step)) / (2.0 * step);
        assert!((slope - exact[node].dot(d)).abs() <= 1e-9, "{slope}");
        let (after, before) = (gradient(&moved(&x, (node, d), step)), gradient(&moved(&x, (node, d), -step)));
        for (b, &(other, e)) in unknowns.iter().enumerate() {
            let second = (after[other] - before[other]).dot(e) / (2.0 * step);
            assert!((second - hessian[(a, b)]).abs() <= 1e-7, "{a} {b}: {second} {}", hessian[(a, b)]);
        }
    }
}

#[test]
fn products_and_samples_give_the_same() {
    let (product, sampled) = cell();
    let (x, freedoms) = (surface(), freedoms());
    let wanted: Vec<bool> = freedoms.iter().map(|f| *f != Freedom::Fixed).collect();
    let tangents = product.tangents(&x);
    for (a, b) in tangents.iter().flatten().zip(sampled.tangents(&x).iter().flatten()) {
        assert!(a.distance(*b) <= 1e-13);
    }
    for (a, b) in product.adjoint(&tangents).iter().zip(sampled.adjoint(&tangents)) {
        assert!(a.distance(b) <= 1e-12);
    }
    let factors: Vec<f64> = (0..81).map(|p| 1.0 + (p % 5) as f64).collect();
    let both: [&dyn Cell; 2] = [&product, &sampled];
    let [h, g] = both.map(|cell| cell.hessian(&freedoms, &tangents).unwrap());
    close(&h, &g, 1e-13);
    let [h, g] = both.map(|cell| cell.metric(&wanted, &tangents).unwrap());
    close(&h, &g, 1e-13);
    let [h, g] = both.map(|cell| cell.mass(&wanted, &factors));
    close(&h, &g, 1e-13);
}

#[test]
fn the_metric_form_of_a_surface_pulls_like_its_area() {
    // ∇A(x) = K(x) x, for D^g(x) = 2 A(x) at the surface g was taken from.
    let (cell, _) = cell();
    let x = surface();
    let tangents = cell.tangents(&x);
    let form = cell.metric(&[true; 20], &tangents).unwrap();
    for (k, gradient) in cell.area_gradient(&tangents).unwrap().into_iter().enumerate() {
        let image = (0..20).fold(Point::ZERO, |sum, l| sum + x[l] * form[(k, l)]);
        assert!(image.distance(gradient) <= 1e-12);
    }
}

/// A cell of two quadrilaterals that fill the triangle (0, 0), (1, 0), (0, 1) but for a third, with the monomials u^i v^j, i + j ≤ 3, as
/// its functions, and the same by samples.
fn pieced() -> (PiecedCell, SampledCell) {
    let monomials = [[0, 0], [0, 1], [0, 2], [0, 3], [1, 0], [1, 1], [1, 2], [2, 0], [2, 1], [3, 0]];
    let power = |x: f64, k: i32| x.powi(k);
    let slope = |x: f64, k: i32| if k == 0 { 0.0 } else { f64::from(k) * x.powi(k - 1) };
    let table = |parameters: &[[f64; 2]], by: [fn(f64, i32) -> f64; 2]| {
        let entry = |p: usize, k: usize| {
            by[0](parameters[p][0], monomials[k][0]) * by[1](parameters[p][1], monomials[k][1])
        };
        Matrix::from_fn(parameters.len(), monomials.len(), entry)
    };
    let third = 1.0 / 3.0;
    let corners = vec![
        [[0.0, 0.0], [0.5, 0.0], [third, third], [0.0, 0.5]],
        [[0.5, 0.0], [1.0, 0.0], [0.5, 0.5], [third, third]],
    ];
    let pieces = Pieces::new(3, corners, |parameters| table(parameters, [power, power])).unwrap();
    let cell = PiecedCell::new(Arc::new(pieces), 6).unwrap();
    let parameters = cell.parameters();
    let values = table(&parameters, [power, power]);
    let slopes = [table(&parameters, [slope, power]), table(&parameters, [power, slope])];
    let sampled = SampledCell::new(parameters, cell.weights().to_vec(), values, slopes).unwrap();
    (cell, sampled)
}

#[test]
fn pieces_are_their_samples() {
    let (pieced, sampled) = pieced();
    let x: Vec<Point> = surface()[..10].to_vec();
    let freedoms = &freedoms()[4..14];
    let wanted: Vec<bool> = freedoms.iter().map(|f| *f != Freedom::Fixed).collect();
    // The first four functions make a plane of full rank of what the others bend.
    let x: Vec<Point> =
        x.iter().enumerate().map(|(k, &p)| if k == 4 { p + Point::new(3.0, 0.0, 0.0) } else { p }).collect();
    let tangents = sampled.tangents(&x);
    assert!((pieced.weights().iter().sum::<f64>() - 1.0 / 3.0).abs() <= 1e-15);
    for (a, b) in pieced.tangents(&x).iter().flatten().zip(tangents.iter().flatten()) {
        assert!(a.distance(*b) <= 1e-12, "{a:?} {b:?}");
    }
    for (a, b) in pieced.adjoint(&tangents).iter().zip(sampled.adjoint(&tangents)) {
        assert!(a.distance(b) <= 1e-10, "{a:?} {b:?}");
    }
    let factors: Vec<f64> = (0..72).map(|p| 1.0 + (p % 5) as f64).collect();
    let both: [&dyn Cell; 2] = [&pieced, &sampled];
    let [h, g] = both.map(|cell| cell.hessian(freedoms, &tangents).unwrap());
    close(&h, &g, 1e-12);
    let [h, g] = both.map(|cell| cell.metric(&wanted, &tangents).unwrap());
    close(&h, &g, 1e-12);
    let [h, g] = both.map(|cell| cell.mass(&wanted, &factors));
    close(&h, &g, 1e-12);
}

#[test]
fn a_singular_point_is_named() {
    let (product, sampled) = cell();
    let line: Vec<Point> = (0..20).map(|k| Point::new((k / 4) as f64, 0.0, 0.0)).collect();
    for cell in [&product as &dyn Cell, &sampled] {
        let tangents = cell.tangents(&line);
        assert_eq!(cell.area(&tangents), 0.0);
        let error = cell.hessian(&[Freedom::Free; 20], &tangents).unwrap_err();
        assert!(error.to_string().contains("singular at (u, v)"), "{error}");
        assert!(cell.area_gradient(&tangents).is_err() && cell.metric(&[true; 20], &tangents).is_err());
    }
}
