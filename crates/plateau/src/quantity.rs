//! The figures of a result: one table of them, which whatever lists, expects, compares or shows figures follows from.

use std::fmt;

use energy::{Functional, Integral};

use crate::{Done, Energy, SearchEnergy};

/// The value of a figure, with its error if it has one of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// A bound of its error, in the same unit.
    pub error: Option<f64>,
}

impl From<f64> for Measured {
    fn from(value: f64) -> Self {
        Self { value, error: None }
    }
}

impl From<Integral> for Measured {
    fn from(integral: Integral) -> Self {
        Self { value: integral.value, error: Some(integral.error) }
    }
}

/// What is known of a figure beside its value.
struct Row {
    name: &'static str,
    key: &'static str,
    /// None where it depends on what was searched for.
    power: Option<i32>,
    meaning: &'static str,
    value: fn(&Done, usize) -> Option<Measured>,
}

/// The enum of figures, the list of them and their rows, from one line each: variant, name, place in a record, power of the length in the
/// unit, meaning, value.
macro_rules! quantities {
    ($($variant:ident $([$index:ident])? = $name:literal, $key:literal, $power:tt, $meaning:literal, $value:expr;)*) => {
        /// A figure of a result.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Quantity {
            $(#[doc = $meaning] $variant $((quantities!(@type $index)))?,)*
        }

        impl Quantity {
            /// Every figure; of those with an index, the first.
            pub const ALL: &'static [Self] = &[$(Self::$variant $((quantities!(@zero $index)))?),*];

            const fn row(self) -> Row {
                match self {
                    $(Self::$variant { .. } => Row { name: $name, key: $key, power: quantities!(@power $power), meaning: $meaning, value: $value },)*
                }
            }

            /// The same figure at an index, if it has one.
            #[must_use]
            pub const fn at(self, index: usize) -> Self {
                match self {
                    $(Self::$variant { .. } => Self::$variant $(({ let $index = index; $index }))?,)*
                }
            }

            /// Its index, if it has one.
            const fn index(self) -> Option<usize> {
                match self {
                    $(Self::$variant $(($index))? => quantities!(@index $($index)?),)*
                }
            }
        }
    };
    (@power searched) => { None };
    (@power $power:expr) => { Some($power) };
    (@type $index:ident) => { usize };
    (@zero $index:ident) => { 0 };
    (@index) => { None };
    (@index $index:ident) => { Some($index) };
}

