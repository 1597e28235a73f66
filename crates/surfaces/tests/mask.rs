//! Mask systems: what they reproduce, and which of them are singular.

use proptest::prelude::*;
use surfaces::{
    COONS_CORNER_WEIGHT, MaskSystem, Net, Point, SurfaceError, TriangleMask, TriangleNet, discrete_coons,
    discrete_coons_triangle, rectangular_mask,
};

const MASKS: [TriangleMask; 5] = [
    TriangleMask::Symmetric(0.0),
    TriangleMask::Symmetric(1.0 / 9.0),
    TriangleMask::Symmetric(1.0 / 3.0),
    TriangleMask::Dirichlet,
    TriangleMask::Coons,
];

/// The net of degree n whose point (i, j, k) is `f(i, j, k)`, interior free.
fn net(n: usize, f: impl Fn(f64, f64, f64) -> Point) -> TriangleNet {
    let border = TriangleNet::from_boundary(
        &vec![Point::ZERO; n + 1],
        &vec![Point::ZERO; n + 1],
        &vec![Point::ZERO; n + 1],
    )
    .unwrap();
    let points = border.indices().flat_map(|[i, j, k]| <[f64; 3]>::from(f(i as f64, j as f64, k as f64)));
    border.with_coordinates(&points.collect::<Vec<_>>()).unwrap()
}

/// The left-hand sides `Σ_c weight P_c`.
fn residuals(system: &MaskSystem, points: &[Point]) -> Vec<Point> {
    let mut sums = vec![Point::ZERO; system.rows];
    for &(r, c, weight) in &system.triplets {
        sums[r] += points[c] * weight;
    }
    sums
}

/// The square matrix of the free points.
fn interior(system: &MaskSystem, fixed: &[bool]) -> Vec<Vec<f64>> {
    let mut column = vec![usize::MAX; fixed.len()];
    let free = fixed.iter().enumerate().filter(|(_, fixed)| !**fixed).map(|(c, _)| c);
    free.enumerate().for_each(|(r, c)| column[c] = r);
    let mut a = vec![vec![0.0; system.rows]; system.rows];
    for &(r, c, weight) in &system.triplets {
        if column[c] != usize::MAX {
            a[r][column[c]] = weight;
        }
    }
    a
}

