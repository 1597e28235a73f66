//! Triangular Bézier patches.

use crate::triangle_basis::{Powers, indices};
use crate::{Domain, Jet, Patch, Point, SurfaceError, TriangleBasis, TriangleNet};

/// The triangular Bézier patch `x(u, v) = Σ P_ijk B^n_ijk(u, v)` of a net (TRI Definition 1), on the triangle
/// u, v ≥ 0, u + v ≤ 1.
///
/// Its corners are the corner points of the net, bit for bit. Positions are within 16u of the net's size; derivatives
/// of order r within 100u of the largest r-th difference of the net times n!/(n − r)!.
///
/// ```
/// use surfaces::{Patch, Point, TriangleNet, TrianglePatch};
/// let [a, b, c] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(Point::from);
/// let patch = TrianglePatch::new(TriangleNet::from_boundary(&[a, b], &[b, c], &[c, a])?)?;
/// assert_eq!(patch.point(0.5, 0.25), Point::new(0.5, 0.25, 0.25));
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TrianglePatch {
    net: TriangleNet,
    basis: TriangleBasis,
    /// The family of degree n − 2 (0 for n = 1) and, for each of its functions, the differences of the net it weighs.
    lower: TriangleBasis,
    differences: Vec<Differences>,
}

/// Differences of the net at a multi-index J of degree n − 2, in the directions e1 − e3 (u) and e2 − e3 (v).
#[derive(Debug, Clone, Copy, Default)]
struct Differences {
    u: Point,
    v: Point,
    uu: Point,
    uv: Point,
    vv: Point,
}

impl TrianglePatch {
    /// The patch of `net`.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] never in fact: every net has a degree that is offered.
    pub fn new(net: TriangleNet) -> Result<Self, SurfaceError> {
        let n = net.degree();
        let basis = TriangleBasis::new(n)?;
        let lower = TriangleBasis::new(n.saturating_sub(2))?;
        let differences = if n == 1 {
            let c = net.point(0, 0);
            vec![Differences { u: net.point(1, 0) - c, v: net.point(0, 1) - c, ..Differences::default() }]
        } else {
            indices(n - 2)
                .map(|[i, j, _]| {
                    let p = |a: usize, b: usize| net.point(i + a, j + b);
                    let (u, v) = (p(1, 0) - p(0, 0), p(0, 1) - p(0, 0));
                    let uu = (p(2, 0) - p(1, 0)) - u;
                    let uv = (p(1, 1) - p(0, 1)) - u;
                    let vv = (p(0, 2) - p(0, 1)) - v;
                    Differences { u, v, uu, uv, vv }
                })
                .collect()
        };
        Ok(Self { net, basis, lower, differences })
    }

    /// The control net.
    pub fn net(&self) -> &TriangleNet {
        &self.net
    }

    /// The Bernstein polynomials of the patch.
    pub fn basis(&self) -> &TriangleBasis {
        &self.basis
    }
}

impl Patch for TrianglePatch {
    fn domain(&self) -> Domain {
        Domain::Triangle
    }

    fn terms(&self) -> usize {
        self.net.points().len()
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        let n = self.net.degree();
        if !(u.is_finite() && v.is_finite()) {
            let nan = Point::new(f64::NAN, f64::NAN, f64::NAN);
            return Jet { point: nan, u: nan, v: nan, uu: nan, uv: nan, vv: nan };
        }
        let powers = Powers::new(u, v, n);
        let point = self.sum(&powers);
        // The Taylor polynomial of de Casteljau's last two steps: Σ_J B^{n−2}_J Δ for every kind of difference.
        let mut sum = Differences::default();
        self.lower.for_each(&powers, |p, _, b| {
            let d = &self.differences[p];
            sum.u += d.u * b;
            sum.v += d.v * b;
            sum.uu += d.uu * b;
            sum.uv += d.uv * b;
            sum.vv += d.vv * b;
        });
        let first = n as f64;
        let second = first * (first - 1.0);
        Jet {
            point,
            u: (sum.u + sum.uu * u + sum.uv * v) * first,
            v: (sum.v + sum.uv * u + sum.vv * v) * first,
            uu: sum.uu * second,
            uv: sum.uv * second,
            vv: sum.vv * second,
        }
    }

    fn point(&self, u: f64, v: f64) -> Point {
        if !(u.is_finite() && v.is_finite()) {
            return Point::new(f64::NAN, f64::NAN, f64::NAN);
        }
        self.sum(&Powers::new(u, v, self.net.degree()))
    }
}

impl TrianglePatch {
    /// `Σ_I P_I B^n_I`.
    fn sum(&self, powers: &Powers) -> Point {
        let (mut point, points) = (Point::ZERO, self.net.points());
        self.basis.for_each(powers, |p, _, b| point += points[p] * b);
        point
    }
}
