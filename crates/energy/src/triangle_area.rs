//! The area of a triangular patch with its gradient.

use surfaces::{Point, TriangleBasis, TrianglePatch};

use crate::area::area;
use crate::tangent::Collapsed;
use crate::{EnergyError, Integral};

/// The area of a triangular patch and its gradient with respect to the coordinates of the net, in the layout of
/// `TriangleNet::coordinates`, both by the rule that settled the area.
///
/// As [`area_with_gradient`](crate::area_with_gradient) does for tensor patches: a point where the patch is singular
/// contributes no gradient.
///
/// # Errors
/// As [`area()`].
pub fn triangle_area_with_gradient(patch: &TrianglePatch) -> Result<(Integral, Vec<f64>), EnergyError> {
    let integral = area(patch)?;
    let (net, n) = (patch.net(), patch.net().degree());
    // x_u = Σ_J n B^{n−1}_J (P_{J+e1} − P_{J+e3}) and x_v with e2: so is the gradient, read backwards.
    let lower = TriangleBasis::new(n - 1)?;
    let steps: Vec<[Point; 2]> = lower
        .indices()
        .map(|[i, j, _]| [net.point(i + 1, j) - net.point(i, j), net.point(i, j + 1) - net.point(i, j)])
        .collect();
    let mut pulls = vec![[Point::ZERO; 2]; lower.count()];
    let mut values = vec![0.0; lower.count()];
    for (u, v, weight) in Collapsed::new(integral.points)?.lines().flatten() {
        lower.evaluate_into(u, v, 0, &mut values);
        let (mut x_u, mut x_v) = (Point::ZERO, Point::ZERO);
        for (b, step) in values.iter().zip(&steps) {
            x_u += step[0] * *b;
            x_v += step[1] * *b;
        }
        // d|n| = N · dn with n = x_u × x_v; without the factors n of both tangents, which cancel but for one.
        let Some(normal) = x_u.cross(x_v).unit() else { continue };
        let factor = weight * (n * n) as f64;
        let (by_u, by_v) = (x_v.cross(normal) * factor, normal.cross(x_u) * factor);
        for (b, pull) in values.iter().zip(&mut pulls) {
            pull[0] += by_u * *b;
            pull[1] += by_v * *b;
        }
    }
    let mut gradient = vec![Point::ZERO; net.points().len()];
    for ([i, j, _], [by_u, by_v]) in lower.indices().zip(pulls) {
        gradient[net.position(i + 1, j)] += by_u;
        gradient[net.position(i, j + 1)] += by_v;
        gradient[net.position(i, j)] += -(by_u + by_v);
    }
    Ok((integral, gradient.into_iter().flat_map(<[f64; 3]>::from).collect()))
}
