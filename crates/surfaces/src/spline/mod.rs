//! B-spline surfaces: Bézier patches are such, others are fitted.

mod fit;
mod knots;
mod surface;

pub use fit::{SplineFit, SplineFitError};
pub use knots::Knots;
pub use surface::SplineSurface;
