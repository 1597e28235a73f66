//! Galerkin orthogonality: the extremal is orthogonal to every free function, with integrals by another quadrature than
//! the one that assembled its system. A residual cannot see a wrong matrix; this can.
//!
//! The table: `cargo test --release -p plateau-energy --test galerkin -- --nocapture`.
#![allow(clippy::print_stdout, reason = "the table is the point")]

mod extremals;

use bases::{GaussLegendre, Matrix, Samples};
use energy::{DenseForm, Functional, QuadraticForm, TangentSamples};
use extremals::{Random, extremal, separated, triangle_extremal};
use surfaces::{Jet, Patch, Point, TensorPatch, TriangleBasis, TriangleNet};

const RATIO: f64 = 30.0;

fn derivative(jet: &Jet, order: [usize; 2]) -> Point {
    match order {
        [1, 0] => jet.u,
        [0, 1] => jet.v,
        [2, 0] => jet.uu,
        [1, 1] => jet.uv,
        [0, 2] => jet.vv,
        other => unreachable!("no energy holds the derivative {other:?}"),
    }
}

/// `½ d/dε` of the energy of the jet moved by ε φ, φ given by its derivatives: a vector.
fn variation(functional: Functional, jet: &Jet, phi: impl Fn([usize; 2]) -> f64) -> Point {
    functional.terms().iter().fold(Point::ZERO, |sum, term| {
        let (left, right) = ([term.u.0, term.v.0], [term.u.1, term.v.1]);
        sum + (derivative(jet, left) * phi(right) + derivative(jet, right) * phi(left))
            * (0.5 * term.coefficient)
    })
}

/// The largest `|φᵢᵀ A X|` over `‖A‖ ‖X‖ n ε`, with maximum norms.
fn ratio(defects: &[Point], fixed: &[bool], matrix: &Matrix, coordinates: &[f64]) -> f64 {
    let size = |p: &Point| p.x.abs().max(p.y.abs()).max(p.z.abs());
    let defect =
        defects.iter().zip(fixed).filter(|(_, fixed)| !**fixed).fold(0.0f64, |m, (p, _)| m.max(size(p)));
    let norm =
        (0..matrix.rows()).map(|i| matrix.row(i).iter().map(|a| a.abs()).sum::<f64>()).fold(0.0, f64::max);
    let largest = coordinates.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    defect / (norm * largest * matrix.rows() as f64 * f64::EPSILON)
}

fn of_tensor(functional: Functional, patch: &TensorPatch) -> f64 {
    let (rows, cols) = (patch.net().rows(), patch.net().cols());
    // Assembly takes this many points; here are eight more.
    let (in_u, in_v) = (
        GaussLegendre::new(Samples::points_for(rows) + 8).unwrap(),
        GaussLegendre::new(Samples::points_for(cols) + 8).unwrap(),
    );
    let mut defects = vec![Point::ZERO; rows * cols];
    for (u, weight_u) in in_u.iter() {
        for (v, weight_v) in in_v.iter() {
            let (jet, w) = (patch.jet(u, v), weight_u * weight_v);
            let tables: Vec<_> =
                patch.products().iter().map(|p| (p.u.evaluate(u, 2), p.v.evaluate(v, 2))).collect();
            for i in 0..rows {
                for j in 0..cols {
                    let phi = |[a, b]: [usize; 2]| tables.iter().map(|(f, g)| f[(a, i)] * g[(b, j)]).sum();
                    defects[i * cols + j] += variation(functional, &jet, phi) * w;
                }
            }
        }
    }
    let matrix = QuadraticForm::of(functional, patch).unwrap().matrix();
    ratio(&defects, patch.net().fixed(), &matrix, &patch.net().coordinates())
}

