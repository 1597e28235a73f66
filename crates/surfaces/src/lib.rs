//! Control nets and the patches they span.
//!
//! A [`Net`] holds control points, each fixed or free. With families of functions (crate `bases`) it spans a
//! [`TensorPatch`]: Bernstein–Bézier, GT–Bézier, or a blend such as [`tb_coons()`]. A [`TriangleNet`] spans a
//! [`TrianglePatch`]. Every [`Patch`] gives its [`Jet`]: position, derivatives to second order, fundamental forms,
//! normal, mean and Gauss curvature; and a triangle [`Mesh`] with these at its vertices. Interiors of nets come from
//! their boundary by [`discrete_coons()`] and by masks ([`TriangleMask`], [`rectangular_mask()`]), or from an energy.
//!
//! Minimal surfaces with exact nets: the [`Helicoid`] family from right helicoid to catenoid, its [`Deformation`], and
//! the [`TrapeziumHelicoid`]; beyond the span one patch can hold they come in [`Pieces`] that meet exactly. A [`Curve`] has
//! a curvature; curves and tensor patches are cut by subdivision.
//!
//! A [`Complex`] is a surface of quadrilateral patches that share vertices and edges. What its rim may be given as is a
//! [`BoundaryCurve`]: a Bézier curve, a polyline, a B-spline, samples, an arc; [`BoundaryCurve::fit`] makes Bézier pieces of
//! it, exact where they can be, else with their distance from it.
//!
//! ```
//! use surfaces::{Mesh, Net, Patch, Point, TensorPatch};
//!
//! let line = |a: Point, b: Point| [a, (a + b) * 0.5, b];
//! let [a, b, c, d] = [[0., 0., 0.], [0., 1., 0.], [1., 0., 0.], [1., 1., 1.]].map(Point::from);
//! let net = Net::from_boundary(&line(a, b), &line(c, d), &line(a, c), &line(b, d))?;
//! assert_eq!(net.fixed().iter().filter(|fixed| !**fixed).count(), 1);
//!
//! let patch = TensorPatch::gt(net, [1.0, 1.0, 1.0, 1.0])?;
//! assert!(patch.jet(0.2, 0.8).mean_curvature().is_some());
//! assert_eq!(Mesh::of(&patch, 10).triangles.len(), 200);
//! # Ok::<(), surfaces::SurfaceError>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | points and nets | [`Point`], [`Net`], [`TriangleNet`], [`extent()`], [`anchor()`] |
//! | patches | [`Patch`], its [`Domain`]; [`TensorPatch`] of [`Product`]s, [`TrianglePatch`] of a [`TriangleBasis`], [`Pieces`] |
//! | families with shape parameters | [`ShapedFamily`], [`ShapeFactor`], [`polynomial_bubbles()`]; [`tb_coons()`], [`tb_coons_parts()`] of [`end_blend()`] and [`bernstein_less_blend()`] |
//! | what is known at a point | [`Jet`], [`FirstForm`], [`SecondForm`] |
//! | meshes | [`Mesh`], [`ComplexMesh`] |
//! | nets by formula | [`discrete_coons()`], [`discrete_coons_triangle()`]; [`TriangleMask`], [`rectangular_mask()`], [`MaskSystem`], [`COONS_CORNER_WEIGHT`]; [`harmonic_relations()`], [`Relation`] |
//! | exact minimal surfaces | [`Helicoid`], [`Deformation`], [`DeformationPath`], [`TrapeziumHelicoid`], [`PlaneConstruction`], [`SpiralEnd`] |
//! | complexes | [`Complex`], [`Vertex`], [`Edge`], [`EdgeUse`], [`FixedEdge`], [`Face`], [`Side`], [`Orientation`], [`ComplexError`] |
//! | curves | [`Curve`], [`CurveJet`]; [`BoundaryCurve`]: [`Bezier`], [`Polyline`], [`SplineCurve`], [`Samples`], [`EllipseArc`]; [`CurveFit`], [`Deviation`], [`CurveError`] with its [`CurvePart`] |
//! | B-spline surfaces | [`SplineSurface`] of [`Knots`], [`SplineFit`], [`SplineFitError`] |
//! | errors | [`SurfaceError`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod anchor;
mod complex;
mod conjugate_gradients;
mod curve;
mod curves;
mod deformation;
mod discrete_coons;
mod error;
mod harmonic;
mod helicoid;
mod jet;
mod mask;
mod mesh;
mod net;
mod patch;
mod pieces;
mod point;
mod shaped;
mod spline;
mod subdivision;
mod tb_coons;
mod tensor;
mod trapezium;
mod triangle;
mod triangle_basis;
mod triangle_net;

pub use anchor::anchor;
pub use complex::{
    Complex, ComplexError, ComplexMesh, Edge, EdgeUse, Face, FixedEdge, Orientation, Side, Vertex,
};
pub use curve::{Curve, CurveJet};
pub use curves::{
    Bezier, BoundaryCurve, CurveError, CurveFit, CurvePart, Deviation, EllipseArc, Polyline, Samples,
    SplineCurve,
};
pub use deformation::{Deformation, DeformationPath};
pub use discrete_coons::{discrete_coons, discrete_coons_triangle};
pub use error::SurfaceError;
pub use harmonic::{Relation, harmonic_relations};
pub use helicoid::Helicoid;
pub use jet::{FirstForm, Jet, SecondForm};
pub use mask::{COONS_CORNER_WEIGHT, MaskSystem, TriangleMask, rectangular_mask};
pub use mesh::Mesh;
pub use net::{Net, extent};
pub use patch::{Domain, Patch};
pub use pieces::Pieces;
pub use point::Point;
pub use shaped::{ShapeFactor, ShapedFamily, polynomial_bubbles};
pub use spline::{Knots, SplineFit, SplineFitError, SplineSurface};
pub use tb_coons::{bernstein_less_blend, end_blend, tb_coons, tb_coons_parts};
pub use tensor::{Product, TensorPatch};
pub use trapezium::{PlaneConstruction, SpiralEnd, TrapeziumHelicoid};
pub use triangle::TrianglePatch;
pub use triangle_basis::TriangleBasis;
pub use triangle_net::TriangleNet;
