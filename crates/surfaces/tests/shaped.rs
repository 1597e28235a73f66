//! Laws of families with shape parameters: what each says of itself agrees with its patch.

use bases::{Lobatto, Matrix};
use surfaces::{Net, Patch, Point, ShapedFamily, SurfaceError, TensorPatch};

/// A net of degrees (m, n) that is not symmetric in anything.
fn net(m: usize, n: usize) -> Net {
    let points = (0..=m)
        .flat_map(|i| (0..=n).map(move |j| (i as f64, j as f64)))
        .map(|(i, j)| Point::new(i + 0.1 * j * j, j - 0.2 * i * j, (2.0 * i + j).sin() + 0.3 * i));
    Net::new(m + 1, n + 1, points.collect()).unwrap()
}

/// A shape inside the range, no two of its numbers alike.
fn shape(family: ShapedFamily) -> Vec<f64> {
    let (from, to) = family.range();
    let count = family.parameters().len();
    (0..count).map(|k| from + (to - from) * (0.2 + 0.6 * k as f64 / count as f64)).collect()
}

const PLACES: [(f64, f64); 4] = [(0.0, 0.3), (0.25, 0.75), (0.6, 1.0), (0.9, 0.1)];

fn distance(a: &TensorPatch, b: impl Fn(f64, f64) -> Point) -> f64 {
    PLACES.iter().map(|&(u, v)| a.point(u, v).distance(b(u, v))).fold(0.0, f64::max)
}

#[test]
fn every_family_is_named_by_its_words() {
    for family in ShapedFamily::ALL {
        let (patch, basis) = family.names();
        let words: &[(&str, Option<ShapedFamily>)] =
            if family.is_blend() { &ShapedFamily::PATCHES } else { &ShapedFamily::BASES };
        let word = if family.is_blend() { patch } else { basis };
        assert!(words.contains(&(word, Some(family))), "{family:?} has no word");
        assert!(ShapedFamily::BASES.iter().any(|(word, _)| *word == basis), "{family:?}: {basis}");
        assert!(ShapedFamily::PATCHES.iter().any(|(word, _)| *word == patch), "{family:?}: {patch}");
        let rising = family.coordinates(&shape(family)).unwrap();
        assert_eq!(family.by_parameters(rising), shape(family), "{family:?}: parameters and coordinates");
        let count = ShapedFamily::ALL.iter().filter(|other| other.names() == family.names()).count();
        assert_eq!(count, 1, "two families are called {:?}", family.names());
    }
}

#[test]
fn the_factors_make_the_patch() {
    for family in ShapedFamily::ALL {
        for degrees in [(2, 2), (3, 5), (7, 4)] {
            let (net, shape) = (net(degrees.0, degrees.1), shape(family));
            let patch = family.patch(net.clone(), &shape).unwrap();
            let [a1, a2, b1, b2] = family.coordinates(&shape).unwrap();
            let factors = family.factors(degrees).unwrap();
            let summed = |u: f64, v: f64| {
                let mut sum = Point::ZERO;
                for [f, g] in &factors {
                    let values = |factor: &surfaces::ShapeFactor, t, [x, y]: [f64; 2]| -> Vec<f64> {
                        let row = factor.affine().unwrap().evaluate(t, 0).row(0).to_vec();
                        let n = row.len() / 3;
                        (0..n).map(|k| row[k] + x * row[n + k] + y * row[2 * n + k]).collect()
                    };
                    let (f, g) = (values(f, u, [a1, a2]), values(g, v, [b1, b2]));
                    for (k, &p) in net.points().iter().enumerate() {
                        sum += p * (f[k / g.len()] * g[k % g.len()]);
                    }
                }
                sum
            };
            assert!(distance(&patch, summed) < 1e-12, "{family:?} {degrees:?}");
        }
    }
}

#[test]
fn derivatives_are_limits_of_differences() {
    for family in ShapedFamily::ALL {
        let shape = shape(family);
        let patch = family.patch(net(4, 3), &shape).unwrap();
        let derivatives = family.derivatives(&patch).unwrap();
        for k in 0..shape.len() {
            let at = |h: f64, u, v| {
                let mut moved = shape.clone();
                moved[k] += h;
                family.patch(net(4, 3), &moved).unwrap().point(u, v)
            };
            let h = 1e-3;
            let difference = |u, v| {
                ((at(h, u, v) - at(-h, u, v)) * 8.0 - (at(2.0 * h, u, v) - at(-2.0 * h, u, v)))
                    * (1.0 / (12.0 * h))
            };
            let by_parameter = |u, v| {
                let mut sum = Point::ZERO;
                for (c, derivative) in derivatives.iter().enumerate() {
                    let mut unit = [0.0; 4];
                    unit[c] = 1.0;
                    sum += derivative.point(u, v) * family.by_parameters(unit)[k];
                }
                sum
            };
            let distance = PLACES.iter().map(|&(u, v)| difference(u, v).distance(by_parameter(u, v)));
            assert!(distance.fold(0.0, f64::max) < 1e-9, "{family:?} {}", family.parameters()[k]);
        }
    }
}

/// A bubble is what the control points of a Lobatto function make in both directions.
#[test]
fn bubbles_have_the_control_points_of_lobatto_functions() {
    for family in ShapedFamily::ALL {
        let ((m, n), shape) = ((5, 4), shape(family));
        let (u, v) =
            (Lobatto::bernstein_coefficients(m).unwrap(), Lobatto::bernstein_coefficients(n).unwrap());
        let bubbles = family.bubbles((m, n), &shape).unwrap();
        for (k, l) in [(0, 0), (1, 2), (m - 2, n - 2)] {
            let weights = Matrix::from_fn(m + 1, n + 1, |i, j| u[(i, k)] * v[(j, l)]);
            let points = weights.as_slice().iter().map(|&z| Point::new(z, 0.0, 0.0)).collect();
            let patch = family.patch(Net::new(m + 1, n + 1, points).unwrap(), &shape).unwrap();
            let bubble = |s, t| {
                let value = |product: &surfaces::Product| {
                    product.u.evaluate(s, 0).row(0)[k] * product.v.evaluate(t, 0).row(0)[l]
                };
                Point::new(bubbles.iter().map(value).sum(), 0.0, 0.0)
            };
            assert!(distance(&patch, bubble) < 1e-12, "{family:?} ({k}, {l})");
        }
    }
}

#[test]
fn shapes_that_a_family_does_not_have_are_refused() {
    for family in ShapedFamily::ALL {
        let (good, degree) = (shape(family), family.least_degree());
        let refused = |shape: &[f64]| family.patch(net(degree, degree), shape).unwrap_err();
        let mut long = good.clone();
        long.push(1.0);
        assert!(matches!(refused(&long), SurfaceError::ShapeCount { .. }), "{family:?}");
        assert!(matches!(refused(&good[1..]), SurfaceError::ShapeCount { .. }), "{family:?}");
        let (from, to) = family.range();
        for value in [from - 0.1, to + 0.1, f64::NAN] {
            let mut outside = good.clone();
            outside[0] = value;
            assert!(matches!(refused(&outside), SurfaceError::Basis(_)), "{family:?} {value}");
            assert!(family.bubbles((degree, degree), &outside).is_err(), "{family:?} {value}");
        }
        assert!(family.patch(net(degree - 1, degree), &good).is_err(), "{family:?}");
    }
}
