//! What the tests need of a solver: interiors of nets from dense forms and mask systems, by plain elimination.

use std::f64::consts::FRAC_PI_2;

use bases::Matrix;
use energy::DenseForm;
use surfaces::{MaskSystem, Point, TriangleNet};

/// `a x = b` for three right-hand sides, by elimination with row exchanges.
pub(crate) fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    let n = a.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&r, &s| a[r][k].abs().total_cmp(&a[s][k].abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for r in k + 1..n {
            let factor = a[r][k] / a[k][k];
            let (upper, lower) = a.split_at_mut(r);
            lower[0].iter_mut().zip(&upper[k]).skip(k).for_each(|(x, y)| *x -= factor * y);
            let row = b[k];
            (0..3).for_each(|d| b[r][d] -= factor * row[d]);
        }
    }
    for k in (0..n).rev() {
        for d in 0..3 {
            let rest: f64 = (k + 1..n).map(|c| a[k][c] * b[c][d]).sum();
            b[k][d] = (b[k][d] - rest) / a[k][k];
        }
    }
    b
}

/// The coordinates with the free points such that every row `Σ_c weight P_c` of theirs vanishes.
fn fill(coordinates: &[f64], fixed: &[bool], rows: impl Fn(usize) -> Vec<f64>, count: usize) -> Vec<f64> {
    let free: Vec<usize> = (0..fixed.len()).filter(|&p| !fixed[p]).collect();
    assert_eq!(free.len(), count);
    let rows: Vec<Vec<f64>> = (0..count).map(rows).collect();
    let a = rows.iter().map(|row| free.iter().map(|&c| row[c]).collect()).collect();
    let b = rows
        .iter()
        .map(|row| {
            let known = |d: usize| -> f64 {
                (0..fixed.len()).filter(|&c| fixed[c]).map(|c| row[c] * coordinates[3 * c + d]).sum()
            };
            [-known(0), -known(1), -known(2)]
        })
        .collect();
    let mut filled = coordinates.to_vec();
    for (&p, point) in free.iter().zip(solve(a, b)) {
        filled[3 * p..3 * p + 3].copy_from_slice(&point);
    }
    filled
}

/// The coordinates of the extremal of a form with the fixed points kept.
pub(crate) fn extremal_coordinates(form: &Matrix, coordinates: &[f64], fixed: &[bool]) -> Vec<f64> {
    let free: Vec<usize> = (0..fixed.len()).filter(|&p| !fixed[p]).collect();
    fill(coordinates, fixed, |r| form.row(free[r]).to_vec(), free.len())
}

#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn extremal(form: &DenseForm, net: &TriangleNet) -> TriangleNet {
    net.with_coordinates(&extremal_coordinates(form.matrix(), &net.coordinates(), net.fixed())).unwrap()
}

#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn masked(system: &MaskSystem, net: &TriangleNet) -> TriangleNet {
    let row = |r: usize| {
        let mut row = vec![0.0; system.cols];
        system.triplets.iter().filter(|t| t.0 == r).for_each(|t| row[t.1] = t.2);
        row
    };
    net.with_coordinates(&fill(&net.coordinates(), net.fixed(), row, system.rows)).unwrap()
}

/// n + 1 equally spaced points on the unit quarter circle from p to q, or on the straight line.
fn side(p: Point, q: Point, n: usize, arc: bool) -> Vec<Point> {
    (0..=n)
        .map(|s| {
            let t = s as f64 / n as f64;
            match s {
                0 => p,
                _ if s == n => q,
                _ if arc => p * (FRAC_PI_2 * t).cos() + q * (FRAC_PI_2 * t).sin(),
                _ => p * (1.0 - t) + q * t,
            }
        })
        .collect()
}

/// The borders of the tables of TRI: A = e1, B = e2, C = e3; NI2 has arcs on all three sides, NI1 on AB alone.
#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn ni(arcs: [bool; 3], n: usize) -> TriangleNet {
    let [a, b, c] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(Point::from);
    TriangleNet::from_boundary(&side(a, b, n, arcs[0]), &side(b, c, n, arcs[1]), &side(c, a, n, arcs[2]))
        .unwrap()
}

/// The border of Enneper's surface x(u + 1, v) over the triangle (TRI §6), degree 3.
#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn enneper() -> TriangleNet {
    let p = |x: f64, y: f64, z: f64| Point::new(x / 3.0, y / 3.0, z / 3.0);
    let ab = [p(-2., 0., 12.), p(1., 5., 8.), p(4., 6., 4.), p(5., 5., 0.)];
    let bc = [p(5., 5., 0.), p(3., 4., 2.), p(2., 2., 3.), p(2., 0., 3.)];
    let ca = [p(2., 0., 3.), p(2., 0., 5.), p(1., 0., 8.), p(-2., 0., 12.)];
    TriangleNet::from_boundary(&ab, &bc, &ca).unwrap()
}
