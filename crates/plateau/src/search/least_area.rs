//! The least area over the border as a function of the shape: what a search for the area asks.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use bases::{Basis, GtParts, Matrix, Stacked};
use energy::area_derivative;
use optim::{Objective, Smooth};
use surfaces::{Net, Product, TensorPatch, bernstein_less_blend};

use crate::interior::with_shape;
use crate::{Method, MethodError, Patch, Progress, least_area};

/// `A(α)`, the area of the area extremal at shape α; its gradient is the partial derivative of the area by the shape, the net
/// held (the envelope theorem).
pub(super) struct LeastArea<'a> {
    net: Net,
    method: Method,
    watch: Watch<'a>,
    /// For each of α1, α2, β1, β2 the derivative by it of the GT family it shapes.
    derivatives: [Arc<dyn Basis>; 4],
}

/// Counts the minimisations; passes on who wants them to end, not their steps.
struct Watch<'a> {
    progress: &'a dyn Progress,
    found: AtomicU64,
}

impl Progress for Watch<'_> {
    fn begin(&self, _: &str, _: Option<u64>) {}
    fn step(&self) {}
    fn end(&self) {
        let found = 1 + self.found.fetch_add(1, Ordering::Relaxed);
        self.progress.tell(&format!("({found} least areas)"));
    }
    fn cancelled(&self) -> bool {
        self.progress.cancelled()
    }
}

impl<'a> LeastArea<'a> {
    pub(super) fn new(net: &Net, method: &Method, progress: &'a dyn Progress) -> Result<Self, MethodError> {
        let (m, n) = net.degrees();
        // GT functions are affine in the shape: the derivative by θ1 or θ2 is a family that does not depend on it.
        let part = |degree: usize, parameter: usize| -> Result<Arc<dyn Basis>, MethodError> {
            let functions = degree + 1;
            let map = Matrix::from_fn(functions, 3 * functions, |i, j| {
                f64::from(u8::from(j == parameter * functions + i))
            });
            Ok(Arc::new(Stacked::new(vec![Arc::new(GtParts::new(degree)?)], map)?))
        };
        let derivatives = [part(m, 1)?, part(m, 2)?, part(n, 1)?, part(n, 2)?];
        let watch = Watch { progress, found: AtomicU64::new(0) };
        Ok(Self { net: net.clone(), method: method.clone(), watch, derivatives })
    }

    /// The extremal at one shape and its area.
    pub(super) fn extremal(&self, shape: [f64; 4]) -> Result<(TensorPatch, energy::Integral), MethodError> {
        let patch = with_shape(self.net.clone(), &self.method, Some(shape))?;
        let found = least_area(&patch, self.method.tolerance, &self.watch);
        self.watch.end();
        let (patch, found) = found?;
        Ok((patch, found.area))
    }

    /// The derivative of the area of `patch` by shape parameter `k`, the net held, by the rule of `points`² points.
    pub(super) fn derivative(
        &self,
        patch: &TensorPatch,
        k: usize,
        points: usize,
    ) -> Result<f64, MethodError> {
        let (m, n) = self.net.degrees();
        let moving = self.derivatives[k].clone();
        let tb_coons = self.method.patch == Patch::TbCoons;
        let product = match (k < 2, tb_coons) {
            (true, false) => Product { u: moving, v: patch.products()[0].v.clone() },
            (false, false) => Product { u: patch.products()[0].u.clone(), v: moving },
            (true, true) => Product { u: moving, v: Arc::new(bernstein_less_blend(n)?) },
            (false, true) => Product { u: Arc::new(bernstein_less_blend(m)?), v: moving },
        };
        let direction = TensorPatch::new(vec![product], patch.net().clone())?;
        Ok(area_derivative(patch, &direction, points)?)
    }
}

impl Objective for LeastArea<'_> {
    fn dimension(&self) -> usize {
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (point, value) in points.chunks_exact(4).zip(values) {
            let shape = std::array::from_fn(|k| point[k]);
            *value = self.extremal(shape).map_or(f64::NAN, |(_, area)| area.value);
        }
    }
}

impl Smooth for LeastArea<'_> {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        let shape = std::array::from_fn(|k| point[k]);
        let found = self.extremal(shape).and_then(|(patch, area)| {
            for (k, g) in gradient.iter_mut().enumerate() {
                *g = self.derivative(&patch, k, area.points)?;
            }
            Ok(area.value)
        });
        found.unwrap_or(f64::NAN)
    }
}
