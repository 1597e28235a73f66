//! A boundary and a method in, the patch that spans the boundary out, with figures that say how good it is.
//!
//! ```
//! use plateau::least_area;
//! use surfaces::{Net, Point, TensorPatch};
//!
//! // The frame of the saddle z = x² − y² over [−1, 1]²: four parabolas, given by their control points.
//! let curve = |points: [[f64; 3]; 3]| points.map(Point::from);
//! let u0 = curve([[-1.0, -1.0, 0.0], [-1.0, 0.0, 2.0], [-1.0, 1.0, 0.0]]);
//! let u1 = curve([[1.0, -1.0, 0.0], [1.0, 0.0, 2.0], [1.0, 1.0, 0.0]]);
//! let v0 = curve([[-1.0, -1.0, 0.0], [0.0, -1.0, -2.0], [1.0, -1.0, 0.0]]);
//! let v1 = curve([[-1.0, 1.0, 0.0], [0.0, 1.0, -2.0], [1.0, 1.0, 0.0]]);
//!
//! let frame = Net::from_boundary(&u0, &u1, &v0, &v1)?.raised(6);
//! let (patch, found) = least_area(&TensorPatch::bernstein(frame)?, 1e-9, &())?;
//! assert!((found.area.value / 7.383_505_602_602 - 1.0).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`least_area`] and [`least_area_triangle`] take a patch, of which the border counts, to the one of least area.
//! - [`solve()`] runs a [`Method`] over a [`Boundary`]: extremals of quadratic energies and of the area, masks, explicit and
//!   harmonic nets, their shape parameters given or searched ([`Search`]). What comes out is [`Done`]: the [`Surface`], the way
//!   to it, its [`Figures`], and each [`Warning`] that a reader needs; of slender boundaries what cutting gains ([`CutGain`]).
//! - [`ReducedEnergy`] joins energies, systems and searches: a swarm of `optim` over it tunes a GT patch in fifteen lines.
//! - [`helicoids`] and [`trapezium`] make the helicoids of AHT and AT, [`of_net`] the surface of a net of one's own, [`sample`] samples
//!   a curve.
//! - [`fill()`] goes from loops to the film of least area in them; [`Fill`] from loops or a graph of curves, in every way.
//! - [`Cutting`] cuts loops and graphs of curves into the quadrilaterals of a [`surfaces::Complex`].
//! - [`degeneracies`] says what is wrong with a boundary before anything is computed.
//!
//! Whoever waits may watch ([`Progress`]) and keep finished runs of searches ([`Keeper`]). Nothing here reads or writes files.
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | boundaries | [`Boundary`]: [`TensorBoundary`], [`OppositeSides`] in a [`Direction`], [`TriangleBoundary`]; [`Corner`], [`Gap`], [`BoundaryError`], [`Degeneracy`]; [`MAX_DEGREE`], [`MAX_COORDINATE`], [`MIN_SIZE`] |
//! | methods | [`Method`], its [`Filling`]; [`Functions`], [`FixedShape`], [`Family`], [`ShapedFamily`]; [`TensorInterior`], [`TriangleInterior`], [`TriangleMask`], [`SolverChoice`], [`ReferenceTriangle`], [`Conditioning`], [`nonnegative_shapes()`], [`BasisFamily`]; [`Energy`], [`SearchEnergy`], [`Functional`]; [`MethodFault`], [`DegreeLimit`], [`Cost`], [`TOLERANCES`], [`MAX_METRIC_STEPS`] |
//! | numbers for people | [`Notation`], [`counted()`], [`rough_duration()`] |
//! | running one | [`Context`], [`Arithmetic`], [`MethodError`] with its [`MethodFailure`] |
//! | searches | [`Search`], [`SearchFault`], [`SearchMode`], [`Variant`], [`MAX_SEARCH_BUDGET`]; [`SearchOutcome`], [`SearchRun`] with its [`Swarm`] |
//! | results | [`Results`] with each [`Remark`] on the whole, [`MethodResult`], [`Done`]; [`Solved`], [`SolveFigures`], [`Surface`] |
//! | figures | [`Figures`], [`BoundaryFigures`], [`FilmFigures`], [`Seams`], [`Kink`]; [`Quantity`] with its [`Bearer`], [`Measured`]; [`ClosedForm`] |
//! | least areas | [`least_area_from()`], [`least_area_raised()`], [`least_area_triangle_from()`], [`least_area_triangle_raised()`], [`least_area_complex()`], [`least_area_complex_near()`], [`dirichlet_complex()`]; [`AreaExtremal`], [`Displacement`], [`DisplacementEnd`], [`Mode`], [`AreaEnd`], [`ValleyEnd`], [`Start`], [`Stage`] |
//! | how far from the least | [`estimate_net()`], [`estimate_triangle()`], [`estimate_complex()`], [`AreaEstimate`], [`NoEstimate`]; [`excess_of_net()`], [`excess_of_triangle()`], [`excess_of_complex()`] |
//! | proved bounds from below | [`lower_bound()`], [`lower_bound_of_net()`], [`LowerBound`], [`CalibratedFace`], [`Competitors`], [`NoBound`] |
//! | loops and graphs of curves | [`Loop`], [`CurveGraph`], [`GraphCurve`], [`FaceSide`]; [`Cutting`], [`CutBoundary`], [`Way`], [`CuttingError`] with its [`CuttingSite`], [`odd_corners()`] |
//! | films | [`Film`], [`FilmFace`], [`FillEnergy`], [`Tried`] |
//! | exact surfaces | [`Helicoid`], [`DeformationPath`], [`Construction`] |
//! | nets of one's own | [`OwnNet`], [`NetBasis`], [`OrderSix`], [`of_net()`] |
//! | curves | [`Curve`], [`CurveBasis`], [`CurveFunction`], [`CurveEnd`], [`CurveResult`] with its [`CurveSample`]; [`NearestCurve`], [`NearestCurveError`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod arithmetic;
mod boundary;
mod boundary_figures;
mod closed_form;
mod conditioning;
mod context;
mod corners;
mod cost;
mod crossing;
mod curve;
mod curve_basis;
mod curve_function;
mod cutting;
mod degeneracy;
mod degenerate;
mod degree_limit;
mod done;
mod error;
mod excess;
mod family;
mod figures;
mod film;
mod film_figures;
mod helicoid;
mod interior;
mod keeper;
mod least_area;
mod lower_bound;
mod memory;
mod method;
mod nearest_curve;
mod number;
mod outcome;
mod own_net;
mod progress;
mod quantity;
mod remark;
mod seams;
mod search;
mod slender;
mod solve;
mod solved;
mod surface;
mod trust;
mod warning;

