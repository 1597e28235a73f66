use bases::Matrix;

use crate::EnergyError;

/// The energy `Σ_d X_dᵀ Q X_d` of a net X with coordinates d = x, y, z, with Q kept as a dense matrix: (points)²,
/// symmetric bit for bit.
///
/// For energies whose functions do not separate: those of triangular nets, and the metric Dirichlet energy of any net.
/// Conventions are those of [`QuadraticForm`](crate::QuadraticForm): nets are passed as their coordinates,
/// (points × 3) row by row, as `coordinates()` of the nets gives them.
#[derive(Debug, Clone, PartialEq)]
pub struct DenseForm {
    matrix: Matrix,
}

impl DenseForm {
    /// The form of the symmetric part of `matrix`.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the matrix is not square.
    pub fn new(mut matrix: Matrix) -> Result<Self, EnergyError> {
        let n = matrix.rows();
        if matrix.cols() != n {
            return Err(EnergyError::Shape {
                what: "columns of the matrix of a form",
                expected: n,
                found: matrix.cols(),
            });
        }
        for i in 0..n {
            for j in 0..i {
                let mean = 0.5 * (matrix[(i, j)] + matrix[(j, i)]);
                matrix[(i, j)] = mean;
                matrix[(j, i)] = mean;
            }
        }
        Ok(Self { matrix })
    }

    /// Number of points of the nets.
    pub fn points(&self) -> usize {
        self.matrix.rows()
    }

    /// The energy of the net `x`.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    #[track_caller]
    pub fn value(&self, x: &[f64]) -> f64 {
        self.apply(x).iter().zip(x).map(|(q, x)| q * x).sum()
    }

    /// What the terms of the energy of the net `x` sum to without their signs, `Σ |Q_ij| |X_i · X_j|`: times the unit of rounding, it
    /// bounds the rounding of [`Self::value`] to within the number of terms.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    #[track_caller]
    pub fn magnitude(&self, x: &[f64]) -> f64 {
        let n = self.points();
        assert_eq!(x.len(), 3 * n, "coordinates of a net of {n} points");
        let points: Vec<&[f64]> = x.chunks_exact(3).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let row = |i: usize| -> f64 {
            self.matrix.row(i).iter().zip(&points).map(|(q, p)| (q * dot(points[i], p)).abs()).sum()
        };
        (0..n).map(row).sum()
    }

    /// The gradient `2 Q X` of the energy, in the layout of `x`.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    #[track_caller]
    pub fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let mut gradient = self.apply(x);
        gradient.iter_mut().for_each(|g| *g *= 2.0);
        gradient
    }

    /// `Q X` for the net `x`, in its layout.
    ///
    /// # Panics
    /// If `x` is not 3 × points long.
    #[track_caller]
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        let n = self.points();
        assert_eq!(x.len(), 3 * n, "coordinates of a net of {n} points");
        let mut product = Vec::with_capacity(x.len());
        for i in 0..n {
            let mut sum = [0.0; 3];
            for (q, point) in self.matrix.row(i).iter().zip(x.chunks_exact(3)) {
                for d in 0..3 {
                    sum[d] += q * point[d];
                }
            }
            product.extend(sum);
        }
        product
    }

    /// Q: (points)², symmetric, row-major over the points of the net.
    pub fn matrix(&self) -> &Matrix {
        &self.matrix
    }
}
