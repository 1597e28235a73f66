use thiserror::Error;

use crate::{AreaEnd, CutGain, Degeneracy, Displacement, NoBound, NoEstimate, Notation};

/// What a reader must know before trusting a surface or its figures; shown as one sentence.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Warning {
    /// What the area is above the least could not be estimated.
    #[error("how far above the least area of the boundary it lies is not known: {0}")]
    NoEstimate(NoEstimate),
    /// The area is not as near the least as was asked for.
    #[error("at degree {degree} the area is not known to lie within {accuracy:.0e} of the least")]
    Inaccurate {
        /// The share that was asked for.
        accuracy: f64,
        /// The degree of the patches.
        degree: usize,
    },
    /// A layer of smaller patches was set for an accuracy that was asked for.
    #[error(
        "raising the degree to {degree} gained little because of corners: they have a layer of smaller patches around them"
    )]
    LayerSet {
        /// The degree of the patches at which it was set.
        degree: usize,
    },
    /// Layers of smaller patches were asked for and not all set.
    #[error("{}", no_layer(*wanted, *set))]
    NoLayer {
        /// How many were asked for.
        wanted: usize,
        /// How many there are.
        set: usize,
    },
    /// A lower bound was asked for and not proved.
    #[error("no lower bound of the area: {0}")]
    NoBound(NoBound),
    /// Ends of sides that differed were made one point.
    #[error(
        "corners of the boundary differed by up to {distance:.1e}, {share:.0e} of its size, and were made one point each"
    )]
    Welded {
        /// Their largest distance (a length).
        distance: f64,
        /// The same as a share of the size of the boundary.
        share: f64,
    },
    /// The best shape of a search lies on the boundary of its box.
    #[error("the search box binds: {} at {}; a wider box may hold a lower minimum", parameters.join(", "), Notation::Exact.of(*bound))]
    BoxBinds {
        /// The parameters there.
        parameters: Vec<&'static str>,
        /// The end of the box.
        bound: f64,
    },
    /// Runs whose polish did not end at a stationary point.
    #[error("{runs} of {of} runs did not end at a stationary point")]
    NotStationary {
        /// How many.
        runs: usize,
        /// Of how many.
        of: usize,
    },
    /// Runs that ended because their budget was spent.
    #[error("{runs} of {of} runs stopped on budget, which is not convergence{}", best_values(*of, *spread))]
    Budget {
        /// How many.
        runs: usize,
        /// Of how many.
        of: usize,
        /// The difference between the best values of the worst and the best run.
        spread: f64,
    },
    /// Evaluations of a search that failed.
    #[error("{failed} of {of} evaluations of the search failed and were passed over")]
    FailedEvaluations {
        /// How many.
        failed: u64,
        /// Of how many.
        of: u64,
    },
    /// A large condition number.
    #[error(
        "the control points are ill-conditioned (about {condition:.0e}): they lose digits, the surface fewer"
    )]
    IllConditioned {
        /// Estimate of the condition number.
        condition: f64,
    },
    /// A linear solve with a large residual.
    #[error("the linear solve left a residual of {residual:.0} (30 is LAPACK's threshold of failure)")]
    Residual {
        /// As LAPACK's tests scale it.
        residual: f64,
    },
    /// The metric of a correction was not integrated.
    #[error(
        "the metric of the last correction has not settled by a rule of {points}² points: D^g is uncertain by {error:.1e}, and the net with \
         it; the surface before it nearly folds"
    )]
    MetricUnsettled {
        /// Points of the rule in each direction.
        points: usize,
        /// The error of D^g.
        error: f64,
    },
    /// Parts of an extremal of high degree that no control net can hold.
    #[error(
        "parts of the extremal that move no point by more than {share:.1e} of the size are left out: rounding of their control \
         points would move it as far; a lower degree, or sides whose control points oscillate less, avoid that"
    )]
    LeftOut {
        /// How far they reach, as a share of the size of the boundary.
        share: f64,
    },
    /// Control points far beyond the boundary.
    #[error(
        "the control points reach {:.0e} times as far out as the boundary: the surface is what their differences leave, and \
         is certain to about {share:.0e} of its size",
        share / f64::EPSILON
    )]
    Cancellation {
        /// Rounding of the surface as a share of the size of its boundary.
        share: f64,
    },
    /// The search for the least area ended before a minimum.
    #[error("the least area was not reached: {end}, gradient {gradient:.1e} of the root of the area")]
    AreaNotReached {
        /// Why it ended.
        end: AreaEnd,
        /// Gradient of the area over √area.
        gradient: f64,
    },
    /// The search for the least area ended on a rule that does not integrate it.
    #[error(
        "the least area was not reached: the search for it ended on a rule of {points}² points that does not integrate it (± {error:.1e}); \
         the net nearly folds, and its gradient is {gradient:.1e} of the root of the area"
    )]
    AreaRule {
        /// Points of the rule in each direction.
        points: usize,
        /// Error of the area by it.
        error: f64,
        /// Gradient of the area over √area.
        gradient: f64,
    },
    /// No net of nearly the least area has its control points near the border and an even parametrisation.
    #[error(
        "control points lie further from the boundary than its size, or the parametrisation nearly folds: no surface of \
         nearly this area was found without that, and figures that depend on the parametrisation are unsure"
    )]
    FarNet,
    /// The inside of a net of high degree was not sought to its own.
    #[error("{0}")]
    Displaced(Displacement),
    /// One patch over a boundary that is many times as long as wide.
    #[error("{}", of_slender(*ratio, cut.as_ref()))]
    Slender {
        /// How many times.
        ratio: f64,
        /// What several patches gain; none where that was not computed.
        cut: Option<CutGain>,
    },
    /// A negative second variation of the area.
    #[error(
        "the surface is not a stable minimum: its second variation is negative along the normal; another surface over the \
         same boundary has less area"
    )]
    Unstable,
    /// No area beyond rounding.
    #[error(
        "the patch has no area beyond rounding ({area:.1e}): (D − A)/A and the mean curvature are left out"
    )]
    NoArea {
        /// The area.
        area: f64,
    },
    /// The quadrature of the area did not converge.
    #[error(
        "the area has not settled: {} ± {error:.1e} after {points}² quadrature points; the patch folds or is singular \
         somewhere",
        Notation::Exact.of(*area)
    )]
    AreaUnsettled {
        /// The area.
        area: f64,
        /// The error believed.
        error: f64,
        /// Points of the rule in each direction.
        points: usize,
    },
    /// Singular at every vertex of the mesh.
    #[error("the patch is singular at every vertex of its mesh: no mean curvature is given")]
    SingularMesh,
    /// The quadrature of H² did not converge.
    #[error(
        "the root mean square of H is left out: ∫H² dA has not settled ({square:.3e} ± {error:.0e} after {points}² quadrature \
         points); the patch is singular somewhere, or nearly, and the largest |H| depends on the mesh"
    )]
    CurvatureUnsettled {
        /// ∫H² dA.
        square: f64,
        /// The error believed.
        error: f64,
        /// Points of the rule in each direction.
        points: usize,
    },
    /// An interval too long for one patch.
    #[error(
        "{name} = {span} is cut into {pieces} equal parts: one patch holds spans below {bound:.4}, the bound of the {basis} \
         basis"
    )]
    SpanCut {
        /// The name of the interval.
        name: &'static str,
        /// Its length.
        span: f64,
        /// The number of equal parts.
        pieces: f64,
        /// The bound of the basis.
        bound: f64,
        /// The basis.
        basis: &'static str,
    },
    /// An interval close to the bound of its basis.
    #[error(
        "{name} = {span} lies within {:.1} % of the bound {bound:.4} of the {basis} basis: the control points grow and lose \
         digits",
        100.0 * (1.0 - span / bound)
    )]
    SpanNearBound {
        /// The name of the interval.
        name: &'static str,
        /// Its length.
        span: f64,
        /// The bound of the basis.
        bound: f64,
        /// The basis.
        basis: &'static str,
    },
    /// A curve whose tangent vanishes at samples.
    #[error(
        "the tangent vanishes at t = {}: there is no curvature there, and so no list of the curvatures of all samples",
        first_five(at)
    )]
    CurveSingular {
        /// Their parameters.
        at: Vec<f64>,
    },
    /// A curve on an interval close to the bound of its basis.
    #[error(
        "the span lies within {} % of the bound {bound:.6} of the {basis} basis, where curves lose digits and control points \
         grow: cut the curve into two",
        Notation::Share.of(100.0 * (1.0 - span / bound))
    )]
    CurveNearBound {
        /// Length of the interval.
        span: f64,
        /// The bound of the basis.
        bound: f64,
        /// The basis.
        basis: &'static str,
    },
    /// The quadrature of a length did not converge.
    #[error("the length has not settled: {} ± {error:.1e}; the curve may have a cusp", Notation::Exact.of(*length))]
    LengthUnsettled {
        /// The length.
        length: f64,
        /// The error believed.
        error: f64,
    },
    /// Patches that fold.
    #[error(
        "the surface folds: in {faces} of {of} patches the normal turns by more than a right angle from one point to the next{}",
        across(*kink)
    )]
    Folded {
        /// Patches whose normal turns over.
        faces: usize,
        /// All patches.
        of: usize,
        /// The largest angle between the normals across an edge, in radians.
        kink: f64,
    },
    /// A patch without a normal inside an edge.
    #[error("no kink is given: a patch is singular inside the edge from {} to {}", ends[0], ends[1])]
    KinkUndefined {
        /// The vertices of the edge.
        ends: [String; 2],
    },
    /// Two loops that no annulus of least area joins.
    #[error(
        "no annulus of least area: it pinches, thinnest at ({}, {}, {}) with {length:.3e} around",
        Notation::Short(4).of(at[0]), Notation::Short(4).of(at[1]), Notation::Short(4).of(at[2])
    )]
    Pinches {
        /// Length of the shortest line around it.
        length: f64,
        /// The middle of that line.
        at: [f64; 3],
    },
    /// Two loops that are spanned with less area one by one.
    #[error("the two loops, each spanned by itself, have less area together: {} instead of {}", Notation::Short(10).of(*discs), Notation::Short(10).of(*area))]
    OneByOne {
        /// The area of both.
        discs: f64,
        /// The area of the annulus.
        area: f64,
    },
    /// A degenerate boundary.
    #[error(transparent)]
    Degenerate(#[from] Degeneracy),
}

