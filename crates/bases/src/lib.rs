//! Univariate families of Bézier-like basis functions and their inner products.
//!
//! A [`Basis`] is a finite family of functions on an interval that answers three questions: how many, where, and the
//! values with derivatives at a point. The families: [`Bernstein`] polynomials, the generalized
//! trigonometric [`Gt`] functions with two shape parameters (and [`GtParts`], their parts affine in the shape), the functions of either
//! that vanish at both ends in a well-conditioned form ([`Lobatto`], [`GtBubbles`]),
//! the six [`Aht`] and [`At`] functions that hold catenoids and helicoids exactly, and
//! linear combinations of families ([`Stacked`]). All are partitions of unity that interpolate at
//! the ends, with errors bounded in units of u = 2⁻⁵³ in their own documentation.
//!
//! [`GaussLegendre`] rules of any size integrate them; [`Samples`] and [`gram()`] make their inner products.
//!
//! All transcendental functions are those of the `libm` crate, so values do not depend on the platform.
//!
//! ```
//! use bases::{Basis, Gt, gram};
//!
//! let basis = Gt::new(3, [0.87, 0.87])?;
//! let values = basis.evaluate(0.3, 0);
//! let sum: f64 = values.row(0).iter().sum();
//! assert!((sum - 1.0).abs() < 1e-15);
//!
//! // The stiffness matrix ∫ G_i' G_j' annihilates constants.
//! let stiffness = gram(&basis, 1, 1)?;
//! assert!(stiffness.row(1).iter().sum::<f64>().abs() < 1e-14);
//! # Ok::<(), bases::BasisError>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | families | [`Basis`], [`BasisFamily`] by name; [`Bernstein`], [`Gt`], [`Aht`], [`At`]; [`GtParts`] affine in the shape, [`nonnegative_shapes()`]; [`Stacked`] combinations; [`Nodal`] values at points |
//! | functions that vanish at both ends | [`Lobatto`], [`GtBubbles`], [`GtBubbleParts`] affine in the shape |
//! | integrals | [`GaussLegendre`], [`Samples`], [`gram()`] |
//! | cutting a family in two | [`Subdivision`] |
//! | matrices, errors | [`Matrix`], [`BasisError`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod aht;
mod at;
mod basis;
mod bernstein;
mod double_double;
mod error;
mod family;
mod gram;
mod gt;
mod gt_bubbles;
mod gt_region;
mod lobatto;
mod matrix;
mod nodal;
mod order_six;
mod quadrature;
mod stacked;
mod subdivision;

pub use aht::Aht;
pub use at::At;
pub use basis::Basis;
pub use bernstein::Bernstein;
pub use error::BasisError;
pub use family::BasisFamily;
pub use gram::{Samples, gram};
pub use gt::{Gt, GtParts};
pub use gt_bubbles::{GtBubbleParts, GtBubbles};
pub use gt_region::nonnegative_shapes;
pub use lobatto::Lobatto;
pub use matrix::Matrix;
pub use nodal::Nodal;
pub use quadrature::GaussLegendre;
pub use stacked::Stacked;
pub use subdivision::Subdivision;
