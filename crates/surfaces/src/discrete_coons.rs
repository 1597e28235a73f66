//! Discrete Coons patches: control nets from boundary polygons by the Coons construction (COONS §2, §3).

use crate::triangle_basis::{check_degree, count, indices, position};
use crate::{Net, Point, SurfaceError, TriangleNet};

/// The discrete Coons net of four boundary polygons (COONS (2), Farin–Hansford): boundary fixed, interior free, with
///
/// `P_ij = (1−i/m) P_0j + i/m P_mj + (1−j/n) P_i0 + j/n P_in − (bilinear interpolant of the corners)`.
///
/// Its Bernstein–Bézier patch is the bilinearly blended Coons patch of the four Bézier curves. Rows as for
/// [`Net::from_boundary`].
///
/// # Errors
/// Those of [`Net::from_boundary`].
pub fn discrete_coons(u0: &[Point], u1: &[Point], v0: &[Point], v1: &[Point]) -> Result<Net, SurfaceError> {
    let net = Net::from_boundary(u0, u1, v0, v1)?;
    let (m, n) = net.degrees();
    let mut points = net.points().to_vec();
    for i in 1..m {
        let s = i as f64 / m as f64;
        for j in 1..n {
            let t = j as f64 / n as f64;
            let across = u0[j] * (1.0 - s) + u1[j] * s + v0[i] * (1.0 - t) + v1[i] * t;
            let corners = (u0[0] * (1.0 - t) + u0[n] * t) * (1.0 - s) + (u1[0] * (1.0 - t) + u1[n] * t) * s;
            points[i * (n + 1) + j] = across - corners;
        }
    }
    net.with_coordinates(&flat(&points))
}

/// The discrete triangular Coons net of three border polygons of degree n (COONS (3)): degree n + 1, border fixed
/// (the formula gives the raised polygons there), interior free, with
///
/// `(n+1) P_ijk = k (P_{i,0,n−i} + P_{0,j,n−j} − C) + j (P_{0,n−k,k} + P_{i,n−i,0} − B) + i (P_{n−k,0,k} + P_{n−j,j,0} − A)`.
///
/// Its patch is the triangular Coons patch (Nielson, Thomas, Wixom) of the three Bézier curves. Rows as for
/// [`TriangleNet::from_boundary`].
///
/// # Errors
/// Those of [`TriangleNet::from_boundary`], and [`SurfaceError::Basis`] if degree n + 1 is not offered.
pub fn discrete_coons_triangle(
    ab: &[Point],
    bc: &[Point],
    ca: &[Point],
) -> Result<TriangleNet, SurfaceError> {
    let border = TriangleNet::from_boundary(ab, bc, ca)?;
    let n = border.degree();
    check_degree(n + 1, 1)?;
    let p = |i: usize, j: usize| border.point(i, j);
    let [a, b, c] = [p(n, 0), p(0, n), p(0, 0)];
    let mut points = vec![Point::ZERO; count(n + 1)];
    for [i, j, k] in indices(n + 1) {
        // Each term is there only with its factor: n − i and the like are no indices of the border otherwise.
        let mut sum = Point::ZERO;
        if k > 0 {
            sum += (p(i, 0) + p(0, j) - c) * (k as f64 / (n + 1) as f64);
        }
        if j > 0 {
            sum += (p(0, n - k) + p(i, n - i) - b) * (j as f64 / (n + 1) as f64);
        }
        if i > 0 {
            sum += (p(n - k, 0) + p(n - j, j) - a) * (i as f64 / (n + 1) as f64);
        }
        points[position(n + 1, i, j)] = sum;
    }
    border.raised(1)?.with_coordinates(&flat(&points))
}

fn flat(points: &[Point]) -> Vec<f64> {
    points.iter().flat_map(|&p| <[f64; 3]>::from(p)).collect()
}
