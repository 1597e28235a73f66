//! B-spline surfaces: Bézier patches exactly, others within what their fit says.

use surfaces::{
    Helicoid, Net, Patch, Point, SplineFit, SplineFitError, SplineSurface, TensorPatch, TriangleNet,
    TrianglePatch, tb_coons,
};

/// A net of degree (m, n) that is not symmetric in anything.
fn net(m: usize, n: usize) -> Net {
    let points = (0..=m)
        .flat_map(|i| (0..=n).map(move |j| (i as f64, j as f64)))
        .map(|(i, j)| Point::new(i + 0.1 * j * j, j - 0.2 * i * j, libm::sin(2.0 * i + j) + 0.3 * i));
    Net::new(m + 1, n + 1, points.collect()).unwrap()
}

fn steps((start, end): (f64, f64), count: usize) -> Vec<f64> {
    (0..=count).map(|k| start + (end - start) * (k as f64 / count as f64)).collect()
}

fn distance(patch: &dyn Patch, [u, v]: [(f64, f64); 2], spline: &SplineSurface, count: usize) -> f64 {
    let (us, vs) = (steps(u, count), steps(v, count));
    let jets = patch.jets(&us, &vs);
    let pairs = jets.iter().zip(spline.points_at(&us, &vs));
    pairs.map(|(jet, p)| jet.point.distance(p)).fold(0.0, f64::max)
}

#[test]
fn bernstein_patches_are_exact() {
    for (m, n) in [(1, 1), (3, 2), (5, 9), (25, 4)] {
        let patch = TensorPatch::bernstein(net(m, n)).unwrap();
        let spline = SplineSurface::bernstein(patch.net());
        assert_eq!(spline.knots().each_ref().map(|knots| knots.degree()), [m, n]);
        assert!(distance(&patch, patch.rectangle(), &spline, 17) < 1e-13 * net(m, n).size());
    }
}

#[test]
fn fits_are_within_their_deviation_and_that_within_the_tolerance() {
    let gt = |m, n| TensorPatch::gt(net(m, n), [0.3, 2.0, 4.0, 1.0]).unwrap();
    let pieces = Helicoid::new(1.0, 2.0, 1.5, 12.0).unwrap().pieces().unwrap();
    for tolerance in [1e-3, 1e-6, 1e-10] {
        let checked = |patch: &dyn Patch, rectangle, fit: SplineFit| {
            let found = distance(patch, rectangle, &fit.surface, 101);
            assert!(found <= fit.deviation, "{tolerance}: {found} > {}", fit.deviation);
            assert!(fit.deviation <= tolerance * fit.size, "{tolerance}: {}", fit.deviation);
            let [u, v] = fit.surface.knots().each_ref().map(|knots| knots.count());
            assert_eq!((fit.surface.points().len(), fit.surface.cols()), (u * v, v));
        };
        for patch in [gt(2, 2), gt(3, 7), tb_coons(net(4, 3), [1.0, 0.5, 2.0, 3.0]).unwrap()] {
            checked(&patch, patch.rectangle(), SplineFit::of_patch(&patch, tolerance).unwrap());
        }
        let rectangle = pieces.cuts().map(|cuts| (cuts[0], cuts[cuts.len() - 1]));
        checked(&pieces, rectangle, SplineFit::of_pieces(&pieces, tolerance).unwrap());
    }
}

#[test]
fn quintic_patches_are_fitted_without_error() {
    let fit = SplineFit::of_patch(&TensorPatch::bernstein(net(5, 5)).unwrap(), 1e-13).unwrap();
    assert!(fit.deviation < 1e-13 * fit.size);
    assert_eq!(fit.surface.knots()[0].values(), [0.0, 1.0]);
}

#[test]
fn what_no_fit_reaches_is_refused() {
    let patch = TensorPatch::gt(net(3, 3), [1.0; 4]).unwrap();
    let error = SplineFit::of_patch(&patch, 1e-18).unwrap_err();
    assert!(matches!(error, SplineFitError::Tolerance { reached, .. } if reached < 1e-12), "{error}");
}

#[test]
fn triangles_fold_onto_the_square() {
    for n in 1..=6 {
        let count = (n + 1) * (n + 2) / 2;
        let point = |k: f64| Point::new(k, libm::sin(3.0 * k), libm::cos(k * k));
        let net = TriangleNet::new(n, (0..count).map(|k| point(k as f64)).collect()).unwrap();
        let spline = SplineSurface::triangle(&net);
        let patch = TrianglePatch::new(net).unwrap();
        for s in steps((0.0, 1.0), 7) {
            for t in steps((0.0, 1.0), 7) {
                let (here, there) = (spline.points_at(&[s], &[t])[0], patch.point(1.0 - s, s * (1.0 - t)));
                assert!(here.distance(there) < 1e-13 * patch.net().size(), "{n}: {s}, {t}");
            }
        }
        assert!(spline.points()[..=n].iter().all(|p| *p == spline.points()[0]));
    }
}
