//! The area to second order.

use bases::Matrix;
use surfaces::{Point, TensorPatch, TrianglePatch};

use crate::product::{add_product, add_upper_product, mirrored};
use crate::{EnergyError, TangentSamples};

/// The area of a patch to second order in the coefficients of N functions: value, gradient and Hessian.
///
/// With the coefficient vectors c_k ∈ ℝ³ of the functions laid out one after the other (x, y, z of the first, then of the
/// second, …), `A(c + d) = value + gradientᵀd + ½ dᵀ hessian d + O(|d|³)`. The Hessian is (3N)², symmetric bit for bit,
/// and in general indefinite and close to singular: moving control points along the surface hardly changes its area.
/// Newton's method converges from the Dirichlet extremal at degree 3; from degree 5 on its steps must be limited.
///
/// Exact for the rule: these are the derivatives of the sum that approximates the area.
#[derive(Debug, Clone, PartialEq)]
pub struct AreaExpansion {
    /// The area.
    pub value: f64,
    /// The gradient, 3N.
    pub gradient: Vec<f64>,
    /// The Hessian, (3N)².
    pub hessian: Matrix,
}

impl AreaExpansion {
    /// The expansion of an area of 0 in `functions` functions: to be added to.
    pub fn zero(functions: usize) -> Self {
        let size = 3 * functions;
        Self { value: 0.0, gradient: vec![0.0; size], hessian: Matrix::zeros(size, size) }
    }

    /// The area of a tensor patch by the rule of `points`² points, in its free control points, row by row.
    ///
    /// Take `points` from the [`Integral`](crate::Integral) that [`area()`](crate::area()) gives.
    ///
    /// # Errors
    /// [`EnergyError::Singular`] if x_u and x_v are parallel at a point of the rule, [`EnergyError::Basis`] for a rule that
    /// is not offered.
    pub fn of_tensor(patch: &TensorPatch, points: usize) -> Result<Self, EnergyError> {
        let net = patch.net();
        Self::of_batches(TangentSamples::of_tensor(patch, points)?, net.points(), net.fixed())
    }

    /// The area of a triangular patch by the collapsed rule of `points`² points, in its free control points, in the order
    /// of its net.
    ///
    /// # Errors
    /// As [`Self::of_tensor`].
    pub fn of_triangle(patch: &TrianglePatch, points: usize) -> Result<Self, EnergyError> {
        let net = patch.net();
        Self::of_batches(TangentSamples::of_triangle(net.degree(), points)?, net.points(), net.fixed())
    }

    fn of_batches(
        batches: impl Iterator<Item = TangentSamples>,
        net: &[Point],
        fixed: &[bool],
    ) -> Result<Self, EnergyError> {
        let free: Vec<bool> = fixed.iter().map(|fixed| !fixed).collect();
        let mut sum = Self::zero(free.iter().filter(|free| **free).count());
        for batch in batches {
            sum.add(&batch.selected(&free), &batch.tangents(net))?;
        }
        Ok(sum)
    }

    /// Adds the part of the area at the points of `samples`, where the surface has the tangents (x_u, x_v) given, to
    /// second order in the coefficients of the sampled functions.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if there are not as many tangents as points, or another number of functions;
    /// [`EnergyError::Singular`] if the tangents are parallel at a point. Nothing is added then.
    pub fn add(&mut self, samples: &TangentSamples, tangents: &[[Point; 2]]) -> Result<(), EnergyError> {
        let (points, functions) = (samples.points(), samples.functions());
        for (what, expected, found) in [
            ("tangents at sampled points", points, tangents.len()),
            ("coefficients of an expansion of the area", 3 * functions, self.gradient.len()),
        ] {
            if expected != found {
                return Err(EnergyError::Shape { what, expected, found });
            }
        }
        // All densities first: a singular point is found before anything is added.
        let densities: Vec<Density> = tangents
            .iter()
            .zip(samples.parameters())
            .map(|(&[x_u, x_v], &[u, v])| Density::new(x_u, x_v).ok_or(EnergyError::Singular { u, v }))
            .collect::<Result<_, _>>()?;
        for (p, (density, weight)) in densities.iter().zip(samples.weights()).enumerate() {
            self.value += weight * density.value;
            let [by_u, by_v] = density.gradient.map(|g| g * *weight);
            for (k, (u, v)) in samples.u().row(p).iter().zip(samples.v().row(p)).enumerate() {
                let slope: [f64; 3] = (by_u * *u + by_v * *v).into();
                self.gradient[3 * k..3 * k + 3].iter_mut().zip(slope).for_each(|(g, s)| *g += s);
            }
        }
        self.add_hessian(samples, &densities);
        Ok(())
    }