impl Warning {
    /// What may be done about it, as a sentence; none where there is nothing to be done.
    pub fn remedy(&self) -> Option<&'static str> {
        match self {
            Self::NotStationary { .. } => Some("follow the swarm by a descent, or allow more iterations"),
            Self::Budget { .. } => Some("allow more iterations, or follow the swarm by a descent"),
            Self::FailedEvaluations { .. } => Some("narrow the box: shapes at its ends have no basis"),
            Self::IllConditioned { .. } => {
                Some("lower the degree if the control points themselves are wanted")
            }
            Self::MetricUnsettled { .. } => Some("take fewer steps, or look for the least area itself"),
            Self::Residual { .. } => Some("lower the degree, or choose the separable solver"),
            Self::Cancellation { .. } => Some("lower the degree"),
            Self::AreaNotReached { .. } => Some("raise the degree, or loosen the tolerance"),
            Self::AreaRule { .. } => Some("try another degree or another start"),
            Self::FarNet => Some("cut the boundary into several patches, or lower the degree"),
            Self::Displaced(_) => Some("give the boundary as a loop: several patches follow what one cannot"),
            Self::Slender { .. } => Some("give the boundary as a loop, which is cut across by itself"),
            Self::Unstable => Some("raise the degree, or move the start"),
            Self::NoArea { .. } => Some("check the boundary: its curves may coincide"),
            Self::AreaUnsettled { .. } => Some("look at the surface; another degree may unfold it"),
            Self::SingularMesh => Some("check the boundary: its curves may coincide"),
            Self::CurvatureUnsettled { .. } => {
                Some("trust the area; for curvature avoid corners that meet in one direction")
            }
            // Its own sentence says what to do.
            Self::BoxBinds { .. } | Self::Degenerate(_) | Self::CurveNearBound { .. } => None,
            Self::NoEstimate(NoEstimate::OutOfMemory { .. }) => Some("free memory"),
            Self::NoEstimate(
                NoEstimate::Slow { .. } | NoEstimate::Unresolved { .. } | NoEstimate::NotReached,
            ) => Some("raise the degree"),
            Self::Inaccurate { .. } => Some("give a higher degree"),
            Self::LayerSet { .. } | Self::NoLayer { .. } => None,
            Self::NoBound(_) | Self::Welded { .. } | Self::LeftOut { .. } | Self::SpanCut { .. } => None,
            Self::SpanNearBound { .. } => Some("shorten the interval, or lengthen it: then it is cut"),
            Self::CurveSingular { .. } => Some("leave out these samples"),
            Self::LengthUnsettled { .. } => Some("cut the curve at the cusp"),
            Self::Folded { .. } => Some("cut the boundary in another way, or raise the degree"),
            Self::KinkUndefined { .. } => Some("check the boundary: its curves may coincide"),
            Self::Pinches { .. } => Some("bring the loops nearer together, or span each by itself"),
            Self::OneByOne { .. } => Some("span each loop by itself if the surface need not hang together"),
        }
    }
}

