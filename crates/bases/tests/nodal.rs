//! Laws of the Lagrange polynomials at Gauss–Lobatto points.

use bases::{Basis, Bernstein, Lobatto, Nodal};

#[test]
fn they_are_cardinal_at_symmetric_nodes() {
    for n in [1, 2, 3, 6, 11, 24, 64] {
        let family = Nodal::new(n).unwrap();
        let nodes = family.nodes();
        assert!((nodes[0], nodes[n]) == (0.0, 1.0) && nodes.is_sorted());
        for (i, &t) in nodes.iter().enumerate() {
            assert!((t + nodes[n - i] - 1.0).abs() <= f64::EPSILON);
            for (j, value) in family.evaluate(t, 0).row(0).iter().enumerate() {
                let cardinal = f64::from(u8::from(i == j));
                assert!((value - cardinal).abs() <= 1e-13, "degree {n}: {i} {j} {value}");
            }
        }
    }
}

#[test]
fn polynomials_and_their_derivatives_are_reproduced() {
    for n in [3, 8, 17] {
        let family = Nodal::new(n).unwrap();
        let values: Vec<f64> = family.nodes().iter().map(|t| t.powi(3) - t).collect();
        for t in [0.0, 0.2, 0.77, 1.0f64] {
            let table = family.evaluate(t, 2);
            let sum = |r: usize| table.row(r).iter().zip(&values).map(|(b, v)| b * v).sum::<f64>();
            assert!((sum(0) - (t.powi(3) - t)).abs() <= 1e-13);
            assert!((sum(1) - (3.0 * t * t - 1.0)).abs() <= 1e-11);
            assert!((sum(2) - 6.0 * t).abs() <= 1e-9, "degree {n} at {t}");
        }
    }
}

#[test]
fn inner_values_lead_to_control_points() {
    for n in [2, 3, 7, 12, 20] {
        let family = Nodal::new(n).unwrap();
        let f = |t: f64| t * (1.0 - t) * (3.0 * t).sin();
        let values: Vec<f64> = (1..n).map(|j| f(family.nodes()[j])).collect();
        let product = |m: &bases::Matrix, x: &[f64]| -> Vec<f64> {
            (0..m.rows()).map(|i| m.row(i).iter().zip(x).map(|(a, b)| a * b).sum()).collect()
        };
        let coefficients = product(&family.inner_lobatto(), &values);
        let points = product(&family.inner_bernstein(), &coefficients);
        let (bernstein, lobatto) = (Bernstein::new(n).unwrap(), Lobatto::new(n - 1, (0.0, 1.0)).unwrap());
        let nodal = |t: f64| (1..n).map(|j| family.evaluate(t, 0)[(0, j)] * values[j - 1]).sum::<f64>();
        for t in [0.05, 0.31, 0.5, 0.9] {
            let by_points: f64 = (1..n).map(|i| bernstein.evaluate(t, 0)[(0, i)] * points[i - 1]).sum();
            let by_lobatto: f64 =
                lobatto.evaluate(t, 0).row(0).iter().zip(&coefficients).map(|(b, c)| b * c).sum();
            assert!((by_lobatto - nodal(t)).abs() <= 1e-13, "degree {n}: {by_lobatto} {}", nodal(t));
            assert!((by_points - nodal(t)).abs() <= 1e-14 * 2f64.powi(n as i32), "degree {n} at {t}");
        }
    }
}
