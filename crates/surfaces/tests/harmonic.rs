//! The relations of harmonic nets.

use proptest::prelude::*;
use surfaces::{Net, Patch, Point, TensorPatch, harmonic_relations};

fn net(rows: usize, cols: usize) -> impl Strategy<Value = Net> {
    prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], rows * cols)
        .prop_map(move |p| Net::new(rows, cols, p.into_iter().map(Point::from).collect()).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The left sides are the Bernstein coefficients of the Laplacian: summed against the basis they give it back.
    #[test]
    fn they_are_the_coefficients_of_the_laplacian(
        net in (2usize..=6, 2usize..=6).prop_flat_map(|(r, c)| net(r, c)),
        u in 0.0..=1.0f64,
        v in 0.0..=1.0f64,
    ) {
        let (m, n) = net.degrees();
        let coefficients: Vec<Point> = harmonic_relations(m, n)
            .iter()
            .map(|relation| relation.iter().fold(Point::ZERO, |sum, &(k, w)| sum + net.points()[k] * w))
            .collect();
        let laplacian = TensorPatch::bernstein(Net::new(m + 1, n + 1, coefficients).unwrap()).unwrap().point(u, v);
        let jet = TensorPatch::bernstein(net).unwrap().jet(u, v);
        prop_assert!(laplacian.distance(jet.laplacian()) < 1e-12 * (m * m + n * n) as f64 * 16.0);
    }
}
