//! Laws of the quadratic energies.

use bases::{Basis, Gt, Matrix, Samples};
use energy::{Functional, QuadraticForm, ShapeForm, area, integrate};
use proptest::prelude::*;
use surfaces::{Jet, Net, Point, ShapedFamily, TensorPatch, tb_coons};

fn density(functional: Functional) -> fn(&Jet) -> f64 {
    match functional {
        Functional::Dirichlet => |j| j.dirichlet_density(),
        Functional::Laplacian => |j| j.laplacian().dot(j.laplacian()),
        Functional::Bending => |j| j.uu.dot(j.uu) + 2.0 * j.uv.dot(j.uv) + j.vv.dot(j.vv),
        Functional::Coons => |j| j.uv.dot(j.uv),
    }
}

fn net() -> impl Strategy<Value = Net> {
    (3usize..=6, 3usize..=6).prop_flat_map(|(rows, cols)| {
        prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], rows * cols).prop_map(move |points| {
            Net::new(rows, cols, points.into_iter().map(Point::from).collect()).unwrap()
        })
    })
}

fn shape() -> impl Strategy<Value = [f64; 4]> {
    let theta = || 0.2..3.8f64;
    [theta(), theta(), theta(), theta()]
}

fn patch() -> impl Strategy<Value = TensorPatch> {
    (net(), shape(), 0..3).prop_map(|(net, shape, kind)| match kind {
        0 => TensorPatch::bernstein(net).unwrap(),
        1 => TensorPatch::gt(net, shape).unwrap(),
        _ => tb_coons(net, shape).unwrap(),
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn values_are_the_integrals_of_the_densities(patch in patch(), f in prop::sample::select(Functional::ALL.to_vec())) {
        let by_form = QuadraticForm::of(f, &patch).unwrap().value(&patch.net().coordinates());
        let [by_quadrature] = integrate(&patch, 1e-12, [0.0], |jet| [density(f)(jet)]).unwrap();
        prop_assert!(by_quadrature.settled);
        prop_assert!((by_form - by_quadrature.value).abs() <= 1e-11 * by_form.abs(), "{by_form} {by_quadrature:?}");
    }

    #[test]
    fn matrix_gradient_and_value_agree(patch in patch(), f in prop::sample::select(Functional::ALL.to_vec())) {
        let form = QuadraticForm::of(f, &patch).unwrap();
        let x = patch.net().coordinates();
        let q = form.matrix();
        let n = q.rows();
        for i in 0..n {
            for j in 0..i {
                prop_assert!((q[(i, j)] - q[(j, i)]).abs() <= 1e-13 * q.max_abs());
            }
        }
        let by_matrix = q.times(&Matrix::from_fn(n, 3, |i, d| x[3 * i + d]));
        for (a, b) in form.gradient(&x).iter().zip(by_matrix.as_slice()) {
            prop_assert!((a - 2.0 * b).abs() <= 1e-12 * q.max_abs() * n as f64);
        }
        let half_gradient: f64 = form.gradient(&x).iter().zip(&x).map(|(g, x)| 0.5 * g * x).sum();
        prop_assert!((half_gradient - form.value(&x)).abs() <= 1e-12 * form.value(&x).abs());
    }

    #[test]
    fn area_never_exceeds_dirichlet_energy(patch in patch()) {
        let dirichlet = QuadraticForm::of(Functional::Dirichlet, &patch).unwrap().value(&patch.net().coordinates());
        let area = area(&patch).unwrap();
        prop_assert!(area.value <= dirichlet + area.error, "{area:?} {dirichlet}");
    }

    #[test]
    fn one_polynomial_holds_every_shape(net in net(), shape in shape(), f in prop::sample::select(Functional::ALL.to_vec()), blend in any::<bool>()) {
        let (kind, patch) = if blend {
            (ShapedFamily::TbCoons, tb_coons(net.clone(), shape).unwrap())
        } else {
            (ShapedFamily::Gt, TensorPatch::gt(net.clone(), shape).unwrap())
        };
        let (whole, form) = (ShapeForm::of(f, kind, net.degrees()).unwrap(), QuadraticForm::of(f, &patch).unwrap());
        let (a, b) = ([shape[0], shape[1]], [shape[2], shape[3]]);
        let q = form.matrix();
        let cols = net.cols();
        let mut sum = Matrix::zeros(q.rows(), q.cols());
        for term in &whole.terms {
            let (l, r) = (whole.left[term.left].at(a), whole.right[term.right].at(b));
            for i in 0..q.rows() {
                for j in 0..q.cols() {
                    sum[(i, j)] += term.coefficient * l[(i / cols, j / cols)] * r[(i % cols, j % cols)];
                }
            }
        }
        for (a, b) in sum.as_slice().iter().zip(q.as_slice()) {
            prop_assert!((a - b).abs() <= 1e-12 * q.max_abs());
        }
    }

    #[test]
    fn difference_forms_assemble_the_same_system(net in net(), shape in shape()) {
        // GT (3.4) with the coefficients (3.5)–(3.10): the gradient of D in every interior point.
        let (m, n) = net.degrees();
        prop_assume!(m >= 3 && n >= 3);
        let patch = TensorPatch::gt(net.clone(), shape).unwrap();
        let gradient = QuadraticForm::of(Functional::Dirichlet, &patch).unwrap().gradient(&net.coordinates());
        let integrals = |degree: usize, theta: [f64; 2]| {
            let (high, low) = (Gt::new(degree, theta).unwrap(), Gt::new(degree - 1, theta).unwrap());
            let (high, low) = (sample(&high), sample(&low));
            let mass = high.gram(0, &high, 0);
            let remainder = high.gram(1, &low, 1);
            let mut difference = high.gram(1, &low, 0);
            for (p, (&t, &w)) in high.nodes().iter().zip(high.weights()).enumerate() {
                for k in 0..=degree {
                    for i in 0..degree {
                        difference[(k, i)] += w * t * high.order(1)[(p, k)] * low.order(1)[(p, i)];
                    }
                }
            }
            (difference, remainder, mass)
        };
        let (i1, i2, i3) = integrals(m, [shape[0], shape[1]]);
        let (j2, j3, j1) = integrals(n, [shape[2], shape[3]]);
        let p = |i: usize, j: usize| net.point(i, j);
        for k in 1..m {
            for l in 1..n {
                let mut sum = Point::ZERO;
                for i in 0..m {
                    for j in 0..=n {
                        sum += (p(i + 1, j) - p(i, j)) * (i1[(k, i)] * j1[(l, j)]) + p(i, j) * (i2[(k, i)] * j1[(l, j)]);
                    }
                }
                for i in 0..=m {
                    for j in 0..n {
                        sum += (p(i, j + 1) - p(i, j)) * (i3[(k, i)] * j2[(l, j)]) + p(i, j) * (i3[(k, i)] * j3[(l, j)]);
                    }
                }
                let at = 3 * (k * (n + 1) + l);
                let ours = Point::new(gradient[at], gradient[at + 1], gradient[at + 2]);
                prop_assert!(ours.distance(sum) < 1e-12, "{ours:?} {sum:?}");
            }
        }
    }
}

fn sample(basis: &dyn Basis) -> Samples {
    Samples::new(basis, 40, 1).unwrap()
}

#[test]
fn harmonic_and_bilinear_patches_are_zeros_of_their_energies() {
    // x + iy ↦ ((x+iy)²): harmonic, so its Laplacian defect vanishes; a bilinear patch has no bending but S_uv.
    let square = [0.0, 0.0, 1.0];
    let half = |k: usize| k as f64 / 2.0;
    let points = (0..9)
        .map(|k| Point::new(square[k / 3] - square[k % 3], 2.0 * half(k / 3) * half(k % 3), half(k / 3)))
        .collect();
    let patch = TensorPatch::bernstein(Net::new(3, 3, points).unwrap()).unwrap();
    let x = patch.net().coordinates();
    let laplacian = QuadraticForm::of(Functional::Laplacian, &patch).unwrap();
    assert!(laplacian.value(&x).abs() < 1e-13);
    assert!(QuadraticForm::of(Functional::Bending, &patch).unwrap().value(&x) > 1.0);
}
