//! The BFGS model of second derivatives.

/// A symmetric positive definite n × n approximation of the Hessian, row-major.
///
/// Kept as B, not as its inverse: the bounds select principal submatrices of B.
pub(crate) struct Hessian {
    dimension: usize,
    entries: Vec<f64>,
    product: Vec<f64>,
}

impl Hessian {
    pub(crate) fn new(dimension: usize) -> Self {
        Self { dimension, entries: vec![0.0; dimension * dimension], product: vec![0.0; dimension] }
    }

    pub(crate) fn row(&self, i: usize) -> &[f64] {
        &self.entries[i * self.dimension..(i + 1) * self.dimension]
    }

    /// B ← curvature · diag(1/widthᵢ²).
    pub(crate) fn reset(&mut self, curvature: f64, widths: &[f64]) {
        self.entries.fill(0.0);
        for (i, width) in widths.iter().enumerate() {
            self.entries[i * self.dimension + i] = curvature / (width * width);
        }
    }

    /// B ← τ (B − B s (B s)ᵀ/(sᵀB s)) + y yᵀ/(yᵀs), for `yᵀs > 0`.
    ///
    /// τ is 1, or with `shrink` at most yᵀs/(sᵀB s): where curvature fell along s it is taken to
    /// have fallen in all directions, which halves the evaluations of a descent from far away.
    ///
    /// Leaves B alone and returns false where rounding or overflow would cost definiteness.
    pub(crate) fn update(&mut self, s: &[f64], y: &[f64], shrink: bool) -> bool {
        let n = self.dimension;
        for i in 0..n {
            self.product[i] = dot(self.row(i), s);
        }
        let sbs = dot(s, &self.product);
        let sy = dot(s, y);
        if !(sbs > 0.0 && sy > 0.0 && (1.0 / sbs).is_finite() && (1.0 / sy).is_finite()) {
            return false;
        }
        let tau = if shrink { (sy / sbs).min(1.0) } else { 1.0 };
        for i in 0..n {
            let (bs, yi) = (self.product[i] / sbs, y[i] / sy);
            let row = &mut self.entries[i * n..(i + 1) * n];
            for j in 0..n {
                row[j] = tau * (row[j] - bs * self.product[j]) + yi * y[j];
            }
        }
        true
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_updated_matrix_maps_the_step_to_the_change() {
        for shrink in [false, true] {
            let mut hessian = Hessian::new(3);
            hessian.reset(4.0, &[1.0, 2.0, 0.5]);
            let (s, y) = ([0.5, -1.0, 0.25], [1.0, -0.5, 2.0]);
            assert!(hessian.update(&s, &y, shrink));
            for i in 0..3 {
                assert!((dot(hessian.row(i), &s) - y[i]).abs() < 1e-14);
                for j in 0..i {
                    assert!((hessian.row(i)[j] - hessian.row(j)[i]).abs() < 1e-15);
                }
            }
        }
    }

    #[test]
    fn negative_curvature_is_refused() {
        let mut hessian = Hessian::new(1);
        hessian.reset(1.0, &[1.0]);
        assert!(!hessian.update(&[1.0], &[-1.0], false));
        assert!(!hessian.update(&[0.0], &[0.0], false));
        assert_eq!(hessian.row(0), [1.0]);
    }
}