    /// Block (a, b) of coordinates: `Σ_p w_p (∂uφ, ∂vφ)ᵀ [second derivatives by x_u^a, x_v^a and x_u^b, x_v^b] (∂uφ, ∂vφ)`.
    fn add_hessian(&mut self, samples: &TangentSamples, densities: &[Density]) {
        let (points, functions) = (samples.points(), samples.functions());
        let left = samples.stacked();
        // One pair of coordinates at a time: six products of N × N in place of one of 3N × 3N, with half of the symmetry used.
        for a in 0..3 {
            for b in a..3 {
                // Rows: all points by u, then all points by v, as in `left`.
                let mut right = Matrix::zeros(2 * points, functions);
                for (p, (density, w)) in densities.iter().zip(samples.weights()).enumerate() {
                    for side in 0..2 {
                        let h = &density.hessian[3 * side + a];
                        let (by_u, by_v) = (w * h[b], w * h[3 + b]);
                        let derivatives = samples.u().row(p).iter().zip(samples.v().row(p));
                        for (out, (u, v)) in right.row_mut(side * points + p).iter_mut().zip(derivatives) {
                            *out = by_u * u + by_v * v;
                        }
                    }
                }
                let mut block = Matrix::zeros(functions, functions);
                if a == b {
                    add_upper_product(&mut block, &left, &right);
                    block = mirrored(block);
                } else {
                    add_product(&mut block, &left, &right);
                }
                for k in 0..functions {
                    for l in 0..functions {
                        self.hessian[(3 * k + a, 3 * l + b)] += block[(k, l)];
                        if a != b {
                            self.hessian[(3 * l + b, 3 * k + a)] += block[(k, l)];
                        }
                    }
                }
            }
        }
    }
}

/// `√(EG − F²) = |x_u × x_v|` as a function of the six coordinates of (x_u, x_v), to second order.
pub(crate) struct Density {
    value: f64,
    gradient: [Point; 2],
    pub(crate) hessian: [[f64; 6]; 6],
}

impl Density {
    /// The value and the unit normal; none where x_u and x_v are parallel to within rounding, or one vanishes.
    #[inline]
    fn normal(x_u: Point, x_v: Point) -> Option<(f64, Point)> {
        const PARALLEL: f64 = 16.0 * f64::EPSILON;
        let cross = x_u.cross(x_v);
        let square = cross.dot(cross);
        // |x_u × x_v|² against |x_u|² |x_v|² is the squared sine of the angle: scale does not matter.
        let least = (PARALLEL * PARALLEL) * x_u.dot(x_u) * x_v.dot(x_v);
        let is_regular = square > least && square.is_finite();
        let value = square.sqrt();
        is_regular.then(|| (value, cross * (1.0 / value)))
    }

    /// The value and its derivatives by x_u and x_v; none where these are parallel to within rounding, or one vanishes.
    #[inline]
    pub(crate) fn slope(x_u: Point, x_v: Point) -> Option<(f64, Point, Point)> {
        let (value, normal) = Self::normal(x_u, x_v)?;
        Some((value, x_v.cross(normal), normal.cross(x_u)))
    }

    /// None where x_u and x_v are parallel to within rounding, or one of them vanishes.
    #[inline]
    pub(crate) fn new(x_u: Point, x_v: Point) -> Option<Self> {
        let (value, normal) = Self::normal(x_u, x_v)?;
        let (by_u, by_v) = (x_v.cross(normal), normal.cross(x_u));
        // With n = x_u × x_v, N = n/|n| and dn = dx_u × x_v + x_u × dx_v:
        // d|n| = N · dn, d²|n| = (|dn|² − (N · dn)²)/|n| + 2 N · (dx_u × dx_v).
        let unit = [Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0), Point::new(0.0, 0.0, 1.0)];
        let changes: [Point; 6] =
            std::array::from_fn(|s| if s < 3 { unit[s].cross(x_v) } else { x_u.cross(unit[s - 3]) });
        // What of dn is tangential: |dn|² − (N · dn)² without cancellation.
        let along: [Point; 6] = std::array::from_fn(|s| changes[s] - normal * normal.dot(changes[s]));
        let mut hessian = [[0.0; 6]; 6];
        for s in 0..6 {
            for r in 0..=s {
                let mut second = along[s].dot(along[r]) / value;
                // 2 N · (dx_u × dx_v) is bilinear in dx_u and dx_v: its Hessian has N · (e_r × e_s) on either side of the diagonal.
                if r < 3 && s >= 3 {
                    second += normal.dot(unit[r].cross(unit[s - 3]));
                }
                hessian[s][r] = second;
                hessian[r][s] = second;
            }
        }
        Some(Self { value, gradient: [by_u, by_v], hessian })
    }
}