/// What a slender boundary means for a single patch.
fn of_slender(ratio: f64, cut: Option<&CutGain>) -> String {
    let slender = format!("the boundary is {ratio:.0} times as long as wide");
    match cut {
        Some(CutGain { pieces, degree, area, gained }) => format!(
            "{slender}: cut across into {pieces} patches of degree {degree}, the least area is {}, which is {:.1e} of it less",
            Notation::Short(10).of(*area),
            gained / area
        ),
        None => format!(
            "{slender}: cut across into several patches, its least area may be less; by how much was not computed"
        ),
    }
}

/// Why layers are not there.
fn no_layer(wanted: usize, set: usize) -> String {
    let more = if set == 0 { "" } else { " more" };
    let layers = if wanted - set == 1 { "layer" } else { "layers" };
    format!(
        "no{more} {layers} of smaller patches could be set: no corner needs one, it does not lower the area, or the surface without it is not a stable minimum"
    )
}

/// How the best values of several runs compare.
fn best_values(runs: usize, spread: f64) -> String {
    match spread {
        _ if runs == 1 => String::new(),
        0.0 => "; their best values are equal".to_owned(),
        spread => format!("; their best values spread by {spread:.1e}"),
    }
}

/// What folds across an edge.
fn across(kink: f64) -> String {
    let degrees = kink.to_degrees();
    if degrees > 90.0 { format!(", and by {degrees:.0}° across an edge") } else { String::new() }
}

fn first_five(numbers: &[f64]) -> String {
    let shown = numbers.iter().take(5).map(|&x| Notation::Exact.of(x)).collect::<Vec<_>>().join(", ");
    if numbers.len() > 5 { format!("{shown} and {} more", numbers.len() - 5) } else { shown }
}