quantities! {
    Dirichlet = "dirichlet", "dirichlet", 2, "the Dirichlet energy ½∫(E + G), length²",
        |done, _| Some(done.figures.dirichlet.into());
    Area = "area", "area", 2, "the area ∫√(EG − F²), length²", |done, _| Some(done.figures.area.into());
    AreaEstimate = "area-estimate", "area_estimate", 2,
        "what the area is above the least area of the boundary, where that was estimated, length²",
        |done, _| done.estimate.map(Into::into);
    LowerBound = "lower-bound", "lower_bound", 2,
        "the area below which no surface over the boundary lies, or none that is a graph as it is, where that was proved, length²",
        |done, _| done.bound.as_ref().map(|bound| bound.value.into());
    LaplacianDefect = "laplacian-defect", "laplacian_defect", 2, "∫‖S_uu + S_vv‖², length²",
        |done, _| Some(done.figures.laplacian_defect.into());
    Bending = "bending", "bending", 2, "∫‖S_uu‖² + 2‖S_uv‖² + ‖S_vv‖², length²", |done, _| Some(done.figures.bending.into());
    CoonsFunctional = "coons-functional", "coons_functional", 2, "∫‖S_uv‖² of extremals of the Coons functional, length²",
        |done, _| done.figures.quadratic(Functional::Coons).map(Into::into);
    MetricDirichlet = "metric-dirichlet", "metric_dirichlet", 2,
        "D^g of metric corrections, the Dirichlet energy in the metric of the surface before the last; at least 2·area; length²",
        |done, _| done.solved.solve()?.metric.map(Into::into);
    ConformalityGap = "conformality-gap", "conformality_gap", 0, "(D − A)/A, 0 exactly for conformal charts",
        |done, _| done.figures.conformality_gap.map(Into::into);
    MeanCurvatureMax = "mean-curvature-max", "mean_curvature.max_abs", (-1), "the largest |H| at the vertices of the mesh, 1/length",
        |done, _| done.figures.mean_curvature_max.map(Into::into);
    MeanCurvatureRms = "mean-curvature-rms", "mean_curvature.rms", (-1), "the root mean square of H over the area, 1/length",
        |done, _| done.figures.mean_curvature_rms.map(Into::into);
    Residual = "residual", "residual", 0, "the scaled residual of the linear system: about 1 is rounding, above 30 a failure",
        |done, _| done.solved.solve().map(|solve| solve.residual.into());
    BoundaryDeviation = "boundary-deviation", "boundary_deviation", 1,
        "the largest distance of the boundary curves from the Bernstein curves of the same net, length",
        |done, _| done.boundary.map(|boundary| boundary.deviation.into());
    HarmonicBound = "harmonic-bound", "harmonic_bound", 2,
        "the least Dirichlet energy any map with the same boundary curves can have, length²",
        |done, _| done.boundary.map(|boundary| Measured {
            value: boundary.harmonic_bound,
            error: Some(boundary.harmonic_bound_error),
        });
    Deviation = "deviation", "deviation", 1, "the largest distance to the closed form on the mesh, length; helicoids only",
        |done, _| done.closed_form.map(|form| form.deviation.into());
    Kink = "kink", "kink.max", 0,
        "the largest angle between the tangent planes of two patches along an edge where they should meet smoothly, radians",
        |done, _| done.film.as_ref()?.seams().kink.map(|kink| kink.max.into());
    RimDeviation = "rim-deviation", "rim_deviation", 1,
        "how far the rim of a surface over loops or faces lies from the curves that were given, length",
        |done, _| done.film.as_ref().map(|film| film.rim().largest.into());
    JacobianRatio = "jacobian-ratio", "jacobian_ratio", 0,
        "the least over the mean of the area that a piece of the parameters becomes, of least areas and of surfaces of several patches",
        |done, _| match &done.film {
            Some(film) => Some(film.seams().jacobian_ratio.into()),
            None => done.solved.area().map(|found| found.jacobian_ratio.into()),
        };
    SpannedOneByOne = "spanned-one-by-one", "spanned_one_by_one", 2,
        "the least area of two loops, each spanned by itself, length²",
        |done, _| done.film.as_ref()?.one_by_one().map(Into::into);
    Shape[k] = "shape", "shape", 0, "the shape parameters: one number for all of them, or a list",
        |done, index| done.solved.shape().and_then(|shape| shape.get(index).copied()).map(Into::into);
    SearchMinimum = "search-minimum", "search.minimum", searched,
        "the least best value of the search's runs: of energies length², of the conformality gap a number",
        |done, _| done.solved.search().map(|search| search.minimum().into());
    Curvature[k] = "curvature", "curvature", (-1),
        "the curvature of a curve at its samples: one number for all, or a list; signed for planar curves", |_, _| None;
}

/// Which results have a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bearer {
    /// All surfaces.
    Surface,
    /// Surfaces that span a boundary.
    Spanning,
    /// Least areas of which a lower bound is to be proved.
    Bounded,
    /// Extremals of this energy.
    Extremal(Functional),
    /// Surfaces whose metric was corrected.
    Corrected,
    /// Surfaces that a single linear system was solved for.
    Solved,
    /// Tensor patches over four sides.
    FourSides,
    /// Surfaces with a closed form.
    Closed,
    /// Surfaces over loops and faces.
    Film,
    /// Least areas over two loops.
    TwoLoops,
    /// Least areas, and surfaces over loops and faces.
    Even,
    /// Patches of families with shape parameters.
    Shaped,
    /// Patches whose shape was searched.
    Searched,
    /// Curves.
    Curve,
}