pub use arithmetic::Arithmetic;
pub use bases::{BasisFamily, nonnegative_shapes};
pub use boundary::{
    Boundary, BoundaryError, Corner, Direction, Gap, MAX_COORDINATE, MAX_DEGREE, MIN_SIZE, OppositeSides,
    TensorBoundary, TriangleBoundary,
};
pub use boundary_figures::BoundaryFigures;
pub use closed_form::ClosedForm;
pub use conditioning::Conditioning;
pub use context::Context;
pub use corners::odd_corners;
pub use cost::Cost;
pub use curve::{Curve, CurveResult, CurveSample, sample};
pub use curve_basis::CurveBasis;
pub use curve_function::{CurveEnd, CurveFunction};
pub use cutting::{
    CurveGraph, CutBoundary, Cutting, CuttingError, CuttingSite, FaceSide, GraphCurve, Loop, Way,
};
pub use degeneracy::Degeneracy;
pub use degenerate::degeneracies;
pub use degree_limit::DegreeLimit;
pub use done::Done;
pub use energy::{Functional, ReferenceTriangle};
pub use error::{MethodError, MethodFailure};
pub use family::Family;
pub use figures::Figures;
pub use film::{Fill, FillEnergy, Film, FilmFace, Tried, fill};
pub use film_figures::FilmFigures;
pub use helicoid::{Construction, DeformationPath, Helicoid, helicoids, trapezium};
pub use keeper::Keeper;
pub(crate) use least_area::costs_less;
pub use least_area::{
    AreaEnd, AreaEstimate, AreaExtremal, Displacement, DisplacementEnd, Mode, NoEstimate, Stage, Start,
    ValleyEnd, dirichlet_complex, estimate_complex, estimate_net, estimate_triangle, excess_of_complex,
    excess_of_net, excess_of_triangle, least_area, least_area_complex, least_area_complex_near,
    least_area_from, least_area_raised, least_area_triangle, least_area_triangle_from,
    least_area_triangle_raised,
};
pub use lower_bound::{CalibratedFace, Competitors, LowerBound, NoBound, lower_bound, lower_bound_of_net};
pub use method::{
    Energy, Filling, FixedShape, Functions, MAX_METRIC_STEPS, Method, MethodFault, SearchEnergy,
    SolverChoice, TOLERANCES, TensorInterior, TriangleInterior,
};
pub use nearest_curve::{NearestCurve, NearestCurveError};
pub use number::{Notation, counted, rough_duration};
pub use outcome::{MethodResult, Results};
pub use own_net::{NetBasis, OrderSix, OwnNet, of_net};
pub use progress::Progress;
pub use quantity::{Bearer, Measured, Quantity};
pub use remark::Remark;
pub use seams::{Kink, Seams};
pub use search::{
    MAX_SEARCH_BUDGET, ReducedEnergy, Search, SearchFault, SearchMode, SearchOutcome, SearchRun, Swarm,
    Variant,
};
pub use slender::CutGain;
pub use solve::solve;
pub(crate) use solved::Interior;
pub use solved::{SolveFigures, Solved};
pub use surface::Surface;
pub use surfaces::{ShapedFamily, TriangleMask};
pub use warning::Warning;
