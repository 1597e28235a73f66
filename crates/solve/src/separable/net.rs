use super::direction::{Direction, product};
use crate::{Place, SolveError, check};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};

/// The factor of the Dirichlet energy ½ ∫ (|S_u|² + |S_v|²).
const HALF: f64 = 0.5;

/// A net between two directions, and the space to reduce it.
///
/// The three coordinates stand side by side: x, y, z planes of `functions × functions`, rows and columns in the
/// order of the directions, so that the free unknowns are the upper left block of each plane.
#[derive(Debug)]
pub(super) struct Net {
    planes: Mat<f64>,
    /// b, then the minimiser, in the diagonal bases: one `free × free` matrix a coordinate.
    diagonal: [Mat<f64>; 3],
    /// F_u P and E_u P.
    along_derivatives: Mat<f64>,
    along_values: Mat<f64>,
    /// A'_u P and R_u P, and each coordinate times R_vᵀ and A'_vᵀ.
    slopes: Mat<f64>,
    heights: Mat<f64>,
    slopes_across: Mat<f64>,
    heights_across: Mat<f64>,
    rotated: Mat<f64>,
    turned: Mat<f64>,
    turned_rotated: Mat<f64>,
}

impl Net {
    pub(super) fn new(u: &Direction, v: &Direction) -> Result<Self, SolveError> {
        let (m, n) = (u.order.len(), v.order.len());
        let (p, q) = (u.roots.len(), v.roots.len());
        let size = check::product("size of the net", m.max(p), 4 * n.max(q))?;
        drop(crate::memory::zeros(size.saturating_mul(2))?);
        Ok(Self {
            planes: Mat::zeros(m, 3 * n),
            diagonal: std::array::from_fn(|_| Mat::zeros(u.free, v.free)),
            along_derivatives: Mat::zeros(u.free, 3 * n),
            along_values: Mat::zeros(u.free, 3 * n),
            slopes: Mat::zeros(p, 3 * n),
            heights: Mat::zeros(u.triangle.nrows(), 3 * n),
            slopes_across: Mat::zeros(p, v.triangle.nrows()),
            heights_across: Mat::zeros(u.triangle.nrows(), q),
            rotated: Mat::zeros(u.free, v.free),
            turned: Mat::zeros(v.free, u.free),
            turned_rotated: Mat::zeros(v.free, u.free),
        })
    }

    /// Takes the fixed points from `values` (row-major, three numbers a point) and zero for the free ones.
    pub(super) fn load(&mut self, u: &Direction, v: &Direction, values: &[f64]) -> Result<(), SolveError> {
        let n = v.order.len();
        let length = check::product("size of the net", u.order.len() * n, 3)?;
        check::length("length of the values", length, values.len())?;
        for (row, &i) in u.order.iter().enumerate() {
            for (column, &j) in v.order.iter().enumerate() {
                for d in 0..3 {
                    let free = row < u.free && column < v.free;
                    let value = if free { 0.0 } else { values[3 * (i * n + j) + d] };
                    if !value.is_finite() {
                        let place = Place::RightHandSide;
                        return Err(SolveError::NotFinite { place, row: i * n + j, column: d });
                    }
                    self.planes[(row, d * n + column)] = value;
                }
            }
        }
        Ok(())
    }

    /// The net in the order of the unknowns, three numbers a point.
    pub(super) fn store(&self, u: &Direction, v: &Direction) -> Vec<f64> {
        let n = v.order.len();
        let mut values = vec![0.0; 3 * u.order.len() * n];
        for (row, &i) in u.order.iter().enumerate() {
            for (column, &j) in v.order.iter().enumerate() {
                for d in 0..3 {
                    values[3 * (i * n + j) + d] = self.planes[(row, d * n + column)];
                }
            }
        }
        values
    }

