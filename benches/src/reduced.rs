use optim::{Bounds, BoundsError, Objective, Smooth};
use solve::{Parametric, Path};
use surfaces::Net;

use crate::{FixtureError, gt_dirichlet};

/// The box of the searches of GT §5: every shape parameter in [0.5, 3.5].
///
/// # Errors
/// None but those of [`Bounds::cube`].
pub fn search_box() -> Result<Bounds, BoundsError> {
    Bounds::cube(4, 0.5, 3.5)
}

/// `count` points of the box of the searches, four numbers each, spread by the fractional parts of multiples of
/// irrational numbers: the same ones every time, no two alike.
pub fn shapes(count: usize) -> Vec<f64> {
    let steps = [2.0, 3.0, 5.0, 7.0].map(f64::sqrt);
    (1..=count).flat_map(|i| steps.map(|step| 0.5 + 3.0 * (i as f64 * step).fract())).collect()
}

/// The reduced Dirichlet energy J(α) of GT patches over a net, as the swarm and the polish ask for it.
pub struct Reduced {
    /// What evaluates it.
    pub parametric: Parametric,
}

impl Reduced {
    /// J over `net`, on the faster path of this machine.
    ///
    /// # Errors
    /// Those of [`gt_dirichlet`] and [`Parametric::new`].
    pub fn new(net: &Net) -> Result<Self, FixtureError> {
        Ok(Self { parametric: Parametric::new(&gt_dirichlet(net)?)? })
    }

    /// The same on a chosen path.
    ///
    /// # Errors
    /// That of [`Parametric::with_path`]: this machine does not have it.
    pub fn with_path(self, path: Path) -> Result<Self, FixtureError> {
        Ok(Self { parametric: self.parametric.with_path(path)? })
    }
}

impl Objective for Reduced {
    fn dimension(&self) -> usize {
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        if self.parametric.values(points, values).is_err() {
            values.fill(f64::NAN);
        }
    }
}

impl Smooth for Reduced {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        let mut slopes = [0.0; 4];
        let value = self.parametric.value_and_gradient(&std::array::from_fn(|k| point[k]), &mut slopes);
        gradient.copy_from_slice(&slopes);
        value
    }
}