/// The form of a triangle is assembled in closed form; here is a Gauss rule with eight points more than exactness takes.
fn of_triangle(functional: Functional, net: &TriangleNet, patch: &dyn Patch) -> f64 {
    let basis = TriangleBasis::new(net.degree()).unwrap();
    let rule = GaussLegendre::new(net.degree() + 1 + 8).unwrap();
    let mut defects = vec![Point::ZERO; basis.count()];
    for (s, weight_s) in rule.iter() {
        for (t, weight_t) in rule.iter() {
            let (u, v, w) = (s, (1.0 - s) * t, weight_s * (1.0 - s) * weight_t);
            let (jet, table) = (patch.jet(u, v), basis.evaluate(u, v, 2));
            for (k, defect) in defects.iter_mut().enumerate() {
                // Rows of the table: 1 | u v | uu uv vv.
                let phi = |[a, b]: [usize; 2]| table[((a + b) * (a + b + 1) / 2 + b, k)];
                *defect += variation(functional, &jet, phi) * w;
            }
        }
    }
    let form = DenseForm::of_triangle(functional, net.degree()).unwrap();
    ratio(&defects, net.fixed(), form.matrix(), &net.coordinates())
}

fn check(name: &str, functional: Functional, n: usize, ratio: f64) {
    println!("{name:<22}{:<12}{n:>4}{ratio:>10.1e}", format!("{functional:?}"));
    assert!(ratio <= RATIO, "{name}, {functional:?}, degree {n}: {ratio}");
}

#[test]
fn tensor_extremals() {
    let mut random = Random(1);
    for kind in ["Bernstein", "GT", "TB-Coons"] {
        for n in [2, 3, 4, 6, 8] {
            for functional in Functional::ALL {
                // The Laplacian defect does not determine biquadratic and bicubic interiors of all kinds.
                if n < 4 && functional == Functional::Laplacian {
                    continue;
                }
                let worst = (0..3)
                    .map(|_| of_tensor(functional, &extremal(functional, &random.patch(kind, n))))
                    .fold(0.0, f64::max);
                check(kind, functional, n, worst);
            }
        }
    }
}

#[test]
fn separated_extremals() {
    let mut random = Random(2);
    for kind in ["Bernstein", "GT"] {
        for n in [3, 7, 12, 20] {
            let patch = separated(&random.patch(kind, n));
            check(
                &format!("{kind}, separated"),
                Functional::Dirichlet,
                n,
                of_tensor(Functional::Dirichlet, &patch),
            );
        }
    }
}

#[test]
fn triangular_extremals() {
    let mut random = Random(3);
    for n in [3, 4, 5, 7, 10, 14] {
        for functional in Functional::ALL {
            let net = random.triangle(n);
            let patch = triangle_extremal(functional, &net);
            check("triangular", functional, n, of_triangle(functional, patch.net(), &patch));
        }
    }
}

#[test]
fn triangle_rules_integrate_all_monomials() {
    // ∫ uᵃ vᵇ over the triangle is a! b!/(a + b + 2)!.
    let (mut worst, mut degree) = (0.0f64, 0);
    for points in 1..=16usize {
        degree = 2 * points - 2;
        for a in 0..=degree {
            for b in 0..=degree - a {
                let sum: f64 = TangentSamples::of_triangle(1, points)
                    .unwrap()
                    .flat_map(|batch| {
                        let values: Vec<f64> = (batch.parameters().iter().zip(batch.weights()))
                            .map(|([u, v], w)| w * u.powi(a as i32) * v.powi(b as i32))
                            .collect();
                        values
                    })
                    .sum();
                let exact = (1..=b).fold(1.0, |f, k| f * k as f64 / (a + k) as f64)
                    / ((a + b + 1) as f64 * (a + b + 2) as f64);
                let error = (sum / exact - 1.0).abs();
                worst = worst.max(error);
                assert!(error <= 8e-15, "{points} points, u^{a} v^{b}: {error:e}");
            }
        }
    }
    println!("triangle rules up to degree {degree}: monomials to {worst:.1e} relatively");
}
