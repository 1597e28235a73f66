//! The least area over the border as a function of the shape: what a search for the area asks.

use std::sync::atomic::{AtomicU64, Ordering};

use energy::area_derivative;
use optim::{Objective, Smooth};
use surfaces::{Net, ShapedFamily, TensorPatch};

use super::at_shapes::Coordinates;
use crate::{MethodError, Progress, least_area};

/// `A(α)`, the area of the area extremal at shape α; its gradient is the partial derivative of the area by the shape, the net
/// held (the envelope theorem).
pub(super) struct LeastArea<'a> {
    net: Net,
    family: ShapedFamily,
    tolerance: f64,
    watch: Watch<'a>,
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
    pub(super) fn new(net: &Net, family: ShapedFamily, tolerance: f64, progress: &'a dyn Progress) -> Self {
        let watch = Watch { progress, found: AtomicU64::new(0) };
        Self { net: net.clone(), family, tolerance, watch }
    }

    /// The extremal at one shape and its area.
    pub(super) fn extremal(&self, shape: &[f64]) -> Result<(TensorPatch, energy::Integral), MethodError> {
        let patch = self.family.patch(self.net.clone(), shape)?;
        let found = least_area(&patch, self.tolerance, &self.watch);
        self.watch.end();
        let (patch, found) = found?;
        Ok((patch, found.area))
    }
}

/// The derivatives of the area of `patch`, one of `family`, by the coordinates of its shape, the net held, by the rule of `points`² points.
pub(super) fn derivatives(
    family: ShapedFamily,
    patch: &TensorPatch,
    points: usize,
) -> Result<Coordinates, MethodError> {
    let mut by_coordinates = [0.0; ShapedFamily::COORDINATES];
    for (derivative, direction) in by_coordinates.iter_mut().zip(&family.derivatives(patch)?) {
        *derivative = area_derivative(patch, direction, points)?;
    }
    Ok(by_coordinates)
}

impl Objective for LeastArea<'_> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (shape, value) in points.chunks_exact(Objective::dimension(self)).zip(values) {
            *value = self.extremal(shape).map_or(f64::NAN, |(_, area)| area.value);
        }
    }
}

impl Smooth for LeastArea<'_> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn value_and_gradient(&self, shape: &[f64], gradient: &mut [f64]) -> f64 {
        let found = self.extremal(shape).and_then(|(patch, area)| {
            let by_coordinates = derivatives(self.family, &patch, area.points)?;
            gradient.copy_from_slice(&self.family.by_parameters(by_coordinates));
            Ok(area.value)
        });
        found.unwrap_or(f64::NAN)
    }
}
