//! Random boundaries and their extremals by the dense solver, for the laws of extremals.
#![allow(dead_code)] // every test file takes what it needs

use std::sync::Arc;

use bases::{Basis, Matrix};
use energy::{DenseForm, Functional, QuadraticForm};
use solve::{Partition, Samples, Separable, solve_partitioned};
use surfaces::{Net, Point, TensorPatch, TriangleNet, TrianglePatch, tb_coons};

/// SplitMix64: reproducible numbers.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub(crate) fn point(&mut self, size: f64) -> Point {
        Point::new(size * self.signed(), size * self.signed(), size * self.signed())
    }

    /// Shape parameters of a GT family.
    pub(crate) fn shape(&mut self) -> [f64; 4] {
        [0.0; 4].map(|_: f64| 2.0 + 1.8 * self.signed())
    }

    /// A net of degree n × n over a smooth surface, with noise; the interior free.
    pub(crate) fn net(&mut self, n: usize) -> Net {
        let mut side = |at: &dyn Fn(f64) -> [f64; 2]| -> Vec<Point> {
            (0..=n)
                .map(|k| {
                    let [u, v] = at(k as f64 / n as f64);
                    let noise = if k % n == 0 { Point::ZERO } else { self.point(0.1) };
                    Point::new(u, v, (3.0 * u).sin() * v - u * v * v) + noise
                })
                .collect()
        };
        let (u0, u1) = (side(&|t| [0.0, t]), side(&|t| [1.0, t]));
        let (v0, v1) = (side(&|t| [t, 0.0]), side(&|t| [t, 1.0]));
        Net::from_boundary(&u0, &u1, &v0, &v1).unwrap()
    }

    /// A triangular net of degree n, the same way.
    pub(crate) fn triangle(&mut self, n: usize) -> TriangleNet {
        let corners = [Point::new(0.0, 0.0, 0.0), Point::new(1.0, 0.0, 0.4), Point::new(0.2, 1.0, -0.3)];
        let mut side = |a: Point, b: Point| -> Vec<Point> {
            (0..=n)
                .map(|k| {
                    let noise = if k % n == 0 { Point::ZERO } else { self.point(0.1) };
                    let t = k as f64 / n as f64;
                    if k == n { b } else { a + (b - a) * t + noise }
                })
                .collect()
        };
        let [a, b, c] = corners;
        TriangleNet::from_boundary(&side(a, b), &side(b, c), &side(c, a)).unwrap()
    }

    /// A patch of one of the three kinds over a random boundary.
    pub(crate) fn patch(&mut self, kind: &str, n: usize) -> TensorPatch {
        let (net, shape) = (self.net(n), self.shape());
        match kind {
            "Bernstein" => TensorPatch::bernstein(net),
            "GT" => TensorPatch::gt(net, shape),
            _ => tb_coons(net, shape),
        }
        .unwrap()
    }
}

/// The extremal of `functional` over the boundary of `patch`.
pub(crate) fn extremal(functional: Functional, patch: &TensorPatch) -> TensorPatch {
    let matrix = QuadraticForm::of(functional, patch).unwrap().matrix();
    let net = patch.net();
    let x = minimised(&matrix, net.fixed(), &net.coordinates());
    patch.with_net(net.with_coordinates(&x).unwrap()).unwrap()
}

/// The Dirichlet extremal over the boundary of `patch`, one product of families, by separation of variables.
pub(crate) fn separated(patch: &TensorPatch) -> TensorPatch {
    let [product] = patch.products() else { panic!("one product of families") };
    let samples = |basis: &Arc<dyn Basis>| {
        let functions = basis.count();
        let samples = bases::Samples::new(basis.as_ref(), bases::Samples::points_for(functions), 1).unwrap();
        Samples {
            points: samples.nodes().len(),
            functions,
            weights: samples.weights().to_vec(),
            values: samples.order(0).as_slice().to_vec(),
            derivatives: samples.order(1).as_slice().to_vec(),
        }
    };
    let (net, (m, n)) = (patch.net(), patch.net().degrees());
    let free = |degree: usize| (1..degree).collect::<Vec<_>>();
    let separable = Separable::new(&samples(&product.u), &samples(&product.v), &free(m), &free(n)).unwrap();
    let x = separable.solve(&net.coordinates()).unwrap().x;
    patch.with_net(net.with_coordinates(&x).unwrap()).unwrap()
}

/// The extremal of `functional` over the boundary of a triangular net.
pub(crate) fn triangle_extremal(functional: Functional, net: &TriangleNet) -> TrianglePatch {
    let form = DenseForm::of_triangle(functional, net.degree()).unwrap();
    let x = minimised(form.matrix(), net.fixed(), &net.coordinates());
    TrianglePatch::new(net.with_coordinates(&x).unwrap()).unwrap()
}

fn minimised(matrix: &Matrix, fixed: &[bool], coordinates: &[f64]) -> Vec<f64> {
    solve_partitioned(matrix.rows(), matrix.as_slice(), &Partition::new(fixed), 3, coordinates).unwrap().x
}
