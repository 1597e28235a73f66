use bases::BasisFamily;
use surfaces::Point;
use thiserror::Error;

use crate::{CuttingError, Degeneracy, DegreeLimit, Direction, Family, Notation};

/// Why a method found no patch.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MethodError {
    /// The linear system of the interior.
    #[error("the interior control points cannot be solved for: {0}")]
    Solve(#[from] solve::SolveError),
    /// The control net or the families on it.
    #[error(transparent)]
    Surface(#[from] surfaces::SurfaceError),
    /// A complex of patches.
    #[error(transparent)]
    Complex(#[from] surfaces::ComplexError),
    /// A boundary that cannot be cut into quadrilaterals.
    #[error(transparent)]
    Cutting(#[from] CuttingError),
    /// Something went wrong with a boundary far from the origin, and that may be why.
    #[error("{far}: {error}")]
    Far {
        /// How far.
        far: Degeneracy,
        /// What went wrong.
        error: Box<MethodError>,
    },
    /// The energy.
    #[error(transparent)]
    Energy(#[from] energy::EnergyError),
    /// A basis.
    #[error(transparent)]
    Basis(#[from] bases::BasisError),
    /// The parameters of the swarm.
    #[error("the search cannot begin: {0}")]
    Swarm(#[from] optim::PsoError),
    /// The parameters of the polish.
    #[error("the polish cannot begin: {0}")]
    Polish(#[from] optim::PolishError),
    /// The search box.
    #[error("the search box is not sound: {0}")]
    Bounds(#[from] optim::BoundsError),
    /// The search box reaches beyond what the family admits.
    #[error(
        "the search box [{lower:?}, {upper:?}] reaches beyond the shape parameters of {family}, each in [{}, {}]: give lower < upper within that",
        range.0, range.1
    )]
    SearchBox {
        /// Lower end of the box.
        lower: f64,
        /// Upper end of the box.
        upper: f64,
        /// The family.
        family: &'static str,
        /// The range of its parameters.
        range: (f64, f64),
    },
    /// No shape in the box has a finite energy.
    #[error("no shape in the search box gives a finite energy: {evaluations} evaluations all failed")]
    NothingFound {
        /// Evaluations made.
        evaluations: u64,
    },
    /// Two loops in the two halves of the cone that all catenoids about an axis touch: no surface of least area hangs together between them.
    #[error(
        "no annulus of least area, nor any other surface that hangs together: it pinches between the two loops, which lie in the two halves of the cone that \
         catenoids touch, of half-angle 56.466° at ({}, {}, {}) along ({}, {}, {}), too far apart for their size; bring them nearer together, or \
         span each by itself{}",
        Notation::Short(6).of(apex[0]), Notation::Short(6).of(apex[1]), Notation::Short(6).of(apex[2]),
        Notation::Short(4).of(axis[0]), Notation::Short(4).of(axis[1]), Notation::Short(4).of(axis[2]),
        discs.map_or_else(String::new, |discs| format!(", with area {} together", Notation::Digits(9).of(discs)))
    )]
    Apart {
        /// The apex of the cone.
        apex: [f64; 3],
        /// Its axis, towards the second loop, of length 1.
        axis: [f64; 3],
        /// The area of both loops, each spanned by itself.
        discs: Option<f64>,
    },
    /// Another error, with what to do about it in the words of whoever asked.
    #[error("{error}. {advice}")]
    Advised {
        /// What went wrong.
        error: Box<MethodError>,
        /// What to do.
        advice: &'static str,
    },
    /// The Coons mask determines no net at even degrees from 6.
    #[error(
        "the Coons mask is exactly singular at every even degree from 6, and this net has degree {degree}: some nets that \
         vanish on the border satisfy it too. Take an odd degree, the net raised by one, or the discrete Coons net, \
         or the net of least Coons functional"
    )]
    SingularMask {
        /// Degree of the net.
        degree: usize,
    },
    /// The degree is beyond what the method is offered for.
    #[error(transparent)]
    TooHigh(#[from] DegreeLimit),
    /// The sides given do not determine the harmonic net.
    #[error(
        "the sides given leave {missing} degrees of freedom of a harmonic net of degree ({m}, {n}): {}", determined(*m, *n, *given)
    )]
    HarmonicMissing {
        /// Degree in u.
        m: usize,
        /// Degree in v.
        n: usize,
        /// Dimension of the harmonic nets that fit, for each coordinate.
        missing: usize,
        /// Which two sides are given; none if all four are.
        given: Option<Direction>,
    },
    /// No harmonic net has the sides given.
    #[error(
        "no harmonic net of degree ({m}, {n}) has the sides given: the relations impose {conditions} conditions on them \
         and they fail by {misfit:.1e}; {}. Sides taken from a harmonic surface fit at every degree", determined(*m, *n, *given)
    )]
    HarmonicConflict {
        /// Degree in u.
        m: usize,
        /// Degree in v.
        n: usize,
        /// How many linear conditions the sides must satisfy, for each coordinate.
        conditions: usize,
        /// The largest relative misfit.
        misfit: f64,
        /// Which two sides are given; none if all four are.
        given: Option<Direction>,
    },
    /// The sides given determine a harmonic net, and rounding does not.
    #[error(
        "the harmonic net of degree ({m}, {n}) is lost to rounding: its relations tell it from others by less than the last digits of \
         control points. Rows of degree {} or less are found; describe the sides with fewer control points, or take the \
         extremal of the Laplacian energy",
        DegreeLimit::HARMONIC_ROWS
    )]
    HarmonicRounding {
        /// Degree in u.
        m: usize,
        /// Degree in v.
        n: usize,
    },
    /// The weights of a mask leave its system without an inverse.
    #[error(
        "the mask is singular at the corner weight α = {alpha:?} on a net of degree {degree} (reciprocal condition \
         {reciprocal_condition:.0e}): some nets that vanish on the border satisfy it too. Take another weight: -0.25 is the Coons mask \
         of tensor nets, which is never singular"
    )]
    MaskWeight {
        /// The corner weight.
        alpha: f64,
        /// The larger degree of the net.
        degree: usize,
        /// Estimate of the reciprocal condition number; 0 if a pivot vanished.
        reciprocal_condition: f64,
    },
    /// The system of a high degree is beyond double precision.
    #[error(
        "at degree {degree} the condition of the dense system of the interior is beyond double precision ({unknowns} unknowns, \
         pivot {pivot} is not positive): on tensor patches leave the choice of the solver to the program, whose own solves every extremal at every \
         degree; triangular ones take a lower degree, or a mask or the discrete Coons net, which stay sound"
    )]
    Degree {
        /// The larger degree of the net.
        degree: usize,
        /// Order of the system.
        unknowns: usize,
        /// The pivot that was not positive.
        pivot: usize,
    },
    /// Control points far beyond the boundary, whose differences leave no digit of the surface.
    #[error(
        "the extremal of degree ({}, {}) has control points up to {:.0e} times as far out as its boundary, and rounding of \
         their differences takes {share:.0e} of the size: take a lower degree, or a boundary whose control points oscillate less",
        degrees.0, degrees.1, share / f64::EPSILON
    )]
    Cancellation {
        /// Degrees in u and v.
        degrees: (usize, usize),
        /// Rounding of the surface as a share of the size of its boundary.
        share: f64,
    },
    /// A setting that nothing is filled with.
    #[error("the {name} of a filling is above 0 and finite; {value} is not")]
    Setting {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Parameters that a family of functions does not have.
    #[error("{} functions have no such parameter: {}", family.title(), parameters(*family))]
    Parameters {
        /// The family.
        family: BasisFamily,
    },
    /// A surface of another kind than its family has.
    #[error("{surface} is no surface that \"{}\" with basis \"{}\" makes", family.names().0, family.names().1)]
    Family {
        /// What it is.
        surface: &'static str,
        /// The family.
        family: Family,
    },
    /// A parameter at which a curve is not defined.
    #[error("the curve lives between {start} and {end}, and has no point at {t}")]
    Sample {
        /// The parameter.
        t: f64,
        /// The first parameter of the curve.
        start: f64,
        /// The last parameter of the curve.
        end: f64,
    },
    /// A control point of a planar curve lies off its plane.
    #[error(
        "control point {index} (counted from 0) is not in the plane z = 0: take the curve as one in space"
    )]
    NotPlanar {
        /// The control point.
        index: usize,
    },
    /// Parameters that cannot be those of cuts.
    #[error(
        "the cuts of a direction ascend between 0 and its span {span}; cut {index} (counted from 0) does not"
    )]
    Cuts {
        /// The length of the interval.
        span: f64,
        /// The first that does not.
        index: usize,
    },
    /// Derivatives of a curve are not finite.
    #[error(
        "the derivatives of the curve near t = {t:?} are beyond double precision: scale its points or its span"
    )]
    Overflow {
        /// The parameter.
        t: f64,
    },
    /// The memory that the method needs cannot be had.
    #[error(
        "out of memory: about {:.0} MB are needed at once and cannot be allocated; take a lower degree or a coarser mesh, or free memory",
        *bytes as f64 / 1e6
    )]
    OutOfMemory {
        /// Size of the request.
        bytes: usize,
    },
    /// The user ended the work before this method had a result.
    #[error("interrupted before it had a result")]
    Interrupted,
    /// The boundary has other sides than the method fills.
    #[error("this method fills {needs}, and the boundary has {given}")]
    Sides {
        /// What the method fills.
        needs: &'static str,
        /// What there is.
        given: &'static str,
    },
}

