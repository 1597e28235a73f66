//! The least area over the border as a function of the shape: what a search for the area asks.

use std::sync::atomic::{AtomicU64, Ordering};

use energy::area_derivative;
use optim::{Objective, Smooth};
use surfaces::{Net, TensorPatch};

use super::shape_derivative::ShapeDerivatives;
use crate::interior::with_shape;
use crate::{Method, MethodError, Progress, least_area};

/// `A(α)`, the area of the area extremal at shape α; its gradient is the partial derivative of the area by the shape, the net
/// held (the envelope theorem).
pub(super) struct LeastArea<'a> {
    net: Net,
    method: Method,
    watch: Watch<'a>,
    derivatives: ShapeDerivatives,
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
        let derivatives = ShapeDerivatives::new(method.patch, net.degrees())?;
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
        let direction = self.derivatives.of(patch, k)?;
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
