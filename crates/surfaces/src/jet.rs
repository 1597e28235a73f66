//! Differential geometry of one point of a parametric surface.

use crate::Point;

/// Position and partial derivatives of a patch at one parameter, to second order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Jet {
    /// The point x(u, v).
    pub point: Point,
    /// x_u.
    pub u: Point,
    /// x_v.
    pub v: Point,
    /// x_uu.
    pub uu: Point,
    /// x_uv.
    pub uv: Point,
    /// x_vv.
    pub vv: Point,
}

/// First fundamental form `E du² + 2F du dv + G dv²`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstForm {
    /// E = x_u · x_u.
    pub e: f64,
    /// F = x_u · x_v.
    pub f: f64,
    /// G = x_v · x_v.
    pub g: f64,
}

/// Second fundamental form `L du² + 2M du dv + N dv²`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondForm {
    /// L = x_uu · normal.
    pub l: f64,
    /// M = x_uv · normal.
    pub m: f64,
    /// N = x_vv · normal.
    pub n: f64,
}

impl FirstForm {
    /// EG − F², the square of the area density.
    pub fn determinant(self) -> f64 {
        self.e * self.g - self.f * self.f
    }
}

impl Jet {
    /// E, F, G at this point.
    pub fn first_form(&self) -> FirstForm {
        FirstForm { e: self.u.dot(self.u), f: self.u.dot(self.v), g: self.v.dot(self.v) }
    }

    /// L, M, N at this point; none where the patch is singular.
    pub fn second_form(&self) -> Option<SecondForm> {
        let n = self.normal()?;
        Some(SecondForm { l: self.uu.dot(n), m: self.uv.dot(n), n: self.vv.dot(n) })
    }

    /// The unit normal x_u × x_v / |x_u × x_v|; none where the patch is singular, that is where the two tangents
    /// are parallel to within rounding or one of them is no more than the rounding of the coordinates.
    pub fn normal(&self) -> Option<Point> {
        let cross = self.u.cross(self.v);
        let (u, v) = (self.u.norm(), self.v.norm());
        // Of a side in one point P the tangent is a sum of terms ±P that cancel: what they leave is not 0 but rounding of P.
        let rounding = 64.0 * f64::EPSILON * self.point.norm();
        let least = (16.0 * f64::EPSILON * u * v).max(rounding * u.max(v));
        if cross.norm() > least { cross.unit() } else { None }
    }

    /// Area density √(EG − F²) = |x_u × x_v|, from the vector product: no cancellation.
    pub fn area_density(&self) -> f64 {
        self.u.cross(self.v).norm()
    }

    /// Dirichlet density ½(E + G).
    pub fn dirichlet_density(&self) -> f64 {
        0.5 * (self.u.dot(self.u) + self.v.dot(self.v))
    }

    /// `∂_u^a ∂_v^b x`.
    ///
    /// # Panics
    /// For a + b above 2: a jet ends there.
    pub fn derivative(&self, a: usize, b: usize) -> Point {
        match (a, b) {
            (0, 0) => self.point,
            (1, 0) => self.u,
            (0, 1) => self.v,
            (2, 0) => self.uu,
            (1, 1) => self.uv,
            (0, 2) => self.vv,
            _ => panic!("a jet holds derivatives to the second order, not ({a}, {b})"),
        }
    }

    /// x_uu + x_vv.
    pub fn laplacian(&self) -> Point {
        self.uu + self.vv
    }

    /// Mean curvature `H = (EN − 2FM + GL) / (2(EG − F²))` in 1/length; none where the patch is singular.
    pub fn mean_curvature(&self) -> Option<f64> {
        let (FirstForm { e, f, g }, SecondForm { l, m, n }) = (self.first_form(), self.second_form()?);
        let w = self.area_density();
        Some((e * n - 2.0 * f * m + g * l) / (2.0 * w * w))
    }

    /// Gauss curvature `K = (LN − M²) / (EG − F²)` in 1/length²; none where the patch is singular.
    pub fn gauss_curvature(&self) -> Option<f64> {
        let SecondForm { l, m, n } = self.second_form()?;
        let w = self.area_density();
        Some((l * n - m * m) / (w * w))
    }
}
