use optim::{Objective, Smooth};
use solve::{Parametric, SeparableParametric, SolveError};
use surfaces::ShapedFamily;

/// The coordinates of a shape.
pub(super) type Coordinates = [f64; ShapedFamily::COORDINATES];

/// The minimum of an energy over the free points, as a function of the coordinates in which families are affine.
pub(super) trait AffineMinimum: Sync {
    /// A value for the coordinates of each place, one after the other; NaN where there is no minimum.
    fn values(&self, coordinates: &[f64], values: &mut [f64]) -> Result<(), SolveError>;

    /// At one place, with its gradient.
    fn value_and_gradient(&self, coordinates: &Coordinates, gradient: &mut Coordinates) -> f64;
}

impl AffineMinimum for Parametric {
    fn values(&self, coordinates: &[f64], values: &mut [f64]) -> Result<(), SolveError> {
        self.values(coordinates, values)
    }

    fn value_and_gradient(&self, coordinates: &Coordinates, gradient: &mut Coordinates) -> f64 {
        self.value_and_gradient(coordinates, gradient)
    }
}

impl AffineMinimum for SeparableParametric {
    fn values(&self, coordinates: &[f64], values: &mut [f64]) -> Result<(), SolveError> {
        self.values(coordinates, values)
    }

    fn value_and_gradient(&self, coordinates: &Coordinates, gradient: &mut Coordinates) -> f64 {
        self.value_and_gradient(coordinates, gradient)
    }
}

/// A minimum at the shapes of a family.
#[derive(Debug)]
pub(super) struct AtShapes<M> {
    pub(super) minimum: M,
    pub(super) family: ShapedFamily,
}

impl<M: AffineMinimum> Objective for AtShapes<M> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        let found = self.family.coordinates_of_all(points).map(|points| self.minimum.values(&points, values));
        // A call that fails as a whole is an evaluation that failed at every point: it is counted and loses.
        if !matches!(found, Ok(Ok(()))) {
            values.fill(f64::NAN);
        }
    }
}

impl<M: AffineMinimum> Smooth for AtShapes<M> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        let Ok(coordinates) = self.family.coordinates(point) else { return f64::NAN };
        let mut by_coordinates = [0.0; ShapedFamily::COORDINATES];
        let value = self.minimum.value_and_gradient(&coordinates, &mut by_coordinates);
        gradient.copy_from_slice(&self.family.by_parameters(by_coordinates));
        value
    }
}