impl Quantity {
    /// Which results have it.
    #[must_use]
    pub const fn bearer(self) -> Bearer {
        match self {
            Self::Dirichlet
            | Self::Area
            | Self::LaplacianDefect
            | Self::Bending
            | Self::ConformalityGap
            | Self::MeanCurvatureMax
            | Self::MeanCurvatureRms => Bearer::Surface,
            Self::AreaEstimate => Bearer::Spanning,
            Self::LowerBound => Bearer::Bounded,
            Self::CoonsFunctional => Bearer::Extremal(Functional::Coons),
            Self::MetricDirichlet => Bearer::Corrected,
            Self::Residual => Bearer::Solved,
            Self::BoundaryDeviation | Self::HarmonicBound => Bearer::FourSides,
            Self::Deviation => Bearer::Closed,
            Self::Kink | Self::RimDeviation => Bearer::Film,
            Self::SpannedOneByOne => Bearer::TwoLoops,
            Self::JacobianRatio => Bearer::Even,
            Self::Shape(_) => Bearer::Shaped,
            Self::SearchMinimum => Bearer::Searched,
            Self::Curvature(_) => Bearer::Curve,
        }
    }

    /// The figure that is the value of an energy.
    #[must_use]
    pub const fn of_energy(energy: Energy) -> Self {
        match energy {
            Energy::Area => Self::Area,
            Energy::Quadratic(Functional::Dirichlet) => Self::Dirichlet,
            Energy::Quadratic(Functional::Laplacian) => Self::LaplacianDefect,
            Energy::Quadratic(Functional::Bending) => Self::Bending,
            Energy::Quadratic(Functional::Coons) => Self::CoonsFunctional,
        }
    }

    /// The figure that is the value of what a search minimises.
    #[must_use]
    pub const fn of_search(energy: SearchEnergy) -> Self {
        match energy {
            SearchEnergy::Energy(energy) => Self::of_energy(energy),
            SearchEnergy::Conformality => Self::ConformalityGap,
        }
    }

    /// Whether it says something of the surface; the others tell how it was found, or of curves.
    #[must_use]
    pub const fn is_of_the_surface(self) -> bool {
        !matches!(self, Self::Residual | Self::SearchMinimum | Self::Curvature(_))
    }

    /// Whether it belongs to the surface whatever its parameters: it is the same where points slide within the surface.
    #[must_use]
    pub const fn is_free_of_parameters(self) -> bool {
        match self {
            Self::Area
            | Self::LowerBound
            | Self::BoundaryDeviation
            | Self::RimDeviation
            | Self::SpannedOneByOne => true,
            Self::Dirichlet
            | Self::AreaEstimate
            | Self::LaplacianDefect
            | Self::Bending
            | Self::CoonsFunctional
            | Self::MetricDirichlet
            | Self::ConformalityGap
            | Self::MeanCurvatureMax
            | Self::MeanCurvatureRms
            | Self::Residual
            | Self::HarmonicBound
            | Self::Deviation
            | Self::Kink
            | Self::JacobianRatio
            | Self::Shape(_)
            | Self::SearchMinimum
            | Self::Curvature(_) => false,
        }
    }

    /// The name in experiment files (the same for every index).
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// Where it stands in a method's entry of `result.json`; a dot leads into an object. The curvature of curves stands in `curve`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        self.row().key
    }

    /// It scales as this power of a length; none where that depends on what was searched for ([`Self::power_in`]).
    #[must_use]
    pub const fn power(self) -> Option<i32> {
        self.row().power
    }

    /// The power of a length as which it scales among the figures of a patch; none of what the patch was not searched for.
    ///
    /// ```
    /// use plateau::{Quantity, SearchEnergy};
    /// assert_eq!(Quantity::SearchMinimum.power(), None);
    /// assert_eq!(Quantity::of_search(SearchEnergy::Conformality).power(), Some(0));
    /// ```
    #[must_use]
    pub fn power_in(self, done: &Done) -> Option<i32> {
        self.power().or_else(|| Self::of_search(done.solved.search()?.energy()).power())
    }

    /// What it is, with its unit.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        self.row().meaning
    }

    /// Its value for a patch with its error; none where it has no meaning.
    #[must_use]
    pub fn of(self, done: &Done) -> Option<Measured> {
        (self.row().value)(done, self.index().unwrap_or(0))
    }
}

impl fmt::Display for Quantity {
    /// The name, with the index where there is one: `shape[2]`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index() {
            Some(k) => write!(f, "{}[{k}]", self.name()),
            None => f.write_str(self.name()),
        }
    }
}