/// Which parameters a family has.
fn parameters(family: BasisFamily) -> String {
    match (family.has_shape(), family.spans().is_some()) {
        (false, false) => "they have none beside their degree".to_owned(),
        (true, false) => {
            format!("a shape ({}) is theirs; they live on [0, 1]", family.parameters().join(", "))
        }
        (false, true) => "the length of their interval is theirs, and no shape".to_owned(),
        (true, true) => "a shape and the length of their interval are theirs".to_owned(),
    }
}

/// Degree from which a matrix that is not positive definite is so by its degree alone.
const HIGH: usize = 10;

/// What kind of thing kept a method from its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MethodFailure {
    /// The caller wanted no more.
    Interrupted,
    /// The memory could not be had.
    Memory,
    /// The boundary cannot be filled by any method of its kind.
    Boundary,
    /// The method, or what was asked of it, does not suit this boundary.
    Method,
}

impl MethodError {
    /// What kind of thing went wrong.
    #[must_use]
    pub fn failure(&self) -> MethodFailure {
        match self {
            Self::Interrupted => MethodFailure::Interrupted,
            Self::OutOfMemory { .. } => MethodFailure::Memory,
            Self::Cutting(_) => MethodFailure::Boundary,
            Self::Far { error, .. } | Self::Advised { error, .. } => error.failure(),
            Self::Solve(_)
            | Self::Surface(_)
            | Self::Complex(_)
            | Self::Energy(_)
            | Self::Basis(_)
            | Self::Swarm(_)
            | Self::Polish(_)
            | Self::Bounds(_)
            | Self::SearchBox { .. }
            | Self::NothingFound { .. }
            | Self::Apart { .. }
            | Self::SingularMask { .. }
            | Self::TooHigh(_)
            | Self::HarmonicMissing { .. }
            | Self::HarmonicConflict { .. }
            | Self::HarmonicRounding { .. }
            | Self::MaskWeight { .. }
            | Self::Degree { .. }
            | Self::Cancellation { .. }
            | Self::Setting { .. }
            | Self::Parameters { .. }
            | Self::Family { .. }
            | Self::Sample { .. }
            | Self::NotPlanar { .. }
            | Self::Cuts { .. }
            | Self::Overflow { .. }
            | Self::Sides { .. } => MethodFailure::Method,
        }
    }

