use energy::Functional;
use plateau::ReducedEnergy;
use surfaces::{Net, ShapedFamily};

use crate::FixtureError;

/// The Dirichlet energy of GT patches over `net`, its interior free, as a function of their shape.
///
/// # Errors
/// Those of [`ReducedEnergy::new`]: degrees below 2 or too large.
pub fn gt_dirichlet(net: &Net) -> Result<ReducedEnergy, FixtureError> {
    Ok(ReducedEnergy::new(Functional::Dirichlet, ShapedFamily::Gt, net)?)
}

/// Indices 1 … degree − 1 of the functions that vanish at both ends.
pub fn interior(degree: usize) -> Vec<usize> {
    (1..degree).collect()
}