/// Gauss–Jordan with row exchanges.
fn inverse(mut a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = a.len();
    for (r, row) in a.iter_mut().enumerate() {
        row.extend((0..n).map(|c| f64::from(u8::from(r == c))));
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|&r, &s| a[r][k].abs().total_cmp(&a[s][k].abs())).unwrap();
        a.swap(k, pivot);
        let scale = 1.0 / a[k][k];
        a[k].iter_mut().for_each(|x| *x *= scale);
        let row = a[k].clone();
        for (r, other) in a.iter_mut().enumerate() {
            let factor = other[k];
            if r != k && factor != 0.0 {
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    a.into_iter().map(|row| row[n..].to_vec()).collect()
}

/// The largest singular value, by the power iteration of aᵀa.
fn norm(a: &[Vec<f64>]) -> f64 {
    let n = a.len();
    let mut x: Vec<f64> = (0..n).map(|k| 1.0 + (k as f64 * 0.7).sin()).collect();
    let mut sigma = 0.0;
    for _ in 0..3000 {
        let y: Vec<f64> = a.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        x = (0..n).map(|c| (0..n).map(|r| a[r][c] * y[r]).sum()).collect();
        let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        x.iter_mut().for_each(|x| *x /= length);
        sigma = length.sqrt();
    }
    sigma
}

fn condition(mask: TriangleMask, n: usize) -> f64 {
    let net = net(n, |_, _, _| Point::ZERO);
    let a = interior(&mask.system(&net).unwrap(), net.fixed());
    norm(&a) * norm(&inverse(a))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_mask_keeps_affine_nets_and_symmetric_ones_nothing_more(n in 3usize..=12, p in -3.0..3.0f64, q in -3.0..3.0f64, alpha in -2.0..2.0f64) {
        let affine = net(n, |i, j, _| Point::new(p * i + q * j + 1.0, i, q));
        for mask in MASKS.into_iter().chain([TriangleMask::Symmetric(alpha)]) {
            let system = mask.system(&affine).unwrap();
            prop_assert_eq!((system.rows, system.cols), ((n - 1) * (n - 2) / 2, (n + 1) * (n + 2) / 2));
            for residual in residuals(&system, affine.points()) {
                prop_assert!(residual.norm() <= 1e-13 * (1.0 + affine.size()), "{mask:?} {residual:?}");
            }
        }
        // i² is no combination of its neighbours' values: β + 3α times its second difference is left over.
        let square = net(n, |i, _, _| Point::new(i * i, 0.0, 0.0));
        let system = TriangleMask::Symmetric(alpha).system(&square).unwrap();
        let beta = (1.0 - 3.0 * alpha) / 6.0;
        for residual in residuals(&system, square.points()) {
            prop_assert!((residual.x + 6.0 * alpha + 4.0 * beta).abs() <= 1e-11, "{}", residual.x);
        }
    }

    #[test]
    fn the_coons_mask_annihilates_its_kernel(n in 3usize..=16, h in prop::collection::vec(-1.0..1.0f64, 17)) {
        let sign = |i: f64| if (i as usize).is_multiple_of(2) { 1.0 } else { -1.0 };
        let kernel = net(n, |i, j, k| Point::new((0.3 * i * i).cos(), (j * j * 0.1).exp(), sign(i) * h[k as usize]));
        let system = TriangleMask::Coons.system(&kernel).unwrap();
        for residual in residuals(&system, kernel.points()) {
            prop_assert!(residual.norm() <= 1e-14 * (1.0 + kernel.size()), "{residual:?}");
        }
    }

    #[test]
    fn the_symmetric_mask_minus_two_thirds_is_the_cubic_coons_net(p in prop::collection::vec([-2.0..2.0f64, -2.0..2.0, -2.0..2.0].prop_map(Point::from), 6)) {
        let rows = [vec![p[0], p[1], p[2]], vec![p[2], p[3], p[4]], vec![p[4], p[5], p[0]]];
        let coons = discrete_coons_triangle(&rows[0], &rows[1], &rows[2]).unwrap();
        let residual = |alpha| residuals(&TriangleMask::Symmetric(alpha).system(&coons).unwrap(), coons.points())[0].norm();
        prop_assert!(residual(-2.0 / 3.0) <= 1e-14);
        // With the printed sign it is another point, unless the border is affine.
        prop_assert!(residual(2.0 / 3.0) > 1e-9);
    }

    #[test]
    fn the_rectangular_coons_net_satisfies_its_mask(m in 2usize..=6, n in 2usize..=6, x in prop::collection::vec(-2.0..2.0f64, 32)) {
        let row = |a: f64, from: usize, b: f64, n: usize| {
            let inner = (1..n).map(|s| Point::new(s as f64, 0.5, x[from + s]));
            std::iter::once(Point::new(0.0, 0.0, a)).chain(inner).chain([Point::new(0.0, 0.0, b)]).collect::<Vec<_>>()
        };
        let u0 = row(x[0], 4, x[1], n);
        let u1 = row(x[2], 10, x[3], n);
        let v0 = row(x[0], 16, x[2], m);
        let v1 = row(x[1], 22, x[3], m);
        let coons = discrete_coons(&u0, &u1, &v0, &v1).unwrap();
        let system = rectangular_mask(COONS_CORNER_WEIGHT, &coons).unwrap();
        prop_assert_eq!((system.rows, system.cols), ((m - 1) * (n - 1), (m + 1) * (n + 1)));
        for residual in residuals(&system, coons.points()) {
            prop_assert!(residual.norm() <= 1e-13, "{residual:?}");
        }
        // Permanence (COONS): every part of the net is the discrete Coons net of its own border.
        for (i0, i1, j0, j1) in [(0, m - 1, 0, n), (1, m, 0, n - 1), (0, m, 1, n), (1, m, 1, n)] {
            let row = |i: usize| (j0..=j1).map(|j| coons.point(i, j)).collect::<Vec<_>>();
            let column = |j: usize| (i0..=i1).map(|i| coons.point(i, j)).collect::<Vec<_>>();
            let part = discrete_coons(&row(i0), &row(i1), &column(j0), &column(j1)).unwrap();
            for i in i0..=i1 {
                for j in j0..=j1 {
                    prop_assert!(part.point(i - i0, j - j0).distance(coons.point(i, j)) <= 1e-13);
                }
            }
        }
        // The mask with the printed sign has another net.
        let other = rectangular_mask(0.25, &coons).unwrap();
        prop_assert!(residuals(&other, coons.points()).iter().any(|r| r.norm() > 1e-9));
    }
}

#[test]
fn the_cubic_masks_are_the_printed_formulas() {
    // P_ijk = (distinct powers of two) tell every weight apart.
    let cubic = net(3, |i, j, k| Point::new(2f64.powi((16.0 * i + 4.0 * j + k) as i32 % 23), 0.0, 0.0));
    let p = |i: usize, j: usize, k: usize| {
        assert_eq!(i + j + k, 3);
        cubic.point(i, j).x
    };
    let value =
        |mask: TriangleMask| p(1, 1, 1) - residuals(&mask.system(&cubic).unwrap(), cubic.points())[0].x;
    let dirichlet =
        (2.0 * p(0, 0, 3) - p(0, 2, 1) + p(0, 3, 0) + p(1, 2, 0) - p(2, 0, 1) + p(2, 1, 0) + p(3, 0, 0))
            / 4.0;
    assert_eq!(value(TriangleMask::Dirichlet), dirichlet);
    let coons = (p(0, 1, 2) - p(0, 2, 1) + p(1, 0, 2) + p(1, 2, 0) - p(2, 0, 1) + p(2, 1, 0)) / 2.0;
    assert_eq!(value(TriangleMask::Coons), coons);
    let edges = p(0, 1, 2) + p(0, 2, 1) + p(1, 0, 2) + p(1, 2, 0) + p(2, 0, 1) + p(2, 1, 0);
    let corners = p(3, 0, 0) + p(0, 3, 0) + p(0, 0, 3);
    assert!((value(TriangleMask::Symmetric(0.25)) - (0.25 * corners + edges / 24.0)).abs() < 1e-9);
}

#[test]
fn the_coons_mask_is_exactly_singular_at_even_degrees_from_6() {
    for n in (4..=20).step_by(2) {
        // h(0) = h(n) = 0, h(n−i) = −(−1)ⁱ h(i): integers, so that the residual is exactly 0.
        let mut h = vec![0.0; n + 1];
        for i in 1..=n / 2 {
            let odd = !i.is_multiple_of(2);
            h[i] = if i == n / 2 && !odd { 0.0 } else { i as f64 };
            h[n - i] = if odd { h[i] } else { -h[i] };
        }
        let sign = |i: f64| if (i as usize).is_multiple_of(2) { 1.0 } else { -1.0 };
        let net = net(n, |i, j, k| {
            let z = -sign(i) * h[n - i as usize] - h[n - j as usize] + sign(i) * h[k as usize];
            Point::new(0.0, 0.0, z)
        });
        let system = TriangleMask::Coons.system(&net).unwrap();
        assert!(residuals(&system, net.points()).iter().all(|r| *r == Point::ZERO), "degree {n}");
        let (border, inside): (Vec<_>, Vec<_>) =
            net.points().iter().zip(net.fixed()).partition(|(_, fixed)| **fixed);
        assert!(border.iter().all(|(p, _)| p.z == 0.0), "degree {n}");
        let singular = inside.iter().any(|(p, _)| p.z != 0.0);
        assert_eq!(singular, n >= 6, "degree {n}");
        assert_eq!(TriangleMask::Coons.is_singular(n), singular);
    }
}

#[test]
fn other_masks_are_well_conditioned() {
    for (mask, n, expected) in [
        (TriangleMask::Coons, 5, 13.708),
        (TriangleMask::Coons, 7, 31.114),
        (TriangleMask::Coons, 15, 159.43),
        (TriangleMask::Dirichlet, 10, 11.591),
        (TriangleMask::Dirichlet, 16, 47.726),
    ] {
        let found = condition(mask, n);
        assert!((found / expected - 1.0).abs() < 1e-3, "{mask:?} at {n}: {found}");
        assert!(!mask.is_singular(n));
    }
}

#[test]
fn weights_that_are_not_finite_are_refused() {
    let cubic = net(3, |_, _, _| Point::ZERO);
    for alpha in [f64::NAN, f64::INFINITY, 1e308] {
        let error = TriangleMask::Symmetric(alpha).system(&cubic).unwrap_err();
        assert!(matches!(error, SurfaceError::Mask { .. }), "{error}");
        assert!(rectangular_mask(alpha, &Net::new(2, 2, vec![Point::ZERO; 4]).unwrap()).is_err());
    }
    // Nothing free, nothing to solve.
    let line = net(2, |_, _, _| Point::ZERO);
    assert_eq!(TriangleMask::Coons.system(&line).unwrap().triplets, []);
}