    /// The error where the boundary was given `by` away from where it lay.
    pub(crate) fn moved(mut self, by: Point) -> Self {
        if let Self::Cutting(CuttingError::Crosses { at }) | Self::Apart { apex: at, .. } = &mut self {
            *at = (Point::from(*at) + by).into();
        }
        self
    }

    /// The error of the system of a mask with this corner weight.
    pub(crate) fn of_mask(self, alpha: f64, degree: usize) -> Self {
        if let Self::Solve(solve::SolveError::Singular { reciprocal_condition, .. }) = self {
            return Self::MaskWeight { alpha, degree, reciprocal_condition };
        }
        self
    }

    /// The error of the linear system of an extremal of this degree.
    pub(crate) fn of_system(error: solve::SolveError, degree: usize) -> Self {
        if let solve::SolveError::NotPositiveDefinite { order, pivot: Some(pivot), .. } = error
            && degree >= HIGH
        {
            return Self::Degree { degree, unknowns: order, pivot };
        }
        error.into()
    }
}

/// Which degrees of a harmonic net leave nothing open, whatever the sides: two rows of degree n determine the net of degree (m, n)
/// exactly if m > n, or m = n is odd (GT §6, corrected), and columns likewise.
fn determined(m: usize, n: usize, given: Option<Direction>) -> String {
    let least = DegreeLimit::across_harmonic_rows;
    let rows = format!("two rows of degree {n} determine the net with degree {} in u or more", least(n));
    let columns =
        format!("two columns of degree {m} determine the net with degree {} in v or more", least(m));
    let whatever = "whatever their points";
    match given {
        Some(Direction::Rows) => format!("{rows}, {whatever}"),
        Some(Direction::Columns) => format!("{columns}, {whatever}"),
        None => format!("give two opposite sides only: {rows}, and {columns}, {whatever}"),
    }
}