    fn plane<'a>(matrix: &'a Mat<f64>, v: &Direction, d: usize) -> MatRef<'a, f64> {
        let n = v.order.len();
        matrix.subcols(d * n, n)
    }

    /// Half of Σ_d ‖A'_u X_d A_vᵀ‖² + ‖A_u X_d A'_vᵀ‖² of the net as it stands: a sum of squares.
    pub(super) fn energy(&mut self, u: &Direction, v: &Direction) -> f64 {
        // A_v enters only as A_vᵀA_v = RᵀR: R is the smaller of the two, and as exact.
        product(&mut self.slopes, u.derivatives.as_ref(), self.planes.as_ref());
        product(&mut self.heights, u.triangle.as_ref(), self.planes.as_ref());
        let mut sum = 0.0;
        for d in 0..3 {
            product(&mut self.slopes_across, Self::plane(&self.slopes, v, d), v.triangle.transpose());
            product(&mut self.heights_across, Self::plane(&self.heights, v, d), v.derivatives.transpose());
            sum += self.slopes_across.squared_norm_l2() + self.heights_across.squared_norm_l2();
        }
        HALF * sum
    }

    /// `F_u X E_vᵀ + E_u X F_vᵀ` of the net as it stands, into `diagonal`: b while the free points are zero, and
    /// the defect of the extremal once they are solved for.
    fn couple(&mut self, u: &Direction, v: &Direction) {
        product(&mut self.along_derivatives, u.of_derivatives.as_ref(), self.planes.as_ref());
        product(&mut self.along_values, u.of_values.as_ref(), self.planes.as_ref());
        for d in 0..3 {
            let (slopes, heights) =
                (Self::plane(&self.along_derivatives, v, d), Self::plane(&self.along_values, v, d));
            let out = &mut self.diagonal[d];
            product(out, slopes, v.of_values.transpose());
            matmul(out.as_mut(), Accum::Add, heights, v.of_derivatives.transpose(), 1.0, Par::Seq);
        }
    }

    /// The minimum over the free points of a loaded net: `c − ½ Σ b²/(λ_i + μ_j)`. Leaves the minimiser in `diagonal`.
    pub(super) fn reduce(&mut self, u: &Direction, v: &Direction) -> Result<f64, SolveError> {
        // The loaded net has zeros at its free points: its energy is c.
        let c = self.energy(u, v);
        if u.free == 0 || v.free == 0 {
            return Ok(c);
        }
        let (least, largest) = spectrum(u, v);
        // λ is the square of a singular value known to n ε: the noise is the square of that.
        let noise = (u.free.max(v.free) as f64 * f64::EPSILON).powi(2);
        if least <= noise * largest || !largest.is_finite() {
            let condition = Some(largest / least);
            return Err(SolveError::NotPositiveDefinite { order: u.free * v.free, pivot: None, condition });
        }
        self.couple(u, v);
        let mut gain = 0.0;
        for diagonal in &mut self.diagonal {
            // In the diagonal bases the system is one division an unknown.
            for (j, mu) in v.eigenvalues.iter().enumerate() {
                for (b, lambda) in diagonal.col_as_slice_mut(j).iter_mut().zip(&u.eigenvalues) {
                    let y = *b / (lambda + mu);
                    gain += *b * y;
                    *b = -y;
                }
            }
        }
        Ok(c - HALF * gain)
    }

    /// Turns the minimiser that `reduce` left into the free points of the net.
    pub(super) fn complete(&mut self, u: &Direction, v: &Direction) {
        if u.free == 0 || v.free == 0 {
            return;
        }
        let n = v.order.len();
        for d in 0..3 {
            u.back(&mut self.diagonal[d], &mut self.rotated);
            // Both factors act on the rows of a matrix: the second one on the transpose.
            self.turned.copy_from(self.diagonal[d].transpose());
            v.back(&mut self.turned, &mut self.turned_rotated);
            self.planes.submatrix_mut(0, d * n, u.free, v.free).copy_from(self.turned.transpose());
        }
    }

    /// How far the net is from the extremal: the norm of what [`couple`](Self::couple) leaves, over
    /// `(‖F_u‖‖E_v‖ + ‖E_u‖‖F_v‖) ‖X‖ n ε` in Frobenius norms.
    pub(super) fn residual(&mut self, u: &Direction, v: &Direction) -> f64 {
        if u.free == 0 || v.free == 0 {
            return 0.0;
        }
        self.couple(u, v);
        let defect = self.diagonal.iter().map(|d| d.squared_norm_l2()).sum::<f64>().sqrt();
        let scale = u.of_derivatives.norm_l2() * v.of_values.norm_l2()
            + u.of_values.norm_l2() * v.of_derivatives.norm_l2();
        let n = u.order.len().max(v.order.len()) as f64;
        if defect == 0.0 { 0.0 } else { defect / (scale * self.planes.norm_l2() * n * f64::EPSILON) }
    }

    /// Weights of ∂A' and ∂A in the derivative of the energy of the net as it stands, for u and for v.
    ///
    /// `½ ∂‖A'_u X A_vᵀ‖² = ⟨∂A'_u, A'_u X (A_vᵀA_v) Xᵀ⟩`, and likewise the other three; R stands in for A where
    /// only AᵀA counts.
    pub(super) fn sensitivities(&mut self, u: &Direction, v: &Direction) -> [Sensitivity; 2] {
        let (m, n) = (u.order.len(), v.order.len());
        let mut of_u = [Mat::zeros(m, m), Mat::zeros(m, m)];
        let mut of_v = [Mat::zeros(n, n), Mat::zeros(n, n)];
        // [X R_vᵀ, X A'_vᵀ]: their squares are X (A_vᵀA_v) Xᵀ and X (A'_vᵀA'_v) Xᵀ.
        let mut across = [Mat::zeros(m, v.triangle.nrows()), Mat::zeros(m, v.roots.len())];
        product(&mut self.slopes, u.derivatives.as_ref(), self.planes.as_ref());
        product(&mut self.heights, u.triangle.as_ref(), self.planes.as_ref());
        let add = |out: &mut Mat<f64>, left: MatRef<'_, f64>, right: MatRef<'_, f64>| {
            matmul(out.as_mut(), Accum::Add, left, right, 1.0, Par::Seq);
        };
        for d in 0..3 {
            let plane = Self::plane(&self.planes, v, d);
            product(&mut across[0], plane, v.triangle.transpose());
            product(&mut across[1], plane, v.derivatives.transpose());
            for k in 0..2 {
                add(&mut of_u[k], across[k].as_ref(), across[k].transpose());
            }
            let (slopes, heights) = (Self::plane(&self.slopes, v, d), Self::plane(&self.heights, v, d));
            // heightsᵀ heights = Xᵀ (A_uᵀA_u) X weighs A'_v, slopesᵀ slopes weighs A_v.
            add(&mut of_v[0], heights.transpose(), heights);
            add(&mut of_v[1], slopes.transpose(), slopes);
        }
        let finish = |direction: &Direction, [by_values, by_derivatives]: [Mat<f64>; 2]| Sensitivity {
            derivatives: &direction.derivatives * by_values,
            values: &direction.values * by_derivatives,
        };
        [finish(u, of_u), finish(v, of_v)]
    }
}

/// `points × functions` weights of the changes of A' and of A.
pub(super) struct Sensitivity {
    pub(super) derivatives: Mat<f64>,
    pub(super) values: Mat<f64>,
}

/// The least and the largest `λ_i + μ_j`.
pub(super) fn spectrum(u: &Direction, v: &Direction) -> (f64, f64) {
    let least = |d: &Direction| d.eigenvalues.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = |d: &Direction| d.eigenvalues.iter().copied().fold(0.0, f64::max);
    (least(u) + least(v), largest(u) + largest(v))
}
