use std::sync::Arc;

use crate::{Basis, BasisError, Matrix};

/// Linear combinations of the functions of several families on one interval.
///
/// Function i is `Σ_j map[i, j] ψ_j`, where ψ runs through the functions of all parts one after the other. Blends
/// of Coons type live in such families: `B_i − ℓ_i` with ℓ the two linear blending functions, for example.
#[derive(Debug, Clone)]
pub struct Stacked {
    parts: Vec<Arc<dyn Basis>>,
    map: Matrix,
}

impl Stacked {
    /// The family `map · (parts one after the other)`; `map` is (functions of this family) × (functions of the parts).
    ///
    /// # Errors
    /// [`BasisError::Map`] if the columns of `map` do not match, [`BasisError::Domain`] if the parts live on
    /// different intervals.
    pub fn new(parts: Vec<Arc<dyn Basis>>, map: Matrix) -> Result<Self, BasisError> {
        let expected = parts.iter().map(|part| part.count()).sum();
        if map.cols() != expected || parts.is_empty() {
            return Err(BasisError::Map { expected, found: map.cols() });
        }
        if let Some(part) = parts.iter().position(|part| part.domain() != parts[0].domain()) {
            return Err(BasisError::Domain { part });
        }
        Ok(Self { parts, map })
    }
}

impl Basis for Stacked {
    fn count(&self) -> usize {
        self.map.rows()
    }

    fn domain(&self) -> (f64, f64) {
        self.parts[0].domain()
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        let count = self.count();
        assert_eq!(out.len(), (order + 1) * count, "length of the output");
        let tables: Vec<Matrix> = self.parts.iter().map(|part| part.evaluate(t, order)).collect();
        for r in 0..=order {
            for k in 0..count {
                let functions = tables.iter().flat_map(|table| table.row(r));
                out[r * count + k] = self.map.row(k).iter().zip(functions).map(|(m, f)| m * f).sum();
            }
        }
    }
}
