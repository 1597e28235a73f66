//! Energies of Bézier-like patches.
//!
//! Two kinds. A quadratic [`Functional`] (Dirichlet, Laplacian defect, bending, Coons) of a tensor patch is a
//! [`QuadraticForm`] of its control net: a short sum of Kronecker products of one-dimensional Gram matrices, with value,
//! gradient and matrix; [`ShapeForm`] holds it for all shapes of a family at once. That of a triangular patch, and the metric
//! Dirichlet energy of either ([`MetricForm`]), is a [`DenseForm`]. The area is not quadratic: [`area()`] integrates it
//! until it has settled and says how far to trust it, [`area_with_gradient`] and [`triangle_area_with_gradient`]
//! differentiate it, [`AreaExpansion`] twice.
//!
//! Far from any patch, a [`Calibration`] bounds the area of *every* graph with a given rim from below, and [`certify`] proves it.
//!
//! Always area ≤ Dirichlet energy, with equality exactly for conformal charts.
//!
//! ```
//! use energy::{Functional, QuadraticForm, area};
//! use surfaces::{Net, Point, TensorPatch};
//!
//! let corners = [[0., 0., 0.], [0., 2., 0.], [1., 0., 0.], [1., 2., 1.]].map(Point::from);
//! let patch = TensorPatch::bernstein(Net::new(2, 2, corners.to_vec())?)?;
//! let dirichlet = QuadraticForm::of(Functional::Dirichlet, &patch)?.value(&patch.net().coordinates());
//! let area = area(&patch)?;
//! assert!(area.settled && area.value < dirichlet);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | quadratic energies | [`Functional`] of [`DensityTerm`]s; [`QuadraticForm`] of [`KroneckerTerm`]s, [`DenseForm`], [`ReferenceTriangle`] |
//! | for every shape of a family | [`ShapeForm`], [`ShapeTerm`], [`GramPolynomial`] |
//! | in the metric of another surface | [`MetricForm`], [`METRIC_TOLERANCE`] |
//! | integrals with their errors | [`Integral`], [`integrate()`], [`area()`], [`AREA_TOLERANCE`] |
//! | derivatives of the area | [`area_with_gradient()`], [`area_derivative()`], [`triangle_area_with_gradient()`], [`AreaExpansion`], [`ProductArea`], [`SampledArea`], [`TangentSamples`], [`NormalVariation`] |
//! | the same, cell by cell | [`Cell`], [`ProductCell`], [`SampledCell`], [`Freedom`]; [`PiecedCell`] of [`Pieces`], each a [`Quadrilateral`] |
//! | bounds from below | [`Calibration`], [`Plane`], [`certify()`], [`Unproved`] |
//! | errors | [`EnergyError`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod area;
mod area_hessian;
mod area_product;
mod area_sampled;
mod bernstein_form;
mod calibration;
mod calibration_proof;
mod cell;
mod cell_contraction;
mod cell_evaluation;
mod cell_pieces;
mod cell_product;
mod cell_sampled;
mod dense;
mod error;
mod functional;
mod normal_variation;
mod panel;
mod product;
mod quadratic;
mod reference;
mod shape;
mod tangent;
mod triangle;
mod triangle_area;
mod weighted;

pub use area::{AREA_TOLERANCE, Integral, area, area_derivative, area_with_gradient, integrate};
pub use area_hessian::AreaExpansion;
pub use area_product::ProductArea;
pub use area_sampled::SampledArea;
pub use calibration::{Calibration, Plane};
pub use calibration_proof::{Unproved, certify};
pub use cell::{Cell, Freedom};
pub use cell_pieces::{PiecedCell, Pieces, Quadrilateral};
pub use cell_product::ProductCell;
pub use cell_sampled::SampledCell;
pub use dense::DenseForm;
pub use error::EnergyError;
pub use functional::{DensityTerm, Functional};
pub use normal_variation::NormalVariation;
pub use quadratic::{KroneckerTerm, QuadraticForm};
pub use reference::ReferenceTriangle;
pub use shape::{GramPolynomial, ShapeForm, ShapeTerm};
pub use tangent::TangentSamples;
pub use triangle_area::triangle_area_with_gradient;
pub use weighted::{METRIC_TOLERANCE, MetricForm};
