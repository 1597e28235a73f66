//! How a patch moves with its shape parameters.

use std::sync::Arc;

use bases::{Basis, GtParts, Matrix, Stacked};
use surfaces::{Product, TensorPatch, bernstein_less_blend};

use crate::{MethodError, Patch};

/// For each of α1, α2, β1, β2 the derivative by it of the GT family it shapes. GT functions are affine in the shape, so none of
/// them depends on it.
pub(super) struct ShapeDerivatives {
    families: [Arc<dyn Basis>; 4],
    kind: Patch,
}

impl ShapeDerivatives {
    /// Of patches of this kind and these degrees.
    pub(super) fn new(kind: Patch, (m, n): (usize, usize)) -> Result<Self, MethodError> {
        let part = |degree: usize, parameter: usize| -> Result<Arc<dyn Basis>, MethodError> {
            let functions = degree + 1;
            let map = Matrix::from_fn(functions, 3 * functions, |i, j| {
                f64::from(u8::from(j == parameter * functions + i))
            });
            Ok(Arc::new(Stacked::new(vec![Arc::new(GtParts::new(degree)?)], map)?))
        };
        Ok(Self { families: [part(m, 1)?, part(m, 2)?, part(n, 1)?, part(n, 2)?], kind })
    }

    /// The derivative of `patch` by shape parameter `k`, the net held: a patch of its own.
    pub(super) fn of(&self, patch: &TensorPatch, k: usize) -> Result<TensorPatch, MethodError> {
        let (m, n) = patch.net().degrees();
        let moving = self.families[k].clone();
        let tb_coons = self.kind == Patch::TbCoons;
        let product = match (k < 2, tb_coons) {
            (true, false) => Product { u: moving, v: patch.products()[0].v.clone() },
            (false, false) => Product { u: patch.products()[0].u.clone(), v: moving },
            (true, true) => Product { u: moving, v: Arc::new(bernstein_less_blend(n)?) },
            (false, true) => Product { u: Arc::new(bernstein_less_blend(m)?), v: moving },
        };
        Ok(TensorPatch::new(vec![product], patch.net().clone())?)
    }
}
